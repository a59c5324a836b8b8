#include "input/sources/hid_source.hpp"

#include <fcntl.h>
#include <hidapi/hidapi.h>
#include <linux/hidraw.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <utility>

#include "input/devices/make_decoder.hpp"
#include "input/devices/uclogic_strings.hpp"
#include "input/sources/usb_strings.hpp"

namespace input {
namespace {

constexpr int kWait_ms = 100;
constexpr std::size_t kReadBytes = 4096;

struct HidClose {
    void operator()(hid_device* d) const { hid_close(d); }
};
using HidHandle = std::unique_ptr<hid_device, HidClose>;

std::string parser_name(const PenDecoder& decoder, const DeviceFile* file) {
    std::string name(decoder.name());
    return file == nullptr ? name : name + " (" + file->file + ")";
}

/// All that is known of one interface before it is opened.
struct Known {
    DeviceIdentity identity;
    std::vector<std::uint8_t> bytes;
    std::optional<ReportDescriptor> descriptor;
    std::string malformed;  ///< why there is no descriptor
    const DeviceFile* file = nullptr;
};

Known know(const UdevNode& node) {
    Known k;
    k.identity = node.identity;
    k.bytes = report_descriptor_of(node);
    core::Result<ReportDescriptor> parsed = parse_report_descriptor(k.bytes);
    if (parsed) {
        k.descriptor = std::move(*parsed);
    } else {
        k.malformed = parsed.error().message;
    }
    k.file = find_device_file(k.identity, device_files());
    return k;
}

/// Why the node cannot be opened, as an errno; 0 when it can. hidapi does not say why, and 0.13 crashes on a node that
/// answers no question.
int try_open(const std::string& node) {
    const int fd = open(node.c_str(), O_RDWR | O_CLOEXEC);
    if (fd < 0) return errno;
    int size = 0;
    const int why = ioctl(fd, HIDIOCGRDESCSIZE, &size) < 0 ? errno : 0;
    close(fd);
    return why;
}

/// Reads the strings that the data file asks for, and the firmware's name, which may point to a better file.
UsbStrings ask_strings(const UdevNode& node, Known& known) {
    UsbStrings strings;
    if (node.usb_node.empty() || known.file == nullptr) return strings;
    const auto ask = [&](std::uint8_t index) {
        core::Result<std::vector<std::uint8_t>> answer = read_usb_string(node.usb_node, index);
        if (answer) strings[index] = std::move(*answer);
    };
    bool asks = false;
    for (const WakeStep& step : known.file->wake) asks = asks || step.kind == WakeStep::Kind::ReadString;
    if (!asks) return strings;
    ask(201);
    if (strings.count(201) != 0) known.identity.firmware = text_of_string(strings[201]);
    known.file = find_device_file(known.identity, device_files());
    for (const WakeStep& step : known.file->wake) {
        if (step.kind == WakeStep::Kind::ReadString) ask(step.string);
    }
    return strings;
}

/// The node of another interface of the same tablet.
std::string sibling(const UdevNode& node, int interface) {
    for (const UdevNode& other : udev_nodes("hidraw")) {
        if (!node.usb_path.empty() && other.usb_path == node.usb_path && other.identity.interface == interface) {
            return other.node;
        }
    }
    return {};
}

/// Wacom's tablets that describe themselves have a switch between the mouse's reports and their own.
void choose_wacom_mode(hid_device* handle, const ReportDescriptor& descriptor) {
    constexpr Usage kDataMode = 0xFF0D1002;
    constexpr std::uint8_t kOwnReports = 2;
    for (const HidField& f : descriptor.fields) {
        if (f.kind != HidKind::Feature || f.usage != kDataMode || f.bit_size != 8) continue;
        std::vector<std::uint8_t> report(descriptor.report_bytes(HidKind::Feature, f.report_id), 0);
        const std::size_t at = 1 + f.bit_offset / 8;
        if (at >= report.size()) continue;
        report[0] = f.report_id;
        report[at] = kOwnReports;
        hid_send_feature_report(handle, report.data(), report.size());
    }
}

void wake(const UdevNode& node, const Known& known, hid_device* handle) {
    if (known.descriptor) choose_wacom_mode(handle, *known.descriptor);
    if (known.file == nullptr) return;
    for (const WakeStep& step : known.file->wake) {
        if (step.kind == WakeStep::Kind::ReadString) continue;
        HidHandle other;
        hid_device* to = handle;
        if (step.interface >= 0 && step.interface != node.identity.interface) {
            const std::string path = sibling(node, step.interface);
            if (path.empty()) continue;
            other.reset(hid_open_path(path.c_str()));
            to = other.get();
        }
        if (to == nullptr) continue;
        if (step.kind == WakeStep::Kind::SetFeature) hid_send_feature_report(to, step.bytes.data(), step.bytes.size());
        if (step.kind == WakeStep::Kind::WriteOutput) hid_write(to, step.bytes.data(), step.bytes.size());
    }
}

/// Event nodes that nobody else hears of for as long as this lives.
class GrabbedNodes {
  public:
    GrabbedNodes() = default;
    explicit GrabbedNodes(const UdevNode& tablet) {
        for (const UdevNode& n : udev_nodes("input")) {
            const bool same_usb = !tablet.usb_path.empty() && n.usb_path == tablet.usb_path;
            const bool same_hid = !tablet.hid_path.empty() && n.hid_path == tablet.hid_path;
            if ((!same_usb && !same_hid) || n.node.find("/event") == std::string::npos) continue;
            const int fd = open(n.node.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
            if (fd < 0) continue;
            ioctl(fd, EVIOCGRAB, 1);
            fds_.push_back(fd);
        }
    }
    ~GrabbedNodes() {
        for (const int fd : fds_) close(fd);
    }
    GrabbedNodes(GrabbedNodes&& other) noexcept : fds_(std::exchange(other.fds_, {})) {}
    GrabbedNodes& operator=(GrabbedNodes&&) = delete;

  private:
    std::vector<int> fds_;
};

class HidReader final : public DeviceReader {
  public:
    HidReader(TraceDevice device, Clock clock, std::size_t queue_events, HidHandle handle,
              std::unique_ptr<PenDecoder> decoder, GrabbedNodes grabbed)
        : DeviceReader(std::move(device), std::move(clock), queue_events),
          handle_(std::move(handle)),
          decoder_(std::move(decoder)),
          grabbed_(std::move(grabbed)),
          buffer_(kReadBytes) {}
    ~HidReader() override { stop(); }

  private:
    Step step() override {
        const int length = hid_read_timeout(handle_.get(), buffer_.data(), buffer_.size(), kWait_ms);
        if (length < 0) return Step::Gone;
        if (length == 0) return Step::Nothing;
        SourceEvent event;
        event.device = device().number;
        event.time_ns = now_ns();
        const std::span<const std::uint8_t> bytes(buffer_.data(), static_cast<std::size_t>(length));
        event.set_raw(RawKind::HidReport, bytes);
        PenReport report;
        const PenAxes* axes = nullptr;
        if (decoder_->decode(bytes, report, axes)) {
            event.sample = to_sample(report, *axes, event.time_ns, event.device);
            event.sample_valid = true;
        }
        push(event);
        return Step::Read;
    }

    HidHandle handle_;
    std::unique_ptr<PenDecoder> decoder_;
    GrabbedNodes grabbed_;
    std::vector<std::uint8_t> buffer_;
};

}  // namespace

struct HidSource::Impl {
    HidSourceOptions options;
    ReaderSet readers;
    std::mutex mutex;                              ///< over the map; the monitor's thread opens and closes
    std::map<std::string, std::uint32_t> numbers;  ///< by node
    std::unique_ptr<UdevMonitor> monitor;

    void changed(UdevMonitor::Change change, const UdevNode& node) {
        if (change == UdevMonitor::Change::Added) return open(node);
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

    void open(const UdevNode& node) {
        {
            const std::lock_guard lock(mutex);
            const auto open_already = numbers.find(node.node);
            if (open_already != numbers.end() && readers.alive(open_already->second)) return;
        }
        Known known = know(node);
        if (!make_decoder(known.file, known.descriptor, {})) {
            if (!known.malformed.empty() && known.file != nullptr) {
                readers.problem(node.node + ": the tablet's report descriptor is malformed (" + known.malformed + ")");
            }
            return;
        }
        if (options.wanted && !options.wanted(node)) return;
        if (const int why = try_open(node.node)) return cannot_open(node, why);
        UsbStrings strings;
        if (options.wake) strings = ask_strings(node, known);
        HidHandle handle(hid_open_path(node.node.c_str()));
        if (!handle) return cannot_open(node, EIO);
        if (options.wake) wake(node, known, handle.get());
        add(node, known, strings, std::move(handle));
    }

    void add(const UdevNode& node, const Known& known, const UsbStrings& strings, HidHandle handle) {
        std::unique_ptr<PenDecoder> decoder = make_decoder(known.file, known.descriptor, strings);
        TraceDevice device;
        device.number = options.numbers->next();
        device.identity = known.identity;
        device.source = "hidraw";
        device.parser = parser_name(*decoder, known.file);
        device.axes = decoder->axes();
        device.reports_range = decoder->reports_range() && !(known.file != nullptr && known.file->silence_ms);
        device.descriptor = known.bytes;
        {
            const std::lock_guard lock(mutex);
            numbers[node.node] = device.number;
        }
        readers.add(std::make_unique<HidReader>(std::move(device), options.clock, options.queue_events,
                                                std::move(handle), std::move(decoder),
                                                options.grab_siblings ? GrabbedNodes(node) : GrabbedNodes()));
    }

    void cannot_open(const UdevNode& node, int why) {
        std::string problem = opening_problem(node, why);
        if (!problem.empty()) readers.problem(std::move(problem));
    }
};

HidSource::HidSource(HidSourceOptions options) : impl_(std::make_unique<Impl>()) {
    impl_->options = std::move(options);
    hid_init();
    // Watch first, look then: what comes in between is seen twice and opened once.
    if (impl_->options.hot_plug) {
        impl_->monitor = std::make_unique<UdevMonitor>(
            std::vector<std::string>{"hidraw"},
            [impl = impl_.get()](UdevMonitor::Change change, const UdevNode& node) { impl->changed(change, node); });
    }
    for (const UdevNode& node : udev_nodes("hidraw")) impl_->open(node);
}

HidSource::~HidSource() {
    impl_->monitor.reset();
    impl_->readers.clear();
}

void HidSource::drain(std::vector<SourceEvent>& out) {
    impl_->readers.drain(out);
}
TraceDevice HidSource::device(std::uint32_t number) const {
    return impl_->readers.device(number);
}
std::uint64_t HidSource::lost() const {
    return impl_->readers.lost();
}
std::vector<std::string> HidSource::take_problems() {
    return impl_->readers.take_problems();
}

std::vector<HidPen> list_hid_pens() {
    std::vector<HidPen> pens;
    for (const UdevNode& node : udev_nodes("hidraw")) {
        const Known known = know(node);
        const std::unique_ptr<PenDecoder> decoder = make_decoder(known.file, known.descriptor, {});
        if (!decoder) continue;
        pens.push_back({node, parser_name(*decoder, known.file), decoder->axes(), decoder->reports_range()});
    }
    return pens;
}

}  // namespace input
