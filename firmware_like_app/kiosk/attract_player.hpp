#pragma once
// The attract picture over time: drawings that come with the program draw themselves, are searched like a visitor's,
// and become the form of the best model.

#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.hpp"
#include "firmware_like_app/kiosk/replay_player.hpp"
#include "firmware_like_app/kiosk/search_worker.hpp"
#include "ui/draw/ink_layer.hpp"
#include "ui/draw/model_stage.hpp"
#include "ui/draw/painter.hpp"
#include "ui/screens/attract_screen.hpp"

namespace app {

/// The drawings of ui/screens/attract, or where a folder is named those of its files, in the order of their names.
/// Files that hold no strokes are passed over. FileMissing when the folder cannot be read or holds no drawing at all.
[[nodiscard]] core::Result<std::vector<NamedDrawing>> attract_drawings(const std::string& folder = {});

class AttractPlayer {
  public:
    static constexpr std::int64_t kDraw_us = 4'000'000, kForm_us = 2'000'000, kRest_us = 3'000'000, kFade_us = 400'000;
    static constexpr std::int64_t kLoop_us = kDraw_us + kForm_us + kRest_us;

    /// `searcher` may be null: lines stay lines. It must outlive the player.
    [[nodiscard]] static core::Result<std::unique_ptr<AttractPlayer>> create(std::vector<NamedDrawing> drawings,
                                                                             Searcher* searcher);

    /// From the first drawing on; also after the size of the stage changed.
    void start(ui::SizePx stage, double ink_width_px, std::int64_t now_us);
    /// Once a frame. `wait`: for the answer when it is due, so that pictures repeat.
    void update(std::int64_t now_us, bool wait, ui::Painter& painter);
    void fill(ui::AttractState& state, std::int64_t now_us) const;
    /// Draws new samples into the ink. Returns the pieces drawn.
    int update_ink();
    /// Names to the painter what of its pictures changed since the last frame.
    void tell_changes(ui::Painter& painter);
    /// Gives back what only this picture needs.
    void stop(ui::Painter& painter);
    /// The drawing on show.
    [[nodiscard]] std::size_t drawing() const { return drawing_; }

  private:
    AttractPlayer(std::vector<NamedDrawing> drawings, Searcher* searcher, ui::InkLayer ink, ui::ModelStage stage);
    void begin_drawing(std::int64_t now_us);
    void add_samples(std::int64_t age_us);
    void take_form(SearchAnswer answer);
    [[nodiscard]] ui::InkLayer::Ink ink() const;

    std::vector<NamedDrawing> drawings_;
    std::unique_ptr<SearchWorker> worker_;
    ui::InkLayer ink_layer_;
    ui::ModelStage model_;
    ui::SizePx stage_;
    double ink_width_px_ = 8;

    std::size_t drawing_ = 0;
    std::int64_t start_us_ = 0, loop_us_ = 0;
    std::vector<core::Stroke> drawn_;
    std::size_t stroke_ = 0, sample_ = 0;  // the next to draw
    std::uint64_t epoch_ = 0, revision_ = 0, ticket_ = 0;
    bool asked_ = false, answered_ = false;
    bool pictures_told_ = false;  // which textures they are
    ui::InkFrame frame_;
    std::optional<std::int64_t> form_since_us_;
    bool has_form_ = false;
    ui::Rect form_box_;
};

}  // namespace app
