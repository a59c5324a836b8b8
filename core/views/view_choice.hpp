#pragma once
// Which two of a model's views are kept (thesis 7.1.2): the one that hides least, and the least symmetric one.

#include <functional>
#include <vector>

#include "core/base/result.hpp"

namespace core {

/// N of the thesis, out of its 50 views. Where only one camera of each opposite pair is described (cameras.hpp), both
/// views of a pair have equal lengths up to a pixel, so that the thesis's 10 views are about 5 of these.
inline constexpr int kLongestViews = 10;

struct ViewCandidate {
    int camera = 0;                ///< its number, unique among the candidates
    double skeletal_length = 0.0;  ///< any unit, the same for all candidates of a model
};

struct ChosenViews {
    int first = 0;   ///< camera with the longest skeleton: the fewest parts hidden
    int second = 0;  ///< of the other candidates among the N longest, the camera with the least symmetric silhouette

    friend bool operator==(const ChosenViews&, const ChosenViews&) = default;
};

/// How far the candidate's silhouette is from its own reversal; larger is less symmetric.
using Asymmetry = std::function<double(const ViewCandidate&)>;

/// Chooses among the views that could be described, in any order; views without a usable silhouette are left out by the
/// caller. A length or asymmetry that is not finite counts as the least. Equal lengths or asymmetries go to the lower
/// camera number, so that the order of the candidates does not matter. One candidate is chosen twice; none gives
/// BadMesh. `asymmetry` is asked once for each of the `longest` longest but the first, in descending order of length;
/// so it may be slow. With `longest` below 2 the runner-up in length still is asked, there being a second view to
/// choose. Time n log n plus the calls.
[[nodiscard]] Result<ChosenViews> choose_views(std::vector<ViewCandidate> candidates, const Asymmetry& asymmetry,
                                               int longest = kLongestViews);

}  // namespace core
