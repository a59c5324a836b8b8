#pragma once
// What pointed while garments were drawn, as a trace that draws the same design again.
//
// The trace's first mark is `garment 1 1920x1080 en right`: version, screen, language, hand. Samples are shares of that
// screen. Zooming, two fingers and what the window takes away are marks: `zoom D X Y SX SY`, `take back`, `cancel`. So
// is a model that was found and put on the figure: `place X Y Z SCALE RX RY RZ NAME MODEL`, both names with `%20` for a
// space.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/design.hpp"
#include "input/trace/trace.hpp"
#include "input/trace/trace_recorder.hpp"
#include "ui/gl/window.hpp"
#include "ui/screens/find_layout.hpp"

namespace app {

struct GarmentStart {
    ui::SizePx screen{1920, 1080};
    std::string language = "en";
    ui::Hand hand = ui::Hand::Right;
    friend bool operator==(const GarmentStart&, const GarmentStart&) = default;
};

class GarmentRecorder {
  public:
    /// A new file. WriteFailed when it cannot be made.
    [[nodiscard]] static core::Result<std::unique_ptr<GarmentRecorder>> create(const std::filesystem::path& file,
                                                                               const GarmentStart& start,
                                                                               std::int64_t now_us);
    /// Neither waits.
    void record(const ui::WindowEvent& event);
    void place(const core::PlacedObject& object, std::int64_t now_us);

  private:
    class Pointer;
    GarmentRecorder(std::unique_ptr<input::TraceRecorder> recorder, ui::SizePx screen, std::int64_t now_us);
    std::unique_ptr<input::TraceRecorder> recorder_;
    std::shared_ptr<Pointer> pointer_;
    ui::SizePx screen_;
    bool tip_ = false;
};

struct GarmentReplay {
    std::string name;
    GarmentStart start;
    std::vector<ui::WindowEvent> events;  ///< times from the first
    /// Objects put on the figure, in order, each before the event of this number (or, with their count, after all).
    struct Placed {
        std::size_t before = 0;
        core::PlacedObject object;
    };
    std::vector<Placed> placed;
};

/// Whether a trace was recorded in Garment.
[[nodiscard]] bool is_garment_trace(const input::Trace& trace);
/// BadFormat when it was not, NewerVersion for one of a later program.
[[nodiscard]] core::Result<GarmentReplay> garment_replay(const input::Trace& trace, std::string name);

/// Where a pointer is, so that recording and playing give the same number: whole 64ths of a pixel.
[[nodiscard]] double whole_64ths(double px);

}  // namespace app
