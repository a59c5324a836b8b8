// How long a pen's sample takes to become ink while searches run flat out, and what a frame costs.
//
//     ink_latency INDEX DRAWING [SECONDS [JOBS]]
//
// A pen of 266 reports a second draws DRAWING over and over into the real desk of pens; the real Find mode, 1920 × 1080
// without a screen, takes it once in 1/60 s, searches INDEX after every frame and draws ink and cards. For each sample:
// from when it was read to the frame that has its ink going to the graphics driver, without and with the time that
// drawing in software takes. Exit code 1 when the p99 without drawing is above a frame and 4 ms.

#include <GLES3/gl3.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "core/exchange/sketch_reader.hpp"
#include "firmware_like_app/collection/sketch_searcher.hpp"
#include "firmware_like_app/kiosk/find_mode.hpp"
#include "firmware_like_app/kiosk/pen_desk.hpp"
#include "input/sources/spsc_queue.hpp"
#include "ui/gl/headless_context.hpp"

namespace {

constexpr std::int64_t kFrame_ns = 1'000'000'000 / 60;
constexpr std::int64_t kReport_ns = 1'000'000'000 / 266;
constexpr ui::SizePx kScreen{1920, 1080};

std::int64_t now_ns() {
    static const input::Clock clock = input::monotonic_clock();
    return clock();
}

/// A tablet of its own thread that draws for as long as it lives.
class RestlessPen final : public input::PenSource {
  public:
    explicit RestlessPen(core::Drawing drawing) : drawing_(std::move(drawing)) {
        thread_ = std::jthread([this](const std::stop_token& stop) { draw(stop); });
    }
    void drain(std::vector<input::SourceEvent>& out) override {
        input::SourceEvent event;
        while (queue_.pop(event)) out.push_back(event);
    }
    input::TraceDevice device(std::uint32_t number) const override {
        input::TraceDevice d;
        d.number = number;
        d.source = "hidraw";
        return d;
    }
    std::uint64_t lost() const override { return queue_.lost(); }
    std::string_view name() const override { return "restless"; }

  private:
    void draw(const std::stop_token& stop) {
        std::int64_t due = now_ns();
        const auto say = [&](const core::PenSample* s) {
            due += kReport_ns;
            std::this_thread::sleep_for(std::chrono::nanoseconds(std::max<std::int64_t>(due - now_ns(), 0)));
            input::SourceEvent e;
            e.device = 1;
            e.time_ns = e.sample.time_ns = now_ns();
            e.sample.device = 1;
            e.sample_valid = true;
            e.sample.in_range = true;
            e.sample.tip = s != nullptr;
            // onto the sheet, which is on the right
            e.sample.x = s != nullptr ? 0.42 + 0.5 * s->x / 400 : 0.5;
            e.sample.y = s != nullptr ? 0.1 + 0.8 * s->y / 300 : 0.5;
            e.sample.pressure = s != nullptr ? 0.6 : 0.0;
            queue_.push(e);
        };
        while (!stop.stop_requested()) {
            for (const core::Stroke& stroke : drawing_.strokes) {
                for (std::size_t i = 0; i < stroke.samples.size() && !stop.stop_requested(); ++i)
                    say(&stroke.samples[i]);
                say(nullptr);
            }
        }
    }

    core::Drawing drawing_;
    input::SpscQueue<input::SourceEvent> queue_{1024};
    std::jthread thread_;
};

/// Into 400 × 300.
core::Drawing fitted(core::Drawing drawing) {
    const core::Frame f = core::frame_of(drawing);
    const double scale = std::min(400 / std::max(f.width(), 1e-9), 300 / std::max(f.height(), 1e-9));
    for (core::Stroke& stroke : drawing.strokes) {
        for (core::PenSample& s : stroke.samples) {
            s.x = (s.x - f.left) * scale;
            s.y = (s.y - f.top) * scale;
        }
    }
    return drawing;
}

double print(const char* what, std::vector<double>& ms) {
    if (ms.empty()) return 0;
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double share) {
        return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
    };
    std::printf("%-44s %7zu  p50 %6.2f  p95 %6.2f  p99 %6.2f  max %6.2f ms\n", what, ms.size(), at(0.5), at(0.95),
                at(0.99), ms.back());
    return at(0.99);
}

struct Times {
    std::vector<double> to_driver, to_picture, update, ink, list, software, spare;
};

void frame(app::PenDesk& desk, app::FindMode& find, ui::Target& target, Times& times) {
    const std::int64_t start = now_ns();
    const std::vector<ui::WindowEvent> events = desk.merge({}, kScreen, find.layout().sheet, start / 1000);
    for (const ui::WindowEvent& event : events) find.pointer(event);
    find.look_ahead(desk.predicted());
    // a visitor begins anew now and then, as the drawing is repeated for ever
    if (find.sketch().drawing().strokes.size() > 60) find.start_sheet_for({});
    find.update(now_ns() / 1000);
    const std::int64_t updated = now_ns();
    find.update_ink();
    const std::int64_t inked = now_ns();
    target.bind();
    find.draw_changes(now_ns() / 1000, false);
    const std::int64_t listed = now_ns();
    glFinish();
    const std::int64_t done = now_ns();
    find.use_spare_time();
    const std::int64_t spared = now_ns();
    const auto ms = [](std::int64_t from, std::int64_t to) { return static_cast<double>(to - from) * 1e-6; };
    for (const ui::WindowEvent& event : events) {
        if (event.kind != ui::WindowEvent::Kind::Down && event.kind != ui::WindowEvent::Kind::Move) continue;
        times.to_driver.push_back(ms(event.time_us * 1000, updated));
        times.to_picture.push_back(ms(event.time_us * 1000, done));
    }
    times.update.push_back(ms(start, updated));
    times.ink.push_back(ms(updated, inked));
    times.list.push_back(ms(inked, listed));
    times.software.push_back(ms(listed, done));
    times.spare.push_back(ms(done, spared));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "ink_latency INDEX DRAWING [SECONDS [JOBS]]\n");
        return 2;
    }
    const double seconds = argc > 3 ? std::atof(argv[3]) : 20;
    auto searcher = app::SketchSearcher::open(argv[1], argc > 4 ? std::atoi(argv[4]) : 2, 10);
    const auto sketch = core::read_sketch(argv[2]);
    if (!searcher || !sketch || !sketch->drawing) {
        std::fprintf(stderr, "%s\n", !searcher ? searcher.error().sentence().c_str() : "no drawing");
        return 1;
    }
    auto context = ui::make_headless_context();
    const auto fonts = ui::FontSet::load();
    const auto languages = ui::Strings::load_all();
    if (!context || !fonts || !languages) return 1;
    app::FindOptions options;
    options.spare_time = true;
    auto find = app::FindMode::create(*fonts, *languages, searcher->get(), options, kScreen);
    input::DeviceNumbers numbers;
    auto desk = app::PenDesk::create(std::make_unique<RestlessPen>(fitted(*sketch->drawing)), numbers, {});
    if (!find || !desk) return 1;
    ui::Target target(kScreen, ui::PixelFormat::Colour);
    std::printf("%s\n", ui::renderer_name().c_str());

    Times times;
    const std::int64_t start = now_ns();
    std::int64_t due = start;
    while (static_cast<double>(now_ns() - start) * 1e-9 < seconds) {
        frame(**desk, **find, target, times);
        due = std::max(due + kFrame_ns, now_ns());
        std::this_thread::sleep_for(std::chrono::nanoseconds(due - now_ns()));
    }
    std::printf("%.0f searches a second, %llu reports lost\n", static_cast<double>((*find)->searches()) / seconds,
                static_cast<unsigned long long>((*desk)->lost()));
    const double p99 = print("sample read -> its frame goes to the driver", times.to_driver);
    print("sample read -> its frame is drawn", times.to_picture);
    print("a frame: input, answers", times.update);
    print("a frame: new ink into the layer", times.ink);
    print("a frame: the draw list", times.list);
    print("a frame: drawing in software", times.software);
    print("after a frame: a card's picture", times.spare);
    return p99 <= static_cast<double>(kFrame_ns) * 1e-6 + 4 ? 0 : 1;
}
