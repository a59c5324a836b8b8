#include "firmware_like_app/kiosk/pen_desk.hpp"

#include <catch2/catch.hpp>
#include <deque>

#include "input/trace/trace.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using Kind = ui::WindowEvent::Kind;
constexpr std::int64_t kMs = 1'000'000;
constexpr ui::SizePx kScreen{1000, 500};
constexpr ui::Rect kSheet{300, 0, 700, 500};

/// Tablets that say what the test wrote down, each 200 by 100 mm.
class ScriptedTablets final : public input::PenSource {
  public:
    std::deque<input::SourceEvent> events;
    void drain(std::vector<input::SourceEvent>& out) override {
        out.insert(out.end(), events.begin(), events.end());
        events.clear();
    }
    input::TraceDevice device(std::uint32_t number) const override {
        input::TraceDevice d;
        d.number = number;
        d.identity.name = "tablet " + std::to_string(number);
        d.source = "hidraw";
        d.axes.x = input::AxisRange{0, 20000, 100.0};
        d.axes.y = input::AxisRange{0, 10000, 100.0};
        return d;
    }
    std::uint64_t lost() const override { return 3; }
    std::vector<std::string> take_problems() override { return {"no permission"}; }
    std::string_view name() const override { return "script"; }
};

struct Desk {
    std::int64_t now_ns = 5000 * kMs;
    input::DeviceNumbers numbers;
    ScriptedTablets* tablets = nullptr;
    std::vector<app::TabletChange> changes;
    std::unique_ptr<app::PenDesk> desk;

    explicit Desk(const std::filesystem::path& trace = {}) {
        auto source = std::make_unique<ScriptedTablets>();
        tablets = source.get();
        app::PenDeskOptions options;
        options.pipeline.smoothing.on = false;
        options.trace = trace;
        options.tablet_changed = [this](const app::TabletChange& change) { changes.push_back(change); };
        auto made = app::PenDesk::create(std::move(source), numbers, options, [this] { return now_ns; });
        if (!made) FAIL(made.error().sentence());
        desk = std::move(*made);
    }
    void change(input::SourceEventKind kind, std::uint32_t device) {
        input::SourceEvent e;
        e.kind = kind;
        e.device = device;
        e.time_ns = now_ns;
        tablets->events.push_back(e);
    }
    void pen(std::uint32_t device, double x, double y, bool tip, double pressure = 0.5, bool eraser = false) {
        now_ns += 4 * kMs;
        input::SourceEvent e;
        e.device = device;
        e.time_ns = now_ns;
        e.sample_valid = true;
        e.sample.device = device;
        e.sample.time_ns = now_ns;
        e.sample.x = x;
        e.sample.y = y;
        e.sample.pressure = tip ? pressure : 0.0;
        e.sample.in_range = true;
        e.sample.tip = tip;
        e.sample.tool = eraser ? input::PenTool::Eraser : input::PenTool::Pen;
        tablets->events.push_back(e);
    }
    void pen_leaves(std::uint32_t device) {
        now_ns += 4 * kMs;
        input::SourceEvent e;
        e.device = device;
        e.time_ns = now_ns;
        e.sample_valid = true;
        e.sample.device = device;
        e.sample.time_ns = now_ns;
        tablets->events.push_back(e);
    }
    /// The window's clock runs a thousand seconds behind the monotonic one.
    [[nodiscard]] std::int64_t window_us() const { return now_ns / 1000 - 1'000'000'000; }
    ui::WindowEvent window(Kind kind, double x, double y, bool finger) {
        now_ns += 4 * kMs;
        return {kind, x, y, 1.0, window_us(), finger};
    }
    std::vector<ui::WindowEvent> merge(const std::vector<ui::WindowEvent>& events = {}) {
        return desk->merge(events, kScreen, kSheet, window_us());
    }
};

std::vector<Kind> kinds(const std::vector<ui::WindowEvent>& events) {
    std::vector<Kind> out;
    for (const ui::WindowEvent& e : events) out.push_back(e.kind);
    return out;
}

using Kinds = std::vector<Kind>;

}  // namespace

TEST_CASE("a tablet's pen hovers, draws with pressure and leaves, on the window's clock", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 1);
    d.pen(1, 0.5, 0.5, false);
    d.pen(1, 0.5, 0.5, true, 0.25);
    d.pen(1, 0.6, 0.5, true, 0.75);
    CHECK(d.desk->lost() == 3);
    std::vector<ui::WindowEvent> events = d.merge();
    CHECK(kinds(events) == Kinds{Kind::Move, Kind::Down, Kind::Move});
    for (const ui::WindowEvent& e : events) CHECK((e.pen && !e.finger && !e.eraser));
    CHECK(events[1].x == Approx(500));
    CHECK(events[1].y == Approx(250));
    CHECK(events[1].pressure == Approx(0.25));
    CHECK(events[2].pressure == Approx(0.75));
    CHECK(events[2].time_us == d.window_us());
    CHECK(d.desk->pen_near());
    d.pen(1, 0.61, 0.5, false);
    d.pen_leaves(1);
    events = d.merge();
    CHECK(kinds(events) == Kinds{Kind::Up, Kind::Move, Kind::Leave});
    CHECK(events[0].x == Approx(600));  // where the tip touched last
    CHECK_FALSE(d.desk->pen_near());
}

TEST_CASE("the pen's other end erases, and turning it in mid-stroke ends the stroke", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 1);
    d.pen(1, 0.5, 0.5, true);
    d.pen(1, 0.5, 0.5, true, 0.5, true);
    const std::vector<ui::WindowEvent> events = d.merge();
    REQUIRE(kinds(events) == Kinds{Kind::Down, Kind::Up, Kind::Down});
    CHECK_FALSE(events[1].eraser);
    CHECK(events[2].eraser);
}

TEST_CASE("mouse and touch do not draw while a pen is near, and draw again after", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 1);
    d.pen(1, 0.5, 0.5, false);
    CHECK(kinds(d.merge()) == Kinds{Kind::Move});
    CHECK(d.merge({d.window(Kind::Move, 501, 250, false), d.window(Kind::Down, 501, 250, false),
                   d.window(Kind::Up, 501, 250, false)})
              .empty());
    CHECK(d.merge({d.window(Kind::Down, 600, 250, true), d.window(Kind::Move, 601, 250, true)}).empty());
    CHECK(d.merge({d.window(Kind::Up, 601, 250, true)}).empty());
    SECTION("touches on the board count while no tip is down") {
        CHECK(kinds(d.merge({d.window(Kind::Down, 100, 100, true), d.window(Kind::Up, 100, 100, true)})) ==
              Kinds{Kind::Down, Kind::Up});
    }
    SECTION("and not while one is") {
        d.pen(1, 0.5, 0.5, true);
        CHECK(kinds(d.merge({d.window(Kind::Down, 100, 100, true), d.window(Kind::Up, 100, 100, true)})) ==
              Kinds{Kind::Down});  // the pen's
    }
    SECTION("half a second after the pen left a finger draws") {
        d.pen_leaves(1);
        d.merge();
        CHECK(d.merge({d.window(Kind::Down, 600, 250, true), d.window(Kind::Up, 600, 250, true)}).empty());
        d.now_ns += 600 * kMs;
        CHECK(kinds(d.merge({d.window(Kind::Down, 600, 250, true), d.window(Kind::Up, 600, 250, true)})) ==
              Kinds{Kind::Down, Kind::Up});
    }
}

TEST_CASE("a palm that came just before its pen is taken back; a finger that drew for long only stops", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 1);
    CHECK(kinds(d.merge({d.window(Kind::Down, 600, 250, true), d.window(Kind::Move, 602, 250, true)})) ==
          Kinds{Kind::Down, Kind::Move});
    SECTION("palm") {
        d.now_ns += 50 * kMs;
        d.pen(1, 0.5, 0.5, false);
        CHECK(kinds(d.merge({d.window(Kind::Move, 603, 250, true)})) == Kinds{Kind::TakeBack, Kind::Move});
        CHECK(d.merge({d.window(Kind::Up, 603, 250, true)}).empty());
    }
    SECTION("finger") {
        d.now_ns += 400 * kMs;
        d.pen(1, 0.5, 0.5, true);
        CHECK(kinds(d.merge()) == Kinds{Kind::Up, Kind::Down});
        CHECK(d.merge({d.window(Kind::Up, 603, 250, true)}).empty());
    }
}

TEST_CASE("one pen draws at a time, and a pulled cable ends its stroke", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 1);
    d.change(input::SourceEventKind::Attached, 2);
    d.pen(1, 0.5, 0.5, true);
    d.pen(2, 0.2, 0.2, true);
    d.pen(1, 0.6, 0.5, true);
    CHECK(kinds(d.merge()) == Kinds{Kind::Down, Kind::Move});
    d.change(input::SourceEventKind::Detached, 1);
    d.pen(2, 0.25, 0.2, true);
    CHECK(kinds(d.merge()) == Kinds{Kind::Up, Kind::Down});
    REQUIRE(d.desk->tablets().size() == 1);
    CHECK(d.desk->tablets()[0].name == "tablet 2");
}

TEST_CASE("a pen that never says that it left is gone after a while", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 1);
    d.pen(1, 0.5, 0.5, true);
    d.merge();
    d.now_ns += 2100 * kMs;
    CHECK(kinds(d.merge()) == Kinds{Kind::Up, Kind::Leave});
    d.now_ns += 600 * kMs;
    CHECK(kinds(d.merge({d.window(Kind::Down, 600, 250, true)})) == Kinds{Kind::Down});
}

TEST_CASE("tablets that come, sleep, wake and go are told", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 4);
    d.merge();
    d.change(input::SourceEventKind::Asleep, 4);
    d.merge();
    CHECK(d.desk->tablets() == std::vector<app::DeskTablet>{{4, "tablet 4", true}});
    d.pen(4, 0.1, 0.1, false);
    d.change(input::SourceEventKind::Detached, 4);
    d.merge();
    std::vector<app::TabletChange::Kind> said;
    for (const app::TabletChange& change : d.changes) said.push_back(change.kind);
    using Change = app::TabletChange::Kind;
    CHECK(said == std::vector<Change>{Change::Attached, Change::Asleep, Change::Awake, Change::Detached});
    CHECK(d.desk->tablets().empty());
    CHECK(d.desk->take_problems() == std::vector<std::string>{"no permission"});
}

TEST_CASE("a tablet is cut to the screen's shape so that a circle stays a circle", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 1);
    d.pen(1, 0.25, 0.5, true);  // 200 by 100 mm on a square screen: the middle 100 mm are used
    const auto events = d.desk->merge({}, {500, 500}, {100, 0, 400, 500}, d.window_us());
    REQUIRE(events.size() == 1);
    CHECK(events[0].x == Approx(0).margin(0.1));
    CHECK(events[0].y == Approx(250));
}

TEST_CASE("the ink ahead of a pen lies on its way", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 1);
    for (int i = 0; i < 10; ++i) d.pen(1, 0.5 + 0.01 * i, 0.5, true);
    d.merge();
    const auto ahead = d.desk->predicted();
    REQUIRE(ahead);
    CHECK(ahead->x > 591);
    CHECK(ahead->x < 650);
    CHECK(ahead->y == Approx(250).margin(1));
    d.pen(1, 0.6, 0.5, false);
    d.merge();
    CHECK_FALSE(d.desk->predicted());
}

TEST_CASE("everything that points goes into the trace, and can be read again", "[pen desk]") {
    const support::TemporaryFolder folder;
    const std::filesystem::path path = folder.path("all.trace");
    {
        Desk d(path);
        d.change(input::SourceEventKind::Attached, 9);
        d.pen(9, 0.5, 0.5, true);
        d.pen(9, 0.5, 0.6, true);
        d.pen_leaves(9);
        d.merge();
        d.now_ns += 600 * kMs;
        d.merge({d.window(Kind::Down, 600, 250, true), d.window(Kind::Up, 600, 250, true)});
        d.desk->mark("the sheet was emptied");
    }
    const core::Result<input::Trace> trace = input::read_trace(path.string());
    if (!trace) FAIL(trace.error().sentence());
    CHECK(trace->fault_count == 0);
    CHECK(trace->samples().size() == 5);
    REQUIRE(trace->device(9) != nullptr);
    CHECK(trace->device(9)->identity.name == "tablet 9");
    bool marked = false;
    for (const input::TraceRecord& r : trace->records) {
        const auto* marker = std::get_if<input::TraceMarker>(&r);
        marked = marked || (marker != nullptr && marker->text == "the sheet was emptied");
    }
    CHECK(marked);
}

TEST_CASE("other settings end the stroke that is being drawn, and no pen stays near for ever", "[pen desk]") {
    Desk d;
    d.change(input::SourceEventKind::Attached, 1);
    d.pen(1, 0.5, 0.5, true);
    REQUIRE(kinds(d.merge()) == Kinds{Kind::Down});
    d.desk->set_pipeline({});
    CHECK(kinds(d.merge()) == Kinds{Kind::Up, Kind::Leave});
    CHECK_FALSE(d.desk->pen_near());
    d.now_ns += 600 * kMs;
    CHECK(kinds(d.merge({d.window(Kind::Down, 600, 250, true)})) == Kinds{Kind::Down});
    d.merge({d.window(Kind::Up, 600, 250, true)});
    d.pen(1, 0.5, 0.5, false);
    CHECK(kinds(d.merge()) == Kinds{Kind::Move});
    CHECK(d.desk->pen_near());
}

TEST_CASE("a finger that is lost leaves the pointer to others", "[pen desk]") {
    Desk d;
    REQUIRE(kinds(d.merge({d.window(Kind::Down, 600, 250, true)})) == Kinds{Kind::Down});
    ui::WindowEvent lost = d.window(Kind::Cancel, 0, 0, true);
    CHECK(kinds(d.merge({lost})) == Kinds{Kind::Cancel});
    CHECK(kinds(d.merge({d.window(Kind::Down, 500, 250, false)})) == Kinds{Kind::Down});
}
