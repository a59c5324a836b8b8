#pragma once
// The colours of the starter collection: one muted, coordinated set, so that any two models look well side by side.

#include "core/mesh/triangle_mesh.hpp"

namespace core::starter {

inline constexpr Rgb kCream{243, 232, 209}, kIvory{236, 222, 190}, kWhite{246, 243, 236}, kSand{219, 194, 148},
    kStraw{229, 192, 110}, kMustard{222, 165, 58}, kHoney{201, 138, 62}, kOrange{226, 128, 58}, kCoral{229, 116, 94},
    kRed{200, 70, 62}, kBrick{168, 79, 62}, kWine{128, 48, 62}, kPink{236, 174, 176}, kRose{219, 130, 142},
    kPlum{131, 92, 138}, kLilac{180, 160, 208}, kSky{141, 192, 222}, kBlue{74, 126, 178}, kNavy{52, 74, 110},
    kTeal{62, 138, 140}, kMint{158, 208, 184}, kLeaf{112, 158, 84}, kGreen{78, 128, 82}, kForest{54, 94, 70},
    kOlive{140, 140, 76}, kTan{190, 146, 100}, kWood{172, 118, 74}, kWalnut{122, 80, 54}, kChestnut{142, 84, 52},
    kCocoa{92, 64, 50}, kStone{184, 178, 168}, kGrey{142, 142, 144}, kSlate{92, 100, 110}, kSteel{170, 180, 188},
    kInk{46, 42, 42}, kGlass{176, 212, 224}, kBrass{206, 168, 88};

/// Part of the way from a to b: t = 0 gives a, t = 1 gives b.
[[nodiscard]] constexpr Rgb mixed(Rgb a, Rgb b, double t) {
    const auto channel = [t](std::uint8_t from, std::uint8_t to) {
        // NOLINTNEXTLINE(bugprone-incorrect-roundings): never below 0, and lround is not constexpr
        return static_cast<std::uint8_t>(from + (to - from) * t + 0.5);
    };
    return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}
[[nodiscard]] constexpr Rgb darker(Rgb c, double t = 0.25) {
    return mixed(c, Rgb{30, 26, 30}, t);
}
[[nodiscard]] constexpr Rgb lighter(Rgb c, double t = 0.3) {
    return mixed(c, Rgb{255, 252, 244}, t);
}

}  // namespace core::starter
