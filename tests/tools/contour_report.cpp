// How the whole-contour reading does on a list of silhouettes (path<TAB>class a line, or a .cla file).
//
//     contour_report LIST [--ranks N] [--parts] [--stability EVERY]
//
// Prints same-class hits by rank, their total and the bull's-eye for the contour; with --parts also for the parts, and
// for both together with several weights; what re-ranking makes of the last; how long a pair takes; the share of pairs
// that bounds spare when the nearest ten are wanted. --stability takes every EVERY-th silhouette, moves, turns, scales
// and mirrors its pixels, and says how often a copy's nearest shape is its original.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/contour/contour_match.hpp"
#include "core/evaluate/retrieval_metrics.hpp"
#include "core/exchange/image_reader.hpp"
#include "core/exchange/list_file.hpp"
#include "core/match/match.hpp"
#include "core/parts/describe.hpp"
#include "core/rerank/set_rerank.hpp"
#include "core/silhouette/contour.hpp"

namespace {

struct Shape {
    std::string path, class_name;
    core::BinaryImage mask;
    core::Polygon contour;
    core::MatchableContour matchable;
};

double now_us() {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

core::Result<core::MatchableContour> matchable_of(const core::BinaryImage& mask, core::Polygon* contour = nullptr) {
    const core::Result<core::Polygon> ring = core::largest_contour(mask);
    if (!ring) return core::unexpected(ring.error());
    if (contour != nullptr) *contour = *ring;
    const core::Result<core::ContourDescriptor> descriptor = core::describe_contour(*ring);
    if (!descriptor) return core::unexpected(descriptor.error());
    return core::matchable(*descriptor);
}

std::vector<Shape> read_shapes(const core::LabelledList& list) {
    std::vector<Shape> shapes;
    for (const core::LabelledFile& file : list.files) {
        const core::Result<core::GrayImage> image = core::read_gray_image(file.path);
        if (!image) {
            std::fprintf(stderr, "%s\n", image.error().sentence().c_str());
            continue;
        }
        Shape shape{file.path, file.class_name, core::object_mask(*image), {}, {}};
        const core::Result<core::MatchableContour> matchable = matchable_of(shape.mask, &shape.contour);
        if (!matchable) {
            std::fprintf(stderr, "%s: %s\n", file.path.c_str(), matchable.error().message.c_str());
            continue;
        }
        shape.matchable = *matchable;
        shapes.push_back(std::move(shape));
    }
    return shapes;
}

std::vector<std::string> classes_of(const std::vector<Shape>& shapes) {
    std::vector<std::string> classes;
    for (const Shape& shape : shapes) classes.push_back(shape.class_name);
    return classes;
}

using Matrix = std::vector<float>;  // n x n

Matrix matrix_of(std::size_t n, const std::function<double(std::size_t, std::size_t)>& distance) {
    Matrix matrix(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            matrix[i * n + j] = matrix[j * n + i] = static_cast<float>(distance(i, j));
        }
    }
    return matrix;
}

void print_test(const char* name, const Matrix& matrix, const std::vector<std::string>& classes, int ranks) {
    const core::ShapeTest test = core::shape_test(matrix, classes, ranks);
    std::printf("%-24s total %6.2f %%  bull's-eye %6.2f %%  hits", name, 100.0 * test.total, 100.0 * test.bullseye);
    for (const int hits : test.hits_by_rank) std::printf(" %d", hits);
    std::printf("\n");
}

/// Median and least over rows of the mean time of a row's pairs, so that a disturbed moment does not count.
Matrix contour_matrix(const std::vector<Shape>& shapes) {
    const std::size_t n = shapes.size();
    core::ContourMatcher matcher;
    Matrix matrix(n * n);
    std::vector<double> us;
    for (std::size_t i = 0; i < n; ++i) {
        const double start = now_us();
        for (std::size_t j = 0; j < n; ++j) {
            matrix[i * n + j] = static_cast<float>(matcher.distance(shapes[i].matchable, shapes[j].matchable));
        }
        us.push_back((now_us() - start) / static_cast<double>(n));
    }
    std::printf("contour: %.2f us a pair (median), %.2f (least)\n", median(us),
                *std::min_element(us.begin(), us.end()));
    std::vector<double> describe_us;
    for (const Shape& shape : shapes) {
        const double start = now_us();
        if (!core::describe_contour(shape.contour)) std::printf("%s: not described\n", shape.path.c_str());
        describe_us.push_back(now_us() - start);
    }
    std::printf("describe: %.0f us (median), %.0f (most)\n", median(describe_us),
                *std::max_element(describe_us.begin(), describe_us.end()));
    return matrix;
}

double median_between_classes(const std::vector<Shape>& shapes, const Matrix& matrix) {
    std::vector<double> pairs;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        for (std::size_t j = i + 1; j < shapes.size(); ++j) {
            if (shapes[i].class_name != shapes[j].class_name) pairs.push_back(matrix[i * shapes.size() + j]);
        }
    }
    return median(pairs);
}

/// Every shape looks for its ten nearest, with candidates in the order of their lower bounds.
void print_spared(const std::vector<Shape>& shapes, const Matrix& brute) {
    constexpr std::size_t kWanted = 10;
    const std::size_t n = shapes.size();
    core::ContourMatcher matcher;
    double spared = 0.0, us = 0.0, tightness = 0.0;
    std::size_t wrong = 0, above = 0;
    for (std::size_t q = 0; q < n; ++q) {
        const double start = now_us();
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t j = 0; j < n; ++j) {
            if (j != q) order.emplace_back(core::lower_bound(shapes[q].matchable, shapes[j].matchable), j);
        }
        std::sort(order.begin(), order.end());
        std::vector<std::pair<double, std::size_t>> best;
        for (const auto& [bound, j] : order) {
            const double worst = best.size() < kWanted ? std::numeric_limits<double>::infinity() : best.back().first;
            if (bound > worst) {
                spared += 1.0;
                continue;
            }
            const double limit = std::nextafter(worst, std::numeric_limits<double>::infinity());
            best.emplace_back(matcher.distance(shapes[q].matchable, shapes[j].matchable, limit), j);
            std::sort(best.begin(), best.end());
            if (best.size() > kWanted) best.pop_back();
        }
        us += now_us() - start;
        std::vector<std::pair<float, std::size_t>> all;
        for (std::size_t j = 0; j < n; ++j) {
            if (j != q) all.emplace_back(brute[q * n + j], j);
        }
        std::sort(all.begin(), all.end());
        // What differs by less than a float tells is a tie here.
        for (std::size_t k = 0; k < best.size(); ++k) {
            wrong += best[k].second == all[k].second || static_cast<float>(best[k].first) == all[k].first ? 0 : 1;
        }
        for (const auto& [bound, j] : order) {
            above += static_cast<float>(bound) > brute[q * n + j] ? 1 : 0;
            tightness += bound / std::max(1e-9, static_cast<double>(brute[q * n + j]));
        }
    }
    const double pairs = static_cast<double>(n) * static_cast<double>(n - 1);
    std::printf(
        "nearest ten: bounds spare %.1f %% of the pairs their alignment, sums that no turning changes alone %.1f %% "
        "(%.2f of the distance), %.2f us a pair; ranks unlike brute force %zu, bounds above the distance %zu\n",
        100.0 * (1.0 - static_cast<double>(matcher.aligned_pairs()) / pairs), 100.0 * spared / pairs, tightness / pairs,
        us / pairs, wrong, above);
}

void print_with_parts(const std::vector<Shape>& shapes, const Matrix& contour, int ranks) {
    const std::size_t n = shapes.size();
    std::vector<core::MatchableShape> matchables(n);
    for (std::size_t i = 0; i < n; ++i) {
        const core::Result<core::ShapeDescriptor> described = core::describe(shapes[i].contour);
        if (!described) {
            std::printf("%s: %s\n", shapes[i].path.c_str(), described.error().message.c_str());
            return;
        }
        matchables[i] = core::matchable(*described);
    }
    core::Matcher matcher;
    const Matrix parts =
        matrix_of(n, [&](std::size_t i, std::size_t j) { return matcher.distance(matchables[i], matchables[j]); });
    const std::vector<std::string> classes = classes_of(shapes);
    print_test("parts", parts, classes, ranks);
    const double parts_scale = median_between_classes(shapes, parts);
    const double contour_scale = median_between_classes(shapes, contour);
    std::printf("median distance between classes: parts %.4g, contour %.4g\n", parts_scale, contour_scale);
    for (const double weight : {0.1, 0.2, 0.35, 0.5, 0.75, 1.0, 1.5}) {
        Matrix fused(n * n);
        for (std::size_t k = 0; k < n * n; ++k) {
            fused[k] = static_cast<float>(contour[k] / contour_scale + weight * parts[k] / parts_scale);
        }
        char name[40];
        std::snprintf(name, sizeof name, "contour + %.2f parts", weight);
        print_test(name, fused, classes, ranks);
        print_test("    reranked", core::reranked_distances(fused, n), classes, ranks);
    }
}

/// The pixels seen through `source`, which gives the point of the original (in pixels) for one of the copy; pixels are
/// mixed linearly, so that an edge stays where it is.
core::BinaryImage redrawn(const core::BinaryImage& image, int width, int height,
                          const std::function<core::Point(double, double)>& source) {
    const auto at = [&image](int x, int y) {
        return x >= 0 && y >= 0 && x < image.width && y < image.height && image.at(x, y) != 0 ? 1.0 : 0.0;
    };
    core::BinaryImage out(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const core::Point p = source(x + 0.5, y + 0.5) - core::Point{0.5, 0.5};
            const int left = static_cast<int>(std::floor(p.x)), top = static_cast<int>(std::floor(p.y));
            const double u = p.x - left, v = p.y - top;
            const double mixed = (at(left, top) * (1 - u) + at(left + 1, top) * u) * (1 - v) +
                                 (at(left, top + 1) * (1 - u) + at(left + 1, top + 1) * u) * v;
            out.pixels[out.index(x, y)] = mixed > 0.5 ? 1 : 0;
        }
    }
    return out;
}

core::BinaryImage turned(const core::BinaryImage& image, double angle_rad) {
    const int side = static_cast<int>(std::ceil(std::hypot(image.width, image.height))) + 2;
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return redrawn(image, side, side, [&](double x, double y) {
        const double dx = x - side * 0.5, dy = y - side * 0.5;
        return core::Point{image.width * 0.5 + c * dx - s * dy, image.height * 0.5 + s * dx + c * dy};
    });
}

core::BinaryImage scaled(const core::BinaryImage& image, double factor) {
    return redrawn(image, static_cast<int>(std::ceil(image.width * factor)),
                   static_cast<int>(std::ceil(image.height * factor)), [&](double x, double y) {
                       return core::Point{x / factor, y / factor};
                   });
}

core::BinaryImage moved(const core::BinaryImage& image, int by) {
    core::BinaryImage out(image.width + 2 * by, image.height + by);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) out.pixels[out.index(x + by, y)] = image.at(x, y);
    }
    return out;
}

core::BinaryImage flipped(const core::BinaryImage& image) {
    core::BinaryImage out(image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) out.pixels[out.index(image.width - 1 - x, y)] = image.at(x, y);
    }
    return out;
}

struct Copy {
    std::string name;
    std::function<core::BinaryImage(const core::BinaryImage&)> make;
};

std::vector<Copy> copies() {
    std::vector<Copy> all{{"moved 37 px", [](const auto& m) { return moved(m, 37); }},
                          {"mirrored", [](const auto& m) { return flipped(m); }}};
    for (const double factor : {0.5, 2.0, 4.0}) {
        all.push_back(
            {"scale " + std::to_string(factor).substr(0, 3), [=](const auto& m) { return scaled(m, factor); }});
    }
    for (int k = 0; k < 12; ++k) {
        const int degrees = 15 + 30 * k;
        all.push_back({"turned " + std::to_string(degrees),
                       [=](const auto& m) { return turned(m, degrees * std::numbers::pi / 180.0); }});
    }
    return all;
}

void print_stability(const std::vector<Shape>& shapes, std::size_t every) {
    core::ContourMatcher matcher;
    for (const Copy& copy : copies()) {
        std::size_t tried = 0, own = 0, same = 0, failed = 0;
        std::vector<double> distances;
        for (std::size_t i = 0; i < shapes.size(); i += every) {
            ++tried;
            const core::Result<core::MatchableContour> copied = matchable_of(copy.make(shapes[i].mask));
            if (!copied) {
                ++failed;
                continue;
            }
            const double to_own = matcher.distance(*copied, shapes[i].matchable);
            bool nearest = true;
            for (std::size_t j = 0; j < shapes.size() && nearest; ++j) {
                if (j != i && matcher.distance(*copied, shapes[j].matchable, to_own) < to_own) {
                    nearest = false;
                }
            }
            own += nearest ? 1 : 0;
            same += copied->descriptor == shapes[i].matchable.descriptor ? 1 : 0;
            distances.push_back(to_own);
        }
        std::printf("%-14s own copy nearest %zu of %zu, equal descriptors %zu, distance %.4f (median) %.4f (most)",
                    copy.name.c_str(), own, tried, same, median(distances),
                    *std::max_element(distances.begin(), distances.end()));
        if (failed > 0) std::printf(", not described %zu", failed);
        std::printf("\n");
    }
}

}  // namespace

int main(int argc, char** argv) {
    const char* list_path = nullptr;
    int ranks = 10;
    std::size_t every = 0;
    bool parts = false;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--ranks") == 0 && i + 1 < argc) {
            ranks = std::atoi(argv[++i]);
        } else if (std::strcmp(argv[i], "--stability") == 0 && i + 1 < argc) {
            every = static_cast<std::size_t>(std::atoi(argv[++i]));
        } else if (std::strcmp(argv[i], "--parts") == 0) {
            parts = true;
        } else {
            list_path = argv[i];
        }
    }
    if (list_path == nullptr || ranks < 1) {
        std::fprintf(stderr, "contour_report LIST [--ranks N] [--parts] [--stability EVERY]\n");
        return 2;
    }
    const core::Result<core::LabelledList> list = core::read_list_file(list_path);
    if (!list) {
        std::fprintf(stderr, "%s\n", list.error().sentence().c_str());
        return 1;
    }
    const std::vector<Shape> shapes = read_shapes(*list);
    if (shapes.size() < 2) return 1;
    std::printf("%zu shapes\n", shapes.size());
    const Matrix contour = contour_matrix(shapes);
    print_test("contour", contour, classes_of(shapes), ranks);
    const double start = now_us();
    const Matrix reranked = core::reranked_distances(contour, shapes.size());
    const double rerank_ms = (now_us() - start) / 1000.0;
    print_test("contour, reranked", reranked, classes_of(shapes), ranks);
    std::printf("re-ranking %.0f ms; median distance between classes %.4f\n", rerank_ms,
                median_between_classes(shapes, contour));
    print_spared(shapes, contour);
    if (parts) print_with_parts(shapes, contour, ranks);
    if (every > 0) print_stability(shapes, every);
    return 0;
}
