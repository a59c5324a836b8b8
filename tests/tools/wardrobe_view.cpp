// Makes worked designs on a mannequin and draws them.
//
//     wardrobe_view FOLDER [SIZE] [NAME...]     FOLDER/NAME.png: front, side, back, three-quarter; a line of figures
//     each
#include <cstdio>
#include <ctime>
#include <string>

#include "core/exchange/png_writer.hpp"
#include "core/garment/wardrobe.hpp"
#include "core/mesh/crossings.hpp"
#include "support/mesh_picture.hpp"

int main(int argc, char** argv) {
    if (argc < 2) return std::fprintf(stderr, "wardrobe_view FOLDER [SIZE] [NAME...]\n"), 2;
    const auto measures = core::measures_of_size(argc > 2 ? argv[2] : "38");
    if (!measures) return std::fprintf(stderr, "%s\n", measures.error().sentence().c_str()), 1;
    const core::Mannequin body = *core::make_mannequin(*measures);
    std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
    if (names.empty()) names = core::wardrobe_names();
    const std::vector<core::Rgb> colours{{110, 140, 190}, {190, 110, 110}, {120, 165, 120}};
    bool good = true;
    for (const std::string& name : names) {
        const auto design = core::wardrobe_design(name, body);
        if (!design) return std::fprintf(stderr, "%s\n", design.error().sentence().c_str()), 1;
        const std::clock_t start = std::clock();
        const core::Garment garment = *core::make_garment(*design, core::triangles_of(body.mesh));
        const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        for (const core::DesignFault& fault : garment.faults)
            std::printf("%s, step %d: %s\n", name.c_str(), fault.step, fault.sentence.c_str());
        good = good && garment.faults.empty();
        std::vector<support::PictureMesh> meshes{{&body.mesh, {216, 207, 191}, false}};
        std::printf("%s: %.0f ms", name.c_str(), ms);
        for (std::size_t i = 0; i < garment.layers.size(); ++i) {
            const core::FinishedLayer& layer = garment.layers[i];
            std::size_t below = core::mesh_crossings(layer.fitted.mesh, body.mesh).size();
            for (std::size_t j = 0; j < i; ++j)
                below += core::mesh_crossings(layer.fitted.mesh, garment.layers[j].fitted.mesh).size();
            std::printf(
                "; layer %zu: %zu pieces, %zu vertices, %.2f cm deep before, %.3f cm from the body after, %zu quads "
                "through what is below, stretch %.1f %%",
                i, layer.fitted.pieces.size(), layer.fitted.mesh.vertices.size(), layer.report.deepest_before_cm,
                layer.report.closest_cm, below, 100.0 * layer.report.mean_stretch);
            good = good && below == 0;
            meshes.push_back({&layer.fitted.mesh, colours[i % colours.size()], true});
        }
        std::printf("\n");
        std::vector<core::RgbaImage> views;
        for (const support::PictureView& view :
             {support::PictureView{0, 0, 560, 760}, support::PictureView{90, 0, 420, 760},
              support::PictureView{180, 0, 560, 760}, support::PictureView{35, 12, 560, 760}})
            views.push_back(support::draw_meshes(meshes, view));
        if (const auto written =
                core::write_png(std::string(argv[1]) + "/" + name + ".png", support::side_by_side(views));
            !written)
            return std::fprintf(stderr, "%s\n", written.error().sentence().c_str()), 1;
    }
    return good ? 0 : 1;
}
