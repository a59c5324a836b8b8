#include "input/pipeline/palm_rejection.hpp"

#include <algorithm>

namespace input {

std::vector<std::int64_t> PalmRejection::see(const PenSample& s) {
    const auto known = std::find(near_.begin(), near_.end(), s.device);
    if (!s.in_range) {
        if (known != near_.end()) forget(s.device, s.time_ns);
        return {};
    }
    if (known != near_.end()) return {};
    near_.push_back(s.device);
    std::vector<std::int64_t> taken_back;
    for (Touch& t : touches_) {
        if (!t.allowed || s.time_ns - t.began_ns > options_.before_ns) continue;
        t.allowed = false;
        taken_back.push_back(t.id);
    }
    return taken_back;
}

void PalmRejection::forget(std::uint32_t device, std::int64_t now_ns) {
    if (std::erase(near_, device) > 0) left_ns_ = now_ns;
}

bool PalmRejection::pen_near(std::int64_t now_ns) const {
    return !near_.empty() || (left_ns_ && now_ns - *left_ns_ <= options_.after_ns);
}

bool PalmRejection::touch_began(std::int64_t touch, std::int64_t now_ns) {
    touch_ended(touch);
    const bool allowed = !pen_near(now_ns);
    touches_.push_back({touch, now_ns, allowed});
    return allowed;
}

bool PalmRejection::touch_allowed(std::int64_t touch) const {
    const auto t = std::find_if(touches_.begin(), touches_.end(), [&](const Touch& x) { return x.id == touch; });
    return t != touches_.end() && t->allowed;
}

void PalmRejection::touch_ended(std::int64_t touch) {
    std::erase_if(touches_, [&](const Touch& t) { return t.id == touch; });
}

}  // namespace input
