#include "core/silhouette/ink.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace core {
namespace {

constexpr int kLeastContrast = 24;        // of 255: below this the page is empty
constexpr double kLeastInkExtent_px = 6;  // a picture whose ink is smaller holds a dot
constexpr double kLeastPageShare = 0.02;  // and so does one whose ink is smaller than this share of the page
constexpr int kLargestFilled_px = 1024;

// What tells a solid silhouette from line art: this much of its ink lies in discs of this radius (a share of the
// diagonal), and its ink is this much of what its outline encloses. On 1,195 silhouettes of Kimia and MPEG-7 the first
// share is at least 0.42, on 700 sketches of TU-Berlin at most 0.31 where the second holds.
constexpr double kSolidShare = 0.015;
constexpr double kFilledShare = 0.4;

Unexpected empty_page() {
    return unexpected(ErrorCode::EmptyDrawing, "there is nothing drawn on the page; draw something");
}
Unexpected only_a_dot() {
    return unexpected(ErrorCode::TooSmall, "the drawing is only a dot; draw something larger");
}

cv::Mat view(const GrayImage& image) {
    return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels.data())};
}

/// Fits `frame` into a raster whose larger side is `side_px`, and sizes `mask` for it.
DrawingRaster fit(const Frame& frame, int side_px, int margin_px, BinaryImage& mask) {
    const double larger = std::max(frame.width(), frame.height());
    const double scale = side_px / larger;
    const auto extent = [&](double size) { return static_cast<int>(std::ceil(size * scale)) + 1 + 2 * margin_px; };
    mask = BinaryImage(extent(frame.width()), extent(frame.height()));
    return {scale, Point{margin_px - frame.left * scale, margin_px - frame.top * scale}};
}

std::uint8_t median_of_border(const GrayImage& page) {
    std::array<int, 256> counts{};
    int total = 0;
    const auto count = [&](int x, int y) {
        ++counts[page.at(x, y)];
        ++total;
    };
    for (int x = 0; x < page.width; ++x) {
        count(x, 0);
        count(x, page.height - 1);
    }
    for (int y = 0; y < page.height; ++y) {
        count(0, y);
        count(page.width - 1, y);
    }
    int below = 0, level = 0;
    while (level < 255 && (below += counts[static_cast<std::size_t>(level)]) * 2 < total) ++level;
    return static_cast<std::uint8_t>(level);
}

/// The smallest strength that counts as ink, 256 for an empty page. Relative to the darkest ink, of which a few pixels
/// in a thousand are enough, so that thin and reduced strokes are seen.
int ink_level(const GrayImage& strength, const InkOptions& options) {
    int darkest = 0;
    for (const std::uint8_t value : strength.pixels) darkest = std::max<int>(darkest, value);
    if (darkest < kLeastContrast) return 256;
    return std::max(kLeastContrast / 2, static_cast<int>(std::lround(options.faint_share * darkest)));
}

/// Line art is thin: most of its ink lies close to paper, and its outlines enclose much more than they cover.
bool is_filled(const cv::Mat& mask, const Frame& frame) {
    cv::Mat padded, depth;
    cv::copyMakeBorder(mask, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::distanceTransform(padded, depth, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    const double solid_radius = kSolidShare * frame.diagonal();
    cv::Mat core_of_ink = depth > solid_radius, apart, opened;
    if (cv::countNonZero(core_of_ink) == 0) return false;
    cv::bitwise_not(core_of_ink, core_of_ink);
    cv::distanceTransform(core_of_ink, apart, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    opened = (apart <= solid_radius + 1.0) & (padded > 0);

    cv::Mat filled = padded.clone();
    cv::floodFill(filled, {0, 0}, cv::Scalar(2));
    const int ink = cv::countNonZero(padded);
    const int with_holes = static_cast<int>(filled.total()) - cv::countNonZero(filled == 2);
    return cv::countNonZero(opened) > kFilledShare * ink && ink > kFilledShare * with_holes;
}

/// Makes strokes at least `width_px` wide, as measured by the ink's own typical half-width.
void widen(cv::Mat& mask, double width_px) {
    cv::Mat inside, apart;
    cv::distanceTransform(mask, inside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    std::vector<float> depths;
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            if (mask.at<std::uint8_t>(y, x) != 0) depths.push_back(inside.at<float>(y, x));
        }
    }
    if (depths.empty()) return;
    // Across a straight stroke the depth grows evenly from its edge to its middle: the mean is a quarter of the width.
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    const double grow = width_px / 2.0 - 2.0 * static_cast<double>(*middle);
    if (grow < 0.5) return;
    cv::Mat paper = 1 - mask;
    cv::distanceTransform(paper, apart, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    mask.setTo(1, apart <= grow);
}

}  // namespace

Frame frame_of(const Drawing& drawing) {
    Frame frame;
    bool first = true;
    for (const Stroke& stroke : drawing.strokes) {
        for (const PenSample& s : stroke.samples) {
            if (first) frame = {s.x, s.y, s.x, s.y};
            first = false;
            frame = {std::min(frame.left, s.x), std::min(frame.top, s.y), std::max(frame.right, s.x),
                     std::max(frame.bottom, s.y)};
        }
    }
    return frame;
}

FixedPoint DrawingLayout::place(const PenSample& sample) const {
    constexpr auto kPart = static_cast<double>(kSubpixels);
    return {std::llround((sample.x - origin.x) * scale * kPart), std::llround((sample.y - origin.y) * scale * kPart)};
}

Result<DrawingLayout> layout_of(Point first, const Frame& frame, const InkOptions& options) {
    constexpr double kSteps = 4;  // of the scale in an octave
    if (frame.right < frame.left) return empty_page();
    const double diagonal = frame.diagonal();
    if (!(diagonal > std::max(options.least_diagonal, 1e-9)) || !std::isfinite(diagonal)) return only_a_dot();
    double step = std::floor(std::log2(options.diagonal_px / diagonal) * kSteps);
    while (std::exp2(step / kSteps) * diagonal > options.diagonal_px) --step;
    while (std::exp2((step + 1) / kSteps) * diagonal <= options.diagonal_px) ++step;
    return DrawingLayout{std::exp2(step / kSteps), first, options.diagonal_px * std::exp2(-0.5 / kSteps)};
}

Result<DrawingLayout> layout_of(const Drawing& drawing, const InkOptions& options) {
    Point first;
    for (const Stroke& stroke : drawing.strokes) {
        if (stroke.samples.empty()) continue;
        first = {stroke.samples[0].x, stroke.samples[0].y};
        break;
    }
    return layout_of(first, frame_of(drawing), options);
}

void GridBox::take(FixedPoint p) {
    const auto left_of = static_cast<int>(floor_div(p.x, kSubpixels)),
               top_of = static_cast<int>(floor_div(p.y, kSubpixels));
    const int right_of = left_of + (p.x % kSubpixels != 0 ? 1 : 0),
              bottom_of = top_of + (p.y % kSubpixels != 0 ? 1 : 0);
    if (empty()) *this = {left_of, top_of, right_of, bottom_of};
    left = std::min(left, left_of);
    top = std::min(top, top_of);
    right = std::max(right, right_of);
    bottom = std::max(bottom, bottom_of);
}

GridBox box_of(const Drawing& drawing, const DrawingLayout& layout) {
    GridBox box;
    for (const Stroke& stroke : drawing.strokes) {
        for (const PenSample& s : stroke.samples) box.take(layout.place(s));
    }
    return box;
}

Ink ink_of(const Drawing& drawing, const DrawingLayout& layout, std::int64_t half, int border) {
    const GridBox box = box_of(drawing, layout);
    const int left = box.left - border, top = box.top - border;
    Ink ink;
    ink.diagonal_px = layout.diagonal_px;
    ink.raster = {layout.scale, Point{-layout.origin.x * layout.scale - left, -layout.origin.y * layout.scale - top}};
    ink.mask = BinaryImage(box.right + border - left + 1, box.bottom + border - top + 1);
    for (const Stroke& stroke : drawing.strokes) {
        for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
            const FixedPoint a = layout.place(stroke.samples[i > 0 ? i - 1 : 0]), b = layout.place(stroke.samples[i]);
            each_capsule_run(a, b, half, [&](int y, int x0, int x1) {
                const auto row = ink.mask.pixels.begin() + static_cast<std::ptrdiff_t>(ink.mask.index(0, y - top));
                std::fill(row + (x0 - left), row + (x1 - left) + 1, std::uint8_t{1});
            });
        }
    }
    return ink;
}

GrayImage ink_strength(const GrayImage& page) {
    GrayImage strength(page.width, page.height);
    if (page.pixels.empty()) return strength;
    const int paper = median_of_border(page);
    for (std::size_t i = 0; i < page.pixels.size(); ++i) {
        const int value = page.pixels[i];
        strength.pixels[i] = static_cast<std::uint8_t>(std::max(0, paper >= 128 ? paper - value : value - paper));
    }
    return strength;
}

Frame frame_of(const GrayImage& strength, const InkOptions& options) {
    const int level = ink_level(strength, options);
    int left = strength.width, top = strength.height, right = -1, bottom = -1;
    for (int y = 0; y < strength.height; ++y) {
        for (int x = 0; x < strength.width; ++x) {
            if (strength.at(x, y) < level) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = y;
        }
    }
    if (right < left) return {};
    return {static_cast<double>(left), static_cast<double>(top), static_cast<double>(right),
            static_cast<double>(bottom)};
}

Result<Ink> ink_of(const GrayImage& strength, const Frame& frame, const InkOptions& options) {
    if (frame.right < frame.left) return empty_page();
    const double least = std::max({kLeastInkExtent_px, options.least_diagonal,
                                   kLeastPageShare * length(Point{double(strength.width), double(strength.height)})});
    if (frame.diagonal() < least) return only_a_dot();

    const int level = ink_level(strength, options);
    const int left = std::clamp(static_cast<int>(std::floor(frame.left)), 0, strength.width - 1);
    const int top = std::clamp(static_cast<int>(std::floor(frame.top)), 0, strength.height - 1);
    const int right = std::clamp(static_cast<int>(std::ceil(frame.right)), left, strength.width - 1);
    const int bottom = std::clamp(static_cast<int>(std::ceil(frame.bottom)), top, strength.height - 1);
    const Frame whole{double(left), double(top), double(right), double(bottom)};
    const cv::Mat part = view(strength)(cv::Rect(left, top, right - left + 1, bottom - top + 1));
    const cv::Mat source = (part >= level) & 1;

    Ink ink;
    ink.filled = is_filled(source, whole);
    const int larger = std::max(part.cols, part.rows) - 1;
    const int side = ink.filled ? std::min(larger, kLargestFilled_px) : options.raster_px;
    ink.raster = fit(whole, side, options.margin_px, ink.mask);
    ink.diagonal_px = frame.diagonal() * ink.raster.scale;
    cv::Mat mask = view(ink.mask);

    // Enlarging interpolates the greys and thresholds after; reducing keeps every stroke, however thin.
    const double s = ink.raster.scale;
    const cv::Matx23d placement(s, 0, options.margin_px, 0, s, options.margin_px);
    cv::Mat placed;
    if (s >= 1.0) {
        cv::warpAffine(part, placed, placement, mask.size(), cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(0));
        mask.setTo(1, placed >= level);
    } else {
        cv::Mat spread = source * 255;
        const int window = 2 * static_cast<int>(std::ceil((1.0 / s - 1.0) / 2.0)) + 1;
        if (ink.filled) {
            cv::blur(spread, spread, {window, window}, {-1, -1}, cv::BORDER_CONSTANT);
        } else {
            cv::dilate(spread, spread, cv::Mat::ones(window, window, CV_8UC1));
        }
        cv::warpAffine(spread, placed, placement, mask.size(), cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(0));
        mask.setTo(1, placed >= 128);
    }
    if (!ink.filled) widen(mask, options.stroke_share * whole.diagonal() * s);
    return ink;
}

}  // namespace core
