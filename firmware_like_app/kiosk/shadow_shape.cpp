#include "firmware_like_app/kiosk/shadow_shape.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

#include "core/geometry/polygon.hpp"
#include "core/views/silhouette_render.hpp"

namespace app {
namespace {

constexpr double kLeastShared = 0.7;  // of the boxes of drawing and shadow; few parts place a shadow badly
constexpr int kView_px = 288, kMost_px = 400;
constexpr double kPlainTurn = 0.7;  // of the middles' spread that one turn explains; below, they are not turned

using Complex = std::complex<double>;

struct PartMass {
    Complex on_drawing, on_view;  // middles; the view's flipped and with y down
    double drawn = 0, seen = 0;   // areas
};

/// Area and centre of mass of a ring.
bool mass_of(const core::Polygon& ring, double& area, core::Point& middle) {
    double sum = 0;
    core::Point moment;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const core::Point a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
        const double c = core::cross(a, b);
        sum += c;
        moment = moment + (a + b) * (c / 3);
    }
    if (std::abs(sum) < 1e-12) return false;
    area = std::abs(sum) / 2;
    middle = ring[0] + moment * (1 / sum);
    return true;
}

std::vector<PartMass> masses_of(const FoundModel& model) {
    std::vector<PartMass> masses;
    for (const FoundPart& part : model.parts) {
        PartMass mass;
        core::Point drawn, seen;
        if (part.on_drawing.empty() || part.on_view.empty()) continue;
        if (!mass_of(part.on_drawing, mass.drawn, drawn) || !mass_of(part.on_view, mass.seen, seen)) continue;
        mass.on_drawing = {drawn.x, drawn.y};
        mass.on_view = {model.mirrored ? -seen.x : seen.x, -seen.y};
        masses.push_back(mass);
    }
    return masses;
}

/// Mean of a 3 x 3 neighbourhood, so that the edge is soft.
core::GrayImage softened(const core::BinaryImage& image) {
    core::GrayImage out(image.width, image.height);
    for (int y = 1; y + 1 < image.height; ++y) {
        for (int x = 1; x + 1 < image.width; ++x) {
            int sum = 0;
            for (int v = -1; v <= 1; ++v)
                for (int u = -1; u <= 1; ++u) sum += image.at(x + u, y + v);
            out.at(x, y) = static_cast<std::uint8_t>(sum * 255 / 9);
        }
    }
    return out;
}

/// Between the four pixels around; 0 outside.
double sample(const core::GrayImage& image, core::Point px) {
    const double x = px.x - 0.5, y = px.y - 0.5;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    if (x0 < 0 || y0 < 0 || x0 + 1 >= image.width || y0 + 1 >= image.height) return 0;
    const double fx = x - x0, fy = y - y0;
    const double above = image.at(x0, y0) * (1 - fx) + image.at(x0 + 1, y0) * fx;
    const double below = image.at(x0, y0 + 1) * (1 - fx) + image.at(x0 + 1, y0 + 1) * fx;
    return above * (1 - fy) + below * fy;
}

/// The box on the drawing of all that the image shows, a pixel wider.
ShadowShape box_of(const core::GrayImage& image, const ViewPlace& place) {
    double left = 1e300, right = -1e300, top = 1e300, bottom = -1e300;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.at(x, y) == 0) continue;
            const core::Point p = place.to_drawing(core::to_image_plane({x + 0.5, y + 0.5}, image.width));
            left = std::min(left, p.x);
            right = std::max(right, p.x);
            top = std::min(top, p.y);
            bottom = std::max(bottom, p.y);
        }
    }
    if (right < left) return {};
    const double pixel = place.scale / core::pixels_per_unit(image.width);
    return {{}, left - pixel, top - pixel, right - left + 2 * pixel, bottom - top + 2 * pixel};
}

/// What both boxes share, of all that either has.
double shared(const ShadowShape& shape, const Extent& drawing) {
    const double wide = std::min(shape.left + shape.width, drawing.right) - std::max(shape.left, drawing.left);
    const double high = std::min(shape.top + shape.height, drawing.bottom) - std::max(shape.top, drawing.top);
    const double both = std::max(wide, 0.0) * std::max(high, 0.0);
    const double all = shape.width * shape.height + drawing.width() * drawing.height() - both;
    return all > 0 ? both / all : 0;
}

/// The same view with the drawing's middle and diagonal.
ViewPlace laid_over(const ViewPlace& place, const ShadowShape& shape, const Extent& drawing) {
    ViewPlace out = place;
    const double ratio = std::hypot(drawing.width(), drawing.height()) / std::hypot(shape.width, shape.height);
    const core::Point middle{shape.left + shape.width / 2, shape.top + shape.height / 2};
    const core::Point wanted{(drawing.left + drawing.right) / 2, (drawing.top + drawing.bottom) / 2};
    out.scale *= ratio;
    out.origin = wanted + (place.origin - middle) * ratio;
    return out;
}

}  // namespace

core::Point ViewPlace::to_drawing(core::Point plane) const {
    const Complex p = std::polar(scale, turn_rad) * Complex(mirrored ? -plane.x : plane.x, -plane.y);
    return {p.real() + origin.x, p.imag() + origin.y};
}

core::Point ViewPlace::to_plane(core::Point drawing) const {
    const Complex p = Complex(drawing.x - origin.x, drawing.y - origin.y) / std::polar(scale, turn_rad);
    return {mirrored ? -p.real() : p.real(), -p.imag()};
}

std::optional<ViewPlace> place_of_view(const FoundModel& model) {
    const std::vector<PartMass> masses = masses_of(model);
    double drawn = 0, seen = 0;
    Complex middle_drawn, middle_seen;
    for (const PartMass& m : masses) {
        drawn += m.drawn;
        seen += m.seen;
        middle_drawn += m.drawn * m.on_drawing;
        middle_seen += m.seen * m.on_view;
    }
    if (drawn <= 0 || seen <= 0) return std::nullopt;
    middle_drawn /= drawn;
    middle_seen /= seen;
    Complex together;
    double spread_drawn = 0, spread_seen = 0;
    for (const PartMass& m : masses) {
        const Complex a = m.on_view - middle_seen, b = m.on_drawing - middle_drawn;
        together += m.drawn * b * std::conj(a);
        spread_drawn += m.drawn * std::norm(b);
        spread_seen += m.drawn * std::norm(a);
    }
    ViewPlace place;
    place.mirrored = model.mirrored;
    place.scale = std::sqrt(drawn / seen);
    if (std::abs(together) > kPlainTurn * std::sqrt(spread_drawn * spread_seen)) place.turn_rad = std::arg(together);
    const Complex origin = middle_drawn - std::polar(place.scale, place.turn_rad) * middle_seen;
    place.origin = {origin.real(), origin.imag()};
    return place;
}

ShadowShape shadow_shape(const FoundModel& model, const Extent& drawing) {
    std::optional<ViewPlace> place = place_of_view(model);
    if (!place || model.mesh == nullptr || model.mesh->empty()) return {};
    const core::GrayImage view = softened(core::render_silhouette(*model.mesh, model.camera, kView_px));
    ShadowShape shape = box_of(view, *place);
    if (shape.width <= 0 || shape.height <= 0) return {};
    if (shared(shape, drawing) < kLeastShared && drawing.width() + drawing.height() > 0) {
        place = laid_over(*place, shape, drawing);
        shape = box_of(view, *place);
    }
    // as fine as the view, but for very large boxes of one that is turned
    const double pixel =
        std::max({place->scale / core::pixels_per_unit(kView_px), shape.width / kMost_px, shape.height / kMost_px});
    core::GrayImage& out = shape.coverage;
    out = core::GrayImage(std::max(1, static_cast<int>(shape.width / pixel)),
                          std::max(1, static_cast<int>(shape.height / pixel)));
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const core::Point at{shape.left + (x + 0.5) * shape.width / out.width,
                                 shape.top + (y + 0.5) * shape.height / out.height};
            const double value = sample(view, core::to_image_px(place->to_plane(at), kView_px));
            out.at(x, y) = static_cast<std::uint8_t>(std::lround(value));
        }
    }
    return shape;
}

}  // namespace app
