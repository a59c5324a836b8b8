#include "input/sources/evdev_source.hpp"

#include <fcntl.h>
#include <linux/input.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <map>

namespace input {
namespace {

constexpr int kWait_ms = 100;

class Fd {
  public:
    explicit Fd(int fd) : fd_(fd) {}
    ~Fd() {
        if (fd_ >= 0) close(fd_);
    }
    Fd(Fd&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Fd& operator=(Fd&&) = delete;
    [[nodiscard]] int get() const { return fd_; }

  private:
    int fd_;
};

template <std::size_t Bits>
std::bitset<Bits> bits_of(const std::array<std::uint8_t, Bits / 8>& bytes) {
    std::bitset<Bits> bits;
    for (std::size_t i = 0; i < Bits; ++i) bits[i] = ((bytes[i / 8] >> (i % 8)) & 1U) != 0;
    return bits;
}

struct NodeState {
    EvdevDescription description;
    std::bitset<768> pressed;
};

/// What the node says of itself now. Nothing for a node that answers no such question.
std::optional<NodeState> ask(int fd) {
    NodeState s;
    std::array<std::uint8_t, 96> keys{}, pressed{};
    std::array<std::uint8_t, 8> axes{};
    if (ioctl(fd, EVIOCGBIT(EV_KEY, keys.size()), keys.data()) < 0) return std::nullopt;
    if (ioctl(fd, EVIOCGBIT(EV_ABS, axes.size()), axes.data()) < 0) return std::nullopt;
    s.description.keys = bits_of<768>(keys);
    const std::bitset<64> has_axis = bits_of<64>(axes);
    for (unsigned code = 0; code < 64; ++code) {
        if (!has_axis[code]) continue;
        input_absinfo info{};
        if (ioctl(fd, EVIOCGABS(code), &info) < 0) continue;
        s.description.axes[code] = EvdevDescription::Axis{info.minimum, info.maximum, info.resolution, info.value};
    }
    if (ioctl(fd, EVIOCGKEY(pressed.size()), pressed.data()) >= 0) s.pressed = bits_of<768>(pressed);
    return s;
}

/// Sizes from libwacom for a node whose kernel driver tells none.
void lend_size(EvdevDescription& d, const std::optional<TabletFacts>& facts) {
    if (!facts || facts->width_mm <= 0.0 || facts->height_mm <= 0.0) return;
    const auto lend = [&](unsigned code, double mm) {
        auto& axis = d.axes[code];
        if (axis && axis->resolution == 0 && axis->max > axis->min) {
            axis->resolution =
                static_cast<std::int32_t>(std::lround((static_cast<double>(axis->max) - axis->min) / mm));
        }
    };
    lend(ABS_X, facts->width_mm);
    lend(ABS_Y, facts->height_mm);
}

void append_event(std::vector<std::uint8_t>& bytes, std::uint16_t type, std::uint16_t code, std::int32_t value) {
    const RawEvdevEvent e{type, code, value};
    const auto* p = reinterpret_cast<const std::uint8_t*>(&e);
    bytes.insert(bytes.end(), p, p + sizeof e);
}

class EvdevReader final : public DeviceReader {
  public:
    EvdevReader(TraceDevice device, Clock clock, std::size_t queue_events, Fd fd, const NodeState& state,
                bool kernel_times)
        : DeviceReader(std::move(device), std::move(clock), queue_events),
          fd_(std::move(fd)),
          pen_(state.description, state.pressed),
          start_(state),
          kernel_times_(kernel_times) {}
    ~EvdevReader() override { stop(); }

  private:
    Step step() override {
        if (!started_) {
            started_ = true;
            push_state(now_ns());
        }
        pollfd p{fd_.get(), POLLIN, 0};
        if (poll(&p, 1, kWait_ms) <= 0) return Step::Nothing;
        std::array<input_event, 64> events;
        const ssize_t got = read(fd_.get(), events.data(), sizeof events);
        if (got < 0) return errno == EAGAIN || errno == EINTR ? Step::Nothing : Step::Gone;
        if (got == 0) return (p.revents & (POLLHUP | POLLERR)) != 0 ? Step::Gone : Step::Nothing;
        for (std::size_t i = 0; i < static_cast<std::size_t>(got) / sizeof(input_event); ++i) take(events[i]);
        return Step::Read;
    }

    void take(const input_event& e) {
        const bool frame = e.type == EV_SYN && e.code == SYN_REPORT;
        if (frame_.empty() || frame) {
            time_ns_ = kernel_times_
                           ? static_cast<std::int64_t>(e.input_event_sec) * 1'000'000'000 + e.input_event_usec * 1000
                           : now_ns();
        }
        append_event(frame_, e.type, e.code, e.value);
        const bool pen = pen_.feed({time_ns_, e.type, e.code, e.value});
        if (!frame) return;
        push_frame(pen);
        if (!pen_.lost_events()) return;
        if (const std::optional<NodeState> now = ask(fd_.get())) {
            pen_.resync(now->description, now->pressed);
            start_ = *now;
            push_state(time_ns_);
        }
    }

    /// The state that no event tells, as a frame: a pen may be down before the node is opened. Only when one is near.
    void push_state(std::int64_t time_ns) {
        if (!pen_.report().in_range || start_.pressed.none()) return;
        for (const std::uint16_t key : start_.description.pen_keys()) {
            if (start_.pressed[key]) append_event(frame_, EV_KEY, key, 1);
        }
        for (std::uint16_t code = 0; code < 64; ++code) {
            if (start_.description.axes[code]) append_event(frame_, EV_ABS, code, start_.description.axes[code]->value);
        }
        append_event(frame_, EV_SYN, SYN_REPORT, 0);
        time_ns_ = time_ns;
        push_frame(true);
    }

    void push_frame(bool pen) {
        SourceEvent event;
        event.device = device().number;
        event.time_ns = time_ns_;
        event.set_raw(RawKind::EvdevFrame, frame_);
        frame_.clear();
        if (pen) {
            event.sample = to_sample(pen_.report(), pen_.axes(), time_ns_, event.device);
            event.sample_valid = true;
        }
        push(event);
    }

    Fd fd_;
    EvdevPen pen_;
    NodeState start_;
    bool kernel_times_;
    bool started_ = false;
    std::int64_t time_ns_ = 0;
    std::vector<std::uint8_t> frame_;
};

}  // namespace

struct EvdevSource::Impl {
    EvdevSourceOptions options;
    ReaderSet readers;
    std::mutex mutex;
    std::map<std::string, std::uint32_t> numbers;  ///< by node
    std::unique_ptr<UdevMonitor> monitor;

    void changed(UdevMonitor::Change change, const UdevNode& node) {
        if (change == UdevMonitor::Change::Added) return open_node(node);
        std::uint32_t number = 0;
        {
            const std::lock_guard lock(mutex);
            const auto found = numbers.find(node.node);
            if (found == numbers.end()) return;
            number = found->second;
            numbers.erase(found);
        }
        readers.remove(number);
    }

    void open_node(const UdevNode& node) {
        if (node.node.find("/event") == std::string::npos || !node.tablet) return;
        {
            const std::lock_guard lock(mutex);
            const auto open_already = numbers.find(node.node);
            if (open_already != numbers.end() && readers.alive(open_already->second)) return;
        }
        if (options.wanted && !options.wanted(node)) return;
        Fd fd(::open(node.node.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
        if (fd.get() < 0) return cannot_open(node, errno);
        std::optional<NodeState> state = ask(fd.get());
        if (!state || !state->description.is_pen()) return;
        if (options.grab && ioctl(fd.get(), EVIOCGRAB, 1) < 0 && errno == EBUSY) return cannot_open(node, EBUSY);
        add(node, std::move(fd), *state);
    }

    void add(const UdevNode& node, Fd fd, NodeState state) {
        int clock = CLOCK_MONOTONIC;
        const bool monotonic = ioctl(fd.get(), EVIOCSCLOCKID, &clock) >= 0;
        const std::optional<TabletFacts> facts = tablet_facts(node.identity);
        lend_size(state.description, facts);
        TraceDevice device;
        device.number = options.numbers->next();
        device.identity = node.identity;
        if (facts && !facts->name.empty()) device.identity.name = facts->name;
        device.source = "evdev";
        device.parser = "evdev";
        device.axes = EvdevPen(state.description).axes();
        device.keys = state.description.pen_keys();
        device.reports_range = true;
        device.descriptor = report_descriptor_of(node);
        {
            const std::lock_guard lock(mutex);
            numbers[node.node] = device.number;
        }
        readers.add(std::make_unique<EvdevReader>(std::move(device), options.clock, options.queue_events, std::move(fd),
                                                  state, options.kernel_times && monotonic));
    }

    void cannot_open(const UdevNode& node, int why) {
        std::string problem = opening_problem(node, why);
        if (!problem.empty()) readers.problem(std::move(problem));
    }
};

EvdevSource::EvdevSource(EvdevSourceOptions options) : impl_(std::make_unique<Impl>()) {
    impl_->options = std::move(options);
    if (impl_->options.hot_plug) {
        impl_->monitor = std::make_unique<UdevMonitor>(
            std::vector<std::string>{"input"},
            [impl = impl_.get()](UdevMonitor::Change change, const UdevNode& node) { impl->changed(change, node); });
    }
    for (const UdevNode& node : udev_nodes("input")) impl_->open_node(node);
}

EvdevSource::~EvdevSource() {
    impl_->monitor.reset();
    impl_->readers.clear();
}

void EvdevSource::drain(std::vector<SourceEvent>& out) {
    impl_->readers.drain(out);
}
TraceDevice EvdevSource::device(std::uint32_t number) const {
    return impl_->readers.device(number);
}
std::uint64_t EvdevSource::lost() const {
    return impl_->readers.lost();
}
std::vector<std::string> EvdevSource::take_problems() {
    return impl_->readers.take_problems();
}

std::vector<EvdevPenNode> list_evdev_pens() {
    std::vector<EvdevPenNode> pens;
    for (const UdevNode& node : udev_nodes("input")) {
        if (node.node.find("/event") == std::string::npos || !node.tablet) continue;
        const Fd fd(::open(node.node.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
        if (fd.get() < 0) {
            pens.push_back({node, {}, false});
            continue;
        }
        std::optional<NodeState> state = ask(fd.get());
        if (!state || !state->description.is_pen()) continue;
        lend_size(state->description, tablet_facts(node.identity));
        pens.push_back({node, EvdevPen(state->description).axes(), true});
    }
    return pens;
}

}  // namespace input
