#pragma once
// While a pen is near, touches are the hand that holds it. Works from the first moment: before any pen was seen touches
// count, and one that began just before the pen came is taken back.

#include <cstdint>
#include <optional>
#include <vector>

#include "input/pen_sample.hpp"
#include "input/pipeline/options.hpp"

namespace input {

class PalmRejection {
  public:
    explicit PalmRejection(const PalmOptions& options) : options_(options) {}

    /// Every sample of every pen. Gives the touches that turn out to be the hand's: what they drew is to be undone.
    [[nodiscard]] std::vector<std::int64_t> see(const PenSample& sample);
    /// The tablet is unplugged: none of its pens is near any more.
    void forget(std::uint32_t device, std::int64_t now_ns);

    /// Whether the touch may draw. A touch that may not stays so until it ends.
    [[nodiscard]] bool touch_began(std::int64_t touch, std::int64_t now_ns);
    [[nodiscard]] bool touch_allowed(std::int64_t touch) const;
    void touch_ended(std::int64_t touch);

  private:
    struct Touch {
        std::int64_t id = 0, began_ns = 0;
        bool allowed = true;
    };
    [[nodiscard]] bool pen_near(std::int64_t now_ns) const;

    PalmOptions options_;
    std::vector<std::uint32_t> near_;  ///< devices with a pen in range
    std::optional<std::int64_t> left_ns_;
    std::vector<Touch> touches_;
};

}  // namespace input
