#include "ui/draw/icons.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {
namespace {

using core::Point;
using core::Polyline;

/// Builds a polyline from moves like a path of a vector drawing.
class Path {
  public:
    explicit Path(Point start) { points_.push_back(start); }
    Path& to(double x, double y) {
        points_.push_back({x, y});
        return *this;
    }
    Path& curve(Point a, Point b, Point end) {
        const Point start = points_.back();
        for (int i = 1; i <= 10; ++i) {
            const double t = i / 10.0, s = 1 - t;
            points_.push_back(start * (s * s * s) + a * (3 * s * s * t) + b * (3 * s * t * t) + end * (t * t * t));
        }
        return *this;
    }
    /// A quarter circle's worth of rounding through the corner point.
    Path& round(Point corner, Point end) {
        const Point start = points_.back();
        return curve(start + (corner - start) * 0.55, end + (corner - end) * 0.55, end);
    }
    Path& close() { return to(points_.front().x, points_.front().y); }
    operator Polyline() const { return points_; }  // NOLINT: reads as a path in the tables below

  private:
    Polyline points_;
};

std::vector<Polyline> undo_strokes() {
    return {Path({11, 6.5}).to(5.5, 12).to(11, 17.5),
            Path({5.5, 12}).to(19.5, 12).round({26, 12}, {26, 18.5}).round({26, 25}, {19.5, 25}).to(14, 25)};
}

std::vector<Polyline> mirrored(std::vector<Polyline> strokes) {
    for (Polyline& line : strokes) {
        for (Point& p : line) p.x = 32 - p.x;
    }
    return strokes;
}

std::vector<Polyline> hand_strokes() {
    // four fingers, then the palm with the thumb
    return {Path({12, 16}).to(12, 7.2).curve({12, 4.6}, {16, 4.6}, {16, 7.2}).to(16, 15),
            Path({16, 7}).to(16, 5.6).curve({16, 3}, {20, 3}, {20, 5.6}).to(20, 15),
            Path({20, 7.6}).curve({20, 5}, {24, 5}, {24, 7.6}).to(24, 16),
            Path({24, 11})
                .curve({24, 8.4}, {28, 8.4}, {28, 11})
                .to(28, 19)
                .curve({28, 26}, {24.5, 29}, {19.5, 29})
                .to(17.5, 29)
                .curve({13.5, 29}, {11.5, 27.5}, {9.5, 24.5})
                .to(4.8, 17.8)
                .curve({3.2, 15.2}, {6.6, 12.8}, {8.6, 15.2})
                .to(12, 19.4)
                .to(12, 12)};
}

std::vector<Polyline> make(Icon icon) {
    switch (icon) {
        case Icon::Pen:
            return {Path({5, 27})
                        .to(6.6, 20.2)
                        .to(20.6, 6.2)
                        .round({22.4, 4.4}, {24.2, 6.2})
                        .to(25.8, 7.8)
                        .round({27.6, 9.6}, {25.8, 11.4})
                        .to(11.8, 25.4)
                        .close(),
                    Path({18, 8.8}).to(23.2, 14)};
        case Icon::Eraser:
            return {Path({11.5, 27})
                        .to(5.2, 20.6)
                        .round({3.4, 18.8}, {5.2, 17})
                        .to(17.4, 4.8)
                        .round({19.2, 3}, {21, 4.8})
                        .to(27.2, 11)
                        .round({29, 12.8}, {27.2, 14.6})
                        .to(14.8, 27)
                        .close(),
                    Path({11.3, 10.9}).to(21.1, 20.7), Path({11.5, 27}).to(27, 27)};
        case Icon::Undo:
            return undo_strokes();
        case Icon::Redo:
            return mirrored(undo_strokes());
        case Icon::New:
            return {Path({6.5, 3.5}).to(19.5, 3.5).to(25.5, 9.5).to(25.5, 28.5).to(6.5, 28.5).close(),
                    Path({19.5, 3.5}).to(19.5, 9.5).to(25.5, 9.5), Path({16, 13.5}).to(16, 22.5),
                    Path({11.5, 18}).to(20.5, 18)};
        case Icon::Hand:
            return hand_strokes();
        case Icon::Collection:
            return {Path({16, 3}).to(28, 9.2).to(28, 22.2).to(16, 28.6).to(4, 22.2).to(4, 9.2).close(),
                    Path({4, 9.2}).to(16, 15.6).to(28, 9.2), Path({16, 15.6}).to(16, 28.6)};
        case Icon::Warning:
            return {Path({16, 4.5}).to(29, 27).to(3, 27).close(), Path({16, 12.5}).to(16, 19.5),
                    Path({16, 23.2}).to(16, 23.3)};
        case Icon::Tablet:
            return {Path({3, 8})
                        .round({3, 5}, {6, 5})
                        .to(26, 5)
                        .round({29, 5}, {29, 8})
                        .to(29, 24)
                        .round({29, 27}, {26, 27})
                        .to(6, 27)
                        .round({3, 27}, {3, 24})
                        .close(),
                    Path({8, 12}).to(8, 20), Path({12.5, 21}).to(24.5, 9)};
        case Icon::Back:
            return {Path({14, 7}).to(5, 16).to(14, 25), Path({5, 16}).to(27, 16)};
        case Icon::Check:
            return {Path({5, 17}).to(12.5, 24).to(27, 8)};
        case Icon::Minus:
            return {Path({8, 16}).to(24, 16)};
        case Icon::Turn:
            return {Path({12, 8}).to(5, 16).to(12, 24), Path({20, 8}).to(27, 16).to(20, 24)};
        case Icon::Plus:
            return {Path({8, 16}).to(24, 16), Path({16, 8}).to(16, 24)};
    }
    return {};
}

double distance_to_segment(Point p, Point a, Point b) {
    const Point along = b - a;
    const double squared = core::dot(along, along);
    const double t = squared > 0 ? std::clamp(core::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return core::distance(p, a + along * t);
}

}  // namespace

const std::vector<Polyline>& icon_strokes(Icon icon) {
    static const auto all = [] {
        std::array<std::vector<Polyline>, static_cast<std::size_t>(Icon::Turn) + 1> strokes;
        for (std::size_t i = 0; i < strokes.size(); ++i) strokes[i] = make(static_cast<Icon>(i));
        return strokes;
    }();
    return all[static_cast<std::size_t>(icon)];
}

core::GrayImage rasterise_icon(Icon icon, int size_px, double line_px) {
    core::GrayImage image(size_px, size_px);
    const double scale = size_px / 32.0;
    for (int y = 0; y < size_px; ++y) {
        for (int x = 0; x < size_px; ++x) {
            const Point p{(x + 0.5) / scale, (y + 0.5) / scale};
            double nearest = 1e9;
            for (const Polyline& line : icon_strokes(icon)) {
                for (std::size_t i = 1; i < line.size(); ++i) {
                    nearest = std::min(nearest, distance_to_segment(p, line[i - 1], line[i]));
                }
            }
            const double coverage = std::clamp(0.5 + line_px * 0.5 - nearest * scale, 0.0, 1.0);
            image.at(x, y) = static_cast<std::uint8_t>(std::lround(coverage * 255));
        }
    }
    return image;
}

}  // namespace ui
