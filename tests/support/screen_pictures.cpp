// Writes a picture of every screen of the kiosk at every size it is designed for.
//
//     screen_pictures DIR [--only NAME] [--size WxH]

#include <cstdio>
#include <filesystem>
#include <string>

#include "core/exchange/png_writer.hpp"
#include "tests/support/scenes.hpp"

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "screen_pictures DIR [--only NAME] [--size WxH]\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::string only;
    std::vector<ui::SizePx> sizes = test::all_sizes();
    bool all = true;  // sizes that are kept
    for (int i = 2; i + 1 < argc; i += 2) {
        if (std::string(argv[i]) == "--only") only = argv[i + 1];
        ui::SizePx size;
        if (std::sscanf(argv[i + 1], "%dx%d", &size.width, &size.height) == 2) {
            sizes = {size};
            all = false;
        }
    }
    std::filesystem::create_directories(folder);
    const auto base = std::make_shared<test::StandBase>();
    for (const test::NamedScene& scene : test::all_scenes()) {
        if (!only.empty() && scene.name.find(only) == std::string::npos) continue;
        for (const ui::SizePx size : sizes) {
            if (all && scene.garment && !test::is_kept_at(scene, size)) continue;
            const std::string at = "-" + std::to_string(size.width) + "x" + std::to_string(size.height);
            int number = 0;
            for (const core::RgbaImage& picture : test::pictures_of(scene, size, base)) {
                const std::string step = scene.step ? "-" + std::to_string(++number) : "";
                const std::filesystem::path file = folder / (scene.name + step + at + ".png");
                if (!core::write_png(file, picture)) return 1;
                std::printf("%s\n", file.string().c_str());
                std::fflush(stdout);
            }
        }
    }
    return 0;
}
