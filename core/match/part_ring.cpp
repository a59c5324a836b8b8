#include "core/match/part_ring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/ring_start.hpp"
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

/// The parts that do not run over the cut before terminal `start`, by where they end, each with how many end before it
/// starts.
std::vector<OpenedRing::Member> members_from(const PartRing& ring, int start) {
    const int n = ring.terminal_count;
    std::vector<OpenedRing::Member> members;
    std::vector<int> ended(static_cast<std::size_t>(n) + 1, 0);  // parts that end at this position or before
    for (int end = 1; end <= n; ++end) {
        for (std::size_t p = 0; p < ring.parts.size(); ++p) {
            const int position = (ring.parts[p].first - start + n) % n;
            if (position + ring.parts[p].count != end) continue;
            members.push_back({static_cast<int>(p), ended[static_cast<std::size_t>(position)]});
        }
        ended[static_cast<std::size_t>(end)] = static_cast<int>(members.size());
    }
    return members;
}

void add_steps(const PartRing& ring, std::size_t first_from, OpenedRing& open) {
    for (std::size_t to = 0; to < open.members.size(); ++to) {
        const auto before = static_cast<std::size_t>(open.members[to].before);
        if (before <= first_from) continue;
        OpenedRing::Step step;
        step.d_e += std::numeric_limits<float>::infinity();
        for (std::size_t from = first_from; from < std::min(first_from + kWideLanes, before); ++from) {
            const InterDistance& d = ring.between(static_cast<std::size_t>(open.members[from].part),
                                                  static_cast<std::size_t>(open.members[to].part));
            step.d_e[from - first_from] = d.d_e;
            step.d_be[from - first_from] = d.d_be;
            step.d_a[from - first_from] = d.d_a;
        }
        open.steps.push_back(step);
        open.steps_to.push_back(static_cast<int>(to));
    }
}

OpenedRing opened_at(const PartRing& ring, int start) {
    OpenedRing open;
    open.members = members_from(ring, start);
    open.steps_from.push_back(0);
    for (std::size_t first = 0; first < open.members.size(); first += kWideLanes) {
        add_steps(ring, first, open);
        open.steps_from.push_back(static_cast<int>(open.steps.size()));
    }
    return open;
}

std::vector<PartGroup> grouped(const std::vector<RingPart>& parts) {
    std::vector<PartGroup> groups(lane_groups(parts.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) {
        PartGroup& group = groups[i / kLanes];
        for (std::size_t k = 0; k < kFeatureCount; ++k) group.weighted[k].v[i % kLanes] = parts[i].weighted[k];
        group.spared.v[i % kLanes] = parts[i].spared;
        for (std::size_t k = 0; k < kSignatureSize; ++k) group.signature[k].v[i % kLanes] = parts[i].signature[k];
    }
    return groups;
}

/// Norms are added up in steps of 2^-11, so that sums below 2^13 are exact: what one pair of equal parts after the
/// other spares adds up to all norms, and the distance of equal shapes to 0.
float in_steps(float norm) {
    constexpr float kSteps = 2048.0F;
    return std::round(norm * kSteps) / kSteps;
}

void fill_norms(PartRing& ring) {
    const int n = ring.terminal_count;
    ring.terminal_norm.assign(static_cast<std::size_t>(n), 0.0F);
    for (int t = 0; t < n; ++t) {
        const RingPart& terminal = ring.parts[static_cast<std::size_t>(t)];
        ring.terminal_norm[static_cast<std::size_t>(terminal.first)] = terminal.norm;
    }
    const auto norm = [&](int t) { return in_steps(ring.terminal_norm[static_cast<std::size_t>(t % n)]); };
    for (int t = 0; t < n; ++t) ring.norms += norm(t);
    for (RingPart& part : ring.parts) {
        for (int t = 0; t < part.count; ++t) part.spared += norm(part.first + t);
    }
}

class RingBuilder {
  public:
    RingBuilder(const ShapeDescriptor& shape, const ShapeParameters& p)
        : shape_(shape), parameters_(p), arcs_(shape.samples) {
        for (const Part& part : shape.parts) directions_.push_back(direction_of(shape, part));
        const double start = ellipse_end(shape.samples);
        outline_ = outline_profile(started_at(shape.samples, start));
        start_ = static_cast<OutlinePlace>(std::lround(start * 65536.0));
    }

    [[nodiscard]] PartRing ring(bool backwards) const {
        PartRing ring;
        ring.terminal_count = shape_.terminal_count;
        for (std::size_t i = 0; i < shape_.parts.size(); ++i) ring.parts.push_back(ring_part(i, backwards));
        fill_norms(ring);
        ring.groups = grouped(ring.parts);
        ring.outline = backwards ? mirrored(outline_) : outline_;
        ring.stop_points = stop_points(shape_.parts, shape_.terminal_count, backwards);
        if (backwards) {
            for (int& t : ring.stop_points) t = shape_.terminal_count - 1 - t;
            std::sort(ring.stop_points.begin(), ring.stop_points.end());
        }
        for (std::size_t i = 0; i < shape_.parts.size(); ++i) {
            for (std::size_t j = 0; j < shape_.parts.size(); ++j) ring.inter.push_back(inter(i, j, backwards));
        }
        for (const int start : ring.stop_points) ring.opened.push_back(opened_at(ring, start));
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
        out.from = place(backwards ? part.end_sample : part.start_sample, backwards);
        out.to = place(backwards ? part.start_sample : part.end_sample, backwards);
        const auto w = weights(parameters_);
        for (std::size_t k = 0; k < kFeatureCount; ++k) out.weighted[k] = static_cast<float>(w[k] * part.features[k]);
        out.signature = part.signature;
        if (backwards) std::reverse(out.signature.begin(), out.signature.end());
        out.norm = norm_of(out);
        return out;
    }

    /// Places wrap round: a full turn is none.
    [[nodiscard]] OutlinePlace place(int sample, bool backwards) const {
        const double share = sample == 0 ? 0.0 : arcs_.length(0, sample) / arcs_.perimeter();
        const auto forwards = static_cast<OutlinePlace>(std::lround(share * 65536.0) - start_);
        return backwards ? static_cast<OutlinePlace>(-forwards) : forwards;
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
    OutlinePlace start_ = 0;  // where the profile starts, from the first sample on
    OutlineProfile outline_;
};

}  // namespace

MatchableShape matchable(const ShapeDescriptor& shape, const ShapeParameters& parameters) {
    const RingBuilder builder(shape, parameters);
    MatchableShape out{builder.ring(false), builder.ring(true), {}};
    out.paired = paired_heights(out.forwards.outline);
    return out;
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
