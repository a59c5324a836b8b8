#include "core/silhouette/closing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace core {
namespace {

constexpr int kRadii = 9;             // radii tried besides 0: the closing radius and its fractions
constexpr double kRadiusStep = 1.4;   // each of them is this much smaller than the one before
constexpr double kFarOffShare = 0.7;  // an object smaller than this share of the raster is laid out again
constexpr float kTouching = 1.5F;     // 8-neighbours

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
void keep_roomy(cv::Mat& cores, const cv::Mat& from_ink, double least_px) {
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
            if (room[static_cast<std::size_t>(label[x])] < static_cast<float>(least_px)) core_row[x] = 0;
        }
    }
}

/// Ink and every region that it encloses up to gaps of 2 r, for a series of r up to `closing_px`.
cv::Mat close_and_fill(const cv::Mat& ink, double closing_px, double room) {
    const int border = static_cast<int>(std::ceil(closing_px)) + 2;  // so that the widest walls leave a way round
    cv::Mat result;
    cv::copyMakeBorder(ink, result, border, border, border, border, cv::BORDER_CONSTANT, cv::Scalar(0));
    const cv::Mat from_ink = distance_to(result);
    fill_holes(result);
    double r = closing_px * std::pow(kRadiusStep, -(kRadii - 1));
    for (int step = 0; step < kRadii; ++step, r *= kRadiusStep) {
        cv::Mat cores = enclosed_by(from_ink <= r);
        if (cv::countNonZero(cores & (result == 0)) == 0) continue;
        keep_roomy(cores, from_ink, r * (1.0 + (room - 1.0) * (0.4 + 0.6 * r / closing_px)));
        if (cv::countNonZero(cores) > 0) result.setTo(1, distance_to(cores) <= r);
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

/// The pixel of piece `label` that is nearest to the object, with its distance; the first in row order of equals.
std::pair<cv::Point, float> nearest_pixel(const Pieces& pieces, int label, const cv::Mat& from_object) {
    std::pair<cv::Point, float> best{{0, 0}, std::numeric_limits<float>::max()};
    const cv::Rect box(pieces.stats.at<int>(label, cv::CC_STAT_LEFT), pieces.stats.at<int>(label, cv::CC_STAT_TOP),
                       pieces.stats.at<int>(label, cv::CC_STAT_WIDTH), pieces.stats.at<int>(label, cv::CC_STAT_HEIGHT));
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) {
            if (pieces.labels.at<int>(y, x) != label) continue;
            if (from_object.at<float>(y, x) < best.second) best = {{x, y}, from_object.at<float>(y, x)};
        }
    }
    return best;
}

/// Walks down the distances from `start` to the object.
cv::Point foot_of(cv::Point start, const cv::Mat& from_object) {
    cv::Point at = start;
    for (;;) {
        cv::Point lowest = at;
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const cv::Point next(at.x + dx, at.y + dy);
                if (!cv::Rect({0, 0}, from_object.size()).contains(next)) continue;
                if (from_object.at<float>(next) < from_object.at<float>(lowest)) lowest = next;
            }
        }
        if (lowest == at) return at;
        at = lowest;
    }
}

/// The largest piece, and every other piece that is no stray mark and lies near it or near one already joined.
cv::Mat join_pieces(const cv::Mat& mask, double joining_px, double stray_px, int stroke_px) {
    const Pieces pieces = pieces_of(mask);
    int largest = 1;
    for (int label = 2; label < pieces.count; ++label) {
        if (pieces.area(label) > pieces.area(largest)) largest = label;
    }
    cv::Mat object = (pieces.labels == largest) & 1;
    std::vector<int> waiting;
    for (int label = 1; label < pieces.count; ++label) {
        if (label != largest && pieces.diagonal(label) >= stray_px) waiting.push_back(label);
    }
    for (bool grown = true; grown && !waiting.empty();) {
        grown = false;
        const cv::Mat from_object = distance_to(object);
        std::erase_if(waiting, [&](int label) {
            const auto [start, gap] = nearest_pixel(pieces, label, from_object);
            if (gap > static_cast<float>(joining_px) + kTouching) return false;
            cv::line(object, start, foot_of(start, from_object), cv::Scalar(1), stroke_px);
            object.setTo(1, pieces.labels == label);
            return grown = true;
        });
    }
    fill_holes(object);
    return object;
}

Silhouette close_ink(Ink ink, const Frame& frame, const SilhouetteOptions& options) {
    const cv::Mat mask = view(ink.mask);
    const double diagonal_px = frame.diagonal() * ink.raster.scale;
    cv::Mat object;
    if (ink.filled) {
        cv::Mat filled = mask.clone();
        fill_holes(filled);
        object = join_pieces(filled, -kTouching, 0.0, 1);
    } else {
        const int stroke_px = std::max(1, static_cast<int>(std::lround(options.ink.stroke_share * diagonal_px)));
        object = join_pieces(close_and_fill(mask, options.closing_share * diagonal_px, options.room),
                             options.joining_share * diagonal_px, options.stray_share * diagonal_px, stroke_px);
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

template <typename Source>
Result<Silhouette> find_in(const Source& source, const Frame& frame, const SilhouetteOptions& options) {
    Result<Ink> ink = ink_of(source, frame, options.ink);
    if (!ink) return unexpected(ink.error());
    Silhouette first = close_ink(std::move(*ink), frame, options);
    const Frame object = frame_of_object(first);
    if (std::max(object.width(), object.height()) > kFarOffShare * std::max(frame.width(), frame.height()))
        return first;
    ink = ink_of(source, object, options.ink);
    if (!ink) return first;
    return close_ink(std::move(*ink), object, options);
}

template <typename Source>
Result<std::vector<Silhouette>> readings_in(const Source& source, const Frame& frame,
                                            const SilhouetteOptions& options) {
    SilhouetteOptions tight = options, wide = options;
    tight.closing_share /= 3.0;
    tight.joining_share = 0.0;
    wide.closing_share *= 2.5;
    wide.joining_share *= 2.5;
    std::vector<Silhouette> readings;
    for (const SilhouetteOptions& reading : {options, tight, wide}) {
        Result<Silhouette> found = find_in(source, frame, reading);
        if (!found) return unexpected(found.error());
        const bool known = std::any_of(readings.begin(), readings.end(), [&](const Silhouette& other) {
            return other.image.width == found->image.width && other.image.pixels == found->image.pixels;
        });
        if (!known) readings.push_back(std::move(*found));
    }
    return readings;
}

Result<BinaryImage> image_of(Result<Silhouette> found) {
    if (!found) return unexpected(found.error());
    return std::move(found->image);
}

}  // namespace

Result<Silhouette> find_silhouette(const Drawing& drawing, const SilhouetteOptions& options) {
    return find_in(drawing, frame_of(drawing), options);
}

Result<Silhouette> find_silhouette(const GrayImage& page, const SilhouetteOptions& options) {
    const GrayImage strength = ink_strength(page);
    return find_in(strength, frame_of(strength, options.ink), options);
}

Result<BinaryImage> silhouette_of(const Drawing& drawing, const SilhouetteOptions& options) {
    return image_of(find_silhouette(drawing, options));
}

Result<BinaryImage> silhouette_of(const GrayImage& page, const SilhouetteOptions& options) {
    return image_of(find_silhouette(page, options));
}

Result<std::vector<Silhouette>> silhouette_readings(const Drawing& drawing, const SilhouetteOptions& options) {
    return readings_in(drawing, frame_of(drawing), options);
}

Result<std::vector<Silhouette>> silhouette_readings(const GrayImage& page, const SilhouetteOptions& options) {
    const GrayImage strength = ink_strength(page);
    return readings_in(strength, frame_of(strength, options.ink), options);
}

}  // namespace core
