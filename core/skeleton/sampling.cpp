#include "core/skeleton/sampling.hpp"

#include <algorithm>
#include <numeric>

#include "core/geometry/polygon.hpp"

namespace core {

namespace {

/// The contour from one corner to the next.
struct Stretch {
    Polyline chain;
    double length = 0.0;
    double cornerity = 0.0;
    int samples = 0;
};

std::vector<int> strongest(std::vector<int> corners, const std::vector<double>& cornerity, std::size_t limit) {
    if (corners.size() <= limit) return corners;
    std::stable_sort(corners.begin(), corners.end(), [&](int a, int b) {
        return cornerity[static_cast<std::size_t>(a)] > cornerity[static_cast<std::size_t>(b)];
    });
    corners.resize(limit);
    std::sort(corners.begin(), corners.end());
    return corners;
}

std::vector<Stretch> stretches_between(const Polygon& contour, const std::vector<double>& cornerity,
                                       const std::vector<int>& corners) {
    const int n = static_cast<int>(contour.size());
    std::vector<Stretch> stretches;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const int from = corners[c];
        int to = corners[(c + 1) % corners.size()];
        if (to <= from) to += n;
        Stretch s;
        for (int i = from; i <= to; ++i) {
            s.chain.push_back(contour[static_cast<std::size_t>(i % n)]);
            // half of each end, so that the other direction sums to the same
            s.cornerity += (i == from || i == to ? 0.5 : 1.0) * cornerity[static_cast<std::size_t>(i % n)];
        }
        s.length = chain_length(s.chain);
        stretches.push_back(std::move(s));
    }
    return stretches;
}

/// The sampling rule with its surplus.
void assign_samples(std::vector<Stretch>& stretches, double total_length, int count) {
    int assigned = 0;
    for (Stretch& s : stretches) {
        s.samples = std::max(1, static_cast<int>(count * s.length / total_length));
        assigned += s.samples;
    }
    std::vector<std::size_t> order(stretches.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return stretches[a].cornerity > stretches[b].cornerity; });
    for (std::size_t k = 0; assigned < count; k = (k + 1) % order.size(), ++assigned) ++stretches[order[k]].samples;
    for (; assigned > count; --assigned) {  // the least of one sample for each corner took too many
        --std::max_element(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
              return a.samples < b.samples;
          })->samples;
    }
}

}  // namespace

Polygon sample_outline(const Polygon& contour, const std::vector<double>& cornerity, const std::vector<int>& corners,
                       int count) {
    const std::vector<int> kept = strongest(corners, cornerity, static_cast<std::size_t>(count) - 1);
    if (kept.empty()) return resample_ring(contour, count);
    std::vector<Stretch> stretches = stretches_between(contour, cornerity, kept);
    assign_samples(stretches, perimeter(contour), count);
    Polygon samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (const Stretch& s : stretches) {
        const Polyline even = resample_chain(s.chain, s.samples + 1);
        samples.insert(samples.end(), even.begin(), even.end() - 1);
    }
    return samples;
}

namespace {

int orientation(Point a, Point b, Point c) {
    const double v = cross(b - a, c - a);
    return v > 0.0 ? 1 : v < 0.0 ? -1 : 0;
}

bool between(Point a, Point b, Point p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

bool touch(Point a, Point b, Point c, Point d) {
    const int abc = orientation(a, b, c), abd = orientation(a, b, d);
    const int cda = orientation(c, d, a), cdb = orientation(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) || (cda == 0 && between(c, d, a)) ||
           (cdb == 0 && between(c, d, b));
}

/// How often edge i of the ring touches an edge that is not its neighbour.
int touches_of_edge(const Polygon& ring, std::size_t i, std::size_t* other = nullptr) {
    const std::size_t n = ring.size();
    const Point a = ring[i], b = ring[(i + 1) % n];
    int count = 0;
    for (std::size_t j = 0; j < n; ++j) {
        if (j == i || (j + 1) % n == i || (i + 1) % n == j) continue;
        const Point c = ring[j], d = ring[(j + 1) % n];
        if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) continue;
        if (touch(a, b, c, d)) {
            ++count;
            if (other != nullptr) *other = j;
        }
    }
    return count;
}

int touches(const Polygon& ring) {
    int count = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) count += touches_of_edge(ring, i);
    return count;
}

bool folds_back(const Polygon& ring, std::size_t i) {
    const std::size_t n = ring.size();
    const Point a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
    return b == c || (orientation(a, b, c) == 0 && dot(a - b, c - b) > 0.0);
}

Polygon without(const Polygon& ring, std::size_t i) {
    Polygon rest = ring;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    return rest;
}

}  // namespace

Polygon without_crossings(Polygon ring) {
    for (std::size_t i = 0; i < ring.size() && ring.size() > 3;) {
        if (folds_back(ring, i)) {
            ring = without(ring, i);
            i = i > 1 ? i - 2 : 0;
            continue;
        }
        std::size_t j = 0;
        if (touches_of_edge(ring, i, &j) == 0) {
            ++i;
            continue;
        }
        // Of the four ends, the one without which the fewest crossings remain goes.
        const std::size_t n = ring.size();
        std::size_t worst = i;
        int fewest = touches(ring) + 1;
        for (const std::size_t k : {i, (i + 1) % n, j, (j + 1) % n}) {
            const int left = touches(without(ring, k));
            if (left < fewest) {
                fewest = left;
                worst = k;
            }
        }
        ring = without(ring, worst);
        i = 0;
    }
    return ring;
}

}  // namespace core
