#pragma once
// Every screen of the kiosk, each with the way to it.

#include <functional>
#include <string>
#include <vector>

#include "tests/support/kiosk_stand.hpp"

namespace test {

struct NamedScene {
    std::string name;
    app::ShellOptions options;
    std::function<void(KioskStand&)> go;
    bool large = false;    ///< also kept at 3840 × 2160
    bool garment = false;  ///< kept at 1920 × 1080 and 1280 × 800 only: its cloth takes time
    bool upright = false;  ///< of Garment, kept at 1080 × 1920 as well
    /// The stand's options of Garment; none: the usual ones.
    std::function<app::GarmentOptions()> garment_options = {};
    /// Brings the screen from one picture to the next, counted from 0; false: there is none. Without it a scene is one
    /// picture.
    std::function<bool(KioskStand&, std::size_t)> step = {};
};

[[nodiscard]] std::vector<NamedScene> all_scenes();
/// Those of Garment, which are among them too.
[[nodiscard]] std::vector<NamedScene> garment_scenes();
/// A stand at the beginning of a scene.
[[nodiscard]] std::unique_ptr<KioskStand> stand_for(const NamedScene& scene, ui::SizePx size,
                                                    std::shared_ptr<StandBase> base = nullptr);
/// All pictures of a scene.
[[nodiscard]] std::vector<core::RgbaImage> pictures_of(const NamedScene& scene, ui::SizePx size,
                                                       const std::shared_ptr<StandBase>& base = nullptr);
[[nodiscard]] bool is_kept_at(const NamedScene& scene, ui::SizePx size);
/// 1920 × 1080, 1280 × 800, 3840 × 2160, 1080 × 1920.
[[nodiscard]] std::vector<ui::SizePx> all_sizes();

}  // namespace test
