#pragma once
// A trace played again as if its tablets were there: in its own time, faster, or as fast as it goes, on a clock that
// the caller holds.

#include <cstdint>
#include <map>
#include <vector>

#include "input/sources/pen_source.hpp"

namespace input {

struct TraceSourceOptions {
    Clock clock = monotonic_clock();
    double speed = 1.0;        ///< recorded seconds per second of the clock; > 0
    bool paced = true;         ///< false: the first drain gives everything
    bool decode_again = true;  ///< samples from the raw records by today's decoders; false: as they were recorded
};

/// Devices keep their numbers and times: recording a replay gives the same trace. Deterministic.
class TraceSource final : public PenSource {
  public:
    TraceSource(const Trace& trace, TraceSourceOptions options);

    void drain(std::vector<SourceEvent>& out) override;
    [[nodiscard]] TraceDevice device(std::uint32_t number) const override;
    [[nodiscard]] std::uint64_t lost() const override { return 0; }
    [[nodiscard]] std::string_view name() const override { return "replay"; }

    [[nodiscard]] bool finished() const { return next_ == events_.size(); }
    /// When the next event is due on the clock; only before finished() and after the first drain().
    [[nodiscard]] std::int64_t due_ns() const;

  private:
    void make_events(const Trace& trace);

    TraceSourceOptions options_;
    std::vector<SourceEvent> events_;
    std::map<std::uint32_t, TraceDevice> devices_;
    std::size_t next_ = 0;
    std::int64_t start_ns_ = 0;
    bool started_ = false;
};

}  // namespace input
