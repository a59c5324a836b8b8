#include "core/geometry/space_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/geometry/segment.hpp"

namespace core {

double line_length(const SpaceLine& line) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += length(line[i + 1] - line[i]);
    return sum;
}

Vec3 place_along(const SpaceLine& line, double along) {
    if (along <= 0.0) return line.front();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double edge = length(line[i + 1] - line[i]);
        if (along <= edge) return edge > 0.0 ? line[i] + (line[i + 1] - line[i]) * (along / edge) : line[i];
        along -= edge;
    }
    return line.back();
}

SpaceLine resampled(const SpaceLine& line, int edges) {
    const double total = line_length(line), step = total / edges;
    SpaceLine out{line.front()};
    std::size_t i = 0;
    double passed = 0.0;  // up to line[i]
    for (int k = 1; k < edges; ++k) {
        const double along = step * k;
        double edge = length(line[i + 1] - line[i]);
        while (i + 2 < line.size() && passed + edge < along) {
            passed += edge;
            ++i;
            edge = length(line[i + 1] - line[i]);
        }
        const double t = edge > 0.0 ? std::clamp((along - passed) / edge, 0.0, 1.0) : 0.0;
        out.push_back(line[i] + (line[i + 1] - line[i]) * t);
    }
    out.push_back(line.back());
    return out;
}

void pull_ends(SpaceLine& line, Vec3 first, Vec3 last) {
    const double total = std::max(line_length(line), 1e-12);
    const Vec3 at_first = first - line.front(), at_last = last - line.back();
    double passed = 0.0;
    Vec3 before = line.front();
    for (Vec3& p : line) {
        passed += length(p - before);
        before = p;
        const double t = passed / total;
        p = p + at_first * (1.0 - t) + at_last * t;
    }
    line.front() = first;
    line.back() = last;
}

NearestOnLine nearest_on_line(const SpaceLine& line, Vec3 point) {
    NearestOnLine best{0.0, std::numeric_limits<double>::max(), {}};
    double passed = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double t = nearest_on_segment(line[i], line[i + 1], point), edge = length(line[i + 1] - line[i]);
        const Vec3 place = line[i] + (line[i + 1] - line[i]) * t;
        const double distance = length(point - place);
        if (distance < best.distance) best = {passed + t * edge, distance, place};
        passed += edge;
    }
    return best;
}

SplitLine split_line(const SpaceLine& line, double along) {
    SplitLine out;
    double passed = 0.0;
    std::size_t i = 0;
    out.before.push_back(line[0]);
    for (; i + 1 < line.size(); ++i) {
        const double edge = length(line[i + 1] - line[i]);
        if (passed + edge >= along || i + 2 == line.size()) break;
        passed += edge;
        out.before.push_back(line[i + 1]);
    }
    const Vec3 cut = place_along(line, along);
    if (length(cut - out.before.back()) > 1e-12 || out.before.size() == 1) out.before.push_back(cut);
    out.after.push_back(out.before.back());
    for (std::size_t k = i + 1; k < line.size(); ++k)
        if (k + 1 == line.size() || length(line[k] - out.after.back()) > 1e-12) out.after.push_back(line[k]);
    return out;
}

SpaceLine smoothed(const SpaceLine& line, double spacing, int passes) {
    SpaceLine out = resampled(line, std::max(2, static_cast<int>(std::lround(line_length(line) / spacing))));
    const auto filter = [&out](double weight) {
        SpaceLine next = out;
        for (std::size_t i = 1; i + 1 < out.size(); ++i)
            next[i] = out[i] + ((out[i - 1] + out[i + 1]) * 0.5 - out[i]) * weight;
        out = std::move(next);
    };
    for (int pass = 0; pass < passes; ++pass) {
        filter(0.5);
        filter(-0.53);
    }
    return out;
}

std::vector<double> sharp_turns(const SpaceLine& line, double angle, double reach) {
    const double total = line_length(line), step = 0.25 * reach;
    const int count = static_cast<int>(total / step);
    std::vector<double> turn(static_cast<std::size_t>(std::max(0, count + 1)), 0.0);
    for (int k = 1; k < count; ++k) {
        const double at = k * step;
        if (at < 0.5 * reach || at > total - 0.5 * reach) continue;
        const Vec3 here = place_along(line, at);
        const Vec3 in = normalised(here - place_along(line, at - reach)),
                   on = normalised(place_along(line, at + reach) - here);
        turn[static_cast<std::size_t>(k)] = std::acos(std::clamp(dot(in, on), -1.0, 1.0));
    }
    std::vector<double> out;
    for (int k = 1; k < count; ++k) {
        const double here = turn[static_cast<std::size_t>(k)];
        if (here < angle) continue;
        bool sharpest = true;
        for (int j = std::max(0, k - 6); j <= std::min(count, k + 6); ++j) {
            const double other = turn[static_cast<std::size_t>(j)];
            sharpest = sharpest && (other < here || (other == here && j >= k));
        }
        if (sharpest) out.push_back(k * step);
    }
    return out;
}

}  // namespace core
