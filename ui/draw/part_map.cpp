#include "ui/draw/part_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/draw/coverage.hpp"
#include "ui/draw/palette.hpp"

namespace ui {
namespace {

constexpr std::uint8_t kOutside = 255;
constexpr std::uint8_t kClayLabel = palette::kPartCount;
constexpr int kLabels = palette::kPartCount + 1;

/// Which part owns each pixel; of overlapping rings the later one.
core::GrayImage label_parts(const std::vector<PartRegion>& parts, int size) {
    core::GrayImage labels(size, size, kOutside);
    for (const PartRegion& part : parts) {
        core::Polygon ring;
        for (const core::Point& p : part.ring) ring.push_back({(p.x + 1) * 0.5 * size, (1 - p.y) * 0.5 * size});
        const CoverageImage fill = fill_polygon(ring, size, size);
        const bool coloured = part.colour >= 0 && part.colour < palette::kPartCount;
        for (int y = 0; y < fill.coverage.height; ++y) {
            for (int x = 0; x < fill.coverage.width; ++x) {
                if (fill.coverage.at(x, y) < 128) continue;
                labels.at(fill.x + x, fill.y + y) = coloured ? static_cast<std::uint8_t>(part.colour) : kClayLabel;
            }
        }
    }
    return labels;
}

/// Grows every label by one pixel into what no part owns.
void grow(core::GrayImage& labels) {
    const core::GrayImage before = labels;
    constexpr std::array<std::array<int, 2>, 4> kSteps{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    for (int y = 0; y < labels.height; ++y) {
        for (int x = 0; x < labels.width; ++x) {
            if (before.at(x, y) != kOutside) continue;
            for (const auto& step : kSteps) {
                const int nx = x + step[0], ny = y + step[1];
                if (nx < 0 || ny < 0 || nx >= labels.width || ny >= labels.height) continue;
                if (before.at(nx, ny) != kOutside) labels.at(x, y) = before.at(nx, ny);
            }
        }
    }
}

/// A running mean of 2 * radius + 1 cells along lines of `count` cells `step` apart.
void blur_lines(std::vector<float>& cells, int lines, int line_step, int count, int step, int radius) {
    std::vector<float> line(static_cast<std::size_t>(count));
    for (int l = 0; l < lines; ++l) {
        float* base = cells.data() + static_cast<std::ptrdiff_t>(l) * line_step;
        for (int i = 0; i < count; ++i) line[static_cast<std::size_t>(i)] = base[static_cast<std::ptrdiff_t>(i) * step];
        const auto at = [&](int i) { return line[static_cast<std::size_t>(std::clamp(i, 0, count - 1))]; };
        float sum = 0;
        for (int i = -radius; i <= radius; ++i) sum += at(i);
        for (int i = 0; i < count; ++i) {
            base[static_cast<std::ptrdiff_t>(i) * step] = sum / static_cast<float>(2 * radius + 1);
            sum += at(i + radius + 1) - at(i - radius);
        }
    }
}

}  // namespace

core::GrayImage part_labels(const std::vector<PartRegion>& parts, int size) {
    core::GrayImage labels = label_parts(parts, size);
    for (int i = 0; i < size / 40 + 2; ++i) grow(labels);
    return labels;
}

core::RgbaImage bake_part_map(const std::vector<PartRegion>& parts, int size, double blend) {
    const core::GrayImage labels = part_labels(parts, size);
    const int radius = std::max(1, static_cast<int>(std::lround(blend * size / 2)));
    const std::size_t pixels = labels.pixels.size();
    std::vector<float> red(pixels), green(pixels), blue(pixels), coloured(pixels), all(pixels);
    std::vector<float> weight(pixels);
    for (int label = 0; label < kLabels; ++label) {
        bool present = false;
        for (std::size_t i = 0; i < pixels; ++i) {
            weight[i] = labels.pixels[i] == label ? 1.0F : 0.0F;
            present = present || labels.pixels[i] == label;
        }
        if (!present) continue;
        for (int pass = 0; pass < 2; ++pass) {
            blur_lines(weight, size, size, size, 1, radius);
            blur_lines(weight, size, 1, size, size, radius);
        }
        const Colour colour =
            label < palette::kPartCount ? palette::parts()[static_cast<std::size_t>(label)] : Colour{};
        for (std::size_t i = 0; i < pixels; ++i) {
            all[i] += weight[i];
            if (label == kClayLabel) continue;
            coloured[i] += weight[i];
            red[i] += weight[i] * colour.r;
            green[i] += weight[i] * colour.g;
            blue[i] += weight[i] * colour.b;
        }
    }
    core::RgbaImage map;
    map.width = map.height = size;
    map.pixels.resize(pixels * 4);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float scale = all[i] > 0.02F ? 255.0F / all[i] : 0.0F;
        const std::array<float, 4> rgba{red[i], green[i], blue[i], coloured[i]};
        for (std::size_t c = 0; c < 4; ++c) {
            map.pixels[i * 4 + c] = static_cast<std::uint8_t>(std::lround(std::min(rgba[c] * scale, 255.0F)));
        }
    }
    return map;
}

}  // namespace ui
