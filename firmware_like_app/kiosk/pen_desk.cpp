#include "firmware_like_app/kiosk/pen_desk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "input/sources/tablet_hub.hpp"

namespace app {
namespace {

using Kind = ui::WindowEvent::Kind;

constexpr std::int64_t kTouch = 1;  // the window lets one finger through at a time

bool is_pointer(const ui::WindowEvent& event) {
    return event.kind == Kind::Down || event.kind == Kind::Move || event.kind == Kind::Up;
}

input::PipelineOptions fitted(input::PipelineOptions options, ui::SizePx screen) {
    const std::array<double, 4> whole{0, 0, 1, 1};
    if (options.calibration.area == whole && !options.calibration.keep_aspect) {
        options.calibration.keep_aspect = static_cast<double>(screen.width) / screen.height;
    }
    return options;
}

}  // namespace

core::Result<std::unique_ptr<PenDesk>> PenDesk::create(std::unique_ptr<input::PenSource> tablets,
                                                       input::DeviceNumbers& numbers, PenDeskOptions options,
                                                       input::Clock clock) {
    std::unique_ptr<PenDesk> desk(new PenDesk(std::move(tablets), numbers, std::move(options), std::move(clock)));
    if (desk->options_.trace.empty()) return desk;
    core::Result<std::unique_ptr<input::TraceRecorder>> recorder =
        input::TraceRecorder::create(desk->options_.trace.string());
    if (!recorder) return core::unexpected(recorder.error());
    desk->recorder_ = std::move(*recorder);
    return desk;
}

PenDesk::PenDesk(std::unique_ptr<input::PenSource> tablets, input::DeviceNumbers& numbers, PenDeskOptions options,
                 input::Clock clock)
    : source_(std::move(tablets)),
      numbers_(numbers),
      options_(std::move(options)),
      clock_(std::move(clock)),
      pipeline_(options_.pipeline),
      palm_(options_.palm),
      pointer_({.numbers = &numbers, .palm = {}}) {}

/// Another screen: tablets are cut to its shape, and the trace gets devices of its size.
void PenDesk::set_pipeline(const input::PipelineOptions& pipeline) {
    options_.pipeline = pipeline;
    screen_ = {0, 0};  // fitted anew with the next frame
}

void PenDesk::fit(ui::SizePx screen, std::vector<Event>& out) {
    if (screen == screen_) return;
    screen_ = screen;
    if (holder_ == Holder::Pen) {
        last_.kind = Kind::Up;
        out.push_back(last_);
        holder_ = Holder::None;
        pen_ = 0;
    }
    // the steps that would have told that a pen left are gone; one that is near says so with its next sample
    for (const std::uint32_t device : near_) palm_.forget(device, clock_());
    if (!near_.empty() && holder_ == Holder::None) {
        last_.kind = Kind::Leave;
        out.push_back(last_);
    }
    near_.clear();
    pipeline_ = input::PenPipeline(fitted(options_.pipeline, screen));
    for (const DeskTablet& tablet : tablets_) {
        const input::TraceDevice device = source_->device(tablet.number);
        pipeline_.attach(device.number, device.axes, device.reports_range);
    }
    constexpr double kMmPerPx = 25.4 / 96;
    pointer_ = input::PointerSource(
        {.numbers = &numbers_, .palm = {}, .width_mm = screen.width * kMmPerPx, .height_mm = screen.height * kMmPerPx});
}

std::vector<ui::WindowEvent> PenDesk::merge(const std::vector<ui::WindowEvent>& window, ui::SizePx screen,
                                            const ui::Rect& sheet, std::int64_t now_us) {
    to_window_us_ = now_us - clock_() / 1000;
    std::vector<Event> out;
    fit(screen, out);
    if (source_) take_tablets(out);
    for (const Event& event : window) take_window(event, sheet, out);
    std::stable_sort(out.begin(), out.end(), [](const Event& a, const Event& b) { return a.time_us < b.time_us; });
    return out;
}

void PenDesk::take_tablets(std::vector<Event>& out) {
    std::vector<input::SourceEvent> events;
    source_->drain(events);
    for (const input::SourceEvent& event : events) {
        if (recorder_) recorder_->record(event, *source_);
        if (event.kind != input::SourceEventKind::Sample) change(event, out);
        if (!event.sample_valid) continue;
        awake(event.device);
        for ([[maybe_unused]] const std::int64_t touch : palm_.see(event.sample)) {
            if (holder_ != Holder::Finger) continue;
            last_.kind = Kind::TakeBack;
            last_.time_us = window_us(event.time_ns);
            out.push_back(last_);
            holder_ = Holder::None;
        }
        if (const std::optional<input::PenSample> sample = pipeline_.feed(event.sample)) take_sample(*sample, out);
    }
    for (const input::PenSample& sample : pipeline_.expire(clock_())) {
        palm_.forget(sample.device, sample.time_ns);
        take_sample(sample, out);
    }
}

void PenDesk::change(const input::SourceEvent& event, std::vector<Event>& out) {
    const auto known = std::find_if(tablets_.begin(), tablets_.end(),
                                    [&](const DeskTablet& tablet) { return tablet.number == event.device; });
    if (event.kind == input::SourceEventKind::Attached) {
        const input::TraceDevice device = source_->device(event.device);
        pipeline_.attach(event.device, device.axes, device.reports_range);
        tablets_.push_back({event.device, device.identity.name, false});
        return say(TabletChange::Kind::Attached, tablets_.back());
    }
    if (known == tablets_.end()) return;
    if (event.kind == input::SourceEventKind::Asleep) {
        known->asleep = true;
        say(TabletChange::Kind::Asleep, *known);
    }
    if (event.kind == input::SourceEventKind::Detached) {
        if (const auto gone = pipeline_.detach(event.device, event.time_ns)) take_sample(*gone, out);
        palm_.forget(event.device, event.time_ns);
        const DeskTablet tablet = *known;
        tablets_.erase(known);
        say(TabletChange::Kind::Detached, tablet);
    }
}

void PenDesk::awake(std::uint32_t number) {
    for (DeskTablet& tablet : tablets_) {
        if (tablet.number != number || !tablet.asleep) continue;
        tablet.asleep = false;
        say(TabletChange::Kind::Awake, tablet);
    }
}

void PenDesk::say(TabletChange::Kind kind, const DeskTablet& tablet) {
    if (options_.tablet_changed) options_.tablet_changed({kind, tablet});
}

ui::WindowEvent PenDesk::event_of(Event::Kind kind, const input::PenSample& sample) const {
    Event event;
    event.kind = kind;
    event.x = sample.x.value_or(0) * screen_.width;
    event.y = sample.y.value_or(0) * screen_.height;
    event.pressure = sample.pressure.value_or(1.0);
    event.time_us = window_us(sample.time_ns);
    event.pen = true;
    event.eraser = sample.eraser();
    event.button = (sample.buttons & input::kBarrel1) != 0;
    if (sample.tilt_x_rad && sample.tilt_y_rad) {
        event.tilt_rad = std::atan(std::hypot(std::tan(*sample.tilt_x_rad), std::tan(*sample.tilt_y_rad)));
    }
    return event;
}

void PenDesk::take_sample(const input::PenSample& sample, std::vector<Event>& out) {
    const auto near = std::find(near_.begin(), near_.end(), sample.device);
    if (sample.in_range && near == near_.end()) near_.push_back(sample.device);
    const bool draws = holder_ == Holder::Pen && pen_ == sample.device;
    const bool turned = draws && last_.eraser != sample.eraser() && sample.in_range;
    if (draws && (!sample.tip || turned)) pen_lifts(sample, out);
    if (!sample.in_range) {
        if (near == near_.end()) return;
        near_.erase(near);
        Event leave = event_of(Kind::Leave, sample);
        leave.x = last_.x;
        leave.y = last_.y;
        if (near_.empty() && holder_ == Holder::None) out.push_back(leave);
        return;
    }
    if (holder_ == Holder::Pen && pen_ != sample.device) return;  // another pen draws
    if (!sample.x || !sample.y) return;
    if (!sample.tip || holder_ == Holder::Pen) {
        last_ = event_of(Kind::Move, sample);
    } else {
        release_others(window_us(sample.time_ns), out);
        holder_ = Holder::Pen;
        pen_ = sample.device;
        last_ = event_of(Kind::Down, sample);
    }
    out.push_back(last_);
}

/// At the last place where the tip touched: what a pen says while it lifts has no pressure and may lie off.
void PenDesk::pen_lifts(const input::PenSample& sample, std::vector<Event>& out) {
    last_.kind = Kind::Up;
    last_.time_us = window_us(sample.time_ns);
    out.push_back(last_);
    holder_ = Holder::None;
    pen_ = 0;
}

void PenDesk::release_others(std::int64_t time_us, std::vector<Event>& out) {
    if (holder_ != Holder::Mouse && holder_ != Holder::Finger) return;
    last_.kind = Kind::Up;
    last_.time_us = time_us;
    out.push_back(last_);
    holder_ = Holder::None;
}

void PenDesk::take_window(const Event& event, const ui::Rect& sheet, std::vector<Event>& out) {
    const bool lost = event.kind == Kind::FocusLost || event.kind == Kind::Cancel;
    if (lost && (holder_ == Holder::Mouse || holder_ == Holder::Finger)) holder_ = Holder::None;
    if (!is_pointer(event)) {
        out.push_back(event);
        return;
    }
    if (recorder_) record_pointer(event);
    if (event.finger) {
        take_finger(event, sheet, out);
    } else {
        take_mouse(event, out);
    }
}

void PenDesk::take_mouse(const Event& event, std::vector<Event>& out) {
    if (holder_ == Holder::Mouse) {
        if (event.kind == Kind::Up) holder_ = Holder::None;
    } else {
        if (holder_ != Holder::None || pen_near() || event.kind == Kind::Up) return;
        if (event.kind == Kind::Down) holder_ = Holder::Mouse;
    }
    last_ = event;
    out.push_back(event);
}

void PenDesk::take_finger(const Event& event, const ui::Rect& sheet, std::vector<Event>& out) {
    const std::int64_t time_ns = (event.time_us - to_window_us_) * 1000;
    if (event.kind == Kind::Down) {
        const bool may_draw = palm_.touch_began(kTouch, time_ns) || !sheet.contains(event.x, event.y);
        if (!may_draw || holder_ != Holder::None) return;
        holder_ = Holder::Finger;
    } else if (holder_ != Holder::Finger) {
        return;
    }
    last_ = event;
    out.push_back(event);
    if (event.kind != Kind::Up) return;
    palm_.touch_ended(kTouch);
    holder_ = Holder::None;
}

void PenDesk::record_pointer(const Event& event) {
    const double x = event.x / screen_.width, y = event.y / screen_.height;
    const std::int64_t time_ns = (event.time_us - to_window_us_) * 1000;
    const bool down = event.kind != Kind::Up;
    if (!event.finger) {
        pointer_.mouse(x, y, event.kind == Kind::Down || (event.kind == Kind::Move && holder_ == Holder::Mouse),
                       time_ns);
    } else if (event.kind == Kind::Down) {
        pointer_.touch_down(kTouch, x, y, event.pressure, time_ns);
    } else if (down) {
        pointer_.touch_move(kTouch, x, y, event.pressure, time_ns);
    } else {
        pointer_.touch_up(kTouch, time_ns);
    }
    std::vector<input::SourceEvent> events;
    pointer_.drain(events);
    for (const input::SourceEvent& e : events) recorder_->record(e, pointer_);
}

std::optional<ui::WindowEvent> PenDesk::predicted() const {
    if (holder_ != Holder::Pen || last_.eraser) return std::nullopt;
    const std::optional<input::PenSample> sample = pipeline_.predict(pen_);
    if (!sample || !sample->x || !sample->y) return std::nullopt;
    return event_of(Kind::Move, *sample);
}

std::vector<std::string> PenDesk::take_problems() {
    return source_ ? source_->take_problems() : std::vector<std::string>{};
}

void PenDesk::mark(const std::string& text) {
    if (recorder_) recorder_->mark(clock_(), text);
}

std::unique_ptr<input::PenSource> open_desk_tablets(input::DeviceNumbers& numbers) {
    return std::make_unique<input::TabletHub>(input::TabletHubOptions{.numbers = &numbers, .grab = true});
}

}  // namespace app
