#include "ui/draw/lifted_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

#include "ui/draw/palette.hpp"
#include "ui/draw/tag_place.hpp"

namespace ui {
namespace {

constexpr int kMap = 256;
constexpr double kFinest = 0.06;  // longest edge, units of the normalised frame
constexpr std::size_t kMostTriangles = 15'000;
constexpr double kBehind = 0.035;  // this much behind what is seen still counts as seen
constexpr int kBlends = 2;
constexpr double kInwards = 4.0 / kMap;  // plane units, two pixels
constexpr std::uint8_t kOutside = 255;
constexpr std::uint8_t kClay = palette::kPartCount;
constexpr double kOthersShare = 0.25;

struct Corner {
    core::Vec3 place, normal;
};
using Triangle = std::array<Corner, 3>;

std::vector<Triangle> triangles_of(const ModelGeometry& geometry) {
    std::vector<Triangle> out(geometry.corners.size() / 27);
    for (std::size_t i = 0; i < out.size() * 3; ++i) {
        const float* f = geometry.corners.data() + i * 9;
        out[i / 3][i % 3] = {{f[0], f[1], f[2]}, {f[3], f[4], f[5]}};
    }
    return out;
}

Corner middle(const Corner& a, const Corner& b) {
    return {(a.place + b.place) * 0.5, core::normalised(a.normal + b.normal)};
}

/// Halves edges that are too long, each at its middle, whichever triangle it is of: so neighbours still meet.
std::vector<Triangle> cut_finely(const std::vector<Triangle>& coarse, double longest) {
    std::vector<Triangle> out, open = coarse;
    std::reverse(open.begin(), open.end());
    while (!open.empty()) {
        const Triangle t = open.back();
        open.pop_back();
        std::size_t edge = 0;
        double length = 0;
        for (std::size_t e = 0; e < 3; ++e) {
            const double l = core::length(t[(e + 1) % 3].place - t[e].place);
            if (l > length) {
                length = l;
                edge = e;
            }
        }
        if (length <= longest || out.size() + open.size() > 2 * kMostTriangles) {
            out.push_back(t);
            continue;
        }
        const Corner &a = t[edge], &b = t[(edge + 1) % 3], &c = t[(edge + 2) % 3];
        const Corner m = middle(a, b);
        open.push_back({m, b, c});
        open.push_back({a, m, c});
    }
    return out;
}

/// Corners at the same place are one vertex.
class Welder {
  public:
    std::uint32_t vertex(core::Vec3 p) {
        const auto grid = [](double v) { return static_cast<std::int64_t>(std::llround(v * 1e5)) & 0x1FFFFF; };
        const auto key = static_cast<std::uint64_t>(grid(p.x) << 42 | grid(p.y) << 21 | grid(p.z));
        const auto [entry, is_new] = ids_.emplace(key, static_cast<std::uint32_t>(places.size()));
        if (is_new) places.push_back(p);
        return entry->second;
    }
    std::vector<core::Vec3> places;

  private:
    std::unordered_map<std::uint64_t, std::uint32_t> ids_;
};

int pixel(double plane) {
    return std::clamp(static_cast<int>((plane + 1) * 0.5 * kMap), 0, kMap - 1);
}

/// Nearness of what the camera sees, pixel by pixel.
std::vector<float> nearness_map(const std::vector<Triangle>& triangles, const core::Camera& camera) {
    std::vector<float> map(kMap * kMap, -std::numeric_limits<float>::infinity());
    for (const Triangle& t : triangles) {
        std::array<core::Point, 3> p;
        std::array<double, 3> n;
        for (std::size_t i = 0; i < 3; ++i) {
            const core::Point plane = camera.project(t[i].place);
            p[i] = {(plane.x + 1) * 0.5 * kMap - 0.5, (1 - plane.y) * 0.5 * kMap - 0.5};
            n[i] = camera.nearness(t[i].place);
        }
        const double area = core::cross(p[1] - p[0], p[2] - p[0]);
        const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
        for (int y = std::max(0, static_cast<int>(std::floor(y0))); y <= std::min<double>(kMap - 1, std::ceil(y1));
             ++y) {
            for (int x = std::max(0, static_cast<int>(std::floor(x0))); x <= std::min<double>(kMap - 1, std::ceil(x1));
                 ++x) {
                float& seen = map[static_cast<std::size_t>(y * kMap + x)];
                const core::Point q{static_cast<double>(x), static_cast<double>(y)};
                double near = std::max({n[0], n[1], n[2]});
                if (std::abs(area) > 1e-9) {
                    const double a = core::cross(p[1] - q, p[2] - q) / area, b = core::cross(p[2] - q, p[0] - q) / area;
                    if (a < -1e-6 || b < -1e-6 || a + b > 1 + 1e-6) continue;
                    near = a * n[0] + b * n[1] + (1 - a - b) * n[2];
                }
                seen = std::max(seen, static_cast<float>(near));
            }
        }
    }
    return map;
}

using Links = std::vector<std::vector<std::uint32_t>>;

Links links_of(const std::vector<std::uint32_t>& vertex_of, std::size_t vertices) {
    Links links(vertices);
    for (std::size_t i = 0; i + 2 < vertex_of.size(); i += 3) {
        for (std::size_t e = 0; e < 3; ++e) {
            const std::uint32_t a = vertex_of[i + e], b = vertex_of[i + (e + 1) % 3];
            if (a == b) continue;
            links[a].push_back(b);
            links[b].push_back(a);
        }
    }
    return links;
}

/// Every vertex that has no label takes that of the nearest one along the mesh; those that reach none keep `fallback`.
void spread(std::vector<std::uint8_t>& labels, const std::vector<core::Vec3>& places, const Links& links,
            const std::vector<std::uint8_t>& fallback) {
    std::vector<double> far(labels.size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (std::uint32_t v = 0; v < labels.size(); ++v) {
        if (labels[v] == kOutside) continue;
        far[v] = 0;
        open.emplace(0.0, v);
    }
    while (!open.empty()) {
        const auto [distance, v] = open.top();
        open.pop();
        if (distance > far[v]) continue;
        for (const std::uint32_t w : links[v]) {
            const double d = distance + core::length(places[w] - places[v]);
            if (d >= far[w]) continue;
            far[w] = d;
            labels[w] = labels[v];
            open.emplace(d, w);
        }
    }
    for (std::size_t v = 0; v < labels.size(); ++v) {
        if (labels[v] == kOutside) labels[v] = fallback[v];
    }
}

using Weights = std::array<float, palette::kPartCount>;

std::vector<Weights> blended(const std::vector<std::uint8_t>& labels, const Links& links) {
    std::vector<Weights> weights(labels.size());
    for (std::size_t v = 0; v < labels.size(); ++v) {
        if (labels[v] < palette::kPartCount) weights[v][labels[v]] = 1;
    }
    for (int pass = 0; pass < kBlends; ++pass) {
        const std::vector<Weights> before = weights;
        for (std::size_t v = 0; v < weights.size(); ++v) {
            if (links[v].empty()) continue;
            const float share = 0.5F / static_cast<float>(links[v].size());
            for (float& w : weights[v]) w *= 0.5F;
            for (const std::uint32_t n : links[v]) {
                for (std::size_t c = 0; c < weights[v].size(); ++c) weights[v][c] += share * before[n][c];
            }
        }
    }
    return weights;
}

/// The seen vertex nearest to where the number stands in the view.
std::vector<LiftedAnchor> anchors_of(const std::vector<Triangle>& triangles,
                                     const std::vector<std::uint32_t>& vertex_of, const std::vector<std::uint8_t>& seen,
                                     const core::Camera& camera, const std::vector<PartRegion>& parts) {
    std::vector<LiftedAnchor> anchors;
    for (int colour = 0; colour < palette::kPartCount; ++colour) {
        const auto part =
            std::find_if(parts.begin(), parts.end(), [&](const PartRegion& p) { return p.colour == colour; });
        if (part == parts.end() || part->ring.empty()) continue;
        const core::Point place = tag_place(part->ring);
        LiftedAnchor anchor;
        anchor.colour = colour;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < vertex_of.size(); ++i) {
            if (seen[vertex_of[i]] != colour) continue;
            const Corner& corner = triangles[i / 3][i % 3];
            const double d = core::distance(camera.project(corner.place), place);
            if (d >= nearest) continue;
            nearest = d;
            anchor.place = corner.place;
            anchor.normal = core::dot(corner.normal, camera.direction) < 0 ? corner.normal * -1.0 : corner.normal;
        }
        if (std::isfinite(nearest)) anchors.push_back(anchor);
    }
    return anchors;
}

void write_geometry(const std::vector<Triangle>& triangles, ModelGeometry& geometry) {
    geometry.corners.resize(triangles.size() * 27);
    for (std::size_t i = 0; i < triangles.size() * 3; ++i) {
        const Corner& c = triangles[i / 3][i % 3];
        float* f = geometry.corners.data() + i * 9;
        const std::array<double, 6> values{c.place.x, c.place.y, c.place.z, c.normal.x, c.normal.y, c.normal.z};
        for (std::size_t k = 0; k < values.size(); ++k) f[k] = static_cast<float>(values[k]);
    }
}

}  // namespace

LiftedModel lift_parts(const ModelGeometry& geometry, const core::Camera& camera,
                       const std::vector<PartRegion>& parts) {
    LiftedModel model;
    std::vector<Triangle> triangles = triangles_of(geometry);
    const bool coloured = std::any_of(parts.begin(), parts.end(), [](const PartRegion& p) { return p.colour >= 0; });
    if (coloured) {
        const std::vector<Triangle> coarse = std::move(triangles);
        double longest = kFinest;
        do {
            triangles = cut_finely(coarse, longest);
            longest *= 1.2;
        } while (triangles.size() > kMostTriangles && triangles.size() > coarse.size());
    }
    Welder welder;
    model.vertex_of.reserve(triangles.size() * 3);
    for (const Triangle& t : triangles) {
        for (const Corner& c : t) model.vertex_of.push_back(welder.vertex(c.place));
    }
    write_geometry(triangles, model.geometry);
    model.weights.resize(welder.places.size());
    if (coloured) {
        const core::GrayImage map = part_labels(parts, kMap);
        const std::vector<float> nearness = nearness_map(triangles, camera);
        std::vector<core::Vec3> normals(welder.places.size());
        for (std::size_t i = 0; i < model.vertex_of.size(); ++i) {
            core::Vec3& sum = normals[model.vertex_of[i]];
            sum = sum + triangles[i / 3][i % 3].normal;
        }
        std::vector<std::uint8_t> projected(welder.places.size()), seen(welder.places.size(), kOutside);
        for (std::size_t v = 0; v < welder.places.size(); ++v) {
            // a little inwards: on the very edge of a part the next one's label is as near
            const core::Point p =
                camera.project(welder.places[v]) - camera.project(core::normalised(normals[v])) * kInwards;
            const int x = pixel(p.x), y = pixel(-p.y);
            projected[v] = map.at(x, y);
            const float front = nearness[static_cast<std::size_t>(y * kMap + x)];
            if (camera.nearness(welder.places[v]) < front - kBehind) continue;
            // what is seen between the parts is clay, as on the card, and takes no neighbour's colour
            seen[v] = projected[v] == kOutside ? kClay : projected[v];
        }
        const Links links = links_of(model.vertex_of, welder.places.size());
        std::vector<std::uint8_t> labels = seen;
        spread(labels, welder.places, links, projected);
        const std::vector<Weights> weights = blended(labels, links);
        for (std::size_t v = 0; v < weights.size(); ++v) {
            for (std::size_t c = 0; c < weights[v].size(); ++c) {
                model.weights[v][c] = static_cast<std::uint8_t>(std::lround(std::min(weights[v][c], 1.0F) * 255));
            }
        }
        model.anchors = anchors_of(triangles, model.vertex_of, seen, camera, parts);
    }
    recolour(model, std::nullopt);
    return model;
}

void recolour(LiftedModel& model, std::optional<int> only) {
    std::vector<std::array<float, 3>> colours(model.weights.size());
    for (std::size_t v = 0; v < colours.size(); ++v) {
        float clay = 1;
        std::array<float, 3> sum{};
        for (int c = 0; c < palette::kPartCount; ++c) {
            const Colour& part = palette::parts()[static_cast<std::size_t>(c)];
            float share =
                palette::kPartShare * static_cast<float>(model.weights[v][static_cast<std::size_t>(c)]) / 255.0F;
            if (only && *only != c) share *= static_cast<float>(kOthersShare);
            clay -= share;
            sum = {sum[0] + share * part.r, sum[1] + share * part.g, sum[2] + share * part.b};
        }
        clay = std::max(clay, 0.0F);
        colours[v] = {sum[0] + clay * palette::kClay.r, sum[1] + clay * palette::kClay.g,
                      sum[2] + clay * palette::kClay.b};
    }
    for (std::size_t i = 0; i < model.vertex_of.size(); ++i) {
        const std::array<float, 3>& c = colours[model.vertex_of[i]];
        std::copy(c.begin(), c.end(), model.geometry.corners.begin() + static_cast<std::ptrdiff_t>(i * 9 + 6));
    }
}

}  // namespace ui
