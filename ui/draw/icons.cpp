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

Path ring(double x, double y, double r) {
    constexpr double k = 0.5523;
    return Path({x + r, y})
        .curve({x + r, y + k * r}, {x + k * r, y + r}, {x, y + r})
        .curve({x - k * r, y + r}, {x - r, y + k * r}, {x - r, y})
        .curve({x - r, y - k * r}, {x - k * r, y - r}, {x, y - r})
        .curve({x + k * r, y - r}, {x + r, y - k * r}, {x + r, y});
}

std::vector<Polyline> eye_strokes() {
    return {Path({3, 16}).curve({7, 8.5}, {12, 7}, {16, 7}).curve({20, 7}, {25, 8.5}, {29, 16}),
            Path({3, 16}).curve({7, 23.5}, {12, 25}, {16, 25}).curve({20, 25}, {25, 23.5}, {29, 16}),
            ring(16, 16, 4.2)};
}

/// A torso from neck to hip.
std::vector<Polyline> torso_strokes() {
    return {Path({9, 3.5}).curve({9, 9}, {11.5, 11}, {11.5, 15}).curve({11.5, 19}, {7.5, 21}, {7.5, 28.5}),
            Path({23, 3.5}).curve({23, 9}, {20.5, 11}, {20.5, 15}).curve({20.5, 19}, {24.5, 21}, {24.5, 28.5})};
}

std::vector<Polyline> with(std::vector<Polyline> strokes, std::vector<Polyline> more) {
    strokes.insert(strokes.end(), more.begin(), more.end());
    return strokes;
}

/// Tools that make lines and regions.
std::vector<Polyline> make_drawing_tool(Icon icon) {
    switch (icon) {
        case Icon::OnPlane:
            return {Path({8, 9.5}).to(24, 4).to(24, 22.5).to(8, 28).close(), Path({12.5, 20.5}).to(19.5, 11.5)};
        case Icon::OnBody:
            return with(torso_strokes(), {Path({11.5, 15}).curve({13, 17.5}, {19, 17.5}, {20.5, 15})});
        case Icon::TemporaryPlane:
            return {Path({3, 23}).to(10.5, 16.5).to(29, 16.5).to(21.5, 23).close(), Path({16, 19.5}).to(16, 4.5),
                    Path({11.5, 9}).to(16, 4.5).to(20.5, 9), Path({13, 28}).to(19, 28)};
        case Icon::Corner:
            return {Path({5, 5}).to(12, 5).to(12, 12).to(5, 12).close(), Path({6.5, 7.3}).to(10.5, 7.3),
                    Path({6.5, 9.6}).to(10.5, 9.6), Path({12, 8.5}).to(28, 8.5), Path({8.5, 12}).to(8.5, 28)};
        case Icon::Cut:
            return {ring(8.5, 25, 3.6), ring(23.5, 25, 3.6), Path({10.8, 22.2}).to(22, 4),
                    Path({21.2, 22.2}).to(10, 4)};
        case Icon::Add:
            return {Path({5, 27}).to(5, 13).round({5, 5}, {13, 5}), Path({5, 27}).to(21, 27).to(21, 22),
                    Path({23.5, 6}).to(23.5, 16), Path({18.5, 11}).to(28.5, 11)};
        case Icon::Mirror:
            return {Path({12, 6}).to(12, 26).to(3.5, 26).close(),
                    Path({20, 6}).to(20, 26).to(28.5, 26).close(),
                    Path({16, 4}).to(16, 8),
                    Path({16, 12}).to(16, 16),
                    Path({16, 20}).to(16, 24),
                    Path({16, 27.5}).to(16, 29)};
        case Icon::Hole:
            return {Path({4, 6}).to(28, 6).to(28, 26).to(4, 26).close(), ring(16, 16, 5.4)};
        case Icon::Remove:
            return {Path({4, 9}).to(28, 9), Path({12, 9}).to(12, 4.5).to(20, 4.5).to(20, 9),
                    Path({7, 9}).to(8.5, 28).to(23.5, 28).to(25, 9), Path({13, 14}).to(13.6, 23),
                    Path({19, 14}).to(18.4, 23)};
        default:
            return {};
    }
}

/// Tools that change what is there.
std::vector<Polyline> make_shaping_tool(Icon icon) {
    switch (icon) {
        case Icon::Move:
            return {Path({16, 3.5}).to(16, 28.5),
                    Path({3.5, 16}).to(28.5, 16),
                    Path({12, 7.5}).to(16, 3.5).to(20, 7.5),
                    Path({12, 24.5}).to(16, 28.5).to(20, 24.5),
                    Path({7.5, 12}).to(3.5, 16).to(7.5, 20),
                    Path({24.5, 12}).to(28.5, 16).to(24.5, 20)};
        case Icon::Smooth:
            return {Path({3, 10}).to(7, 5.5).to(11, 11).to(15, 5).to(19, 11).to(23, 6).to(29, 10),
                    Path({3, 23.5}).curve({10, 18}, {22, 18}, {29, 23.5})};
        case Icon::Bump:
            return {Path({3, 22})
                        .curve({6, 22}, {6, 10}, {9.5, 10})
                        .curve({13, 10}, {12.5, 22}, {16, 22})
                        .curve({19.5, 22}, {19, 10}, {22.5, 10})
                        .curve({26, 10}, {26, 22}, {29, 22}),
                    Path({3, 28}).to(29, 28)};
        case Icon::Weld:
            return {ring(16, 16, 4), Path({3, 6}).to(13.2, 13.2), Path({3, 26}).to(13.2, 18.8),
                    Path({29, 6}).to(18.8, 13.2), Path({29, 26}).to(18.8, 18.8)};
        case Icon::Measure:
            return {Path({3, 11}).to(29, 11).to(29, 21).to(3, 21).close(), Path({8, 11}).to(8, 15.5),
                    Path({13.3, 11}).to(13.3, 17), Path({18.6, 11}).to(18.6, 15.5), Path({24, 11}).to(24, 17)};
        case Icon::Fabric:
            return {Path({5, 5}).to(27, 5).to(27, 27).to(5, 27).close(), Path({5, 12.3}).to(27, 12.3),
                    Path({5, 19.6}).to(27, 19.6), Path({12.3, 5}).to(12.3, 27), Path({19.6, 5}).to(19.6, 27)};
        case Icon::Quads:
            return {Path({10, 4}).to(22, 4).to(28.5, 27).to(3.5, 27).close(), Path({16, 4}).to(16, 27),
                    Path({8, 11}).to(24, 11), Path({5.8, 19}).to(26.2, 19)};
        case Icon::Drape:  // cloth over a rail
            return {Path({3, 5}).to(29, 5),
                    Path({7, 5})
                        .to(6, 16)
                        .round({5.4, 21}, {4, 26})
                        .round({7.5, 29}, {10, 26.5})
                        .round({13, 23.5}, {16, 26.5})
                        .round({19, 29}, {22, 26.5})
                        .round({25, 24}, {28, 26})
                        .round({26.6, 21}, {26, 16})
                        .to(25, 5),
                    Path({13, 10}).to(12.4, 20), Path({19, 10}).to(19.6, 20)};
        default:
            return {};
    }
}

std::vector<Polyline> make_garment(Icon icon) {
    switch (icon) {
        case Icon::Designs:
            return {Path({4, 4}).to(14, 4).to(14, 14).to(4, 14).close(),
                    Path({18, 4}).to(28, 4).to(28, 14).to(18, 14).close(),
                    Path({4, 18}).to(14, 18).to(14, 28).to(4, 28).close(),
                    Path({18, 18}).to(28, 18).to(28, 28).to(18, 28).close()};
        case Icon::Eye:
            return eye_strokes();
        case Icon::EyeShut:
            return with(eye_strokes(), {Path({5, 27}).to(27, 5)});
        case Icon::Tape:
            return {ring(13, 15, 8.5), ring(13, 15, 3.4), Path({13, 23.5}).to(28, 23.5).to(28, 18),
                    Path({24, 23.5}).to(24, 20.5)};
        case Icon::Export:
            return {Path({16, 20}).to(16, 4), Path({10.5, 9.5}).to(16, 4).to(21.5, 9.5),
                    Path({9, 14}).to(5, 14).to(5, 28).to(27, 28).to(27, 14).to(23, 14)};
        case Icon::Close:
            return {Path({7, 7}).to(25, 25), Path({25, 7}).to(7, 25)};
        case Icon::Up:
            return {Path({7, 20.5}).to(16, 11.5).to(25, 20.5)};
        case Icon::Down:
            return {Path({7, 11.5}).to(16, 20.5).to(25, 11.5)};
        case Icon::Layers:
            return {Path({16, 4}).to(29, 11).to(16, 18).to(3, 11).close(), Path({3, 16.5}).to(16, 23.5).to(29, 16.5),
                    Path({3, 22}).to(16, 29).to(29, 22)};
        default:
            break;
    }
    std::vector<Polyline> strokes = make_drawing_tool(icon);
    return strokes.empty() ? make_shaping_tool(icon) : strokes;
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
        default:
            return make_garment(icon);
    }
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
        std::array<std::vector<Polyline>, kIconCount> strokes;
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
