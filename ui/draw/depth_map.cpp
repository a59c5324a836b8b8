#include "ui/draw/depth_map.hpp"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr float kNothing = -1e9F;

}  // namespace

void DepthMap::clear(const FigureCamera& camera, SizePx size, int cell_px) {
    camera_ = camera;
    cell_px_ = std::max(1, cell_px);
    width_ = (size.width + cell_px_ - 1) / cell_px_;
    height_ = (size.height + cell_px_ - 1) / cell_px_;
    near_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), kNothing);
}

DepthMap::Corner DepthMap::corner(core::Vec3 place) const {
    const core::Point px = camera_.to_px(place);
    return {px.x / cell_px_, px.y / cell_px_, camera_.nearness(place)};
}

/// Every cell whose middle the triangle covers keeps the nearest of what was there. Nearness is not linear in the
/// picture of a view with an eye, but over one triangle of a figure the difference is far below a millimetre.
void DepthMap::fill(const Corner& a, const Corner& b, const Corner& c) {
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (std::abs(area) < 1e-9) return;
    const int x0 = std::max(0, static_cast<int>(std::floor(std::min({a.x, b.x, c.x}) - 0.5)));
    const int x1 = std::min(width_ - 1, static_cast<int>(std::ceil(std::max({a.x, b.x, c.x}) - 0.5)));
    const int y0 = std::max(0, static_cast<int>(std::floor(std::min({a.y, b.y, c.y}) - 0.5)));
    const int y1 = std::min(height_ - 1, static_cast<int>(std::ceil(std::max({a.y, b.y, c.y}) - 0.5)));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            const double u = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) / area;
            const double v = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / area;
            if (u < -1e-9 || v < -1e-9 || u + v > 1 + 1e-9) continue;
            const double near = a.near + u * (b.near - a.near) + v * (c.near - a.near);
            float& cell =
                near_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
            cell = std::max(cell, static_cast<float>(near));
        }
    }
}

void DepthMap::add(const std::vector<core::Vec3>& vertices,
                   const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<Corner> corners;
    corners.reserve(vertices.size());
    for (const core::Vec3& v : vertices) corners.push_back(corner(v));
    for (const auto& t : triangles) fill(corners[t[0]], corners[t[1]], corners[t[2]]);
}

void DepthMap::add(const std::vector<core::Vec3>& vertices, const std::vector<std::array<std::uint32_t, 4>>& quads) {
    std::vector<Corner> corners;
    corners.reserve(vertices.size());
    for (const core::Vec3& v : vertices) corners.push_back(corner(v));
    for (const auto& q : quads) {
        fill(corners[q[0]], corners[q[1]], corners[q[2]]);
        fill(corners[q[0]], corners[q[2]], corners[q[3]]);
    }
}

bool DepthMap::hides(core::Vec3 place, double slack_cm) const {
    const Corner at = corner(place);
    const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return false;
    const float near =
        near_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    return near > at.near + slack_cm;
}

bool DepthMap::covered(core::Point px, double reach_px) const {
    const double cx = px.x / cell_px_, cy = px.y / cell_px_, r = std::max(0.5, reach_px / cell_px_);
    const int x0 = std::max(0, static_cast<int>(std::floor(cx - r))),
              x1 = std::min(width_ - 1, static_cast<int>(cx + r));
    const int y0 = std::max(0, static_cast<int>(std::floor(cy - r))),
              y1 = std::min(height_ - 1, static_cast<int>(cy + r));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            if (std::hypot(x + 0.5 - cx, y + 0.5 - cy) > r + 0.71) continue;
            if (near_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] >
                kNothing)
                return true;
        }
    }
    return false;
}

}  // namespace ui
