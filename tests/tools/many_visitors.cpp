// Visitors come and go: each wakes the kiosk, draws, looks at a result, chooses a language, and leaves; the idle wipe
// does the rest. Says how memory and file handles grow.
//
//     many_visitors [VISITORS] [REPLAY.ndjson …]      2000 and a built drawing where nothing is given
//
// Exit code 1 when memory grew by 1 MB or more after the first 100 visitors, or handles by any.

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <thread>

#include "core/exchange/quickdraw_reader.hpp"
#include "firmware_like_app/health/self_test.hpp"
#include "firmware_like_app/kiosk/placing.hpp"
#include "tests/support/kiosk_stand.hpp"

namespace {

constexpr int kWarm = 100;
constexpr double kMostGrowth_mb = 1.0;

void draw(test::KioskStand& kiosk, const core::Drawing& drawing) {
    const ui::Rect sheet = kiosk.find->layout().sheet;
    const ui::InkFrame frame = app::fit_drawing(drawing, sheet.width, sheet.height, 0.14);
    for (const core::Stroke& stroke : drawing.strokes) {
        core::Point p;
        for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
            p = frame.to_px({stroke.samples[i].x, stroke.samples[i].y}) + core::Point{sheet.x, sheet.y};
            kiosk.event(i == 0 ? ui::WindowEvent::Kind::Down : ui::WindowEvent::Kind::Move, p.x, p.y);
        }
        kiosk.event(ui::WindowEvent::Kind::Up, p.x, p.y);
        kiosk.shell->update_ink();
    }
    kiosk.find->search_and_wait();
    kiosk.find->settle(true);
}

void visit(test::KioskStand& kiosk, int number, const core::Drawing& drawing) {
    kiosk.wait(0.2);
    kiosk.tap(kiosk.size.width * 0.7, kiosk.size.height * 0.5);  // wakes
    draw(kiosk, drawing);
    (void)kiosk.picture();
    if (number % 4 == 0) {
        kiosk.tap(kiosk.find->layout().cards[static_cast<std::size_t>(number / 4 % 9)]);
        kiosk.wait(0.4);
        (void)kiosk.picture();
    }
    if (number % 3 == 0) kiosk.find->set_language(static_cast<std::size_t>(number / 3 % 3));
    if (number % 10 == 0) kiosk.tap(kiosk.find->layout().hand_switch);
    kiosk.wait(90);  // Still there?, and the wipe
}

/// The least of some seconds of the attract state, which shows a drawing and its results and puts them away again; what
/// is made beside the frames is let end.
double settled_mb(test::KioskStand& kiosk) {
    double least_mb = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 12; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        kiosk.wait(1);
        (void)kiosk.picture();
        malloc_trim(0);
        least_mb = std::min(least_mb, app::resident_mb());
    }
    return least_mb;
}

/// What the program itself has asked for and not given back, without what the allocator and the driver keep.
double in_use_mb() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) / (1024.0 * 1024.0);
}

}  // namespace

int main(int argc, char** argv) {
    const int visitors = argc > 1 ? std::atoi(argv[1]) : 2000;
    std::vector<core::Drawing> drawings;
    for (int i = 2; i < argc; ++i) {
        if (core::Result<core::Drawing> drawing = core::read_quickdraw(argv[i]))
            drawings.push_back(std::move(*drawing));
    }
    if (drawings.empty()) drawings.push_back(test::make_horse_drawing());
    test::KioskStand kiosk({640, 480});
    double warm_mb = 0;
    int warm_handles = 0;
    for (int i = 0; i < visitors; ++i) {
        visit(kiosk, i, drawings[static_cast<std::size_t>(i) % drawings.size()]);
        if (kiosk.scene() != app::Scene::Attract || !kiosk.find->sketch().empty()) {
            std::printf("visitor %d was not wiped\n", i);
            return 1;
        }
        if (i + 1 == kWarm) {
            warm_mb = settled_mb(kiosk);
            warm_handles = app::open_handles();
        }
        if ((i + 1) % 100 == 0) {
            const double resident_mb = settled_mb(kiosk);
            std::printf("%5d visitors: %.2f MB, %.2f MB of them in use, %d handles\n", i + 1, resident_mb, in_use_mb(),
                        app::open_handles());
            std::fflush(stdout);
        }
    }
    const double growth_mb = settled_mb(kiosk) - warm_mb;
    const int more_handles = app::open_handles() - warm_handles;
    std::printf("after the first %d: %+.2f MB, %+d handles\n", kWarm, growth_mb, more_handles);
    return growth_mb < kMostGrowth_mb && more_handles == 0 ? 0 : 1;
}
