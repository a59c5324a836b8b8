#include "mock_tablet.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <umockdev.h>
#include <unistd.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>

namespace support {
namespace {

constexpr int kEventMajor = 13, kFirstEventMinor = 64, kPtyMajor = 136;

std::string hex(std::span<const std::uint8_t> bytes) {
    std::string out;
    std::array<char, 3> two{};
    for (const std::uint8_t b : bytes) {
        std::snprintf(two.data(), two.size(), "%02X", b);
        out += two.data();
    }
    return out;
}

template <typename T>
std::string hex_of(const T& value) {
    std::array<std::uint8_t, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(T));
    return hex(bytes);
}

std::string zeros(std::size_t bytes) {
    return std::string(2 * bytes, '0');
}

std::string padded(const std::string& text, std::size_t bytes) {
    std::vector<std::uint8_t> out(text.begin(), text.end());
    out.resize(bytes, 0);
    return hex(out);
}

std::string bits(const std::vector<int>& codes, std::size_t bytes) {
    std::vector<std::uint8_t> out(bytes, 0);
    for (const int c : codes) out[static_cast<std::size_t>(c) / 8] |= static_cast<std::uint8_t>(1U << (c % 8));
    return hex(out);
}

struct Axis {
    int code, min, max, resolution;
};
constexpr std::array<Axis, 8> kAxes{{{ABS_X, 0, 44800, 200},
                                     {ABS_Y, 0, 29600, 200},
                                     {ABS_Z, -900, 899, 287},
                                     {ABS_PRESSURE, 0, 8191, 0},
                                     {ABS_DISTANCE, 0, 63, 0},
                                     {ABS_TILT_X, -64, 63, 57},
                                     {ABS_TILT_Y, -64, 63, 57},
                                     {ABS_MISC, INT32_MIN, INT32_MAX, 0}}};
const std::vector<int> kKeys{BTN_TOOL_PEN, BTN_TOOL_RUBBER, BTN_TOUCH, BTN_STYLUS, BTN_STYLUS2, BTN_STYLUS3};
const std::string kName = "Mock Pen";
const std::string kPhys = "usb-0000:00:14.0-1/input0";

std::string hid_path(int number) {
    return "/devices/pci0000:00/0000:00:14.0/usb1/1-" + std::to_string(number + 1) + "/1-" +
           std::to_string(number + 1) + ":1.0/0003:1234:5678.000" + std::to_string(number);
}
std::string input_path(int number) {
    return "/devices/virtual/input/input" + std::to_string(number);
}

std::string hid_description(int number, const std::vector<std::uint8_t>& descriptor) {
    const std::string path = hid_path(number), n = std::to_string(number);
    const std::string usb = "/devices/pci0000:00/0000:00:14.0/usb1/1-" + std::to_string(number + 1);
    return "P: " + path + "/hidraw/hidraw" + n + "\nN: hidraw" + n + "\nE: DEVNAME=/dev/hidraw" + n +
           "\nE: MAJOR=240\nE: MINOR=" + n + "\nE: SUBSYSTEM=hidraw\nA: dev=240:" + n +
           "\\n\nL: device=../../../0003:1234:5678.000" + n + "\n\nP: " + path +
           "\nE: DRIVER=hid-generic\nE: HID_ID=0003:00001234:00005678\nE: HID_NAME=Mock HID Pen\nE: HID_PHYS=" + kPhys +
           "\nE: HID_UNIQ=SN" + n + "\nE: SUBSYSTEM=hid\nH: report_descriptor=" + hex(descriptor) + "\n\nP: " + usb +
           "/1-" + std::to_string(number + 1) +
           ":1.0\nE: DEVTYPE=usb_interface\nE: PRODUCT=1234/5678/100\nE: SUBSYSTEM=usb\nA: "
           "bInterfaceNumber=00\\n\n\nP: " +
           usb + "\nN: bus/usb/001/00" + std::to_string(number + 2) + "\nE: DEVNAME=/dev/bus/usb/001/00" +
           std::to_string(number + 2) +
           "\nE: DEVTYPE=usb_device\nE: PRODUCT=1234/5678/100\nE: MAJOR=189\nE: MINOR=" + std::to_string(number + 1) +
           "\nE: SUBSYSTEM=usb\nA: idVendor=1234\\n\nA: idProduct=5678\\n\n\n";
}

std::string evdev_description(int number) {
    const std::string path = input_path(number), n = std::to_string(number);
    std::uint64_t axes = 0;
    for (const Axis& a : kAxes) axes |= std::uint64_t{1} << static_cast<unsigned>(a.code);
    std::array<char, 32> abs{};
    std::snprintf(abs.data(), abs.size(), "%lx", static_cast<unsigned long>(axes));
    return "P: " + path + "/event" + n + "\nN: input/event" + n + "\nE: DEVNAME=/dev/input/event" + n +
           "\nE: MAJOR=13\nE: MINOR=" + std::to_string(kFirstEventMinor + number) +
           "\nE: ID_INPUT=1\nE: ID_INPUT_TABLET=1\nE: ID_INPUT_WIDTH_MM=224\nE: ID_INPUT_HEIGHT_MM=148\nE: "
           "LIBINPUT_DEVICE_GROUP=3/1234/1:" +
           n + "\nE: ID_SEAT=seat0\nE: SUBSYSTEM=input\nA: dev=13:" + std::to_string(kFirstEventMinor + number) +
           "\nL: device=../../input" + n + "\n\nP: " + path + "\nE: ABS=" + abs.data() +
           "\nE: EV=1b\nE: ID_INPUT=1\nE: ID_INPUT_TABLET=1\nE: KEY=1c03 0 0 0 0 0\nE: NAME=\"" + kName +
           "\"\nE: PHYS=\"" + kPhys + "\"\nE: PRODUCT=3/1234/1/110\nE: PROP=1\nE: SUBSYSTEM=input\nA: name=" + kName +
           "\nA: properties=1\nA: id/vendor=1234\nA: id/product=0001\nA: id/bustype=0003\nA: id/version=0110\nA: "
           "phys=" +
           kPhys + "\nA: uniq=\n\n";
}

/// What the node answers to those who ask.
std::string evdev_ioctls(int number, int down_at) {
    std::string t = "@DEV /dev/input/event" + std::to_string(number) + "\n";
    for (const std::size_t size : {std::size_t{255}, std::size_t{256}}) {
        t += "EVIOCGNAME(0) " + std::to_string(kName.size() + 1) + " " + padded(kName, size) + "\n";
        t += "EVIOCGPHYS(0) " + std::to_string(kPhys.size() + 1) + " " + padded(kPhys, size) + "\n";
        t += "EVIOCGUNIQ(0) 1 " + zeros(size) + "\n";
    }
    t += "EVIOCGVERSION 0 " + hex_of(std::int32_t{0x10001}) + "\n";
    t += "EVIOCGID 0 " + hex_of(std::array<std::uint16_t, 4>{3, 0x1234, 1, 0x110}) + "\n";
    t += "EVIOCGPROP(0) 8 " + bits({INPUT_PROP_POINTER}, 8) + "\n";
    std::vector<int> axes;
    for (const Axis& a : kAxes) axes.push_back(a.code);
    t += "EVIOCGBIT(0) 8 " + bits({EV_SYN, EV_KEY, EV_ABS, EV_MSC}, 8) + "\n";
    t += "EVIOCGBIT(1) 96 " + bits(kKeys, 96) + "\nEVIOCGBIT(2) 8 " + zeros(8) + "\nEVIOCGBIT(3) 8 " + bits(axes, 8) +
         "\n";
    t += "EVIOCGBIT(4) 8 " + bits({MSC_SERIAL}, 8) + "\nEVIOCGBIT(5) 8 " + zeros(8) + "\nEVIOCGBIT(17) 8 " + zeros(8) +
         "\nEVIOCGBIT(18) 8 " + zeros(8) + "\nEVIOCGBIT(21) 16 " + zeros(16) + "\nEVIOCGBIT(20) 8 " + zeros(8) + "\n";
    const std::vector<int> pressed = down_at >= 0 ? std::vector<int>{BTN_TOOL_PEN, BTN_TOUCH} : std::vector<int>{};
    t += "EVIOCGKEY(0) 96 " + bits(pressed, 96) + "\nEVIOCGLED(0) 8 " + zeros(8) + "\nEVIOCGSW(0) 8 " + zeros(8) + "\n";
    for (const Axis& a : kAxes) {
        int value = 0;
        if (down_at >= 0 && a.code == ABS_X) value = down_at;
        if (down_at >= 0 && a.code == ABS_PRESSURE) value = 4000;
        const std::string code = a.code == 0 ? "" : "(" + std::to_string(a.code) + ")";
        t += "EVIOCGABS" + code + " 0 " + hex_of(std::array<std::int32_t, 6>{value, a.min, a.max, 0, 0, a.resolution}) +
             "\n";
    }
    return t;
}

std::string hid_ioctls(int number, const std::vector<std::uint8_t>& descriptor) {
    std::vector<std::uint8_t> padded_descriptor(descriptor);
    padded_descriptor.resize(4096, 0);
    const std::string size = hex_of(static_cast<std::int32_t>(descriptor.size()));
    return "@DEV /dev/hidraw" + std::to_string(number) + "\nHIDIOCGRDESCSIZE 0 " + size + "\nHIDIOCGRDESC 0 " + size +
           hex(padded_descriptor) + "\n";
}

}  // namespace

struct MockTablets::Impl {
    UMockdevTestbed* bed = umockdev_testbed_new();
    ~Impl() { g_object_unref(bed); }

    void add(const std::string& description) const {
        GError* error = nullptr;
        if (!umockdev_testbed_add_from_string(bed, description.c_str(), &error)) fail(error);
    }
    /// umockdev reads what a node answers from a file.
    void answers(const std::string& text) const {
        std::array<char, 32> path{"/tmp/croquis-mock-XXXXXX"};
        const int fd = mkstemp(path.data());
        const bool written = fd >= 0 && write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size());
        if (fd >= 0) close(fd);
        GError* error = nullptr;
        const bool loaded = written && umockdev_testbed_load_ioctl(bed, nullptr, path.data(), &error);
        unlink(path.data());
        if (!loaded) fail(error);
    }
    void send(const std::string& node, const void* data, std::size_t size) const {
        const int fd = umockdev_testbed_get_dev_fd(bed, node.c_str());
        if (fd < 0 || write(fd, data, size) != static_cast<ssize_t>(size))
            throw std::runtime_error("no mock node " + node);
    }
    [[noreturn]] static void fail(GError* error) {
        throw std::runtime_error(error != nullptr ? error->message : "umockdev");
    }
};

MockTablets::MockTablets() : impl_(std::make_unique<Impl>()) {}
MockTablets::~MockTablets() = default;

bool MockTablets::running_mocked() {
    return umockdev_in_mock_environment() != 0;
}

void MockTablets::plug_hid(int number, const std::vector<std::uint8_t>& descriptor, bool announce, bool kernel_pen) {
    impl_->answers(hid_ioctls(number, descriptor));  // first: adding already tells those who listen
    impl_->add(hid_description(number, descriptor));
    if (kernel_pen) {
        impl_->add("P: " + hid_path(number) + "/input/input" + std::to_string(90 + number) +
                   "\nE: SUBSYSTEM=input\nA: capabilities/key=1c03 0 0 0 0 0\\n\nA: capabilities/abs=d000003\\n\n\n");
    }
    if (announce)
        umockdev_testbed_uevent(impl_->bed,
                                ("/sys" + hid_path(number) + "/hidraw/hidraw" + std::to_string(number)).c_str(), "add");
}

void MockTablets::plug_evdev(int number, bool announce, int down_at) {
    impl_->answers(evdev_ioctls(number, down_at));
    impl_->add(evdev_description(number));
    if (announce)
        umockdev_testbed_uevent(impl_->bed, ("/sys" + input_path(number) + "/event" + std::to_string(number)).c_str(),
                                "add");
}

void MockTablets::unplug_hid(int number) {
    const std::string path = "/sys" + hid_path(number);
    umockdev_testbed_uevent(impl_->bed, (path + "/hidraw/hidraw" + std::to_string(number)).c_str(), "remove");
    umockdev_testbed_remove_device(impl_->bed, (path + "/hidraw/hidraw" + std::to_string(number)).c_str());
    // Up to the USB device itself: umockdev makes no device twice.
    const std::string usb = "/sys/devices/pci0000:00/0000:00:14.0/usb1/1-" + std::to_string(number + 1);
    for (const std::string& gone : {path, usb + "/1-" + std::to_string(number + 1) + ":1.0", usb}) {
        umockdev_testbed_remove_device(impl_->bed, gone.c_str());
    }
}

void MockTablets::unplug_evdev(int number) {
    const std::string path = "/sys" + input_path(number);
    umockdev_testbed_uevent(impl_->bed, (path + "/event" + std::to_string(number)).c_str(), "remove");
    umockdev_testbed_remove_device(impl_->bed, (path + "/event" + std::to_string(number)).c_str());
    umockdev_testbed_remove_device(impl_->bed, path.c_str());
}

void MockTablets::report(int number, std::span<const std::uint8_t> bytes) {
    impl_->send("/dev/hidraw" + std::to_string(number), bytes.data(), bytes.size());
}

void MockTablets::frame(int number, const std::vector<MockEvent>& events, std::int64_t time_us) {
    std::vector<input_event> raw;
    const auto add = [&](const MockEvent& e) {
        input_event r{};
        r.input_event_sec = time_us / 1'000'000;
        r.input_event_usec = time_us % 1'000'000;
        r.type = e.type;
        r.code = e.code;
        r.value = e.value;
        raw.push_back(r);
    };
    for (const MockEvent& e : events) add(e);
    add({EV_SYN, SYN_REPORT, 0});
    impl_->send(evdev_node(number), raw.data(), raw.size() * sizeof(input_event));
}

}  // namespace support

// What umockdev 0.17 leaves out, put before it: libinput wants devices that udev has finished with and nodes with the
// numbers of event nodes, and every reader of event nodes asks for monotonic times. The program exports these names.
template <typename Stat>
static void mend(int result, Stat* s) {
    if (result == 0 && S_ISCHR(s->st_mode) && major(s->st_rdev) == support::kPtyMajor) {
        s->st_rdev = makedev(support::kEventMajor, support::kFirstEventMinor);
    }
}

extern "C" {

int udev_device_get_is_initialized(void*) {
    return 1;
}

int fstat(int fd, struct stat* s) noexcept {
    static auto* real = reinterpret_cast<int (*)(int, struct stat*)>(dlsym(RTLD_NEXT, "fstat"));
    const int result = real(fd, s);
    mend(result, s);
    return result;
}

int fstat64(int fd, struct stat64* s) noexcept {
    static auto* real = reinterpret_cast<int (*)(int, struct stat64*)>(dlsym(RTLD_NEXT, "fstat64"));
    const int result = real(fd, s);
    mend(result, s);
    return result;
}

int ioctl(int fd, unsigned long request, ...) noexcept {
    va_list arguments;
    va_start(arguments, request);
    void* argument = va_arg(arguments, void*);
    va_end(arguments);
    if (request == EVIOCSCLOCKID) return 0;
    static auto* real = reinterpret_cast<int (*)(int, unsigned long, void*)>(dlsym(RTLD_NEXT, "ioctl"));
    return real(fd, request, argument);
}

}  // extern "C"
