#pragma once
// The Find mode at work: pen and touches in, sketch, searches and cards kept, one draw list a frame out.
// Ink never waits: searches run on the worker's thread and card pictures are painted one a frame.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "firmware_like_app/kiosk/best_shadow.hpp"
#include "firmware_like_app/kiosk/card_pictures.hpp"
#include "firmware_like_app/kiosk/card_worker.hpp"
#include "firmware_like_app/kiosk/mode.hpp"
#include "firmware_like_app/kiosk/search_worker.hpp"
#include "ui/draw/ink_layer.hpp"
#include "ui/draw/painter.hpp"
#include "ui/gl/window.hpp"
#include "ui/screens/calm_order.hpp"
#include "ui/screens/find_screen.hpp"
#include "ui/screens/sketch.hpp"

namespace app {

struct FindOptions {
    std::size_t language = 0;
    ui::Hand hand = ui::Hand::Right;
    std::string board_key = "hint_board";  ///< of the words on the board while it shows no cards
    bool shadow = true;                    ///< of the best match, under the ink
    bool search_while_drawing = true;      ///< whenever samples came; false: only after strokes
    bool every_frame_seen = true;          ///< false: cards and wash are made when settle() asks for them
    bool spare_time = false;               ///< true: card pictures are painted in use_spare_time() alone
};

class FindMode final : public Mode {
  public:
    /// `searcher` may be null: the sheet works, nothing is found. All references must outlive the mode.
    [[nodiscard]] static core::Result<std::unique_ptr<FindMode>> create(const ui::FontSet& fonts,
                                                                        const std::vector<ui::Strings>& languages,
                                                                        Searcher* searcher, const FindOptions& options,
                                                                        ui::SizePx screen);

    /// Another size of screen: everything is laid out and drawn anew, the drawing keeps its place on the sheet.
    void resize(ui::SizePx screen) override;
    /// A mouse, a finger or a pen. The eraser end of a pen erases whatever tool is chosen.
    void pointer(const ui::WindowEvent& event) override;
    /// Where the pen will be when the frame is seen: shown as ink ahead of it, never part of a stroke.
    void look_ahead(const std::optional<ui::WindowEvent>& predicted);
    /// The pointer is gone (focus lost): a stroke ends where it is, a pressed control does nothing.
    void cancel_pointer(std::int64_t now_us) override;

    /// An empty sheet with no history, onto which a drawing of this extent fits with a margin.
    void start_sheet_for(const core::Drawing& drawing);
    void begin_stroke(const core::PenSample& sample, std::int64_t now_us);
    void extend_stroke(const core::PenSample& sample);
    void end_stroke(std::int64_t now_us);

    /// Searches what was drawn since the last search, while a stroke is drawn.
    void search_news();
    /// Once a frame: searches when due, takes answers, paints a few card pictures, moves what fades.
    void update(std::int64_t now_us) override;
    /// Paints one card picture that is wanted. To be called when a frame is on its way to the screen, before the pen is
    /// read for the next: what is done here keeps no ink waiting. See FindOptions::spare_time.
    void use_spare_time();
    /// Searches the sheet as it is and waits until its answer is on the cards.
    void search_and_wait();
    /// Ends all fades; with `resting` the wash is shown as when the pen rests.
    void settle(bool resting);
    /// Whether the frame would differ from the one drawn last.
    [[nodiscard]] bool changed(std::int64_t now_us) const override;
    /// The frame into whatever is bound; `flip` for windows.
    void draw(std::int64_t now_us, bool flip) override;
    /// The same pixels, where what is bound still holds the frame that was drawn last: only what changed is drawn.
    /// `over`: commands without pictures that lie over the frame.
    void draw_changes(std::int64_t now_us, bool flip, const ui::DrawList& over = {});
    /// What is bound to be drawn into no longer holds the frame that was drawn last.
    void forget_frame() { painter_.forget_frame(); }
    /// Draws new samples into the ink layer (before the frame is bound). Returns the number of pieces drawn.
    int update_ink() override;

    [[nodiscard]] const ui::Sketch& sketch() const { return sketch_; }
    [[nodiscard]] const ui::FindLayout& layout() const { return layout_; }
    /// What the cards show or are about to: models of the newest answers in a calm order, see
    /// ui/screens/calm_order.hpp.
    [[nodiscard]] const PreparedAnswer* answer() const { return answer_.get(); }
    /// The newest answer as the search gave it.
    [[nodiscard]] const PreparedAnswer* ranking() const { return ranking_.get(); }
    [[nodiscard]] ui::FindState state(std::int64_t now_us) const;
    [[nodiscard]] bool has_work() const override { return !sketch_.empty() || sketch_.can_undo() || sketch_.open(); }
    void wipe(std::size_t language, ui::Hand hand) override;
    [[nodiscard]] std::size_t language() const override { return options_.language; }
    void set_language(std::size_t language) override { options_.language = language; }
    [[nodiscard]] ui::Hand hand() const override { return options_.hand; }
    void set_hand(ui::Hand hand) override;
    /// Whether the switch to Garment is on the board.
    void offer_garment(bool offered) { garment_offered_ = offered; }
    /// The visitor pressed Garment.
    [[nodiscard]] bool take_garment_wish() { return std::exchange(garment_wanted_, false); }
    /// Parts have other colours from now on (ui/draw/palette.hpp): cards are painted anew.
    void recolour();
    /// Whether the best match lies under the ink as a shadow.
    void show_shadow(bool shown) { options_.shadow = shown; }
    void set_board_key(std::string key) { options_.board_key = std::move(key); }
    /// A card that was tapped.
    struct OpenedCard {
        std::int64_t model = 0;
        ui::Rect picture;  ///< on the screen
    };
    /// The one tapped since the last call.
    [[nodiscard]] std::optional<OpenedCard> take_opened_card() { return std::exchange(opened_card_, std::nullopt); }
    [[nodiscard]] std::shared_ptr<const PreparedAnswer> shared_answer() const { return answer_; }
    /// Searches finished so far.
    [[nodiscard]] std::uint64_t searches() const { return worker_ ? worker_->searches() : 0; }
    /// The last thing a searcher threw.
    [[nodiscard]] const std::string& search_failure() const { return search_failure_; }

  private:
    FindMode(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, Searcher* searcher,
             const FindOptions& options, ui::SizePx screen, ui::Painter painter, ui::InkLayer ink,
             CardPictures pictures);
    struct Wash {
        ui::Texture coverage;
        ui::Rect in_sheet;  ///< pixels from the sheet's corner
        int colour;
    };

    void act(const ui::Intent& intent, std::int64_t now_us);
    void relayout(ui::SizePx screen, ui::Hand hand);
    void sheet_changed(std::int64_t now_us);
    void submit();
    void accept(PreparedAnswer answer);
    void change_cards(std::int64_t now_us);
    [[nodiscard]] PreparedAnswer arranged(const ui::CalmOrder::Models& models) const;
    [[nodiscard]] ui::CalmOrder::Frozen frozen_cards() const;
    void show_answer();
    void make_wash();
    void drop_wash();
    void make_answer_visible();
    void drop_results();
    void start_over_frame();
    [[nodiscard]] bool wash_is_current() const;
    [[nodiscard]] double wash_opacity(std::size_t part, std::int64_t now_us) const;
    [[nodiscard]] ui::InkLayer::Ink ink() const;
    [[nodiscard]] std::vector<ui::InkPiece> ahead_ink() const;
    [[nodiscard]] core::PenSample sample_of(const ui::WindowEvent& event) const;
    [[nodiscard]] std::vector<ui::BoardTouch::Target> targets(std::int64_t now_us) const;
    void erase(const ui::WindowEvent& event);
    void touch(const ui::WindowEvent& event, bool on_sheet);
    void draw_or_erase(const ui::WindowEvent& event);
    void end_erasing(std::int64_t now_us);
    void take_back(std::int64_t now_us);

    const ui::FontSet& fonts_;
    const std::vector<ui::Strings>& languages_;
    FindOptions options_;
    ui::FindLayout layout_;
    ui::FindScreen screen_;
    ui::Painter painter_;
    ui::InkLayer ink_layer_;
    CardPictures pictures_;
    std::unique_ptr<SearchWorker> worker_;
    std::unique_ptr<CardWorker> card_worker_;

    ui::Sketch sketch_;
    ui::InkFrame frame_;  // units of the drawing to pixels of the sheet
    ui::Tool tool_ = ui::Tool::Pen;
    bool garment_offered_ = false, garment_wanted_ = false;
    bool fine_pen_ = false;
    ui::BoardTouch touch_;
    enum class Pen { Up, Drawing, Erasing } pen_ = Pen::Up;
    std::optional<core::Point> pointer_px_;
    bool pen_hovers_ = false, eraser_near_ = false;
    std::optional<core::PenSample> ahead_;
    std::optional<std::int64_t> drawing_start_us_;
    std::int64_t pen_up_us_ = 0, pen_down_us_ = 0;
    bool cleared_ = false;
    std::optional<OpenedCard> opened_card_;
    std::int64_t cleared_us_ = 0;

    ui::CardRail rail_;
    ui::CalmOrder order_;
    std::shared_ptr<const PreparedAnswer> ranking_, answer_;
    std::uint64_t shown_ranking_ = 0;  // ticket of the ranking that the cards were arranged by
    std::uint64_t oldest_ticket_ = 0;  // answers to older drawings are of a sheet that is gone
    std::uint64_t last_ticket_ = 0, last_ticket_revision_ = 0, submitted_revision_ = 0;
    std::string search_failure_;
    BestShadow shadow_;
    CardPreparer preparer_;        // for answers that come without cards
    bool answer_is_shown_ = true;  // cards and wash were made of answer_

    /// What the last frame showed.
    struct Shown {
        ui::FindState state;
        ui::SizePx screen;
        ui::Hand hand;
        std::uint64_t answer_ticket;
        friend bool operator==(const Shown&, const Shown&) = default;
    };
    [[nodiscard]] Shown shown_at(std::int64_t now_us) const;
    std::optional<Shown> shown_;

    std::vector<Wash> wash_;
    bool wash_settled_ = false;
    std::optional<std::int64_t> wash_since_us_;
    std::optional<std::int64_t> wash_out_us_;
};

}  // namespace app
