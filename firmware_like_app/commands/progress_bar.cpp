#include "firmware_like_app/commands/progress_bar.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace app {

namespace {

/// "48 s", "3 min 20 s", "2 h 5 min".
std::string time_text(double seconds) {
    const auto s = static_cast<long>(std::ceil(seconds));
    if (s < 60) return std::to_string(s) + " s";
    if (s < 3600) return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
    return std::to_string(s / 3600) + " h " + std::to_string(s % 3600 / 60) + " min";
}

}  // namespace

std::string progress_line(std::size_t done, std::size_t total, const std::string& unit, double per_second) {
    constexpr std::size_t kWidth = 30;
    const std::size_t filled = total == 0 ? kWidth : kWidth * done / total;
    std::string line = "[" + std::string(filled, '#') + std::string(kWidth - filled, '.') + "] " +
                       std::to_string(done) + " of " + std::to_string(total) + " " + unit;
    if (!(per_second > 0.0)) return line;
    char rate[40];
    std::snprintf(rate, sizeof rate, per_second < 10.0 ? ", %.1f a second" : ", %.0f a second", per_second);
    line += rate;
    if (done < total) line += ", " + time_text(static_cast<double>(total - done) / per_second) + " left";
    return line;
}

ProgressBar::ProgressBar(std::string unit) : unit_(std::move(unit)), on_terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    if (drawn_) std::fprintf(stderr, "\n");
}

void ProgressBar::show(std::size_t done, std::size_t total) {
    if (!on_terminal_) return;
    constexpr double kPause_ms = 100.0, kRecent_ms = 10000.0;
    const double now = watch_.ms();
    if (now - drawn_ms_ < kPause_ms && done < total) return;
    drawn_ms_ = now;
    recent_.push_back({now, done});
    while (recent_.size() > 2 && now - recent_.front().ms > kRecent_ms) recent_.pop_front();
    const double since = (now - recent_.front().ms) / 1000.0;
    const double rate = since > 0.0 ? static_cast<double>(done - recent_.front().done) / since : 0.0;
    std::fprintf(stderr, "\r%s\033[K", progress_line(done, total, unit_, rate).c_str());
    drawn_ = true;
}

}  // namespace app
