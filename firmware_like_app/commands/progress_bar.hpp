#pragma once
// One line on standard error that says how far long work is, at what rate and for how long still.

#include <cstddef>
#include <deque>
#include <string>

#include "firmware_like_app/collection/stopwatch.hpp"

namespace app {

/// The line: a bar, numbers, and at a rate above 0 the rate and the time left; about 90 columns.
[[nodiscard]] std::string progress_line(std::size_t done, std::size_t total, const std::string& unit,
                                        double per_second);

/// Draws over the line before, at most ten times a second, and only where standard error is a terminal.
class ProgressBar {
  public:
    explicit ProgressBar(std::string unit);
    ~ProgressBar();  ///< ends the line
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(std::size_t done, std::size_t total);

  private:
    struct Moment {
        double ms = 0.0;
        std::size_t done = 0;
    };
    std::string unit_;
    bool on_terminal_;
    bool drawn_ = false;
    Stopwatch watch_;
    double drawn_ms_ = -1e9;
    std::deque<Moment> recent_;
};

}  // namespace app
