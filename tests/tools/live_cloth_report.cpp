// How long a drag and a slider take at the garment desk.
//
//     live_cloth_report [VERTICES]     a dress of about so many vertices (10,000): time from a pen sample or a slider
//                                      place to the places of all vertices, drawing apart; median and 95th percentile
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/garment/desk/garment_desk.hpp"
#include "core/garment/wardrobe.hpp"

namespace {

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void print_times(const char* what, std::vector<double> ms) {
    std::sort(ms.begin(), ms.end());
    std::printf("%-28s %zu times: median %.1f ms, 95 %% within %.1f ms, at most %.1f ms\n", what, ms.size(),
                ms[ms.size() / 2], ms[ms.size() * 95 / 100], ms.back());
}

/// A vertex of the hem drawn about, there and back, as the pen does.
void report_drag(core::GarmentDesk& desk, core::Vec3 vertex, const char* what) {
    const core::DrawingView front = *core::named_view("front");
    desk.settings().tool = core::DeskTool::Move;
    std::vector<double> ms;
    desk.begin(front, front.project(vertex));
    for (int k = 1; k <= 200; ++k) {
        const core::Point to = front.project(vertex) + core::Point{3.0 * std::sin(0.1 * k), 2.0 * std::sin(0.07 * k)};
        const auto start = std::chrono::steady_clock::now();
        desk.extend(front, to);
        ms.push_back(ms_since(start));
    }
    std::printf("%s: live %s\n", what, desk.live() ? "yes" : "no");
    desk.cancel();
    std::printf("  first sample %.1f ms (analysis of every piece)\n", ms.front());
    ms.erase(ms.begin());
    print_times("  drag", std::move(ms));
}

void report_slider(core::GarmentDesk& desk, const std::string& region) {
    std::vector<double> ms;
    for (int k = 0; k <= 200; ++k) {
        const auto start = std::chrono::steady_clock::now();
        desk.slide_alpha(region, -0.25 * (0.5 + 0.5 * std::sin(0.1 * k)));
        ms.push_back(ms_since(start));
    }
    desk.drop_live();
    ms.erase(ms.begin());
    print_times(("  alpha of " + region).c_str(), std::move(ms));
}

}  // namespace

int main(int argc, char** argv) {
    const double vertices = argc > 1 ? std::atof(argv[1]) : 10000.0;
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    core::Design design = *core::wardrobe_design("dress", body);
    design.network.edge_cm *= std::sqrt(1790.0 / vertices);
    core::Result<core::GarmentDesk> desk = core::GarmentDesk::open(design, core::dress_form(body));
    if (!desk) {
        std::fprintf(stderr, "%s\n", desk.error().sentence().c_str());
        return 1;
    }
    const auto start = std::chrono::steady_clock::now();
    desk->build_now();
    std::printf("%zu vertices; built in %.0f ms\n", desk->cloth()[0].cloth->fitted.mesh.vertices.size(),
                ms_since(start));
    const core::NetworkRegion& skirt = *desk->network().find_region("skirt");
    core::Vec3 hem, shoulder;
    for (const core::LineUse use : skirt.ring) {
        const core::NetworkLine& line = desk->network().lines()[static_cast<std::size_t>(use.line)];
        if (line.name == "hem") hem = line.shape.front();
    }
    shoulder = desk->network().lines().front().shape.back();
    report_drag(*desk, hem, "end of the hem");
    report_drag(*desk, shoulder, "tip of the shoulder");
    for (const char* region : {"skirt", "front", "sleeve_back"}) report_slider(*desk, region);
    return 0;
}
