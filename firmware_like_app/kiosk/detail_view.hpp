#pragma once
// One result, opened: the model that can be turned, its parts and the drawing's, six other close models.

#include <memory>
#include <optional>
#include <vector>

#include "firmware_like_app/kiosk/detail_model.hpp"
#include "firmware_like_app/kiosk/newest_worker.hpp"
#include "firmware_like_app/kiosk/search_worker.hpp"
#include "ui/draw/ink_layer.hpp"
#include "ui/draw/lifted_parts.hpp"
#include "ui/draw/model_painter.hpp"
#include "ui/draw/model_stage.hpp"
#include "ui/draw/painter.hpp"
#include "ui/gl/window.hpp"
#include "ui/screens/detail_screen.hpp"

namespace app {

class DetailView {
  public:
    /// Where every frame is seen no frame waits for a model: it is made ready on another thread, comes to the graphics
    /// card in steps (use_spare_time) and is shown as on its card until then; the moving model is drawn with fewer
    /// pixels when frames come slowly; pictures of similar models come one by one. Else all is as it will be at once.
    void set_frames_are_seen(bool seen);
    /// One step of what is wanted; see FindMode::use_spare_time.
    void use_spare_time(ui::Painter& painter);
    static constexpr std::int64_t kOpen_us = 320'000, kGreeting_us = 4'000'000, kRise_us = 600'000;
    static constexpr std::int64_t kFade_us = 160'000;  ///< from the still picture to the model that turns

    [[nodiscard]] static core::Result<DetailView> create(const ui::FontSet& fonts,
                                                         const std::vector<ui::Strings>& languages);

    /// Shows the `index`-th of the answer. `from`: the card's picture on the screen, out of which the model grows.
    void open(std::shared_ptr<const PreparedAnswer> answer, std::size_t index, core::Drawing drawing,
              const ui::Rect& from, ui::SizePx screen, ui::Hand hand, std::int64_t now_us, ui::Painter& painter);
    /// Gives back what the view needs.
    void close(ui::Painter& painter);
    [[nodiscard]] bool is_open() const { return answer_ != nullptr; }
    void resize(ui::SizePx screen, ui::Hand hand, ui::Painter& painter);

    /// Whether a result can be put on the figure of Garment.
    void offer_wear(bool offered) { wear_offered_ = offered; }
    /// The one that is open.
    [[nodiscard]] const FoundModel& found() const { return answer_->answer.best[index_]; }

    /// Turning, zooming and the numbers. Gives what was tapped: KeepDrawing, Wear, or nothing.
    std::optional<ui::Control> pointer(const ui::WindowEvent& event, ui::Painter& painter);
    void cancel_pointer();
    /// Once a frame: turns.
    void update(std::int64_t now_us);
    /// Before a frame that is seen: the model's picture, where its view changed.
    void draw_model(ui::Painter& painter);
    /// Ends the opening at once.
    void settle(std::int64_t now_us);
    [[nodiscard]] ui::DetailState state(std::size_t language, std::int64_t now_us) const;
    [[nodiscard]] ui::DrawList draw(const ui::DetailState& state) const { return screen_.draw(state, layout_); }
    [[nodiscard]] const ui::DetailLayout& layout() const { return layout_; }
    /// Parts have other colours from now on (ui/draw/palette.hpp): those of the model change.
    void recolour();
    /// Which of the answer is shown.
    [[nodiscard]] std::size_t index() const { return index_; }

  private:
    DetailView(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, ui::ModelStage stage,
               ui::ModelPainter cards, ui::InkLayer ink);
    struct Wash {
        ui::Texture coverage;
        ui::Rect in_box;
        int colour;
    };
    void show(std::size_t index, std::int64_t now_us, ui::Painter& painter);
    /// Of what is shown; null where it has no mesh.
    [[nodiscard]] const ui::CardModel* card() const;
    void make_still(ui::Painter& painter);
    void ask_for_model();
    void take_model(PreparedDetail ready);
    void upload_model();
    void begin_whole();
    bool draw_piece(ui::Painter& painter);
    void show_stage(ui::Painter& painter);
    [[nodiscard]] ui::Rect still_rect(double opened) const;
    [[nodiscard]] double still_opacity(std::int64_t now_us) const;
    void lay_out(ui::Painter& painter);
    void make_drawing(ui::Painter& painter);
    void make_similar(ui::Painter& painter);
    void paint_similar(std::size_t count, ui::Painter& painter);
    void act(const ui::Intent& intent, std::int64_t now_us, ui::Painter& painter);
    void set_focus(std::optional<int> focus);
    void zoom_by(double factor);
    [[nodiscard]] double opened(std::int64_t now_us) const;
    [[nodiscard]] ui::StageView view() const;
    [[nodiscard]] std::vector<ui::DetailTag> model_tags() const;

    ui::DetailScreen screen_;
    ui::ModelStage stage_;
    ui::ModelPainter card_painter_;
    ui::InkLayer ink_;
    ui::DetailLayout layout_;

    std::shared_ptr<const PreparedAnswer> answer_;
    CardPreparer preparer_;
    CardPreparer::Cards cards_;
    std::size_t index_ = 0;
    core::Drawing drawing_;
    ui::InkFrame frame_;
    std::vector<Wash> wash_;
    std::vector<ui::DetailTag> drawing_tags_;  // from the box's corner
    std::vector<std::size_t> similar_;         // places in the answer
    std::vector<ui::Texture> similar_pictures_;
    // the model on its way: asked for, lifted, uploaded, its picture made, drawn
    enum class Model { None, Asked, Lifted, Uploaded, Pictured, Drawn } model_ = Model::None;
    std::unique_ptr<NewestWorker<DetailJob, PreparedDetail>> worker_;
    std::uint64_t ticket_ = 0;  // of the newest that was asked for
    std::optional<ui::Texture> still_;
    ui::PicturePlace still_place_;
    std::optional<std::int64_t> model_since_us_;  // shown since
    ui::LiftedModel lifted_;
    std::vector<ui::GroundContact> contacts_;
    std::shared_ptr<const ui::ModelGeometry> surface_;       // uncut: what may stand before a part
    std::vector<bool> covered_;                              // for each anchor, in the view as it is
    double ground_ = -1, fit_scale_ = 1, plane_middle_ = 0;  // of the model in its first view
    double wide_ = 1, tall_ = 1;                             // units

    ui::Rect from_;
    std::int64_t opened_us_ = 0, last_us_ = 0;
    double azimuth_ = 0, elevation_ = 0, zoom_ = 1;
    bool touched_ = false, turning_ = false, frames_are_seen_ = false, wear_offered_ = false;
    core::Point grip_;
    ui::BoardTouch touch_;
    std::optional<int> focus_;
    std::optional<ui::StageView> view_, drawn_view_;  // as it is, and as it was drawn last
    std::uint64_t view_number_ = 0;
    // where drawing is slow, moving pictures are drafts, and the one at rest is drawn whole in pieces, one a frame
    int slow_frames_ = 0;
    bool drew_whole_ = false;    // in one go, for the frame that is shown now
    bool draft_ = false;         // is shown
    bool at_rest_ = false;       // the pieces have begun
    std::int64_t whole_us_ = 0;  // of the pieces so far
};

}  // namespace app
