#include "firmware_like_app/kiosk/garment_trace.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <variant>
#include <vector>

#include "input/sources/pen_source.hpp"

namespace app {
namespace {

using Kind = ui::WindowEvent::Kind;

constexpr int kVersion = 1;
constexpr std::uint32_t kDevice = 1;

std::string start_mark(const GarmentStart& start) {
    return "garment " + std::to_string(kVersion) + " " + std::to_string(start.screen.width) + "x" +
           std::to_string(start.screen.height) + " " + start.language +
           (start.hand == ui::Hand::Right ? " right" : " left");
}

std::string zoom_mark(const ui::WindowEvent& event) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), "zoom %.17g %.17g %.17g %.17g %.17g%s", event.zoom, event.x, event.y,
                  event.shift_x, event.shift_y, event.finger ? " finger" : "");
    return text.data();
}

/// In one word: what is no letter, digit or a mark of its own as % and two hexadecimal digits.
std::string one_word(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte > 0x20 && byte < 0x7F && c != '%') {
            out += c;
            continue;
        }
        std::array<char, 4> code{};
        std::snprintf(code.data(), code.size(), "%%%02X", byte);
        out += code.data();
    }
    return out;
}

std::string from_one_word(const std::string& word) {
    std::string out;
    for (std::size_t i = 0; i < word.size(); ++i) {
        unsigned int byte = 0;
        if (word[i] == '%' && std::sscanf(word.c_str() + i + 1, "%2x", &byte) == 1) {
            out += static_cast<char>(byte);
            i += 2;
        } else {
            out += word[i];
        }
    }
    return out;
}

std::string place_mark(const core::PlacedObject& o) {
    std::array<char, 240> numbers{};
    std::snprintf(numbers.data(), numbers.size(), "place %.17g %.17g %.17g %.17g %.17g %.17g %.17g ", o.at.x, o.at.y,
                  o.at.z, o.scale, o.turn.x, o.turn.y, o.turn.z);
    return numbers.data() + one_word(o.name) + " " + one_word(o.model);
}

std::optional<core::PlacedObject> placed_of(const std::string& mark) {
    core::PlacedObject o;
    int end = 0;
    if (std::sscanf(mark.c_str(), "place %lf %lf %lf %lf %lf %lf %lf %n", &o.at.x, &o.at.y, &o.at.z, &o.scale,
                    &o.turn.x, &o.turn.y, &o.turn.z, &end) != 7) {
        return std::nullopt;
    }
    const std::string names = mark.substr(static_cast<std::size_t>(end));
    const std::size_t gap = names.find(' ');
    if (gap == std::string::npos || gap == 0 || gap + 1 == names.size()) return std::nullopt;
    o.name = from_one_word(names.substr(0, gap));
    o.model = from_one_word(names.substr(gap + 1));
    return o;
}

const input::TraceMarker* first_mark(const input::Trace& trace) {
    for (const input::TraceRecord& record : trace.records) {
        if (const auto* mark = std::get_if<input::TraceMarker>(&record)) return mark;
    }
    return nullptr;
}

input::PenTool tool_of(const ui::WindowEvent& event) {
    if (event.finger) return input::PenTool::Touch;
    if (!event.pen) return input::PenTool::Mouse;
    return event.eraser ? input::PenTool::Eraser : input::PenTool::Pen;
}

/// The event that a sample was made of, by what it changes.
ui::WindowEvent event_of(const input::PenSample& sample, bool was_down, ui::SizePx screen) {
    ui::WindowEvent event;
    event.kind = sample.tip ? (was_down ? Kind::Move : Kind::Down) : (was_down ? Kind::Up : Kind::Move);
    if (!sample.in_range) event.kind = Kind::Leave;
    event.x = sample.x.value_or(0) * screen.width;
    event.y = sample.y.value_or(0) * screen.height;
    event.pressure = sample.pressure.value_or(1);
    event.finger = sample.tool == input::PenTool::Touch;
    event.pen = sample.tool == input::PenTool::Pen || sample.tool == input::PenTool::Eraser;
    event.eraser = sample.tool == input::PenTool::Eraser;
    event.button = (sample.buttons & input::kBarrel1) != 0;
    return event;
}

std::optional<ui::WindowEvent> event_of(const input::TraceMarker& mark) {
    ui::WindowEvent event;
    if (mark.text == "take back") {
        event.kind = Kind::TakeBack;
        return event;
    }
    if (mark.text == "cancel") {
        event.kind = Kind::Cancel;
        return event;
    }
    event.kind = Kind::Zoom;
    if (std::sscanf(mark.text.c_str(), "zoom %lf %lf %lf %lf %lf", &event.zoom, &event.x, &event.y, &event.shift_x,
                    &event.shift_y) != 5) {
        return std::nullopt;
    }
    event.finger = mark.text.size() > 7 && mark.text.substr(mark.text.size() - 7) == " finger";
    return event;
}

using Recorded = std::variant<const input::PenSample*, const input::TraceMarker*>;

/// Samples and marks as they came: a recorder writes the marks of a while behind its samples.
std::vector<Recorded> in_time(const input::Trace& trace) {
    std::vector<Recorded> all;
    for (const input::TraceRecord& record : trace.records) {
        if (const auto* sample = std::get_if<input::PenSample>(&record)) all.emplace_back(sample);
        if (const auto* mark = std::get_if<input::TraceMarker>(&record)) all.emplace_back(mark);
    }
    const auto time = [](const Recorded& r) { return std::visit([](const auto* v) { return v->time_ns; }, r); };
    std::stable_sort(all.begin(), all.end(), [&](const Recorded& a, const Recorded& b) { return time(a) < time(b); });
    return all;
}

}  // namespace

/// What the trace knows of mouse, finger and pen: one device on the screen.
class GarmentRecorder::Pointer final : public input::PenSource {
  public:
    void drain(std::vector<input::SourceEvent>& out) override { out.clear(); }
    [[nodiscard]] input::TraceDevice device(std::uint32_t number) const override {
        input::TraceDevice device;
        device.number = number;
        device.identity.name = "what pointed in Garment";
        device.source = "pointer";
        return device;
    }
    [[nodiscard]] std::uint64_t lost() const override { return 0; }
    [[nodiscard]] std::string_view name() const override { return "pointer"; }
};

double whole_64ths(double px) {
    return std::round(px * 64) / 64;
}

core::Result<std::unique_ptr<GarmentRecorder>> GarmentRecorder::create(const std::filesystem::path& file,
                                                                       const GarmentStart& start, std::int64_t now_us) {
    core::Result<std::unique_ptr<input::TraceRecorder>> recorder = input::TraceRecorder::create(file.string());
    if (!recorder) return core::unexpected(recorder.error());
    (*recorder)->mark(now_us * 1000, start_mark(start));
    return std::unique_ptr<GarmentRecorder>(new GarmentRecorder(std::move(*recorder), start.screen, now_us));
}

GarmentRecorder::GarmentRecorder(std::unique_ptr<input::TraceRecorder> recorder, ui::SizePx screen, std::int64_t now_us)
    : recorder_(std::move(recorder)), pointer_(std::make_shared<Pointer>()), screen_(screen) {
    input::SourceEvent attached;
    attached.kind = input::SourceEventKind::Attached;
    attached.device = kDevice;
    attached.time_ns = now_us * 1000;
    recorder_->record(attached, *pointer_);
}

void GarmentRecorder::record(const ui::WindowEvent& event) {
    const std::int64_t time_ns = event.time_us * 1000;
    if (event.kind == Kind::Zoom) return recorder_->mark(time_ns, zoom_mark(event));
    if (event.kind == Kind::TakeBack || event.kind == Kind::Cancel) {
        tip_ = false;
        return recorder_->mark(time_ns, event.kind == Kind::TakeBack ? "take back" : "cancel");
    }
    if (event.kind == Kind::Down) tip_ = true;
    if (event.kind == Kind::Up || event.kind == Kind::Leave) tip_ = false;
    input::SourceEvent sampled;
    sampled.kind = input::SourceEventKind::Sample;
    sampled.device = kDevice;
    sampled.time_ns = time_ns;
    sampled.sample_valid = true;
    sampled.sample.time_ns = time_ns;
    sampled.sample.device = kDevice;
    sampled.sample.in_range = event.kind != Kind::Leave;
    sampled.sample.tip = tip_;
    if (sampled.sample.in_range) {
        sampled.sample.x = event.x / screen_.width;
        sampled.sample.y = event.y / screen_.height;
        sampled.sample.pressure = event.pressure;
        sampled.sample.tool = tool_of(event);
        sampled.sample.buttons = event.button ? input::kBarrel1 : 0;
    }
    recorder_->record(sampled, *pointer_);
}

void GarmentRecorder::place(const core::PlacedObject& object, std::int64_t now_us) {
    recorder_->mark(now_us * 1000, place_mark(object));
}

bool is_garment_trace(const input::Trace& trace) {
    const input::TraceMarker* mark = first_mark(trace);
    return mark != nullptr && mark->text.rfind("garment ", 0) == 0;
}

core::Result<GarmentReplay> garment_replay(const input::Trace& trace, std::string name) {
    const input::TraceMarker* mark = first_mark(trace);
    GarmentReplay replay;
    int version = 0;
    std::array<char, 16> language{}, hand{};
    if (mark == nullptr ||
        std::sscanf(mark->text.c_str(), "garment %d %dx%d %15s %15s", &version, &replay.start.screen.width,
                    &replay.start.screen.height, language.data(), hand.data()) != 5) {
        return core::unexpected(core::ErrorCode::BadFormat, "this trace was not recorded while a garment was drawn",
                                std::move(name));
    }
    if (version > kVersion) {
        return core::unexpected(core::ErrorCode::NewerVersion,
                                "this trace of a garment was recorded by a newer Croquis; update to play it",
                                std::move(name));
    }
    const ui::SizePx screen = replay.start.screen;
    if (screen.width < 1 || screen.height < 1 || screen.width > 16384 || screen.height > 16384) {
        return core::unexpected(core::ErrorCode::BadFormat, "the trace names a screen of no possible size",
                                std::move(name));
    }
    replay.name = std::move(name);
    replay.start.language = language.data();
    replay.start.hand = std::string(hand.data()) == "left" ? ui::Hand::Left : ui::Hand::Right;
    bool down = false;
    std::optional<std::int64_t> first_ns;
    const auto add = [&](ui::WindowEvent event, std::int64_t time_ns) {
        if (!first_ns) first_ns = time_ns;
        event.time_us = std::max<std::int64_t>(0, (time_ns - *first_ns) / 1000);
        replay.events.push_back(event);
    };
    for (const Recorded& record : in_time(trace)) {
        if (const auto* sample = std::get_if<const input::PenSample*>(&record)) {
            add(event_of(**sample, down, screen), (*sample)->time_ns);
            down = (*sample)->tip;
            continue;
        }
        const input::TraceMarker& marked = *std::get<const input::TraceMarker*>(record);
        if (std::optional<core::PlacedObject> placed = placed_of(marked.text)) {
            replay.placed.push_back({replay.events.size(), std::move(*placed)});
            continue;
        }
        const std::optional<ui::WindowEvent> event = event_of(marked);
        if (!event) continue;
        add(*event, marked.time_ns);
        if (event->kind != Kind::Zoom) down = false;
    }
    return replay;
}

}  // namespace app
