#pragma once
// All tablets of the machine behind one source, each with one owner.
//
// A tablet whose pen the kernel's driver knows, with pressure, is read by its event node; any other by hidraw, and the
// event nodes that it has as a mouse are taken, so that nothing is drawn twice. A tablet that stops speaking while its
// pen is near is said to be asleep, see sleep_watch.hpp.

#include <memory>

#include "input/sources/evdev_source.hpp"
#include "input/sources/hid_source.hpp"
#include "input/sources/sleep_watch.hpp"

namespace input {

struct TabletHubOptions {
    Clock clock = monotonic_clock();
    DeviceNumbers* numbers = nullptr;  ///< shared by all sources of the program; must outlive the hub
    bool hot_plug = true;
    bool grab = false;  ///< take tablets away from the desktop while the program runs
};

/// Whether the kernel gives the device's pen as events with pressure. Read from sysfs: the same answer for whoever
/// asks, also before udev has finished with the nodes.
[[nodiscard]] bool kernel_knows_pen(const UdevNode& node);

class TabletHub final : public PenSource {
  public:
    explicit TabletHub(const TabletHubOptions& options);

    void drain(std::vector<SourceEvent>& out) override;
    [[nodiscard]] TraceDevice device(std::uint32_t number) const override;
    [[nodiscard]] std::uint64_t lost() const override;
    [[nodiscard]] std::vector<std::string> take_problems() override;
    [[nodiscard]] std::string_view name() const override { return "tablets"; }

  private:
    Clock clock_;
    EvdevSource events_;
    HidSource reports_;
    SleepWatch sleep_;
};

}  // namespace input
