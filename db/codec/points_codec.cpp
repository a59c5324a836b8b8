#include "db/codec/points_codec.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/point_grid.hpp"

namespace db {

namespace {

constexpr std::uint8_t kPolygonVersion = 1;
constexpr std::int64_t kMostSteps = 65535;
constexpr double kLargest = 1073741824.0;  // 2^30

using core::kCoarsestGrid;
using core::kFarthestGridLine;
using core::kFinestGrid;

/// One coordinate of the chain while it is read: sums up steps, and watches the size of the box.
class Axis {
  public:
    /// False when the step leads off the grid.
    [[nodiscard]] bool move(std::int64_t step) {
        if (step > 2 * kFarthestGridLine || step < -2 * kFarthestGridLine) return false;
        at_ += step;
        low_ = first_ ? at_ : std::min(low_, at_);
        high_ = first_ ? at_ : std::max(high_, at_);
        first_ = false;
        return low_ >= -kFarthestGridLine && high_ <= kFarthestGridLine && high_ - low_ <= kMostSteps;
    }
    [[nodiscard]] double value(int exponent) const { return std::ldexp(static_cast<double>(at_), exponent); }

  private:
    std::int64_t at_ = 0, low_ = 0, high_ = 0;
    bool first_ = true;
};

}  // namespace

core::Result<void> write_points(ByteWriter& out, const std::vector<core::Point>& points) {
    for (const core::Point& p : points) {
        if (!(std::abs(p.x) <= kLargest && std::abs(p.y) <= kLargest)) {
            return core::unexpected(core::ErrorCode::BadOutline,
                                    "a point of the outline is not finite or too far away");
        }
    }
    out.varint(points.size());
    if (points.empty()) return {};
    const int exponent = core::finest_grid(points, kMostSteps);
    out.u8(static_cast<std::uint8_t>(exponent - kFinestGrid));
    std::int64_t x = 0;
    std::int64_t y = 0;
    for (const core::Point& p : points) {
        const auto next_x = static_cast<std::int64_t>(core::grid_line(p.x, exponent));
        const auto next_y = static_cast<std::int64_t>(core::grid_line(p.y, exponent));
        out.svarint(next_x - x);
        out.svarint(next_y - y);
        x = next_x;
        y = next_y;
    }
    return {};
}

std::vector<core::Point> read_points(ByteReader& in) {
    std::vector<core::Point> points;
    const std::size_t count = in.count(2);
    if (count == 0) return points;
    const int exponent = in.u8() + kFinestGrid;
    if (exponent > kCoarsestGrid) in.fail("the grid of its points is unknown");
    points.reserve(count);
    Axis x;
    Axis y;
    for (std::size_t i = 0; i < count && !in.failed(); ++i) {
        const bool x_fits = x.move(in.svarint());
        const bool y_fits = y.move(in.svarint());
        if (!x_fits || !y_fits) in.fail("a point in it is out of range");
        points.push_back({x.value(exponent), y.value(exponent)});
        if (!(std::abs(points.back().x) <= kLargest && std::abs(points.back().y) <= kLargest)) {
            in.fail("a point in it is out of range");
        }
    }
    return points;
}

core::Result<Blob> encode_polygon(const core::Polygon& ring) {
    ByteWriter out(BlobKind::Polygon, kPolygonVersion);
    if (const core::Result<void> done = write_points(out, ring); !done) return core::unexpected(done.error());
    return out.take();
}

core::Result<core::Polygon> decode_polygon(BlobView blob) {
    ByteReader in(blob);
    core::Polygon ring;
    if (in.header(BlobKind::Polygon, kPolygonVersion) != 0) ring = read_points(in);
    if (const core::Result<void> done = in.finish(); !done) return core::unexpected(done.error());
    return ring;
}

}  // namespace db
