#include "firmware_like_app/kiosk/pin_lock.hpp"

#include <algorithm>
#include <utility>

namespace app {
namespace {

constexpr int kFreeTries = 3;
constexpr std::int64_t kFirstWait_s = 30, kLongestWait_s = 3600;
constexpr std::int64_t kSecond_us = 1'000'000;

}  // namespace

bool PinLock::enter(char digit, std::int64_t now_us) {
    if (digit < '0' || digit > '9' || wait_s(now_us) > 0) return false;
    just_wrong_ = false;
    entered_ += digit;
    if (entered_.size() < pin_.size()) return false;
    // every digit is looked at, whichever is wrong
    unsigned difference = 0;
    for (std::size_t i = 0; i < pin_.size(); ++i) difference |= static_cast<unsigned>(pin_[i] ^ entered_[i]);
    entered_.clear();
    if (difference == 0) {
        wrong_ = 0;
        return true;
    }
    just_wrong_ = true;
    ++wrong_;
    if (wrong_ >= kFreeTries) {
        const int doublings = std::min(wrong_ - kFreeTries, 10);
        free_us_ = now_us + std::min(kFirstWait_s << doublings, kLongestWait_s) * kSecond_us;
    }
    return false;
}

void PinLock::erase() {
    if (!entered_.empty()) entered_.pop_back();
}

std::int64_t PinLock::wait_s(std::int64_t now_us) const {
    return std::max<std::int64_t>(0, (free_us_ - now_us + kSecond_us - 1) / kSecond_us);
}

}  // namespace app
