#pragma once
// All that points: tablets, mouse and fingers, as one row of pointer events for the screens.
//
//     PenDesk desk(std::move(tablets), options);
//     for (const ui::WindowEvent& event : desk.merge(surface.poll(), surface.size(), find.layout().sheet, now_us)) …
//
// One pointer at a time, and a pen before the others: while one is near, touches on the sheet are the hand that holds
// it and the mouse is what the desktop makes of it, so neither draws. A pen's tip ends what a finger or the mouse was
// doing; a touch that turns out to be the palm is taken back.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/pipeline/palm_rejection.hpp"
#include "input/pipeline/pipeline.hpp"
#include "input/sources/pointer_source.hpp"
#include "input/trace/trace_recorder.hpp"
#include "ui/draw/palette.hpp"
#include "ui/gl/window.hpp"

namespace app {

/// A tablet that is attached.
struct DeskTablet {
    std::uint32_t number = 0;
    std::string name;
    bool asleep = false;  ///< fell silent with its pen near; over with its next sample
    friend bool operator==(const DeskTablet&, const DeskTablet&) = default;
};

struct TabletChange {
    enum class Kind { Attached, Detached, Asleep, Awake };
    Kind kind = Kind::Attached;
    DeskTablet tablet;
};

struct PenDeskOptions {
    /// The tablet's area is cut to the screen's shape unless an area or aspect is set here.
    input::PipelineOptions pipeline;
    input::PalmOptions palm;
    /// A new trace of everything that points, tablets' raw reports included. Empty: none.
    std::filesystem::path trace;
    /// Called from merge() for every tablet that comes, goes, falls asleep or wakes.
    std::function<void(const TabletChange&)> tablet_changed;
};

class PenDesk {
  public:
    /// `tablets` may be null: mouse and fingers only. `numbers` gives numbers to mouse and touch; the tablets' source
    /// shares it. WriteFailed when the trace cannot be begun.
    [[nodiscard]] static core::Result<std::unique_ptr<PenDesk>> create(std::unique_ptr<input::PenSource> tablets,
                                                                       input::DeviceNumbers& numbers,
                                                                       PenDeskOptions options,
                                                                       input::Clock clock = input::monotonic_clock());

    /// Once a frame: the window's events as far as they count, and those of the tablets since the last call, in the
    /// order of their times. Tablets cover the whole screen; `sheet` is where touches may be a palm. `now_us` is the
    /// window's clock. Never waits.
    [[nodiscard]] std::vector<ui::WindowEvent> merge(const std::vector<ui::WindowEvent>& window, ui::SizePx screen,
                                                     const ui::Rect& sheet, std::int64_t now_us);

    /// Where the pen that draws will be when the next frame is seen, in pixels; for ink that is shown early.
    [[nodiscard]] std::optional<ui::WindowEvent> predicted() const;
    /// A pen is in range of a tablet.
    [[nodiscard]] bool pen_near() const { return !near_.empty(); }
    [[nodiscard]] const std::vector<DeskTablet>& tablets() const { return tablets_; }
    /// Reports that a full queue refused.
    [[nodiscard]] std::uint64_t lost() const { return source_ ? source_->lost() : 0; }
    /// What went wrong with tablets since the last call, in sentences for people.
    [[nodiscard]] std::vector<std::string> take_problems();
    /// Other settings from the next frame on; a stroke that is being drawn ends.
    void set_pipeline(const input::PipelineOptions& pipeline);
    /// A line in the trace, such as "sheet emptied".
    void mark(const std::string& text);

  private:
    PenDesk(std::unique_ptr<input::PenSource> tablets, input::DeviceNumbers& numbers, PenDeskOptions options,
            input::Clock clock);
    using Event = ui::WindowEvent;
    /// Who holds the one pointer.
    enum class Holder { None, Mouse, Finger, Pen };

    void fit(ui::SizePx screen, std::vector<Event>& out);
    void take_tablets(std::vector<Event>& out);
    void change(const input::SourceEvent& event, std::vector<Event>& out);
    void awake(std::uint32_t number);
    void say(TabletChange::Kind kind, const DeskTablet& tablet);
    void take_sample(const input::PenSample& sample, std::vector<Event>& out);
    void pen_lifts(const input::PenSample& sample, std::vector<Event>& out);
    void release_others(std::int64_t time_us, std::vector<Event>& out);
    void take_window(const Event& event, const ui::Rect& sheet, std::vector<Event>& out);
    void take_mouse(const Event& event, std::vector<Event>& out);
    void take_finger(const Event& event, const ui::Rect& sheet, std::vector<Event>& out);
    void record_pointer(const Event& event);
    [[nodiscard]] Event event_of(Event::Kind kind, const input::PenSample& sample) const;
    [[nodiscard]] std::int64_t window_us(std::int64_t time_ns) const { return time_ns / 1000 + to_window_us_; }

    std::unique_ptr<input::PenSource> source_;
    input::DeviceNumbers& numbers_;
    PenDeskOptions options_;
    input::Clock clock_;
    input::PenPipeline pipeline_;
    input::PalmRejection palm_;
    input::PointerSource pointer_;  // for the trace alone
    std::unique_ptr<input::TraceRecorder> recorder_;
    ui::SizePx screen_{0, 0};
    std::int64_t to_window_us_ = 0;  // from the monotonic clock to the window's
    std::vector<DeskTablet> tablets_;
    std::vector<std::uint32_t> near_;  // tablets with a pen in range
    Holder holder_ = Holder::None;
    std::uint32_t pen_ = 0;  // the tablet whose tip is down
    Event last_;             // of the holder
};

/// The tablets of this machine, taken from the desktop while they are open.
[[nodiscard]] std::unique_ptr<input::PenSource> open_desk_tablets(input::DeviceNumbers& numbers);

}  // namespace app
