// How long a frame of Garment takes with a dress of some ten thousand vertices, and where the time goes.
//
//     garment_frames [WxH] [FRAMES]
//
// Medians over the frames, drawing finished (glFinish) before the clock is read.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <thread>

#include "core/garment/wardrobe.hpp"
#include "tests/support/garment_hand.hpp"
#include "ui/gl/objects.hpp"

namespace {

double median_ms(int frames, const std::function<void(int)>& work) {
    std::vector<double> times;
    for (int i = 0; i < frames; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work(i);
        ui::finish();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::nth_element(times.begin(), times.begin() + frames / 2, times.end());
    return times[static_cast<std::size_t>(frames / 2)];
}

/// Three seconds under gravity on the drape's own thread, while this one looks for the newest places 60 times a second.
void hang(test::KioskStand& kiosk) {
    using Clock = std::chrono::steady_clock;
    app::GarmentDrape drape(true);
    const auto start = Clock::now();
    drape.start(kiosk.garment->desk().cloth(), kiosk.garment->desk().state().worn(), 0);
    int seen = 0, looks = 0;
    double first_ms = 0, most_ms = 0;
    while (Clock::now() - start < std::chrono::seconds(3)) {
        const auto before = Clock::now();
        const bool news = drape.take().has_value();
        most_ms = std::max(most_ms, std::chrono::duration<double, std::milli>(Clock::now() - before).count());
        if (news && seen++ == 0) first_ms = std::chrono::duration<double, std::milli>(before - start).count();
        ++looks;
        std::this_thread::sleep_until(start + looks * std::chrono::microseconds(16'667));
    }
    std::printf(
        "it hangs: %.1f states a second came to the screen, the first after %.0f ms; a look took %.2f ms at most\n",
        seen / 3.0, first_ms, most_ms);
}

}  // namespace

int main(int argc, char** argv) {
    ui::SizePx size{1920, 1080};
    if (argc > 1) (void)std::sscanf(argv[1], "%dx%d", &size.width, &size.height);
    const int frames = argc > 2 ? std::max(3, std::atoi(argv[2])) : 15;
    test::KioskStand kiosk(size);
    test::GarmentHand hand(kiosk);
    hand.enter();
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    core::Design dress = *core::wardrobe_design("dress", body);
    dress.network.edge_cm = 1.15;
    if (!kiosk.garment->open(dress)) return 1;
    kiosk.garment->settle(kiosk.now_us);
    std::size_t vertices = 0;
    for (const core::BuiltLayer& layer : kiosk.garment->desk().cloth()) {
        vertices += layer.cloth->fitted.mesh.vertices.size();
    }
    std::printf("%zu vertices of cloth, %d x %d, %s\n", vertices, size.width, size.height, ui::renderer_name().c_str());
    ui::Target screen(size, ui::PixelFormat::Colour);
    app::FigureViews& views = kiosk.garment->views();
    const auto paint = [&](int) {
        screen.bind();
        kiosk.garment->draw(kiosk.now_us, false);
    };
    std::printf("nothing changed, the frame as a whole: %.1f ms\n", median_ms(frames, paint));
    const auto picture = [&](int) {
        views.move_by({0, 0});
        (void)views.draw();
    };
    std::printf("the large picture of figure and cloth: %.1f ms\n", median_ms(frames, picture));
    std::printf("lines over it: projected and hidden ones found: %.1f ms\n", median_ms(frames, [&](int) {
                    views.move_by({0, 0});
                    kiosk.garment->project_now();
                }));
    const core::BuiltLayer& layer = kiosk.garment->desk().cloth().front();
    const std::vector<core::Vec3> places = layer.cloth->fitted.mesh.vertices;
    std::printf("cloth that moves: upload of a layer: %.1f ms\n",
                median_ms(frames, [&](int) { views.set_places(layer.layer, &places); }));
    views.set_places(-1, nullptr);
    hand.view(ui::GarmentView::Solid);
    std::printf("a frame while the figure turns: %.1f ms\n", median_ms(frames, [&](int) {
                    views.turn(0.02, 0);
                    (void)kiosk.garment->update_ink();
                    paint(0);
                }));
    hang(kiosk);
    return 0;
}
