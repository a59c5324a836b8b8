#include "core/views/view_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace core {
namespace {

double or_least(double value) {
    return std::isfinite(value) ? value : -std::numeric_limits<double>::infinity();
}

/// Longest first, the lower camera first among equals.
bool comes_before(const ViewCandidate& a, const ViewCandidate& b) {
    const double la = or_least(a.skeletal_length), lb = or_least(b.skeletal_length);
    return la > lb || (la == lb && a.camera < b.camera);
}

}  // namespace

Result<ChosenViews> choose_views(std::vector<ViewCandidate> candidates, const Asymmetry& asymmetry, int longest) {
    if (candidates.empty()) {
        return unexpected(ErrorCode::BadMesh, "no view of the model gives a shape; choose a model with more extent");
    }
    std::sort(candidates.begin(), candidates.end(), comes_before);
    const std::size_t kept = std::min(candidates.size(), static_cast<std::size_t>(std::max(longest, 2)));
    ChosenViews chosen{candidates.front().camera, candidates.front().camera};
    double greatest = 0.0;
    for (std::size_t i = 1; i < kept; ++i) {
        const double value = or_least(asymmetry(candidates[i]));
        if (i == 1 || value > greatest || (value == greatest && candidates[i].camera < chosen.second)) {
            greatest = value;
            chosen.second = candidates[i].camera;
        }
    }
    return chosen;
}

}  // namespace core
