#include "core/parts/readings.hpp"

namespace core {

ShapeParameters reading_parameters(std::size_t reading, const ShapeParameters& base) {
    ShapeParameters p = base;
    if (reading == 1) p.sample_size = base.sample_size * 6 / 5;
    if (reading == 2) p.contour_sigma = base.contour_sigma * 1.5;
    return p;
}

ShapeReadings further_readings(const Polygon& contour, const ShapeDescriptor& first, const ShapeParameters& base) {
    ShapeReadings further;
    for (std::size_t k = 1; k < kReadingCount; ++k) {
        Result<ShapeDescriptor> reading = describe(contour, reading_parameters(k, base));
        further.push_back(reading ? std::move(*reading) : first);
    }
    return further;
}

Result<ShapeReadings> describe_readings(const Polygon& contour, const ShapeParameters& base) {
    Result<ShapeDescriptor> first = describe(contour, base);
    if (!first) return unexpected(first.error());
    ShapeReadings all = further_readings(contour, *first, base);
    all.insert(all.begin(), std::move(*first));
    return all;
}

}  // namespace core
