// How long a worked design with many vertices takes to fit to its mannequin, and how well it does.
//
//     fit_report [VERTICES [SIZE [NAME...]]]     a line for each layer; 1 where cloth is left in the body
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "core/mesh/crossings.hpp"
#include "support/fine_garment.hpp"

int main(int argc, char** argv) {
    const auto vertices = static_cast<std::size_t>(argc > 1 ? std::max(100, std::atoi(argv[1])) : 10000);
    const auto measures = core::measures_of_size(argc > 2 ? argv[2] : "38");
    if (!measures) return std::fprintf(stderr, "%s\n", measures.error().sentence().c_str()), 1;
    const core::Mannequin body = *core::make_mannequin(*measures);
    std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
    if (names.empty()) names = core::wardrobe_names();
    bool good = true;
    for (const std::string& name : names) {
        const auto design = core::wardrobe_design(name, body);
        if (!design) return std::fprintf(stderr, "%s\n", design.error().sentence().c_str()), 1;
        const core::Garment garment = support::garment_of(*design, body, vertices);
        core::Obstacle obstacle = *core::Obstacle::of_body(core::dress_form(body));
        for (std::size_t i = 0; i < garment.layers.size(); ++i) {
            std::vector<double> ms;
            core::Cloth fitted;
            core::FittingReport report;
            for (int time = 0; time < 5; ++time) {
                fitted = garment.layers[i].drawn;
                const std::clock_t start = std::clock();  // of this process alone, whatever else runs
                report = core::fit_cloth(fitted, obstacle, design->fitting);
                ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
            }
            std::sort(ms.begin(), ms.end());
            std::size_t through = 0;
            for (const core::QuadMesh& below : obstacle.surfaces())
                through += core::mesh_crossings(fitted.mesh, below).size();
            std::printf(
                "%s, layer %zu: %zu vertices fitted in %.0f ms (median of 5; most %.0f), %.2f cm deep before, "
                "%.2f after, %zu quads through what is below, %zu through themselves\n",
                name.c_str(), i, fitted.mesh.vertices.size(), ms[2], ms[4], report.deepest_before_cm,
                report.deepest_after_cm, through, report.self_crossings);
            good = good && through == 0 && report.deepest_after_cm == 0.0;
            obstacle.add_layer(fitted.mesh);
        }
    }
    return good ? 0 : 1;
}
