// Shows what the cameras see of a model, and measures how long reading and rendering take.
//
//     view_sheet MODEL SHEET.png     the 50 silhouettes by camera number, ten a row; a representative has a green frame
//     view_sheet --measure FOLDER    reads every model of a folder and renders its 25 views at 256 px; a line of times
//     each
//                                    for reading and rendering, and every model that fails
#include <png.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "core/exchange/mesh_reader.hpp"
#include "core/mesh/normalise.hpp"
#include "core/views/cameras.hpp"
#include "core/views/silhouette_render.hpp"

namespace {

namespace fs = std::filesystem;

constexpr int kCellPx = 160;
constexpr int kColumns = 10;

core::Result<core::TriangleMesh> read_normalised(const fs::path& path) {
    core::Result<core::TriangleMesh> mesh = core::read_mesh(path);
    return mesh ? core::normalised_mesh(std::move(*mesh)) : std::move(mesh);
}

bool write_png(const std::string& path, const core::RgbaImage& sheet) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(sheet.width);
    png.height = static_cast<png_uint_32>(sheet.height);
    png.format = PNG_FORMAT_RGBA;
    return png_image_write_to_file(&png, path.c_str(), 0, sheet.pixels.data(), 0, nullptr) != 0;
}

int write_sheet(const fs::path& model, const std::string& sheet_path) {
    const core::Result<core::TriangleMesh> mesh = read_normalised(model);
    if (!mesh) return std::fprintf(stderr, "%s\n", mesh.error().sentence().c_str()), 1;
    core::RgbaImage sheet{kColumns * kCellPx, core::kCameraCount / kColumns * kCellPx, {}};
    sheet.pixels.assign(static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height) * 4, 255);
    for (int c = 0; c < core::kCameraCount; ++c) {
        const core::Camera& camera = core::cameras()[static_cast<std::size_t>(c)];
        const core::BinaryImage view = core::render_silhouette(*mesh, camera, kCellPx);
        for (int y = 0; y < kCellPx; ++y) {
            for (int x = 0; x < kCellPx; ++x) {
                const bool frame = x == 0 || y == 0;
                if (!frame && view.at(x, y) == 0) continue;
                const int sheet_x = c % kColumns * kCellPx + x, sheet_y = c / kColumns * kCellPx + y;
                std::uint8_t* pixel =
                    &sheet.pixels[(static_cast<std::size_t>(sheet_y) * static_cast<std::size_t>(sheet.width) +
                                   static_cast<std::size_t>(sheet_x)) *
                                  4];
                const bool representative = core::representative_of(c) == c;
                pixel[0] = pixel[2] = frame && !representative ? 200 : 0;
                pixel[1] = frame ? 200 : 0;
            }
        }
    }
    return write_png(sheet_path, sheet) ? 0 : 1;
}

/// Of this process alone, whatever else the machine does.
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

int measure(const fs::path& folder) {
    std::vector<fs::path> models;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (core::has_mesh_extension(entry.path())) models.push_back(entry.path());
    }
    std::sort(models.begin(), models.end());
    std::vector<double> read_s, render_s;
    std::size_t triangles = 0;
    for (const fs::path& model : models) {
        const double start = processor_seconds();
        const core::Result<core::TriangleMesh> mesh = read_normalised(model);
        if (!mesh) {
            std::printf("%s\n", mesh.error().sentence().c_str());
            continue;
        }
        read_s.push_back(processor_seconds() - start);
        triangles += mesh->triangles.size();
        const double begin = processor_seconds();
        for (const int c : core::representative_cameras()) {
            const core::BinaryImage view =
                core::render_silhouette(*mesh, core::cameras()[static_cast<std::size_t>(c)], 256);
            if (std::count(view.pixels.begin(), view.pixels.end(), 1) == 0) {
                std::printf("%s: nothing to be seen by camera %d\n", model.c_str(), c);
            }
        }
        render_s.push_back(processor_seconds() - begin);
    }
    const auto report = [](const char* what, const std::vector<double>& s) {
        if (s.empty()) return;
        const double sum = std::accumulate(s.begin(), s.end(), 0.0);
        std::printf("%s: total %.2f s, mean %.2f ms, largest %.2f ms\n", what, sum,
                    1e3 * sum / static_cast<double>(s.size()), 1e3 * *std::max_element(s.begin(), s.end()));
    };
    std::printf("%zu of %zu models, %zu triangles\n", read_s.size(), models.size(), triangles);
    report("reading and normalising", read_s);
    report("25 views at 256 px", render_s);
    return read_s.size() == models.size() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return std::fprintf(stderr, "view_sheet MODEL SHEET.png | view_sheet --measure FOLDER\n"), 2;
    return std::string(argv[1]) == "--measure" ? measure(argv[2]) : write_sheet(argv[1], argv[2]);
}
