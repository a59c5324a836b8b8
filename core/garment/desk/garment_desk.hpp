#pragma once
// The garment desk: everything that a screen for drawing garments drives, without threads, clock or screen. State in,
// state out; the same calls give the same design, byte for byte.
//
//     auto desk = *core::GarmentDesk::open(design, form);
//     desk.settings().tool = core::DeskTool::DrawOnBody;
//     desk.begin(view, pen); desk.extend(view, pen); …; core::DeskReply reply = desk.end();
//     for (const core::JournalEvent& event : desk.take_journal()) store.append(event);
//     if (auto request = desk.build_request()) …          // build_request.hpp
//
// Points are centimetres to the right and up from the view's centre, as in core/garment/drawing.hpp. Every act is some
// steps of the design (core/garment/design.hpp); nothing that was drawn is lost: a stroke that closes nothing stays a
// line, one that leaves the body stays as far as it lay on it.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/desk/build_request.hpp"
#include "core/garment/desk/desk_history.hpp"
#include "core/garment/desk/desk_tool.hpp"
#include "core/garment/desk/face_finder.hpp"
#include "core/garment/desk/live_cloth.hpp"

namespace core {

/// What an open stroke looks like.
struct StrokePreview {
    SpaceLine line;    ///< so far
    bool cut = false;  ///< a cut or hole, drawn dashed
    DeskTool tool = DeskTool::DrawOnPlane;
    /// The temporary or drawing plane in use: its origin, two unit axes.
    struct Plane {
        Vec3 origin, right, up;
    };
    std::optional<Plane> plane;
    SnapTarget start, end;  ///< what its ends would be joined to
};

/// The plane across an axis, 0 x, 1 y, 2 z, at this place of it.
[[nodiscard]] StrokePreview::Plane plane_across(int axis, double at);

/// A row of the layers list.
struct LayerRow {
    int layer = 0;
    std::string name;  ///< empty: not named
    bool shown = true, worked_on = false;
    std::vector<std::string> regions;
    std::string clash;  ///< what fitting left unresolved, one sentence; empty when all is well
};

/// How a part of a stroke was drawn.
struct PartHand {
    DeskTool tool = DeskTool::DrawOnPlane;
    bool placed = false;  ///< in a plane that the designer had put there: no landmark draws its end out of it
};

/// A stroke that the pen is at; the desk's own.
struct OpenStroke {
    DeskTool tool = DeskTool::Select;  // as the pen came down
    SketchStroke parts;
    std::vector<PartHand> hands;  // of each part
    std::unique_ptr<QuadMesh> piece;
    std::unique_ptr<StrokeLifter> lifter;
    bool lifted = false;  // paused
    Pick grabbed;         // what Move, Weld, Smooth, Bump began at
    Vec3 to;              // Move: where it is now
    std::optional<Network> dragged;
    DrawingView view;  // of the first and last sample
    Point first, last;
};

/// A line that stays open from stroke to stroke; the desk's own.
struct LineGoingOn {
    SketchStroke parts;
    std::vector<PartHand> hands;
    std::vector<std::size_t> strokes;  // how many parts there were after each stroke of the pen
    std::string name;                  // of the line; empty before there is one
    std::size_t place = 0;             // of the history before it
    Vec3 from, end;                    // from: the vertex that it began at, where it began at one
};

class GarmentDesk {
  public:
    /// Takes all steps of the design on the form, which is that of design.body. Steps that fail are faults and stay in
    /// the design. `source`: bodies of the user's own by name. ErrorCode::BadMesh when the form is not closed.
    [[nodiscard]] static Result<GarmentDesk> open(Design design, const DressForm& form, FormSource source = {});
    /// The same on the body that another desk's garment wears, which must be that of design.body: at no cost but the
    /// steps', and layers that both have are not made again.
    [[nodiscard]] static GarmentDesk open(Design design, const DesignRunner& on);

    // ---- the pen

    /// Tool and its settings; may be changed in the middle of a stroke.
    [[nodiscard]] DeskSettings& settings() { return settings_; }
    [[nodiscard]] const DeskSettings& settings() const { return settings_; }

    /// The pen comes down; after pause(), the open stroke goes on.
    void begin(const DrawingView& view, Point at);
    void extend(const DrawingView& view, Point at);
    /// The pen lifts, but the stroke stays open: another view or tool may be chosen for what follows.
    void pause();
    DeskReply end();
    void cancel();
    /// A begin and an end at one place.
    DeskReply tap(const DrawingView& view, Point at);
    [[nodiscard]] bool is_open() const { return open_.has_value(); }

    // A line may go on from stroke to stroke, each in its own view and with its own tool (thesis 3.1). What was drawn
    // of it so far is in the design, as one act, all the time.

    /// A tap on an end: the last act's line goes on from there where it is its loose end; from any other vertex a new
    /// line begins. False, and nothing changes, where there is no vertex under the pen.
    bool go_on(const DrawingView& view, Point at);
    [[nodiscard]] bool goes_on() const { return going_.has_value(); }
    /// Where it goes on from, and the line's name, empty before there is one.
    [[nodiscard]] const LineGoingOn* line_going_on() const { return going_ ? &*going_ : nullptr; }
    /// Instead of end() where the pen only tapped: the line gets one more point there. On its own end it is finished;
    /// on another vertex it ends.
    DeskReply end_tapped();
    /// The next stroke is another line. (undo() takes back the last stroke of a line that goes on.)
    void finish_line();

    [[nodiscard]] const StrokePreview& preview() const { return preview_; }

    /// What a tap would meet, for handles and highlights.
    [[nodiscard]] Pick pick(const DrawingView& view, Point at) const;
    /// What the next stroke would start at.
    [[nodiscard]] SnapTarget snap(const DrawingView& view, Point at) const;

    // ---- acts without the pen

    DeskReply set_alpha(const std::string& region, double alpha);
    DeskReply set_material(const std::string& region, const ClothMaterial& material);
    /// Of several regions, as one act.
    DeskReply set_materials(const std::vector<std::pair<std::string, ClothMaterial>>& of_regions);
    DeskReply rename_region(const std::string& region, const std::string& name);
    DeskReply remove_region(const std::string& region);
    DeskReply associate(const std::string& region, PartSet parts);
    DeskReply set_mirror(bool on);
    /// Length of quads along lines, kLeastEdge_cm to kMostEdge_cm; of the whole design.
    DeskReply set_edge(double cm);

    DeskReply new_layer();
    DeskReply work_on(int layer);
    DeskReply move_layer(int layer, int by);  ///< +1: one further out
    DeskReply show_layer(int layer, bool shown);
    DeskReply rename_layer(int layer, const std::string& name);

    DeskReply set_body(const BodyMeasures& measures);
    DeskReply set_own_body(const std::string& file);  ///< the FormSource gives it

    DeskReply place(const PlacedObject& object);
    DeskReply unplace(const std::string& name);

    DeskReply undo();
    DeskReply redo();
    DeskReply go_to(std::size_t place);  ///< after so many acts
    [[nodiscard]] bool can_undo() const { return history_.place() > 0; }
    [[nodiscard]] bool can_redo() const { return history_.place() < history_.acts(); }
    [[nodiscard]] std::vector<HistoryEntry> history() const { return history_.entries(); }
    [[nodiscard]] std::size_t history_place() const { return history_.place(); }

    /// Journal of another desk played here.
    Result<void> replay(const JournalEvent& event);
    /// What happened since the last call.
    [[nodiscard]] std::vector<JournalEvent> take_journal();

    // ---- what there is

    [[nodiscard]] Design design() const;  ///< up to the place in the history
    /// Its steps in order, without a copy of them.
    void each_step(const std::function<void(const DesignStep&)>& use) const;
    [[nodiscard]] const DesignRunner& state() const { return history_.now(); }
    [[nodiscard]] const Network& network() const { return state().network(); }
    /// The lines to draw: while a vertex is dragged, where they would be.
    [[nodiscard]] const Network& shown_network() const;
    [[nodiscard]] int layer() const { return state().layer(); }
    [[nodiscard]] std::vector<LayerRow> layers() const;  ///< inner ones first
    [[nodiscard]] const std::vector<DesignFault>& faults() const { return faults_; }
    /// Ends that keep an outline of the worked layer open, as notes OutlineOpen or OpenMiddle.
    [[nodiscard]] std::vector<DeskNote> open_places() const;

    // ---- cloth

    /// What a worker must make for the shown cloth to be that of the design; nothing when it is, or when this was
    /// asked for already.
    [[nodiscard]] std::optional<BuildRequest> build_request();
    /// The same for a body that is only tried on; follow with set_body to keep it.
    [[nodiscard]] BuildRequest try_body(const BodyMeasures& measures);
    /// Takes a result; false when a newer one was taken already, or it was stopped.
    bool accept(BuildResult result);
    /// Builds here and now.
    void build_now();
    [[nodiscard]] const std::vector<BuiltLayer>& cloth() const { return cloth_; }
    [[nodiscard]] const std::vector<DeskNote>& cloth_faults() const { return cloth_faults_; }
    [[nodiscard]] bool cloth_is_current() const { return cloth_number_ == number_; }
    /// The figure that the shown cloth is worn by.
    [[nodiscard]] std::shared_ptr<const DressForm> form() const { return shown_form_; }

    /// While a vertex is dragged or alpha slides: places for the vertices of cloth()[k].cloth->fitted of this layer.
    struct Live {
        int layer = 0;
        const std::vector<Vec3>* places = nullptr;
    };
    [[nodiscard]] std::optional<Live> live() const;
    /// Shows a piece with another alpha; set_alpha keeps it.
    void slide_alpha(const std::string& region, double alpha);
    /// Ends slide_alpha without keeping it.
    void drop_live();

  private:
    struct WholeRegion;

    GarmentDesk(Design settings, DesignRunner start);
    static GarmentDesk with_steps(Design design, DesignRunner start);

    DeskReply act(const std::vector<DesignStep>& steps, bool closes = false);
    void join_ends(DesignRunner& next, std::vector<DesignStep>& saved) const;
    void meet_lines(DesignRunner& next, std::vector<DesignStep>& saved) const;
    void give_way(DesignRunner& next, std::vector<DesignStep>& saved) const;
    void close_middle(DesignRunner& next, std::vector<DesignStep>& saved) const;
    void close_regions(DesignRunner& next, std::vector<DesignStep>& saved, DeskReply& reply) const;
    void keep_look(DesignRunner& next, std::vector<DesignStep>& saved, const std::string& part,
                   const WholeRegion& whole) const;
    void went();  // to another state

    void begin_part(const DrawingView& view, Point at);
    void add_sample(Point at);
    [[nodiscard]] DrawingTool lifting_tool(const DrawingView& view, Point at) const;
    [[nodiscard]] double plane_through_start(const DrawingView& view, Point at, int axis) const;
    void add_anchor(const DrawingView& view, Point at);
    [[nodiscard]] std::optional<Vec3> joined(const StrokePart& part, Point at, Vec3 end) const;
    void preview_stroke();
    void drag(const DrawingView& view, Point at);
    bool ready_live(int layer);

    DeskReply end_line(OpenStroke stroke);
    DeskReply lengthen(OpenStroke stroke);
    DeskReply draw_anew(LineGoingOn line);
    DeskReply take_back_stroke();
    void resume();
    [[nodiscard]] DesignStep at_landmarks(DesignStep step, const OpenStroke& stroke) const;
    [[nodiscard]] std::optional<LineGoingOn> last_line_from(int vertex) const;
    [[nodiscard]] DeskTool hand() const;
    DeskReply add_between_ends(const DesignStep& line);
    DeskReply fill_at(const DrawingView& view, Point at);
    DeskReply end_cut(OpenStroke stroke, DesignStep::Kind kind);
    DeskReply end_along(const OpenStroke& stroke, DesignStep::Kind kind);
    DeskReply end_weld(const OpenStroke& stroke);
    DeskReply end_move(const OpenStroke& stroke);
    DeskReply end_tap(const OpenStroke& stroke, DeskTool tool);
    DeskReply end_tape(const OpenStroke& stroke);
    [[nodiscard]] TapeReading girth_at(const DrawingView& view, Point at) const;

    Design settings_only_;
    DesignHistory history_;
    DeskSettings settings_;
    std::optional<OpenStroke> open_;
    std::optional<LineGoingOn> going_;
    StrokePreview preview_;
    std::vector<DesignFault> faults_;
    std::vector<JournalEvent> journal_;
    std::uint64_t number_ = 1, asked_ = 0, cloth_number_ = 0;
    std::vector<BuiltLayer> cloth_;
    std::vector<DeskNote> cloth_faults_;
    std::shared_ptr<const DressForm> shown_form_;
    std::optional<LiveCloth> live_;
    int live_layer_ = 0;
    bool live_shown_ = false;
};

}  // namespace core
