#pragma once
// From the kernel's input events to pen reports.
//
//     input::EvdevPen pen(description);
//     for (const input::EvdevEvent& e : events)
//         if (pen.feed(e)) use(pen.report(), pen.axes(), e.time_ns);
//
// The numbers of types and codes are those of <linux/input-event-codes.h>.

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

#include "input/pen_axes.hpp"

namespace input {

struct EvdevEvent {
    std::int64_t time_ns = 0;
    std::uint16_t type = 0, code = 0;
    std::int32_t value = 0;
    friend bool operator==(const EvdevEvent&, const EvdevEvent&) = default;
};

/// What an event node says of itself.
struct EvdevDescription {
    struct Axis {
        std::int32_t min = 0, max = 0, resolution = 0, value = 0;
        friend bool operator==(const Axis&, const Axis&) = default;
    };
    std::array<std::optional<Axis>, 64> axes{};
    std::bitset<768> keys{};
    std::bitset<32> properties{};

    /// A tablet's pen: it has a position, and a tool or a stylus button that only tablets have.
    [[nodiscard]] bool is_pen() const;
    /// Those of its keys that matter to EvdevPen, ascending.
    [[nodiscard]] std::vector<std::uint16_t> pen_keys() const;
    friend bool operator==(const EvdevDescription&, const EvdevDescription&) = default;
};

class EvdevPen {
  public:
    /// The axes' current values and the keys in `pressed` are the state to start from: a pen may be down already.
    explicit EvdevPen(const EvdevDescription& description, const std::bitset<768>& pressed = {});

    /// True when a frame is complete and it said something of the pen. After SYN_DROPPED the frame is passed over and
    /// `lost_events()` is true until resync().
    bool feed(const EvdevEvent& event);

    [[nodiscard]] const PenReport& report() const { return report_; }
    [[nodiscard]] const PenAxes& axes() const { return axes_; }
    [[nodiscard]] bool lost_events() const { return lost_; }
    /// State asked anew from the kernel after lost events.
    void resync(const EvdevDescription& description, const std::bitset<768>& pressed);

  private:
    void set_axis(std::uint16_t code, std::int32_t value);
    void set_key(std::uint16_t code, bool on);
    void finish_frame();

    PenAxes axes_;
    PenReport report_;
    std::bitset<768> pressed_;
    bool has_tools_ = false, has_touch_ = false;
    bool touched_ = false;  ///< the frame said something of the pen
    bool lost_ = false, skipping_ = false;
};

}  // namespace input
