// Visitors replayed in real time for minutes: what frames cost, where that goes, and whether one was ever late.
//
//     long_replay INDEX FOLDER [MINUTES [JOBS [SEED]]]
//
// The whole kiosk at 1920 × 1080 without a screen, on the real clock, searching INDEX. Each visitor wakes it, draws one
// of the Quick-Draw files of FOLDER at its recorded speed, rests, opens the best result, turns it, and goes on or
// leaves: then the kiosk asks, counts down, wipes and shows its own drawings. Prints what frames cost in each scene and
// the worst ones. Exit code 1 when a frame took more than 100 ms.
//
// On a machine that others use the clock says more of them than of the kiosk. So each frame is told by processor time
// as well, as if nobody else wanted a core: that of the thread that draws, and the most that one of the driver's own
// threads took, for which it waits.

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include "core/exchange/sketch_reader.hpp"
#include "firmware_like_app/collection/sketch_searcher.hpp"
#include "firmware_like_app/health/self_test.hpp"
#include "firmware_like_app/kiosk/collection_host.hpp"
#include "firmware_like_app/kiosk/placing.hpp"
#include "firmware_like_app/kiosk/shell.hpp"
#include "support/chosen_drawings.hpp"
#include "ui/gl/headless_context.hpp"

namespace {

using Kind = ui::WindowEvent::Kind;
constexpr ui::SizePx kScreen{1920, 1080};
constexpr std::int64_t kFrame_us = 1'000'000 / 60;
constexpr double kLate_ms = 100;
constexpr std::int64_t kLongestLift_us = 1'500'000;

std::int64_t now_us() {
    return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

const char* name_of(app::Scene scene) {
    switch (scene) {
        case app::Scene::Attract:
            return "attract";
        case app::Scene::Work:
            return "ink and cards";
        case app::Scene::Detail:
            return "detail";
        case app::Scene::StillThere:
            return "still there?";
        default:
            return "others";
    }
}

/// What one frame cost, in ms: input and answers; new ink and the turning model; list and calls; drawing to its end;
/// what was done in the time that was left.
enum Part { kInput, kLayers, kCalls, kDrawing, kSpare, kParts };
struct Frame {
    app::Scene scene{};
    double at_s = 0;
    double alone_ms = 0;  ///< by processor time
    std::array<double, kParts> ms{};
    [[nodiscard]] double total() const {
        double sum = 0;
        for (const double part : ms) sum += part;
        return sum;
    }
};

/// Processor time of the threads that make frames.
class FrameThreads {
  public:
    /// After the driver has begun to draw.
    FrameThreads() {
        for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
            std::string name;
            std::getline(std::ifstream(entry.path() / "comm"), name);
            if (name.starts_with("llvmpipe")) drivers_.push_back(entry.path() / "schedstat");
        }
        was_.resize(drivers_.size());
    }
    void begin() {
        for (std::size_t i = 0; i < drivers_.size(); ++i) was_[i] = time_ns(drivers_[i]);
        own_ns_ = own_ns();
    }
    [[nodiscard]] double ms_since_begin() const {
        double most = 0;
        for (std::size_t i = 0; i < drivers_.size(); ++i) most = std::max(most, time_ns(drivers_[i]) - was_[i]);
        return (own_ns() - own_ns_ + most) * 1e-6;
    }

  private:
    static double time_ns(const std::filesystem::path& file) {
        double ns = 0;
        std::ifstream(file) >> ns;
        return ns;
    }
    static double own_ns() {
        timespec t{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
    }
    std::vector<std::filesystem::path> drivers_;
    std::vector<double> was_;
    double own_ns_ = 0;
};

struct Kiosk {
    app::FindMode& find;
    app::Shell& shell;
};

/// What a visitor does, each at its time from the visit's start.
class Visit {
  public:
    Visit(const Kiosk& kiosk, const core::Drawing& drawing, bool leaves) : leaves_(leaves) {
        const ui::Rect sheet = kiosk.find.layout().sheet;
        tap(300'000, sheet.centre_x(), sheet.centre_y());  // wakes, or is a dot
        std::int64_t at = 1'000'000, before = 0;
        bool first = true;
        const ui::InkFrame frame = app::fit_drawing(drawing, sheet.width, sheet.height, 0.14);
        for (const core::Stroke& stroke : drawing.strokes) {
            core::Point p;
            for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
                const core::PenSample& s = stroke.samples[i];
                at += first ? 0 : std::clamp<std::int64_t>(s.time_us - before, 0, kLongestLift_us);
                before = s.time_us;
                first = false;
                p = frame.to_px({s.x, s.y}) + core::Point{sheet.x, sheet.y};
                add(at, i == 0 ? Kind::Down : Kind::Move, p);
            }
            add(at, Kind::Up, p);
        }
        const ui::Rect card = kiosk.find.layout().cards[0];
        tap(at + 2'000'000, card.centre_x(), card.centre_y());
        at += 3'500'000;
        add(at, Kind::Down, {sheet.centre_x(), sheet.centre_y()});
        for (int i = 1; i <= 60; ++i)
            add(at + i * 16'000, Kind::Move, {sheet.centre_x() + i * 5, sheet.centre_y() + i});
        add(at + 1'000'000, Kind::Up, {sheet.centre_x() + 300, sheet.centre_y() + 60});
        end_us_ = at + 2'500'000;
    }

    /// Those that are due; afterwards the visit goes back to the sheet, and empties it or leaves.
    void play(std::int64_t since_us, std::int64_t clock_us, const Kiosk& kiosk) {
        for (; next_ < events_.size() && events_[next_].time_us <= since_us; ++next_)
            send(events_[next_], clock_us, kiosk);
        if (since_us < end_us_ || step_ > 1) return;
        if (step_ == 0) {
            if (kiosk.shell.station().scene() == app::Scene::Detail)
                press(kiosk.shell.detail().layout().back, clock_us, kiosk);
            end_us_ += 700'000;
        } else if (!leaves_) {
            press(kiosk.find.layout().tools[4], clock_us, kiosk);
        }
        ++step_;
        done_us_ = since_us + (leaves_ ? 17'000'000 : 700'000);  // asked, counted down, wiped, and attract for a while
    }
    [[nodiscard]] bool over(std::int64_t since_us) const { return step_ > 1 && since_us >= done_us_; }

  private:
    void add(std::int64_t at_us, Kind kind, core::Point p) { events_.push_back({kind, p.x, p.y, 1.0, at_us, false}); }
    void tap(std::int64_t at_us, double x, double y) {
        add(at_us, Kind::Down, {x, y});
        add(at_us + 60'000, Kind::Up, {x, y});
    }
    static void send(ui::WindowEvent event, std::int64_t clock_us, const Kiosk& kiosk) {
        event.time_us = clock_us;
        kiosk.shell.pointer(event);
    }
    static void press(const ui::Rect& r, std::int64_t clock_us, const Kiosk& kiosk) {
        for (const Kind kind : {Kind::Down, Kind::Up})
            send({kind, r.centre_x(), r.centre_y(), 1.0, 0, false}, clock_us, kiosk);
    }

    std::vector<ui::WindowEvent> events_;
    std::size_t next_ = 0;
    std::int64_t end_us_ = 0, done_us_ = 0;
    int step_ = 0;
    bool leaves_;
};

/// One turn of the loop; false when nothing had to be drawn.
bool turn(const Kiosk& kiosk, Visit& visit, std::int64_t arrived_us, ui::Target& target, bool kept, Frame& frame) {
    std::int64_t last = now_us();
    const auto lap = [&](Part part) {
        const std::int64_t now = now_us();
        frame.ms[part] += static_cast<double>(now - last) * 1e-3;
        last = now;
    };
    visit.play(last - arrived_us, last, kiosk);
    kiosk.shell.update(now_us());
    const bool drawn = kiosk.shell.changed(now_us()) || !kept;
    lap(kInput);
    if (drawn) {
        kiosk.shell.update_ink();
        lap(kLayers);
        frame.scene = kiosk.shell.station().scene();
        target.bind();
        kiosk.shell.draw(now_us(), false, kept);
        lap(kCalls);
        glFinish();
        lap(kDrawing);
    }
    kiosk.shell.use_spare_time();
    lap(kSpare);
    return drawn;
}

double at_share(std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void print_scenes(const std::vector<Frame>& frames) {
    std::map<std::string, std::vector<const Frame*>> by_scene;
    for (const Frame& f : frames) by_scene[name_of(f.scene)].push_back(&f);
    std::printf("%-14s %7s %8s %8s %8s %8s   alone: p50    p99    max   mean of: input %s\n", "ms a frame", "frames",
                "p50", "p95", "p99", "max", "layers   calls drawing   spare");
    for (const auto& [name, in_scene] : by_scene) {
        std::vector<double> totals, alone;
        std::array<double, kParts> mean{};
        for (const Frame* f : in_scene) {
            totals.push_back(f->total());
            alone.push_back(f->alone_ms);
            for (std::size_t i = 0; i < kParts; ++i) mean[i] += f->ms[i] / static_cast<double>(in_scene.size());
        }
        std::sort(totals.begin(), totals.end());
        std::sort(alone.begin(), alone.end());
        std::printf("%-14s %7zu %8.2f %8.2f %8.2f %8.2f       %6.2f %6.2f %6.2f          ", name.c_str(), totals.size(),
                    at_share(totals, 0.5), at_share(totals, 0.95), at_share(totals, 0.99), totals.back(),
                    at_share(alone, 0.5), at_share(alone, 0.99), alone.back());
        for (const double ms : mean) std::printf(" %7.2f", ms);
        std::printf("\n");
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "long_replay INDEX FOLDER [MINUTES [JOBS [SEED]]]\n");
        return 2;
    }
    const double minutes = argc > 3 ? std::atof(argv[3]) : 10;
    auto searcher = app::SketchSearcher::open(argv[1], argc > 4 ? std::atoi(argv[4]) : 2, 10);
    auto context = ui::make_headless_context();
    const auto fonts = ui::FontSet::load();
    const auto languages = ui::Strings::load_all();
    if (!searcher || !context || !fonts || !languages) {
        std::fprintf(stderr, "%s\n", !searcher ? searcher.error().sentence().c_str() : "nothing can be drawn here");
        return 1;
    }
    app::FindOptions find_options;
    find_options.spare_time = true;
    app::ShellOptions options;
    options.times.ask = options.times.countdown = 5'000'000;
    auto find = app::FindMode::create(*fonts, *languages, searcher->get(), find_options, kScreen);
    if (!find) return 1;
    auto shell = app::Shell::create(*fonts, *languages, **find, searcher->get(), options, kScreen, now_us());
    if (!shell) return 1;
    const Kiosk kiosk{**find, **shell};
    const std::vector<std::string> drawings =
        support::chosen_drawings(argv[2], 1000, argc > 5 ? static_cast<unsigned>(std::atoi(argv[5])) : 1);

    ui::Target target(kScreen, ui::PixelFormat::Colour);
    std::vector<Frame> frames;
    FrameThreads threads;
    bool kept = false;
    const std::int64_t start = now_us();
    int visitors = 0;
    for (const std::string& spec : drawings) {
        const auto sketch = core::read_sketch(spec);
        if (!sketch || !sketch->drawing) continue;
        Visit visit(kiosk, *sketch->drawing, visitors % 3 == 2);
        ++visitors;
        const std::int64_t arrived = now_us();
        while (!visit.over(now_us() - arrived)) {
            const std::int64_t began = now_us();
            Frame frame;
            frame.at_s = static_cast<double>(began - start) * 1e-6;
            threads.begin();
            const bool drawn = turn(kiosk, visit, arrived, target, kept, frame);
            frame.alone_ms = threads.ms_since_begin();
            if (drawn) frames.push_back(frame);
            kept = true;
            std::this_thread::sleep_for(
                std::chrono::microseconds(std::max<std::int64_t>(began + kFrame_us - now_us(), 0)));
        }
        if (static_cast<double>(now_us() - start) > minutes * 60e6) break;
    }

    std::printf("%s, %d visitors, %llu searches, %.1f MB, %d handles\n", ui::renderer_name().c_str(), visitors,
                static_cast<unsigned long long>((*find)->searches()), app::resident_mb(), app::open_handles());
    if (frames.empty()) return 1;
    print_scenes(frames);
    std::stable_sort(frames.begin(), frames.end(),
                     [](const Frame& a, const Frame& b) { return a.total() > b.total(); });
    const auto late = std::count_if(frames.begin(), frames.end(), [](const Frame& f) { return f.total() > kLate_ms; });
    const auto late_alone =
        std::count_if(frames.begin(), frames.end(), [](const Frame& f) { return f.alone_ms > kLate_ms; });
    std::printf("%td of %zu frames took more than %.0f ms, %td alone; the worst:\n", late, frames.size(), kLate_ms,
                late_alone);
    for (std::size_t i = 0; i < std::min<std::size_t>(frames.size(), 12); ++i) {
        const Frame& f = frames[i];
        std::printf(
            "  %8.2f s  %-14s %7.2f ms, %.1f alone: input %.2f, layers %.2f, calls %.2f, drawing %.2f, spare %.2f\n",
            f.at_s, name_of(f.scene), f.total(), f.alone_ms, f.ms[kInput], f.ms[kLayers], f.ms[kCalls], f.ms[kDrawing],
            f.ms[kSpare]);
    }
    return late == 0 ? 0 : 1;
}
