#include "input/sources/udev.hpp"

#include <libudev.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/exchange/file_bytes.hpp"
#include "input/formats/text_lines.hpp"
#include "input/parse/report_descriptor.hpp"

namespace input {
namespace {

struct UdevFree {
    void operator()(udev* u) const { udev_unref(u); }
    void operator()(udev_device* d) const { udev_device_unref(d); }
    void operator()(udev_enumerate* e) const { udev_enumerate_unref(e); }
    void operator()(udev_monitor* m) const { udev_monitor_unref(m); }
};
template <typename T>
using UdevPtr = std::unique_ptr<T, UdevFree>;

std::string text(const char* s) {
    return s == nullptr ? std::string() : std::string(s);
}

std::uint16_t hex_number(std::string_view s) {
    return static_cast<std::uint16_t>(number_of_text<std::uint32_t>(s, 16).value_or(0) & 0xffffU);
}

/// "0003:0000256C:0000006E"
void read_hid_id(std::string_view id, DeviceIdentity& identity) {
    const std::size_t first = id.find(':'), second = id.find(':', first + 1);
    if (first == std::string_view::npos || second == std::string_view::npos) return;
    identity.bus = hex_number(id.substr(0, first));
    identity.vendor = hex_number(id.substr(first + 1, second - first - 1));
    identity.product = hex_number(id.substr(second + 1));
}

/// "3/56a/357/110", as input devices have it.
void read_product(std::string_view product, DeviceIdentity& identity) {
    std::array<std::uint16_t*, 4> parts{&identity.bus, &identity.vendor, &identity.product, &identity.version};
    for (std::uint16_t* part : parts) {
        const std::size_t slash = product.find('/');
        *part = hex_number(product.substr(0, slash));
        if (slash == std::string_view::npos) return;
        product.remove_prefix(slash + 1);
    }
}

std::string unquoted(std::string s) {
    if (s.size() >= 2 && s.front() == '"' && s.back() == '"') return s.substr(1, s.size() - 2);
    return s;
}

/// Reads what the parents say: udev gives them for as long as the child lives.
UdevNode describe(udev_device* d) {
    UdevNode n;
    n.subsystem = text(udev_device_get_subsystem(d));
    n.node = text(udev_device_get_devnode(d));
    n.syspath = text(udev_device_get_syspath(d));
    n.tablet = text(udev_device_get_property_value(d, "ID_INPUT_TABLET")) == "1";
    n.virtual_device = n.syspath.find("/devices/virtual/") != std::string::npos;
    if (udev_device* hid = udev_device_get_parent_with_subsystem_devtype(d, "hid", nullptr)) {
        n.hid_path = text(udev_device_get_syspath(hid));
        read_hid_id(text(udev_device_get_property_value(hid, "HID_ID")), n.identity);
        n.identity.name = text(udev_device_get_property_value(hid, "HID_NAME"));
        n.identity.serial = text(udev_device_get_property_value(hid, "HID_UNIQ"));
    }
    if (n.subsystem == "input") {
        if (udev_device* input = udev_device_get_parent_with_subsystem_devtype(d, "input", nullptr)) {
            read_product(text(udev_device_get_property_value(input, "PRODUCT")), n.identity);
            const std::string name = unquoted(text(udev_device_get_property_value(input, "NAME")));
            if (!name.empty()) n.identity.name = name;
        }
    }
    if (udev_device* interface = udev_device_get_parent_with_subsystem_devtype(d, "usb", "usb_interface")) {
        const auto number = number_of_text<std::uint8_t>(
            trimmed(text(udev_device_get_sysattr_value(interface, "bInterfaceNumber"))), 16);
        if (number) n.identity.interface = *number;
    }
    if (udev_device* usb = udev_device_get_parent_with_subsystem_devtype(d, "usb", "usb_device")) {
        n.usb_path = text(udev_device_get_syspath(usb));
        n.usb_node = text(udev_device_get_devnode(usb));
    }
    return n;
}

}  // namespace

std::vector<UdevNode> udev_nodes(const char* subsystem) {
    std::vector<UdevNode> nodes;
    const UdevPtr<udev> context(udev_new());
    if (!context) return nodes;
    const UdevPtr<udev_enumerate> list(udev_enumerate_new(context.get()));
    udev_enumerate_add_match_subsystem(list.get(), subsystem);
    udev_enumerate_scan_devices(list.get());
    for (udev_list_entry* e = udev_enumerate_get_list_entry(list.get()); e != nullptr;
         e = udev_list_entry_get_next(e)) {
        const UdevPtr<udev_device> d(udev_device_new_from_syspath(context.get(), udev_list_entry_get_name(e)));
        if (!d || udev_device_get_devnode(d.get()) == nullptr) continue;
        nodes.push_back(describe(d.get()));
    }
    std::sort(nodes.begin(), nodes.end(), [](const UdevNode& a, const UdevNode& b) {
        return a.node.size() != b.node.size() ? a.node.size() < b.node.size() : a.node < b.node;
    });
    return nodes;
}

std::vector<std::uint8_t> report_descriptor_of(const UdevNode& node) {
    if (node.hid_path.empty()) return {};
    std::ifstream file(node.hid_path + "/report_descriptor", std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    if (bytes.size() > kMaxDescriptorBytes) return {};
    return {bytes.begin(), bytes.end()};
}

std::optional<int> battery_of(const UdevNode& node) {
    if (node.hid_path.empty()) return std::nullopt;
    std::error_code failure;
    for (std::filesystem::directory_iterator it(node.hid_path + "/power_supply", failure), end; !failure && it != end;
         it.increment(failure)) {
        const core::Result<std::string> capacity = core::read_file_bytes((it->path() / "capacity").string(), 4096);
        if (!capacity) continue;
        std::string_view digits = *capacity;
        while (!digits.empty() && digits.back() == '\n') digits.remove_suffix(1);
        const auto value = number_of_text<int>(digits);
        if (value && *value >= 0 && *value <= 100) return value;
    }
    return std::nullopt;
}

struct UdevMonitor::Impl {
    UdevPtr<udev> context;
    UdevPtr<udev_monitor> monitor;
    Callback callback;
    std::jthread thread;

    void run(const std::stop_token& stop) const {
        pollfd fd{udev_monitor_get_fd(monitor.get()), POLLIN, 0};
        while (!stop.stop_requested()) {
            if (poll(&fd, 1, 100) <= 0) continue;
            while (const UdevPtr<udev_device> d{udev_monitor_receive_device(monitor.get())}) {
                if (udev_device_get_devnode(d.get()) == nullptr) continue;
                const std::string action = text(udev_device_get_action(d.get()));
                if (action == "add") callback(Change::Added, describe(d.get()));
                if (action == "remove") callback(Change::Removed, describe(d.get()));
            }
        }
    }
};

UdevMonitor::UdevMonitor(std::vector<std::string> subsystems, Callback callback) : impl_(std::make_unique<Impl>()) {
    impl_->callback = std::move(callback);
    impl_->context.reset(udev_new());
    if (!impl_->context) return;
    impl_->monitor.reset(udev_monitor_new_from_netlink(impl_->context.get(), "udev"));
    if (!impl_->monitor) return;
    for (const std::string& s : subsystems) {
        udev_monitor_filter_add_match_subsystem_devtype(impl_->monitor.get(), s.c_str(), nullptr);
    }
    if (udev_monitor_enable_receiving(impl_->monitor.get()) < 0) return;
    impl_->thread = std::jthread([this](const std::stop_token& stop) { impl_->run(stop); });
}

UdevMonitor::~UdevMonitor() {
    if (!impl_->thread.joinable()) return;
    impl_->thread.request_stop();
    impl_->thread.join();
}

std::string missing_rule(const UdevNode& node) {
    constexpr const char* kFile = "/etc/udev/rules.d/70-croquis-tablets.rules";
    std::array<char, 160> rule{};
    if (node.subsystem == "hidraw") {
        std::snprintf(
            rule.data(), rule.size(),
            "SUBSYSTEM==\"hidraw\", KERNELS==\"*:%04X:%04X.*\", MODE=\"0660\", GROUP=\"input\", TAG+=\"uaccess\"",
            node.identity.vendor, node.identity.product);
    } else {
        std::snprintf(
            rule.data(), rule.size(),
            "SUBSYSTEM==\"input\", ENV{ID_INPUT_TABLET}==\"1\", MODE=\"0660\", GROUP=\"input\", TAG+=\"uaccess\"");
    }
    return std::string("put this line into ") + kFile + " and plug the tablet in again: " + rule.data();
}

std::string opening_problem(const UdevNode& node, int why) {
    if (why == ENOENT || why == ENODEV || why == ENXIO) return {};
    const std::string what = node.identity.name.empty() ? node.node : node.node + " (" + node.identity.name + ")";
    if (why == EACCES || why == EPERM) return what + " may not be opened by this user; " + missing_rule(node);
    if (why == EBUSY) return what + " is held by another program; end that program";
    return what + " cannot be opened (" + std::strerror(why) + ")";
}

}  // namespace input
