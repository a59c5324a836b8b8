#pragma once
// The drawing on the sheet while it is made: strokes, the stroke-wise eraser, undo and redo without limit.

#include <cstdint>
#include <utility>
#include <vector>

#include "core/stroke/stroke.hpp"

namespace ui {

class Sketch {
  public:
    /// Tip down. The first sample belongs to the stroke; its line is `width` times as wide as the normal one.
    void begin(const core::PenSample& sample, double width = 1.0);
    /// Tip moved. A sample at the very place of the last one is left out. Needs an open stroke.
    void extend(const core::PenSample& sample);
    /// Tip up: the stroke becomes one step of undo.
    void end();
    /// What is being drawn or erased did not happen (a palm): gone from the sheet and from the history.
    void take_back();
    [[nodiscard]] bool open() const { return open_; }

    /// Removes every stroke that comes within `reach` of the point (units of the drawing). Returns whether any did.
    /// Everything erased before end_erasing() is one step of undo.
    bool erase_at(core::Point point, double reach);
    void end_erasing();

    /// Empties the sheet as one step of undo. Nothing on an empty sheet.
    void clear();
    /// Empties the sheet and the history: nothing of it can come back.
    void forget();
    void undo();
    void redo();
    [[nodiscard]] bool can_undo() const { return !done_.empty() && !open_; }
    [[nodiscard]] bool can_redo() const { return !undone_.empty() && !open_; }

    [[nodiscard]] const core::Drawing& drawing() const { return drawing_; }
    [[nodiscard]] bool empty() const { return drawing_.strokes.empty(); }
    /// Of each stroke of the drawing, as begin() was told.
    [[nodiscard]] const std::vector<double>& widths() const { return widths_; }
    /// Changes with everything but appending samples and strokes: a picture of the strokes must be drawn anew.
    [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
    /// Changes with every change.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

  private:
    /// A step: strokes that it added at the end, or removed from the places given (ascending).
    struct Step {
        struct Placed {
            std::size_t place = 0;
            core::Stroke stroke;
            double width = 1.0;
        };
        bool added = false;
        std::vector<Placed> strokes;
    };
    void remove(std::size_t i);
    void add_back(const Step& step);
    void take_out(const Step& step);
    void record(Step step);

    core::Drawing drawing_;
    std::vector<double> widths_;
    std::vector<Step> done_, undone_;
    Step erasing_;
    bool open_ = false;
    std::uint64_t epoch_ = 0, revision_ = 0;
};

}  // namespace ui
