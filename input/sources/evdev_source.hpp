#pragma once
// Tablets by their event nodes, as the kernel's drivers decode them. Frames go into the trace as they came.
//
// The nodes are read themselves, without libinput between: libinput averages a tablet's last places and hides the raw
// frames, and both would be in every stroke for good. libinput_source.hpp is there for comparison.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "input/sources/device_reader.hpp"
#include "input/sources/udev.hpp"

namespace input {

struct EvdevSourceOptions {
    Clock clock = monotonic_clock();
    DeviceNumbers* numbers = nullptr;  ///< shared by all sources of the program; must outlive the source
    std::size_t queue_events = kQueueEvents;
    std::function<bool(const UdevNode&)> wanted{};  ///< nothing: every pen
    bool hot_plug = true;
    bool grab = false;         ///< nobody else hears of these pens while they are open, so that no pointer moves
    bool kernel_times = true;  ///< the kernel's time of each frame, where it tells monotonic time; else that of reading
};

class EvdevSource final : public PenSource {
  public:
    explicit EvdevSource(EvdevSourceOptions options);
    ~EvdevSource() override;
    EvdevSource(const EvdevSource&) = delete;
    EvdevSource& operator=(const EvdevSource&) = delete;

    void drain(std::vector<SourceEvent>& out) override;
    [[nodiscard]] TraceDevice device(std::uint32_t number) const override;
    [[nodiscard]] std::uint64_t lost() const override;
    [[nodiscard]] std::vector<std::string> take_problems() override;
    [[nodiscard]] std::string_view name() const override { return "evdev"; }

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// What libwacom knows of a tablet; nothing for one that it does not know.
struct TabletFacts {
    std::string name;
    double width_mm = 0.0, height_mm = 0.0;  ///< 0 unknown
    int buttons = 0;                         ///< on the tablet, not the pen
    bool on_screen = false;
};
[[nodiscard]] std::optional<TabletFacts> tablet_facts(const DeviceIdentity& device);

/// A pen that an event node has.
struct EvdevPenNode {
    UdevNode node;
    PenAxes axes;
    bool readable = true;  ///< false: the axes could not be asked
};
[[nodiscard]] std::vector<EvdevPenNode> list_evdev_pens();

}  // namespace input
