#pragma once
// Steps that look at one device's samples before anything is made of them. Each remembers what it has to and no more;
// each can be left out.

#include <cstdint>
#include <optional>

#include "input/pen_sample.hpp"
#include "input/pipeline/options.hpp"

namespace input {

/// Takes out samples that say what the one before said, and samples that are older than the one before. Counts both.
class OrderGuard {
  public:
    /// Nothing when the sample is to be left out.
    [[nodiscard]] std::optional<PenSample> pass(const PenSample& sample);
    [[nodiscard]] std::uint64_t duplicates() const { return duplicates_; }
    [[nodiscard]] std::uint64_t out_of_order() const { return out_of_order_; }

  private:
    std::optional<PenSample> last_;
    std::uint64_t duplicates_ = 0, out_of_order_ = 0;
};

/// A pen that leaves without a word: after a silence it has left.
class ProximityTimeout {
  public:
    /// `reports_range`: the device says itself when its pen leaves, so the longer time counts.
    ProximityTimeout(const ProximityOptions& options, bool reports_range)
        : limit_ns_(reports_range ? options.lost_ns : options.silence_ns) {}

    void see(const PenSample& sample) { last_ = sample; }
    /// Once after the time has run out: the sample that says the pen is gone, at the moment when it ran out.
    [[nodiscard]] std::optional<PenSample> expire(std::int64_t now_ns);
    /// When to ask again; nothing while no pen is near.
    [[nodiscard]] std::optional<std::int64_t> due_ns() const;

  private:
    std::int64_t limit_ns_;
    std::optional<PenSample> last_;
};

/// Decides whether the tip draws: what the device says, but with pressure only from `down` on and until below `up`.
class TipThreshold {
  public:
    explicit TipThreshold(const TipOptions& options) : options_(options) {}
    [[nodiscard]] PenSample apply(PenSample sample);

  private:
    TipOptions options_;
    bool down_ = false;
};

/// Pressure through the curve; a sample without pressure stays without.
[[nodiscard]] PenSample apply_pressure(PenSample sample, const PressureOptions& options);

}  // namespace input
