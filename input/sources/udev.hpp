#pragma once
// The kernel's devices as udev lists them, and word of those that come and go. libudev is only in udev.cpp.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "input/device_identity.hpp"

namespace input {

/// One device node.
struct UdevNode {
    std::string subsystem;  ///< "hidraw" or "input"
    std::string node;       ///< "/dev/hidraw0"
    std::string syspath;
    std::string hid_path;  ///< of the HID interface that it belongs to; empty for a device that has none
    std::string usb_path;  ///< of the USB device around it; empty without
    std::string usb_node;  ///< its node under /dev/bus/usb
    bool tablet = false;   ///< of an event node: udev takes it for a tablet
    bool virtual_device = false;
    DeviceIdentity identity;
};

/// All nodes of a subsystem, by the names of their nodes. Empty without udev.
[[nodiscard]] std::vector<UdevNode> udev_nodes(const char* subsystem);
/// The report descriptor of a HID interface; empty when it cannot be read.
[[nodiscard]] std::vector<std::uint8_t> report_descriptor_of(const UdevNode& node);
/// Charge in per cent, where the tablet's HID interface reports one.
[[nodiscard]] std::optional<int> battery_of(const UdevNode& node);

/// Watches subsystems on a thread of its own.
class UdevMonitor {
  public:
    enum class Change { Added, Removed };
    using Callback = std::function<void(Change, const UdevNode&)>;

    /// `callback` is called on the monitor's thread. Without udev nothing is ever told.
    UdevMonitor(std::vector<std::string> subsystems, Callback callback);
    ~UdevMonitor();
    UdevMonitor(const UdevMonitor&) = delete;
    UdevMonitor& operator=(const UdevMonitor&) = delete;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// What to install where a node may not be opened: the line of the udev rules file that is missing, and where it goes.
[[nodiscard]] std::string missing_rule(const UdevNode& node);

/// Why a node could not be opened, for people, after an errno: the rule that is missing, or that another program holds
/// the tablet. Empty when the node has gone in the meantime, which is no problem.
[[nodiscard]] std::string opening_problem(const UdevNode& node, int why);

}  // namespace input
