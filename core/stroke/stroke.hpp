#pragma once
// What a pen leaves: samples in time, grouped into strokes, grouped into a drawing.

#include <cstdint>
#include <vector>

#include "core/geometry/point.hpp"

namespace core {

/// One position of the pen tip on the sheet.
struct PenSample {
    std::int64_t time_us = 0;  ///< monotonic, from the start of the drawing
    double x = 0.0;            ///< in the drawing's own units, y DOWN as sheets, screens and files have it
    double y = 0.0;
    double pressure = 1.0;  ///< 0 … 1; 1 where the device reports none
};

/// From tip down to tip up. Never empty in a Drawing.
struct Stroke {
    std::vector<PenSample> samples;
};

struct Drawing {
    std::vector<Stroke> strokes;
    [[nodiscard]] bool empty() const { return strokes.empty(); }
};

}  // namespace core
