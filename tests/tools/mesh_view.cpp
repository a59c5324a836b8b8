// Draws OBJ meshes, to look at them.
//
//     mesh_view OUT.png [--plain] [--size WxH] [--views YAW,PITCH...] MESH.obj...    each mesh in a colour of its own
//
// Without --views: front, side, three-quarter. --plain leaves the edges of the faces out.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "core/exchange/png_writer.hpp"
#include "support/mesh_picture.hpp"

namespace {

/// Vertices and faces of an OBJ file; a face of n corners becomes quads, a triangle one with its last corner twice.
core::QuadMesh read_obj(const std::string& path) {
    core::QuadMesh mesh;
    std::ifstream in(path);
    for (std::string text; std::getline(in, text);) {
        std::istringstream line(text);
        std::string word;
        line >> word;
        if (word == "v") {
            core::Vec3 p;
            line >> p.x >> p.y >> p.z;
            mesh.vertices.push_back(p);
        } else if (word == "f") {
            std::vector<std::uint32_t> face;
            while (line >> word) face.push_back(static_cast<std::uint32_t>(std::atoi(word.c_str()) - 1));
            for (std::size_t k = 1; k + 1 < face.size(); k += 2)
                mesh.quads.push_back({face[0], face[k], face[k + 1], face[std::min(k + 2, face.size() - 1)]});
        }
    }
    return mesh;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<core::Rgb> colours{{216, 207, 191}, {120, 150, 190}, {190, 120, 110}, {130, 170, 120}};
    std::vector<support::PictureView> views;
    std::vector<core::QuadMesh> meshes;
    int width = 500, height = 800;
    bool wire = true;
    for (int i = 2; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--plain") {
            wire = false;
        } else if (word == "--size" && i + 1 < argc) {
            if (std::sscanf(argv[++i], "%dx%d", &width, &height) != 2) return 2;
        } else if (word == "--views") {
            for (double yaw = 0, pitch = 0; i + 1 < argc && std::sscanf(argv[i + 1], "%lf,%lf", &yaw, &pitch) == 2; ++i)
                views.push_back({yaw, pitch});
        } else {
            meshes.push_back(read_obj(word));
        }
    }
    if (meshes.empty())
        return std::fprintf(stderr, "mesh_view OUT.png [--plain] [--size WxH] [--views YAW,PITCH...] MESH.obj...\n"), 2;
    if (views.empty()) views = {{0, 0}, {90, 0}, {35, 10}};
    std::vector<core::RgbaImage> pictures;
    for (support::PictureView view : views) {
        view.width = width, view.height = height;
        std::vector<support::PictureMesh> parts;
        for (std::size_t k = 0; k < meshes.size(); ++k)
            parts.push_back({&meshes[k], colours[k % colours.size()], wire});
        pictures.push_back(support::draw_meshes(parts, view));
    }
    const auto written = core::write_png(argv[1], support::side_by_side(pictures));
    if (!written) return std::fprintf(stderr, "%s\n", written.error().sentence().c_str()), 1;
}
