#pragma once
// The measures of a body, in centimetres, as a tailor takes them: girths with a level tape, heights above the floor.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace core {

enum class Figure { Woman, Man };

/// In the order of measure_names().
enum class Measure {
    Stature,
    Bust,       ///< fullest, level; the chest of a man
    UnderBust,  ///< women only
    Waist,
    Hip,
    Neck,  ///< at half its height
    Biacromial,
    UpperArm,
    Wrist,
    ArmLength,
    Thigh,  ///< of one leg, below the crotch
    Knee,
    Calf,
    Ankle,
    BustHeight,
    WaistHeight,
    HipHeight,
    CrotchHeight,
    KneeHeight,
    NapeToWaist,
};
inline constexpr std::size_t kMeasureCount = 20;

/// "stature", "bust", "under_bust", … one for each Measure.
[[nodiscard]] const std::array<std::string_view, kMeasureCount>& measure_names();

struct BodyMeasures {
    Figure figure = Figure::Woman;
    std::array<double, kMeasureCount> cm{};

    [[nodiscard]] double operator[](Measure m) const { return cm[static_cast<std::size_t>(m)]; }
    [[nodiscard]] double& operator[](Measure m) { return cm[static_cast<std::size_t>(m)]; }
};

/// Women's EU sizes "36" to "44" in steps of 2, the odd numbers between them interpolated, and men's "m". Size labels
/// shift between countries: these are body measures under a name. ErrorCode::BadArgument names what there is.
[[nodiscard]] Result<BodyMeasures> measures_of_size(std::string_view size);

/// Sets one measure by name; "chest" is another name of "bust". ErrorCode::BadArgument for a name that does not exist,
/// with all that do, and for a value that is no positive finite number.
[[nodiscard]] Result<void> set_measure(BodyMeasures& measures, std::string_view name, double cm);

/// Whether a mannequin can be made: heights in order and apart, girths that fit each other. ErrorCode::BadArgument
/// names the measures at fault.
[[nodiscard]] Result<void> check_measures(const BodyMeasures& measures);

}  // namespace core
