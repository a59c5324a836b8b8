#include "core/match/part_ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parts/describe.hpp"
#include "core/skeleton/arc_measures.hpp"

namespace core {

namespace {

std::array<double, kFeatureCount> weights(const ShapeParameters& p) {
    return {p.w_area,      p.w_perimeter, p.w_eccentricity,   p.w_circularity,       p.w_rectangularity,
            p.w_convexity, p.w_solidity,  p.w_bending_energy, p.w_chord_length_ratio};
}

float norm_of(const RingPart& part) {
    float geometric = 0.0F, radial = 0.0F;
    for (const float f : part.weighted) geometric += f * f;
    for (const float r : part.signature) radial += r * r;
    return std::sqrt(geometric) + radial;
}

/// Average of the vectors from the middle of the part's chord to the samples of its arc.
Point direction_of(const ShapeDescriptor& shape, const Part& part) {
    const int n = static_cast<int>(shape.samples.size());
    const auto at = [&](int i) { return shape.samples[static_cast<std::size_t>(i % n)]; };
    const Point middle = midpoint(at(part.start_sample), at(part.end_sample));
    const int steps = part.start_sample < part.end_sample ? part.end_sample - part.start_sample
                                                          : part.end_sample - part.start_sample + n;
    Point sum;
    for (int k = 0; k <= steps; ++k) sum = sum + (at(part.start_sample + k) - middle);
    return sum * (1.0 / (steps + 1));
}

double angle_deg(Point a, Point b) {
    if (length(a) == 0.0 || length(b) == 0.0) return 0.0;
    return std::atan2(std::abs(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi;
}

OpenedRing opened_at(const PartRing& ring, int start) {
    const int n = ring.terminal_count;
    OpenedRing open;
    open.starts_at.push_back(0);
    for (int i = 0; i < n; ++i) {
        const int terminal = (start + i) % n;
        for (std::size_t p = 0; p < ring.parts.size(); ++p) {
            if (ring.parts[p].first != terminal || i + ring.parts[p].count > n) continue;
            open.members.push_back({static_cast<int>(p), i + ring.parts[p].count});
        }
        open.starts_at.push_back(static_cast<int>(open.members.size()));
    }
    open.norms_from.assign(static_cast<std::size_t>(n) + 1, 0.0F);
    for (int i = n - 1; i >= 0; --i) {
        open.norms_from[static_cast<std::size_t>(i)] = open.norms_from[static_cast<std::size_t>(i) + 1] +
                                                       ring.terminal_norm[static_cast<std::size_t>((start + i) % n)];
    }
    return open;
}

class RingBuilder {
  public:
    RingBuilder(const ShapeDescriptor& shape, const ShapeParameters& p)
        : shape_(shape), parameters_(p), arcs_(shape.samples) {
        for (const Part& part : shape.parts) directions_.push_back(direction_of(shape, part));
    }

    [[nodiscard]] PartRing ring(bool backwards) const {
        PartRing ring;
        ring.terminal_count = shape_.terminal_count;
        for (std::size_t i = 0; i < shape_.parts.size(); ++i) ring.parts.push_back(ring_part(i, backwards));
        ring.terminal_norm.assign(static_cast<std::size_t>(shape_.terminal_count), 0.0F);
        for (int t = 0; t < shape_.terminal_count; ++t) {
            const RingPart& terminal = ring.parts[static_cast<std::size_t>(t)];
            ring.terminal_norm[static_cast<std::size_t>(terminal.first)] = terminal.norm;
        }
        ring.stop_points = stop_points(shape_.parts, shape_.terminal_count, backwards);
        if (backwards) {
            for (int& t : ring.stop_points) t = shape_.terminal_count - 1 - t;
            std::sort(ring.stop_points.begin(), ring.stop_points.end());
        }
        for (const int start : ring.stop_points) ring.opened.push_back(opened_at(ring, start));
        for (std::size_t i = 0; i < shape_.parts.size(); ++i) {
            for (std::size_t j = 0; j < shape_.parts.size(); ++j) ring.inter.push_back(inter(i, j, backwards));
        }
        return ring;
    }

  private:
    [[nodiscard]] RingPart ring_part(std::size_t i, bool backwards) const {
        const Part& part = shape_.parts[i];
        RingPart out;
        out.part = static_cast<int>(i);
        out.count = part.terminal_count;
        const int n = shape_.terminal_count;
        out.first = backwards ? (2 * n - part.first_terminal - part.terminal_count) % n : part.first_terminal;
        const auto w = weights(parameters_);
        for (std::size_t k = 0; k < kFeatureCount; ++k) out.weighted[k] = static_cast<float>(w[k] * part.features[k]);
        out.signature = part.signature;
        if (backwards) std::reverse(out.signature.begin(), out.signature.end());
        out.norm = norm_of(out);
        return out;
    }

    /// Going clockwise, a part ends where its arc starts, and the gap to the next lies on the other side.
    [[nodiscard]] InterDistance inter(std::size_t i, std::size_t j, bool backwards) const {
        const Part& a = shape_.parts[i];
        const Part& b = shape_.parts[j];
        const int gap_from = backwards ? b.end_sample : a.end_sample;
        const int gap_to = backwards ? a.start_sample : b.start_sample;
        const auto at = [&](int s) { return shape_.samples[static_cast<std::size_t>(s)]; };
        const double bending = gap_from == gap_to ? 0.0 : arcs_.bending(gap_from, gap_to);
        const double whole = arcs_.bending();
        return {static_cast<float>(parameters_.w_d_e * distance(at(gap_from), at(gap_to)) / arcs_.perimeter()),
                static_cast<float>(parameters_.w_d_be * (whole > 0.0 ? 100.0 * bending / whole : 0.0)),
                static_cast<float>(parameters_.w_d_a * angle_deg(directions_[i], directions_[j]))};
    }

    const ShapeDescriptor& shape_;
    const ShapeParameters& parameters_;
    ArcMeasures arcs_;
    std::vector<Point> directions_;
};

}  // namespace

MatchableShape matchable(const ShapeDescriptor& shape, const ShapeParameters& parameters) {
    const RingBuilder builder(shape, parameters);
    return {builder.ring(false), builder.ring(true)};
}

float node_distance(const RingPart& a, const RingPart& b) {
    float geometric = 0.0F, radial = 0.0F;
    for (std::size_t k = 0; k < kFeatureCount; ++k) {
        const float d = a.weighted[k] - b.weighted[k];
        geometric += d * d;
    }
    for (std::size_t k = 0; k < kSignatureSize; ++k) {
        const float d = a.signature[k] - b.signature[k];
        radial += d * d;
    }
    return std::sqrt(geometric) + radial;
}

}  // namespace core
