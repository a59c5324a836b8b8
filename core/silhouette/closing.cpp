#include "core/silhouette/closing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "core/silhouette/closing_levels.hpp"
#include "core/silhouette/far_off.hpp"

namespace core {
namespace {

cv::Mat view(BinaryImage& image) {
    return {image.height, image.width, CV_8UC1, image.pixels.data()};
}

/// Distance of every pixel to the nearest pixel of the mask.
cv::Mat distance_to(const cv::Mat& mask) {
    cv::Mat others = mask == 0, apart;
    cv::distanceTransform(others, apart, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return apart;
}

/// 255 where a walker from outside the picture, who moves to 4-neighbours and may not step on `wall`, cannot come and
/// there is no wall.
cv::Mat enclosed_by(const cv::Mat& wall) {
    cv::Mat reached;
    cv::copyMakeBorder(wall != 0, reached, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::floodFill(reached, {0, 0}, cv::Scalar(128), nullptr, {}, {}, 4);
    return reached(cv::Rect(1, 1, wall.cols, wall.rows)) == 0;
}

void fill_holes(cv::Mat& mask) {
    mask.setTo(1, enclosed_by(mask));
}

/// Removes from `cores` the connected regions that nowhere lie farther than `least_px` from ink.
void keep_roomy(cv::Mat& cores, const cv::Mat& from_ink, float least_px) {
    cv::Mat labels;
    const int count = cv::connectedComponents(cores, labels, 4, CV_32S);
    std::vector<float> room(static_cast<std::size_t>(count), 0.0F);
    for (int y = 0; y < cores.rows; ++y) {
        const int* label = labels.ptr<int>(y);
        const float* apart = from_ink.ptr<float>(y);
        for (int x = 0; x < cores.cols; ++x) {
            float& most = room[static_cast<std::size_t>(label[x])];
            most = std::max(most, apart[x]);
        }
    }
    for (int y = 0; y < cores.rows; ++y) {
        const int* label = labels.ptr<int>(y);
        auto* core_row = cores.ptr<std::uint8_t>(y);
        for (int x = 0; x < cores.cols; ++x) {
            if (room[static_cast<std::size_t>(label[x])] < least_px) core_row[x] = 0;
        }
    }
}

/// A distance between those of two neighbouring squares, so that comparing with it is exact.
float above(int squared) {
    return static_cast<float>(std::sqrt(squared + 0.5));
}

/// Ink and every region that it encloses up to gaps of 2 r, for a series of r. A region that was filled at one radius
/// is left alone at the larger ones.
cv::Mat close_and_fill(const cv::Mat& ink, const ClosingLevels& closing) {
    const int border = closing.border;  // so that the widest walls leave a way round
    cv::Mat result;
    cv::copyMakeBorder(ink, result, border, border, border, border, cv::BORDER_CONSTANT, cv::Scalar(0));
    const cv::Mat from_ink = distance_to(result);
    cv::Mat taken = enclosed_by(result);
    result.setTo(1, taken);
    for (const ClosingLevel& level : closing.levels) {
        cv::Mat cores = enclosed_by(from_ink <= above(level.wall2)) & ~taken;
        if (cv::countNonZero(cores) == 0) continue;
        keep_roomy(cores, from_ink, above(level.room2 - 1));
        if (cv::countNonZero(cores) == 0) continue;
        taken |= cores;
        result.setTo(1, distance_to(cores) <= above(level.wall2));
    }
    fill_holes(result);
    return result(cv::Rect(border, border, ink.cols, ink.rows)).clone();
}

struct Pieces {
    cv::Mat labels, stats;
    int count = 0;  ///< label 0 is the paper
    [[nodiscard]] int area(int label) const { return stats.at<int>(label, cv::CC_STAT_AREA); }
    [[nodiscard]] double diagonal(int label) const {
        return length(
            Point{double(stats.at<int>(label, cv::CC_STAT_WIDTH)), double(stats.at<int>(label, cv::CC_STAT_HEIGHT))});
    }
};

Pieces pieces_of(const cv::Mat& mask) {
    Pieces pieces;
    cv::Mat centres;
    pieces.count = cv::connectedComponentsWithStats(mask, pieces.labels, pieces.stats, centres, 8, CV_32S);
    return pieces;
}

/// Where a piece is nearest to the object: the first such pixel of the piece in row order, and the first pixel of the
/// object, likewise, that is as near to it. Nothing when they are farther apart than the square root of `most2`.
struct Bridge {
    cv::Point from, to;
};
std::optional<Bridge> nearest(const Pieces& pieces, int label, const cv::Mat& object, const cv::Mat& from_object,
                              int most2) {
    const cv::Rect box(pieces.stats.at<int>(label, cv::CC_STAT_LEFT), pieces.stats.at<int>(label, cv::CC_STAT_TOP),
                       pieces.stats.at<int>(label, cv::CC_STAT_WIDTH), pieces.stats.at<int>(label, cv::CC_STAT_HEIGHT));
    std::pair<cv::Point, float> best{{0, 0}, std::numeric_limits<float>::max()};
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) {
            if (pieces.labels.at<int>(y, x) != label || from_object.at<float>(y, x) >= best.second) continue;
            best = {{x, y}, from_object.at<float>(y, x)};
        }
    }
    if (best.second > above(most2)) return std::nullopt;
    const auto gap2 = static_cast<int>(std::lround(best.second * best.second));
    const int reach = static_cast<int>(std::ceil(best.second));
    for (int y = best.first.y - reach; y <= best.first.y + reach; ++y) {
        for (int x = best.first.x - reach; x <= best.first.x + reach; ++x) {
            const int dx = x - best.first.x, dy = y - best.first.y;
            if (dx * dx + dy * dy != gap2 || !cv::Rect({0, 0}, object.size()).contains({x, y})) continue;
            if (object.at<std::uint8_t>(y, x) != 0) return Bridge{best.first, {x, y}};
        }
    }
    return std::nullopt;
}

/// The piece with the largest area; of equals the one that comes first in row order.
int largest_of(const Pieces& pieces) {
    int largest = 0;
    for (int y = 0; y < pieces.labels.rows; ++y) {
        for (int x = 0; x < pieces.labels.cols; ++x) {
            const int label = pieces.labels.at<int>(y, x);
            if (label == 0 || label == largest) continue;
            if (largest == 0 || pieces.area(label) > pieces.area(largest)) largest = label;
        }
    }
    return largest;
}

void draw_bridge(cv::Mat& object, const Bridge& bridge, std::int64_t half) {
    const FixedPoint a{bridge.from.x * kSubpixels, bridge.from.y * kSubpixels};
    const FixedPoint b{bridge.to.x * kSubpixels, bridge.to.y * kSubpixels};
    each_capsule_run(a, b, half, [&](int y, int x0, int x1) {
        if (y < 0 || y >= object.rows) return;
        for (int x = std::max(x0, 0); x <= std::min(x1, object.cols - 1); ++x) object.at<std::uint8_t>(y, x) = 1;
    });
}

/// The largest piece, and every other piece that is no stray mark and lies near it or near one already joined. A
/// negative join2 joins nothing.
cv::Mat join_pieces(const cv::Mat& mask, int join2, double stray_px, std::int64_t half) {
    const Pieces pieces = pieces_of(mask);
    const int largest = largest_of(pieces);
    cv::Mat object = (pieces.labels == largest) & 1;
    std::vector<int> waiting;
    for (int label = 1; label < pieces.count; ++label) {
        const bool may_join = label != largest && join2 >= 0 && pieces.diagonal(label) >= stray_px;
        if (may_join) waiting.push_back(label);
    }
    for (bool grown = true; grown && !waiting.empty();) {
        grown = false;
        const cv::Mat before = object.clone(), from_object = distance_to(object);
        std::erase_if(waiting, [&](int label) {
            const std::optional<Bridge> bridge = nearest(pieces, label, before, from_object, join2);
            if (!bridge) return false;
            draw_bridge(object, *bridge, half);
            object.setTo(1, pieces.labels == label);
            return grown = true;
        });
    }
    fill_holes(object);
    return object;
}

Silhouette close_ink(Ink ink, const ClosingLevels& closing) {
    const cv::Mat mask = view(ink.mask);
    cv::Mat object;
    if (ink.filled) {
        cv::Mat filled = mask.clone();
        fill_holes(filled);
        object = join_pieces(filled, -1, 0.0, 0);
    } else {
        object = join_pieces(close_and_fill(mask, closing), closing.join2, closing.stray, closing.half);
    }
    Silhouette silhouette{BinaryImage(object.cols, object.rows), ink.raster};
    object.copyTo(view(silhouette.image));
    return silhouette;
}

/// The object's rectangle in the source's units.
Frame frame_of_object(const Silhouette& silhouette) {
    BinaryImage image = silhouette.image;
    const cv::Rect box = cv::boundingRect(view(image));
    const Point a = silhouette.raster.to_drawing({double(box.x), double(box.y)});
    const Point b = silhouette.raster.to_drawing({double(box.x + box.width - 1), double(box.y + box.height - 1)});
    return {a.x, a.y, b.x, b.y};
}

Result<Silhouette> find_in(const GrayImage& strength, const SilhouetteOptions& options) {
    const Frame frame = frame_of(strength, options.ink);
    Result<Ink> ink = ink_of(strength, frame, options.ink);
    if (!ink) return unexpected(ink.error());
    const double diagonal_px = ink->diagonal_px;
    Silhouette first = close_ink(std::move(*ink), closing_levels(options, diagonal_px));
    const Frame object = frame_of_object(first);
    if (std::max(object.width(), object.height()) > kFarOffShare * std::max(frame.width(), frame.height()))
        return first;
    ink = ink_of(strength, object, options.ink);
    if (!ink) return first;
    const double object_diagonal_px = ink->diagonal_px;
    return close_ink(std::move(*ink), closing_levels(options, object_diagonal_px));
}

Silhouette close_drawing(const Drawing& drawing, const DrawingLayout& layout, const SilhouetteOptions& options) {
    const ClosingLevels closing = closing_levels(options, layout.diagonal_px);
    return close_ink(ink_of(drawing, layout, closing.half, closing.border), closing);
}

/// The object's box on the drawing's grid.
GridBox box_of_object(const Silhouette& silhouette, const GridBox& drawing, int border) {
    BinaryImage image = silhouette.image;
    const cv::Rect box = cv::boundingRect(view(image));
    const int left = drawing.left - border, top = drawing.top - border;
    return {left + box.x, top + box.y, left + box.x + box.width - 1, top + box.y + box.height - 1};
}

Result<Silhouette> find_in(const Drawing& drawing, const SilhouetteOptions& options) {
    const Result<DrawingLayout> layout = layout_of(drawing, options.ink);
    if (!layout) return unexpected(layout.error());
    Silhouette first = close_drawing(drawing, *layout, options);
    const GridBox all = box_of(drawing, *layout);
    const GridBox object = box_of_object(first, all, closing_levels(options, layout->diagonal_px).border);
    if (!rest_is_far_off(object, all)) return first;
    const Drawing near = part_within(drawing, *layout, object);
    const Result<DrawingLayout> near_layout = layout_of(near, options.ink);
    return near_layout ? close_drawing(near, *near_layout, options) : first;
}

Result<BinaryImage> image_of(Result<Silhouette> found) {
    if (!found) return unexpected(found.error());
    return std::move(found->image);
}

}  // namespace

Result<Silhouette> find_silhouette(const Drawing& drawing, const SilhouetteOptions& options) {
    return find_in(drawing, options);
}

Result<Silhouette> find_silhouette(const GrayImage& page, const SilhouetteOptions& options) {
    return find_in(ink_strength(page), options);
}

Result<BinaryImage> silhouette_of(const Drawing& drawing, const SilhouetteOptions& options) {
    return image_of(find_silhouette(drawing, options));
}

Result<BinaryImage> silhouette_of(const GrayImage& page, const SilhouetteOptions& options) {
    return image_of(find_silhouette(page, options));
}

}  // namespace core
