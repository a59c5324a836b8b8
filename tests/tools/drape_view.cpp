// Hangs worked designs under gravity and measures it.
//
//     drape_view FOLDER [NAME] [SECONDS] [VERTICES]    a line of figures for each second; FOLDER/NAME-drape.png: as
//                                                      drawn, after that time, and from the side
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "core/exchange/png_writer.hpp"
#include "core/garment/drape.hpp"
#include "core/garment/wardrobe.hpp"
#include "core/mesh/crossings.hpp"
#include "support/fine_garment.hpp"
#include "support/mesh_picture.hpp"

int main(int argc, char** argv) {
    if (argc < 2) return std::fprintf(stderr, "drape_view FOLDER [NAME] [SECONDS] [VERTICES]\n"), 2;
    const std::string name = argc > 2 ? argv[2] : "dress";
    const int seconds = argc > 3 ? std::atoi(argv[3]) : 10;
    const auto vertices = static_cast<std::size_t>(argc > 4 ? std::atoi(argv[4]) : 10000);
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    const auto design = core::wardrobe_design(name, body);
    if (!design) return std::fprintf(stderr, "%s\n", design.error().sentence().c_str()), 1;
    const core::Garment garment = support::garment_of(*design, body, vertices);
    const core::Obstacle obstacle = *core::Obstacle::of_body(core::dress_form(body));
    const core::QuadMesh drawn = core::joined_layers(garment.layers);
    const std::vector<core::SewnVertex> sewn = core::sewn(garment.layers);
    core::Drape drape(drawn, obstacle, {}, core::banded(garment.layers, obstacle), sewn);
    std::printf("%zu vertices are sewn to cloth below\n", sewn.size());
    std::printf("%s: %zu vertices, sheets %.2f cm apart; as drawn %zu quads through the body, %zu through themselves\n",
                name.c_str(), drawn.vertices.size(), drape.thickness_cm(),
                core::mesh_crossings(drawn, body.mesh).size(), core::self_crossings(drawn).size());
    bool good = true;
    for (int second = 1; second <= seconds; ++second) {
        std::vector<double> ms;
        std::size_t through = 0;
        for (int k = 0; k < 60; ++k) {
            const std::clock_t start = std::clock();  // of this process alone, whatever else runs
            drape.step();
            ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
            if (k % 20 != 19) continue;
            const core::QuadMesh now{drape.places(), drawn.quads};
            const auto crossings = core::mesh_crossings(now, body.mesh);
            through += crossings.size();
            if (crossings.empty() || k != 59) continue;
            const core::Vec3 at = now.vertices[now.quads[crossings.front().first][0]];
            std::printf("     the first near (%.1f, %.1f, %.1f)\n", at.x, at.y, at.z);
        }
        std::sort(ms.begin(), ms.end());
        double lowest = 1e300, closest = 1e300;
        for (const core::Vec3& p : drape.places()) {
            lowest = std::min(lowest, p.y);
            closest = std::min(closest, obstacle.distance(p));
        }
        std::printf(
            "%2d s: %.1f ms a step (median; fastest %.1f), %zu quads through the body, %zu through themselves, lowest "
            "%.1f cm, closest %.2f cm, speed %.1f cm/s\n",
            second, ms[30], ms[0], through, core::self_crossings({drape.places(), drawn.quads}).size(), lowest, closest,
            drape.mean_speed_cm_s());
        good = good && through == 0;
    }
    const core::QuadMesh hanging{drape.places(), drawn.quads};
    const auto picture = [&](const core::QuadMesh& cloth, double yaw) {
        return support::draw_meshes({{&body.mesh, {216, 207, 191}, false}, {&cloth, {110, 140, 190}, false}},
                                    {yaw, 0, 520, 760});
    };
    const auto written = core::write_png(
        std::string(argv[1]) + "/" + name + "-drape.png",
        support::side_by_side({picture(drawn, 0), picture(hanging, 0), picture(drawn, 35), picture(hanging, 35)}));
    if (!written) return std::fprintf(stderr, "%s\n", written.error().sentence().c_str()), 1;
    return good ? 0 : 1;
}
