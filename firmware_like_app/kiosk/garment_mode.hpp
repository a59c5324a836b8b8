#pragma once
// The Garment mode at work: pen and touches in; the garment desk, the cloth that is built for it and the pictures of
// the figure kept; one draw list a frame out. The pen never waits: cloth is made on the builder's thread.

#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/desk/garment_desk.hpp"
#include "firmware_like_app/garment/exporter.hpp"
#include "firmware_like_app/garment/gallery_desk.hpp"
#include "firmware_like_app/garment/stick_finder.hpp"
#include "firmware_like_app/kiosk/figure_views.hpp"
#include "firmware_like_app/kiosk/garment_body.hpp"
#include "firmware_like_app/kiosk/garment_body_files.hpp"
#include "firmware_like_app/kiosk/garment_builder.hpp"
#include "firmware_like_app/kiosk/garment_drape.hpp"
#include "firmware_like_app/kiosk/garment_keeper.hpp"
#include "firmware_like_app/kiosk/garment_objects.hpp"
#include "firmware_like_app/kiosk/garment_sheet.hpp"
#include "firmware_like_app/kiosk/garment_stepper.hpp"
#include "firmware_like_app/kiosk/garment_trace.hpp"
#include "firmware_like_app/kiosk/mode.hpp"
#include "firmware_like_app/kiosk/own_fabrics.hpp"
#include "firmware_like_app/kiosk/searcher.hpp"
#include "ui/draw/painter.hpp"
#include "ui/screens/garment_screen.hpp"

namespace app {

struct GarmentOptions {
    std::size_t language = 0;
    ui::Hand hand = ui::Hand::Right;
    std::string size = "38";          ///< of a new design's body
    std::filesystem::path designs;    ///< file in which designs are kept; empty: they go with the visitor
    std::filesystem::path export_to;  ///< folder; empty: the USB stick
    std::string models;               ///< index in which placed objects are looked up; empty: none
    ModelSource model_source = {};    ///< in its place, where it is given
    std::filesystem::path bodies;     ///< folder of bodies to choose from; empty: none
    std::filesystem::path fabrics;    ///< folder of pictures of fabrics; empty: none
    int bin_days = 30;
    std::filesystem::path record;  ///< folder for a trace of each visit; empty: none
    /// Gives the desk of an empty design on a body of that size, called on a thread of its own; none: it is made.
    std::function<core::Result<core::GarmentDesk>(const std::string& size)> first_desk;
    bool every_frame_seen = true;  ///< false: cloth is made before the next frame, for pictures and replays
};

class GarmentMode final : public Mode {
  public:
    /// All references must outlive the mode.
    [[nodiscard]] static core::Result<std::unique_ptr<GarmentMode>> create(const ui::FontSet& fonts,
                                                                           const std::vector<ui::Strings>& languages,
                                                                           const GarmentOptions& options,
                                                                           ui::SizePx screen);
    ~GarmentMode() override;

    void resize(ui::SizePx screen) override;
    void pointer(const ui::WindowEvent& event) override;
    void cancel_pointer(std::int64_t now_us) override;
    void update(std::int64_t now_us) override;
    int update_ink() override;
    [[nodiscard]] bool changed(std::int64_t now_us) const override;
    void draw(std::int64_t now_us, bool flip) override;
    [[nodiscard]] bool has_work() const override;
    void wipe(std::size_t language, ui::Hand hand) override;
    [[nodiscard]] std::size_t language() const override { return options_.language; }
    void set_language(std::size_t language) override { options_.language = language; }
    [[nodiscard]] ui::Hand hand() const override { return options_.hand; }
    void set_hand(ui::Hand hand) override;

    /// Makes the body of an empty design on a thread of its own, so that it is there when the visitor comes. Without
    /// this it is made when the mode is first used.
    void prepare();
    /// Another design in place of the one at work. A body that is not the worn one is made first: some 100 ms.
    [[nodiscard]] core::Result<void> open(const core::Design& design);
    /// The design as it stands.
    [[nodiscard]] core::Design design();
    [[nodiscard]] core::GarmentDesk& desk();
    /// A model that was found goes on the figure, chosen, so that it can be moved at once. Waits for the figure.
    void wear(const FoundModel& found, std::int64_t now_us);
    /// The same of a recording.
    void place(const core::PlacedObject& object, std::int64_t now_us);
    /// The gallery, while it is on the screen.
    [[nodiscard]] const GalleryDesk* gallery() const { return gallery_open_ ? gallery_.get() : nullptr; }
    [[nodiscard]] ExportState export_state() const { return exporter_.state(); }

    /// After so many acts of the history.
    void go_to(std::size_t acts, std::int64_t now_us) { take_reply(desk().go_to(acts), now_us); }

    /// The visitor pressed Find.
    [[nodiscard]] bool take_find_wish() { return std::exchange(find_wanted_, false); }
    /// Ends what moves and makes what is due: cloth, small pictures.
    void settle(std::int64_t now_us);

    [[nodiscard]] bool pen_is_down() const { return hold_ != Hold::None; }
    /// The lines over the figure anew; for measuring.
    void project_now() { project(); }
    [[nodiscard]] const ui::GarmentLayout& layout() const { return layout_; }
    [[nodiscard]] ui::GarmentState state(std::int64_t now_us) const;
    [[nodiscard]] FigureViews& views() { return views_; }

  private:
    GarmentMode(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, const GarmentOptions& options,
                ui::SizePx screen, ui::Painter painter, FigureViews views);
    /// What the pointer does between its down and its up.
    enum class Hold { None, Board, Drawing, Turning, Moving, Folds, Measure, Number, List, Gesture, Object };

    // desk
    void ready_desk();
    void take_reply(const core::DeskReply& reply, std::int64_t now_us);
    void note(const core::DeskNote& note);
    void choose_piece();
    bool close_middle(const core::DeskNote& from, std::int64_t now_us);
    void request_cloth();
    void take_cloth();
    void show_cloth();
    void follow_live();
    [[nodiscard]] std::vector<int> woven_layers() const;
    [[nodiscard]] ui::FabricLook look_of(const std::string& piece, int layer) const;
    [[nodiscard]] std::string piece_for_folds() const;

    // the garment under gravity
    void press_drape();
    void put_back();
    void follow_drape(std::int64_t now_us);
    [[nodiscard]] bool can_hang() const;

    // what the figure wears beside cloth
    void show_objects();
    [[nodiscard]] const std::vector<core::PlacedObject>& objects() const { return desk_->state().look().objects; }
    [[nodiscard]] std::optional<ui::ObjectHandles> object_handles() const;
    bool hold_object(const ui::WindowEvent& event);
    void let_object_go(std::int64_t now_us);
    void press_object_row(std::size_t row);
    void unplace_row(std::size_t row, std::int64_t now_us);
    void fill_object_rows(ui::GarmentState& state) const;

    // pointer
    bool ready_recorder(std::int64_t now_us);
    void record(const ui::WindowEvent& event);
    void gesture(const ui::WindowEvent& event);
    void repeat_until(std::int64_t now_us);
    void press(const ui::WindowEvent& event);
    void touch_sheet(const ui::WindowEvent& event);
    void drag(const ui::WindowEvent& event);
    void release(const ui::WindowEvent& event);
    void end_stroke(const ui::WindowEvent& event);
    void end_tap(const ui::WindowEvent& event);
    void select_at(core::Point px);
    void hold_slider(const ui::Intent& intent, const ui::WindowEvent& event);
    void slide(double x);
    void drop_hold(std::int64_t now_us);
    void take_back();
    [[nodiscard]] core::DeskTool desk_tool() const;
    [[nodiscard]] bool pen_turns(const ui::WindowEvent& event);

    // acts
    void act(const ui::Intent& intent, std::int64_t now_us);
    void act(const ui::GarmentIntent& intent, std::int64_t now_us);
    void choose_tool(ui::GarmentTool tool, std::int64_t now_us);
    void finish_line();
    void choose_view(std::size_t tile);
    void press_row(std::size_t row, std::int64_t now_us);
    void press_eye(std::size_t row, std::int64_t now_us);
    void move_row(std::size_t row, int by, std::int64_t now_us);
    void open_drawer(ui::GarmentDrawer drawer);
    void choose_fabric(std::size_t fabric, std::int64_t now_us);
    void choose_colour(std::size_t colour, std::int64_t now_us);
    void try_body();
    void keep_body(std::int64_t now_us);
    void act_on_body(const ui::GarmentIntent& intent, std::int64_t now_us);
    void open_pad(std::size_t slider);
    void press_pad(std::size_t key);
    void end_pad(std::int64_t now_us);
    void take_own_body(std::int64_t now_us);
    void clear_design(std::int64_t now_us);
    void undo(std::int64_t now_us);
    void undo_new();
    [[nodiscard]] std::vector<std::string> pieces_to_dye() const;
    void dye(const std::function<void(core::ClothMaterial&)>& change, std::int64_t now_us);

    // designs that are kept
    void export_as(std::size_t kind);
    void fill_export(ui::GarmentState& state) const;
    void open_gallery();
    void keep_picture();
    void leave_gallery();
    void show_gallery_pictures();
    void gallery_pointer(const ui::WindowEvent& event);
    void press_gallery(std::size_t item, std::int64_t now_us);
    void open_kept(std::int64_t id);

    // where lines lie
    [[nodiscard]] ui::StepperOf stepper_of() const;
    [[nodiscard]] double last_place_cm(ui::StepperOf what) const;
    void step_number(int direction);
    void keep_quads(std::int64_t now_us);
    void fill_planes(ui::GarmentState& state) const;

    // state
    void relayout(ui::SizePx screen, ui::Hand hand);
    void project();
    void make_washes();
    void drop_washes();
    void fill_rows(ui::GarmentState& state) const;
    void fill_history(ui::GarmentState& state) const;
    void fill_stroke(ui::GarmentState& state) const;
    void fill_drawer(ui::GarmentState& state) const;
    [[nodiscard]] const ui::Strings& words() const { return languages_[options_.language]; }
    [[nodiscard]] std::optional<std::size_t> layer_of_row(std::size_t row) const;
    void make_fabric_tiles();

    const ui::FontSet& fonts_;
    const std::vector<ui::Strings>& languages_;
    GarmentOptions options_;
    ui::GarmentLayout layout_;
    ui::GarmentScreen screen_;
    ui::Painter painter_;
    FigureViews views_;
    GarmentBuilder builder_;
    GarmentDrape drape_;
    HangingPlaces hanging_;                                // as shown
    bool hanging_wanted_ = false;                          // hangs as soon as its cloth is there
    std::future<core::Result<core::GarmentDesk>> coming_;  // the desk of an empty design
    std::optional<core::GarmentDesk> desk_;
    std::string failure_;  // why there is no desk
    std::vector<std::shared_ptr<const core::Cloth>> textured_;
    mutable GarmentObjects objects_;  // looks models up when they are first seen

    ui::GarmentTool tool_ = ui::GarmentTool::OnBody;
    std::size_t page_ = 0;
    GarmentStepper stepper_;
    bool quads_ = true, body_shown_ = true, history_shown_ = false;
    ui::GarmentDrawer drawer_ = ui::GarmentDrawer::None;
    GarmentBody body_;
    GarmentBodyFiles body_files_;
    std::optional<std::size_t> typed_;  // slider whose number is being written
    ui::NumberEdit number_;
    bool number_wrong_ = false;
    OwnFabrics own_fabrics_;
    std::string body_problem_, problem_;
    std::vector<std::pair<core::DeskNote, std::string>> notes_;  // at a place, with its words' key
    std::optional<core::TapeReading> tape_;
    std::string piece_, line_;  // selected
    bool cleared_ = false;
    std::int64_t cleared_us_ = 0;
    std::optional<core::Design> put_away_;  // by New; Undo at the start of what follows brings it back
    std::int64_t put_away_id_ = 0;          // where it is kept; 0: nowhere
    GarmentKeeper keeper_;
    std::unique_ptr<GalleryDesk> gallery_;
    std::map<ui::PictureId, ui::Texture> gallery_pictures_;
    bool gallery_open_ = false, export_no_place_ = false;
    Exporter exporter_;
    bool find_wanted_ = false;

    ui::BoardTouch touch_;
    Hold hold_ = Hold::None;
    core::Point down_px_, last_px_;
    std::optional<core::Point> pointer_px_;
    bool pen_hovers_ = false, eraser_near_ = false, erasing_ = false, moved_ = false;
    bool repeated_ = false;  // a stepper that is held
    core::Polyline stroke_px_;
    std::size_t slider_ = 0;  // of the body drawer
    double folds_ = 0;        // while they are held
    std::string folds_piece_;
    double scroll_px_ = 0, scroll_start_px_ = 0;
    std::optional<std::int64_t> repeat_us_;  // of a stepper that is held: the next step
    int repeat_by_ = 0, repeats_ = 0;
    double number_start_cm_ = 0;     // of the stepper, while its number is dragged
    GarmentStepper stepper_before_;  // as the pointer came down
    std::unique_ptr<GarmentRecorder> recorder_;
    bool recording_failed_ = false;

    SheetDrawing drawing_;
    bool drawing_due_ = true, live_due_ = false, body_due_ = false;
    std::uint64_t projected_geometry_ = 0;
    struct Wash {
        ui::Texture coverage;
        ui::Rect rect;
        ui::Colour colour;
    };
    std::vector<Wash> washes_;

    struct Shown {
        ui::GarmentState state;
        std::optional<ui::GalleryState> gallery;
        ui::SizePx screen;
        ui::Hand hand;
        friend bool operator==(const Shown&, const Shown&) = default;
    };
    [[nodiscard]] Shown shown_at(std::int64_t now_us) const;
    std::optional<Shown> shown_;
};

}  // namespace app
