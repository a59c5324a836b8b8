#include "core/mannequin/body_measures.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace core {
namespace {

constexpr std::array<std::string_view, kMeasureCount> kNames{
    "stature",     "bust",         "under_bust", "waist",         "hip",         "neck",         "biacromial",
    "upper_arm",   "wrist",        "arm_length", "thigh",         "knee",        "calf",         "ankle",
    "bust_height", "waist_height", "hip_height", "crotch_height", "knee_height", "nape_to_waist"};

using Row = std::array<double, kMeasureCount>;

/// Women's sizes 36, 38, … 44; stature 168.
constexpr std::array<Row, 5> kWomen{
    Row{168, 84, 69.3, 68, 92, 32.7, 36.7, 27.2, 15.5, 58, 54.8, 34.6, 34.3, 20.9, 120, 103, 82.7, 75.7, 45, 40.6},
    Row{168, 88, 72.3, 72, 96, 33.6, 37.0, 28.4, 16, 58.5, 57.3, 35.7, 35.3, 21.4, 120, 104, 83.4, 76, 45.5, 41},
    Row{168, 92, 76.1, 76, 100, 34.6, 37.3, 29.6, 16.5, 59, 59.7, 36.7, 36.3, 21.8, 120, 105, 84.1, 76.3, 46, 41.4},
    Row{168, 96, 80.1, 80, 104, 35.6, 37.6, 30.8, 17, 59.5, 62.2, 37.8, 37.3, 22.3, 120, 106, 84.8, 76.6, 46.5, 41.8},
    Row{168, 100, 84, 84, 108, 36.6, 37.9, 32, 17.5, 60, 64.6, 38.8, 38.3, 22.8, 120, 107, 85.5, 76.9, 47, 42.2}};
constexpr Row kMan{177, 100, 0, 88, 100, 40, 41, 32, 17.5, 59.5, 57, 38, 38, 23.5, 126.4, 110.2, 88, 81, 50.3, 42};

Unexpected bad(std::string what) {
    return unexpected(ErrorCode::BadArgument, std::move(what));
}

std::string name_of(Measure m) {
    return std::string(kNames[static_cast<std::size_t>(m)]);
}

std::string number(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 4);
    return {digits.data(), end.ptr};
}

/// `low` must be smaller than `high` by `apart`.
struct Order {
    Measure low, high;
    double apart;
};
constexpr std::array kOrders{Order{Measure::KneeHeight, Measure::CrotchHeight, 18.0},
                             Order{Measure::CrotchHeight, Measure::HipHeight, 3.0},
                             Order{Measure::HipHeight, Measure::WaistHeight, 8.0},
                             Order{Measure::WaistHeight, Measure::BustHeight, 8.0},
                             Order{Measure::BustHeight, Measure::Stature, 34.0},
                             Order{Measure::Ankle, Measure::Knee, 5.0},
                             Order{Measure::Ankle, Measure::Calf, 5.0},
                             Order{Measure::Wrist, Measure::UpperArm, 4.0},
                             Order{Measure::Thigh, Measure::Hip, 20.0},
                             Order{Measure::Knee, Measure::Thigh, 6.0},
                             Order{Measure::Waist, Measure::Hip, -25.0}};

/// What a body that stands may have.
struct Span {
    Measure measure;
    double low, high;
};
constexpr std::array kSpans{
    Span{Measure::Stature, 130, 220},  Span{Measure::Bust, 60, 160},         Span{Measure::Waist, 45, 160},
    Span{Measure::Hip, 65, 170},       Span{Measure::Neck, 24, 55},          Span{Measure::Biacromial, 27, 52},
    Span{Measure::UpperArm, 17, 55},   Span{Measure::Wrist, 11, 24},         Span{Measure::ArmLength, 42, 80},
    Span{Measure::Thigh, 38, 90},      Span{Measure::Knee, 26, 60},          Span{Measure::Calf, 24, 60},
    Span{Measure::Ankle, 16, 36},      Span{Measure::BustHeight, 85, 165},   Span{Measure::WaistHeight, 75, 145},
    Span{Measure::HipHeight, 60, 120}, Span{Measure::CrotchHeight, 52, 110}, Span{Measure::KneeHeight, 30, 70},
    Span{Measure::NapeToWaist, 30, 55}};

}  // namespace

const std::array<std::string_view, kMeasureCount>& measure_names() {
    return kNames;
}

Result<BodyMeasures> measures_of_size(std::string_view size) {
    if (size == "m" || size == "M") return BodyMeasures{Figure::Man, kMan};
    int number_of = 0;
    const auto read = std::from_chars(size.data(), size.data() + size.size(), number_of);
    if (read.ec != std::errc() || read.ptr != size.data() + size.size() || number_of < 36 || number_of > 44)
        return bad("There is no size \"" + std::string(size) +
                   "\"; give 36 to 44 for a woman, m for a man, or measures.");
    const auto below = static_cast<std::size_t>((number_of - 36) / 2);
    const std::size_t above = std::min(below + static_cast<std::size_t>(number_of % 2), kWomen.size() - 1);
    BodyMeasures measures{Figure::Woman, {}};
    for (std::size_t k = 0; k < kMeasureCount; ++k) measures.cm[k] = 0.5 * (kWomen[below][k] + kWomen[above][k]);
    return measures;
}

Result<void> set_measure(BodyMeasures& measures, std::string_view name, double cm) {
    if (name == "chest") name = "bust";
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) {
        std::string all;
        for (const std::string_view known : kNames) all += (all.empty() ? "" : ", ") + std::string(known);
        return bad("There is no measure \"" + std::string(name) + "\"; there are " + all + ".");
    }
    if (!std::isfinite(cm) || cm <= 0.0)
        return bad("The measure " + std::string(name) + " must be a number of centimetres above 0.");
    measures.cm[static_cast<std::size_t>(found - kNames.begin())] = cm;
    return {};
}

Result<void> check_measures(const BodyMeasures& m) {
    for (const Span& span : kSpans)
        if (!(m[span.measure] >= span.low && m[span.measure] <= span.high))
            return bad("The measure " + name_of(span.measure) + " is " + number(m[span.measure]) +
                       " cm; a mannequin has " + number(span.low) + " to " + number(span.high) + " cm there.");
    for (const Order& order : kOrders)
        if (!(m[order.low] + order.apart <= m[order.high]))
            return bad("The measures " + name_of(order.low) + " (" + number(m[order.low]) + " cm) and " +
                       name_of(order.high) + " (" + number(m[order.high]) + " cm) do not fit one body.");
    const double nape = m[Measure::WaistHeight] + m[Measure::NapeToWaist];
    if (!(nape >= m[Measure::BustHeight] + 12.0 && nape <= m[Measure::Stature] - 14.0))
        return bad("The measure nape_to_waist (" + number(m[Measure::NapeToWaist]) +
                   " cm) puts the nape too near the bust or the top of the head.");
    if (m.figure == Figure::Woman &&
        !(m[Measure::UnderBust] >= 50.0 && m[Measure::UnderBust] <= m[Measure::Bust] - 3.0))
        return bad("The measure under_bust (" + number(m[Measure::UnderBust]) +
                   " cm) must be 50 cm at least and 3 cm less "
                   "than the bust.");
    return {};
}

}  // namespace core
