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
};

[[nodiscard]] std::vector<NamedScene> all_scenes();
/// Those of Garment, which are among them too.
[[nodiscard]] std::vector<NamedScene> garment_scenes();
[[nodiscard]] bool is_kept_at(const NamedScene& scene, ui::SizePx size);
/// 1920 × 1080, 1280 × 800, 3840 × 2160, 1080 × 1920.
[[nodiscard]] std::vector<ui::SizePx> all_sizes();

}  // namespace test
