#pragma once
// Ink on a raster with the squared distance of every pixel to it, kept up to date while ink is added.

#include <cstdint>
#include <vector>

#include "core/silhouette/bit_image.hpp"

namespace core {

/// A pixel of a raster.
struct RasterPixel {
    int x = 0, y = 0;
};

class DistanceRaster {
  public:
    /// Distances up to `reach` are exact, larger ones only known to be larger. reach at most 127. The width is rounded
    /// up to a multiple of 64. Ink keeps `reach` free pixels on every side.
    DistanceRaster(int width, int height, int reach);

    void clear();
    /// Marks pixels x0 … x1 of a row as ink; distances are stale until settle() or settle_all(). Inside the raster.
    void ink(int y, int x0, int x1);
    /// Brings distances up to date about the ink that is new since the last call. Returns its pixels that have paper
    /// beside them, from which alone distances were lowered. Linear in these times reach².
    const std::vector<RasterPixel>& settle();
    /// The same for the whole raster, whatever is new, after clear(). Linear in reach and the pixels of the ink's box.
    void settle_all();

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] int squared(int x, int y) const { return distance2_[index(x, y)]; }
    /// One bit a pixel: its squared distance is above `limit`, which is below reach².
    void farther_than(int limit, BitImage& out) const;
    /// Whether a pixel of the run lies at least that far from ink.
    [[nodiscard]] bool any_at_least(int y, int x0, int x1, int limit) const;

  private:
    using Cell = std::int16_t;
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y + pad_) * static_cast<std::size_t>(stride_) +
               static_cast<std::size_t>(x + pad_);
    }
    void lower_about(RasterPixel p);
    void column_pass(int top, int bottom);
    void row_pass(int top, int bottom);

    int width_, height_, reach_, pad_, stride_;
    std::vector<Cell> distance2_;  ///< with pad_ cells on every side that nobody reads
    std::vector<Cell> squares_;    ///< of -pad_ … pad_
    std::vector<int> chord_;       ///< half the chord of the disc of radius reach, by the distance of its row
    std::vector<RasterPixel> fresh_, edge_;
    std::vector<Cell> line_;           ///< one row of vertical distances, squared
    std::vector<std::uint8_t> above_;  ///< vertical distance to ink, capped
};

}  // namespace core
