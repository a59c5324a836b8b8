#include "input/sources/libinput_source.hpp"

#include <fcntl.h>
#include <libinput.h>
#include <libudev.h>
#include <linux/input-event-codes.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <map>
#include <numbers>

namespace input {
namespace {

constexpr int kWait_ms = 100;
constexpr double kDegree = std::numbers::pi / 180.0;

struct LibinputFree {
    void operator()(libinput* l) const { libinput_unref(l); }
    void operator()(udev* u) const { udev_unref(u); }
};

int open_node(const char* path, int flags, void* problems) {
    const int fd = open(path, flags | O_CLOEXEC);
    if (fd >= 0) return fd;
    const int why = errno;
    static_cast<std::vector<std::string>*>(problems)->push_back(std::string(path) + " cannot be opened (" +
                                                                std::strerror(why) + ")");
    return -why;
}
void close_node(int fd, void*) {
    close(fd);
}
constexpr libinput_interface kInterface{open_node, close_node};

/// libinput's own complaints are problems, too; it would print them.
void keep_complaint(libinput* l, libinput_log_priority, const char* format, va_list arguments) {
    std::array<char, 300> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    std::string sentence = text.data();
    while (!sentence.empty() && (sentence.back() == '\n' || sentence.back() == ' ')) sentence.pop_back();
    if (void* problems = libinput_get_user_data(l)) {
        static_cast<std::vector<std::string>*>(problems)->push_back("libinput: " + sentence);
    }
}

PenTool tool_of(libinput_tablet_tool* tool) {
    switch (libinput_tablet_tool_get_type(tool)) {
        case LIBINPUT_TABLET_TOOL_TYPE_ERASER:
            return PenTool::Eraser;
        case LIBINPUT_TABLET_TOOL_TYPE_BRUSH:
            return PenTool::Brush;
        case LIBINPUT_TABLET_TOOL_TYPE_PENCIL:
            return PenTool::Pencil;
        case LIBINPUT_TABLET_TOOL_TYPE_AIRBRUSH:
            return PenTool::Airbrush;
        case LIBINPUT_TABLET_TOOL_TYPE_LENS:
            return PenTool::Lens;
        case LIBINPUT_TABLET_TOOL_TYPE_MOUSE:
            return PenTool::Mouse;
        default:
            return PenTool::Pen;
    }
}

std::uint32_t button_bit(std::uint32_t code) {
    switch (code) {
        case BTN_STYLUS:
            return kBarrel1;
        case BTN_STYLUS2:
            return kBarrel2;
        case BTN_STYLUS3:
            return kBarrel3;
        default:
            return 0;
    }
}

double turned(double degrees) {
    return (degrees > 180.0 ? degrees - 360.0 : degrees) * kDegree;
}

}  // namespace

struct LibinputSource::Impl {
    LibinputSourceOptions options;
    std::vector<std::string> open_problems;  ///< of the reading thread
    std::unique_ptr<udev, LibinputFree> context;
    std::unique_ptr<libinput, LibinputFree> input;
    SpscQueue<SourceEvent> queue;
    mutable std::mutex mutex;
    std::vector<TraceDevice> known;
    std::vector<std::string> problems;
    std::map<libinput_device*, std::uint32_t> numbers;  ///< of the reading thread
    std::map<std::uint32_t, std::uint32_t> buttons;     ///< of the reading thread, by device number
    std::optional<SourceEvent> held;                    ///< of the reading thread: the moment that is being told
    std::jthread thread;

    explicit Impl(LibinputSourceOptions o) : options(std::move(o)), queue(options.queue_events) {}

    void start() {
        if (options.nodes.empty()) {
            context.reset(udev_new());
            input.reset(libinput_udev_create_context(&kInterface, &open_problems, context.get()));
            if (input) libinput_log_set_handler(input.get(), keep_complaint);
            if (input && libinput_udev_assign_seat(input.get(), options.seat.c_str()) != 0) input.reset();
        } else {
            input.reset(libinput_path_create_context(&kInterface, &open_problems));
            if (input) libinput_log_set_handler(input.get(), keep_complaint);
            for (const std::string& node : options.nodes) {
                if (input && libinput_path_add_device(input.get(), node.c_str()) == nullptr) {
                    open_problems.push_back(node + " is no device that libinput takes");
                }
            }
        }
        if (!input) return say("libinput cannot be started; is udev running?");
        keep_problems();
        thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }

    void run(const std::stop_token& stop) {
        pollfd p{libinput_get_fd(input.get()), POLLIN, 0};
        while (!stop.stop_requested()) {
            if (libinput_dispatch(input.get()) != 0) return;
            while (libinput_event* event = libinput_get_event(input.get())) {
                take(event);
                libinput_event_destroy(event);
            }
            flush();
            keep_problems();
            poll(&p, 1, kWait_ms);
        }
    }

    void take(libinput_event* event) {
        libinput_device* device = libinput_event_get_device(event);
        switch (libinput_event_get_type(event)) {
            case LIBINPUT_EVENT_DEVICE_ADDED:
                if (libinput_device_has_capability(device, LIBINPUT_DEVICE_CAP_TABLET_TOOL) != 0) attach(device);
                return;
            case LIBINPUT_EVENT_DEVICE_REMOVED:
                detach(device);
                return;
            case LIBINPUT_EVENT_TABLET_TOOL_AXIS:
            case LIBINPUT_EVENT_TABLET_TOOL_PROXIMITY:
            case LIBINPUT_EVENT_TABLET_TOOL_TIP:
            case LIBINPUT_EVENT_TABLET_TOOL_BUTTON:
                tool(device, event);
                return;
            default:
                return;
        }
    }

    void attach(libinput_device* device) {
        TraceDevice d;
        d.number = options.numbers->next();
        d.identity.name = libinput_device_get_name(device);
        d.identity.vendor = static_cast<std::uint16_t>(libinput_device_get_id_vendor(device));
        d.identity.product = static_cast<std::uint16_t>(libinput_device_get_id_product(device));
        d.source = "libinput";
        d.parser = "libinput";
        double width = 0.0, height = 0.0;
        if (libinput_device_get_size(device, &width, &height) == 0 && width > 0.0 && height > 0.0) {
            // libinput tells no ranges, only sizes: thousandths of a millimetre stand for them.
            d.axes.x = AxisRange{0, static_cast<std::int32_t>(width * 1000), 1000.0};
            d.axes.y = AxisRange{0, static_cast<std::int32_t>(height * 1000), 1000.0};
        }
        numbers[device] = d.number;
        const std::uint32_t number = d.number;
        {
            const std::lock_guard lock(mutex);
            known.push_back(std::move(d));
        }
        change(SourceEventKind::Attached, number);
    }

    void detach(libinput_device* device) {
        const auto found = numbers.find(device);
        if (found == numbers.end()) return;
        change(SourceEventKind::Detached, found->second);
        buttons.erase(found->second);
        numbers.erase(found);
    }

    void change(SourceEventKind kind, std::uint32_t number) {
        SourceEvent e;
        e.kind = kind;
        e.device = number;
        e.time_ns = options.clock();
        flush();
        queue.push(e);
    }

    void tool(libinput_device* device, libinput_event* event) {
        const auto found = numbers.find(device);
        if (found == numbers.end()) return;
        libinput_event_tablet_tool* t = libinput_event_get_tablet_tool_event(event);
        std::uint32_t& pressed = buttons[found->second];
        if (libinput_event_get_type(event) == LIBINPUT_EVENT_TABLET_TOOL_BUTTON) {
            const std::uint32_t bit = button_bit(libinput_event_tablet_tool_get_button(t));
            const bool down = libinput_event_tablet_tool_get_button_state(t) == LIBINPUT_BUTTON_STATE_PRESSED;
            pressed = down ? pressed | bit : pressed & ~bit;
        }
        SourceEvent e;
        e.device = found->second;
        e.time_ns = static_cast<std::int64_t>(libinput_event_tablet_tool_get_time_usec(t)) * 1000;
        e.sample = sample_of(t, libinput_event_get_type(event), e, pressed);
        e.sample_valid = true;
        // One frame of the kernel becomes several events of the same moment; the last one has all of it.
        if (held && (held->device != e.device || held->time_ns != e.time_ns)) flush();
        held = e;
    }

    void flush() {
        if (held) queue.push(*held);
        held.reset();
    }

    static PenSample sample_of(libinput_event_tablet_tool* t, libinput_event_type type, const SourceEvent& e,
                               std::uint32_t pressed) {
        PenSample s;
        s.time_ns = e.time_ns;
        s.device = e.device;
        const bool leaves =
            type == LIBINPUT_EVENT_TABLET_TOOL_PROXIMITY &&
            libinput_event_tablet_tool_get_proximity_state(t) == LIBINPUT_TABLET_TOOL_PROXIMITY_STATE_OUT;
        if (leaves) return s;
        libinput_tablet_tool* tool = libinput_event_tablet_tool_get_tool(t);
        s.in_range = true;
        s.tip = libinput_event_tablet_tool_get_tip_state(t) == LIBINPUT_TABLET_TOOL_TIP_DOWN;
        s.x = libinput_event_tablet_tool_get_x_transformed(t, 1);
        s.y = libinput_event_tablet_tool_get_y_transformed(t, 1);
        s.x_mm = libinput_event_tablet_tool_get_x(t);
        s.y_mm = libinput_event_tablet_tool_get_y(t);
        if (libinput_tablet_tool_has_pressure(tool) != 0) s.pressure = libinput_event_tablet_tool_get_pressure(t);
        if (libinput_tablet_tool_has_distance(tool) != 0) s.distance = libinput_event_tablet_tool_get_distance(t);
        if (libinput_tablet_tool_has_tilt(tool) != 0) {
            s.tilt_x_rad = libinput_event_tablet_tool_get_tilt_x(t) * kDegree;
            s.tilt_y_rad = libinput_event_tablet_tool_get_tilt_y(t) * kDegree;
        }
        if (libinput_tablet_tool_has_rotation(tool) != 0)
            s.rotation_rad = turned(libinput_event_tablet_tool_get_rotation(t));
        if (libinput_tablet_tool_has_slider(tool) != 0) {
            s.wheel = (libinput_event_tablet_tool_get_slider_position(t) + 1.0) / 2.0;
        }
        s.tool = tool_of(tool);
        s.serial = libinput_tablet_tool_get_serial(tool);
        s.tool_id = static_cast<std::uint32_t>(libinput_tablet_tool_get_tool_id(tool));
        s.buttons = pressed;
        return s;
    }

    void keep_problems() {
        if (open_problems.empty()) return;
        for (std::string& p : open_problems) say(std::move(p));
        open_problems.clear();
    }
    void say(std::string sentence) {
        const std::lock_guard lock(mutex);
        if (problems.size() < 100) problems.push_back(std::move(sentence));
    }
};

LibinputSource::LibinputSource(LibinputSourceOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {
    impl_->start();
}

LibinputSource::~LibinputSource() {
    if (!impl_->thread.joinable()) return;
    impl_->thread.request_stop();
    impl_->thread.join();
}

void LibinputSource::drain(std::vector<SourceEvent>& out) {
    SourceEvent event;
    while (impl_->queue.pop(event)) out.push_back(event);
}

TraceDevice LibinputSource::device(std::uint32_t number) const {
    const std::lock_guard lock(impl_->mutex);
    for (const TraceDevice& d : impl_->known) {
        if (d.number == number) return d;
    }
    return {};
}

std::uint64_t LibinputSource::lost() const {
    return impl_->queue.lost();
}

std::vector<std::string> LibinputSource::take_problems() {
    const std::lock_guard lock(impl_->mutex);
    return std::exchange(impl_->problems, {});
}

}  // namespace input
