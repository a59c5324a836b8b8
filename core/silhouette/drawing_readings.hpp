#pragma once
// Which silhouettes a drawing may mean, where one alone is doubtful: a crown whose trunk is open, a jaw left open, a
// gap that may be a mouth.
//
// The plain reading (closing.hpp) closes gaps up to 14 % of the drawing's diagonal, for wider ones are mostly meant.
// The wide reading closes gaps two and a half times as wide. Where the two show nearly the same object the plain one
// stands alone; where they differ, both are searched for and the better one counts. On 339 Quick-Draw drawings of the
// starter collection's classes the first five results have the right class in 71.1 % of the drawings instead of 69.6,
// the first ten in 77.6 instead of 76.1, the first in 49.6 instead of 49.3; on 267 of the Princeton models' classes in
// 29.6 as before, 43.4 instead of 41.9, 15.4 instead of 15.0. One drawing in ten is doubtful, one in seven of the
// latter; asking for less than 1 % makes more of them so, and finds no more. A reading that closes less finds fewer
// beside the plain one (48.7, 69.9 and 76.4 % on the former).

#include <vector>

#include "core/silhouette/closing.hpp"
#include "core/silhouette/live_silhouette.hpp"

namespace core {

/// The options of the wide reading.
[[nodiscard]] SilhouetteOptions wide_reading(const SilhouetteOptions& options);

/// Whether two readings of one drawing differ by more than 1 % of the plain one's pixels, or lie on rasters that
/// cannot be laid over each other pixel by pixel. Linear in pixels.
[[nodiscard]] bool is_doubtful(const Silhouette& plain, const Silhouette& wide);

/// The plain reading, and the wide one where the drawing is doubtful. One reading for a solid silhouette. Errors of
/// find_silhouette; twice its time.
[[nodiscard]] Result<std::vector<Silhouette>> drawing_readings(const Drawing& drawing,
                                                               const SilhouetteOptions& options = {});
[[nodiscard]] Result<std::vector<Silhouette>> drawing_readings(const GrayImage& page,
                                                               const SilhouetteOptions& options = {});

/// The readings of a drawing while it is drawn. Each of the two silhouettes follows the drawing when it is asked for;
/// one that was not asked for in a while has the more to catch up with.
class LiveReadings {
  public:
    explicit LiveReadings(const SilhouetteOptions& options = {}) : plain_(options), wide_(wide_reading(options)) {}
    /// The first of drawing_readings, at half the cost of all.
    [[nodiscard]] Result<Silhouette> plain(const Drawing& drawing);
    /// drawing_readings.
    [[nodiscard]] Result<std::vector<Silhouette>> all(const Drawing& drawing);

  private:
    LiveSilhouette plain_, wide_;
};

}  // namespace core
