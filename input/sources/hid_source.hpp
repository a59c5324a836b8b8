#pragma once
// Tablets by hidraw: their reports as they come, decoded by descriptor or data file. hidapi is only in hid_source.cpp.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "input/sources/device_reader.hpp"
#include "input/sources/udev.hpp"

namespace input {

struct HidSourceOptions {
    Clock clock = monotonic_clock();
    DeviceNumbers* numbers = nullptr;  ///< shared by all sources of the program; must outlive the source
    std::size_t queue_events = kQueueEvents;
    /// Whether this tablet is to be read by hidraw; asked for every HID interface that has a pen. Nothing: all of them.
    std::function<bool(const UdevNode&)> wanted{};
    bool hot_plug = true;        ///< false: only what is there at the start
    bool grab_siblings = false;  ///< take the event nodes that the same tablet has, so that it moves no pointer
    bool wake = true;            ///< read strings and write what the data file says
};

class HidSource final : public PenSource {
  public:
    /// Opens what is there; what cannot be opened becomes a problem in words.
    explicit HidSource(HidSourceOptions options);
    ~HidSource() override;
    HidSource(const HidSource&) = delete;
    HidSource& operator=(const HidSource&) = delete;

    void drain(std::vector<SourceEvent>& out) override;
    [[nodiscard]] TraceDevice device(std::uint32_t number) const override;
    [[nodiscard]] std::uint64_t lost() const override;
    [[nodiscard]] std::vector<std::string> take_problems() override;
    [[nodiscard]] std::string_view name() const override { return "hidraw"; }

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// A pen that a HID interface has.
struct HidPen {
    UdevNode node;
    std::string parser;
    PenAxes axes;
    bool reports_range = true;
};
/// All HID interfaces with a pen, opened or not. Strings are not asked, so ranges may be missing.
[[nodiscard]] std::vector<HidPen> list_hid_pens();

}  // namespace input
