#pragma once
// The Garment screen: board with tools, views, layers and folds; sheet with the figure and what is drawn on it. State
// in, draw list and intents out.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/draw/draw_list.hpp"
#include "ui/screens/find_screen.hpp"
#include "ui/screens/garment_layout.hpp"
#include "ui/screens/number_pad.hpp"
#include "ui/screens/sheet_line.hpp"
#include "ui/screens/strings.hpp"

namespace ui {

/// What the pen does on the sheet. The first eight stand on the first page of the grid, in this order.
enum class GarmentTool {
    OnPlane,
    OnBody,
    TemporaryPlane,
    Corner,
    Cut,
    Add,
    Mirror,  ///< a switch of the design rather than of the pen
    Eraser,
    Move,
    Smooth,
    Bump,
    Weld,
    Hole,
    Remove,
    Measure
};

/// The first four have tiles; a tap on the tile that is large already turns it to its other side.
enum class GarmentView { Front, Side, Back, Solid, OtherSide, Top };
[[nodiscard]] std::size_t tile_of(GarmentView view);
/// "view_front", …
[[nodiscard]] const char* view_key(GarmentView view);

enum class GarmentAction {
    Tool,  ///< index: GarmentTool
    Page,
    View,  ///< index: tile
    Less,
    More,
    Number,  ///< of the stepper: dragged it changes, a tap lets a plane go
    ShowLayers,
    ShowHistory,
    Row,  ///< index: in the list, from the top
    Eye,
    Swatch,
    RowUp,
    RowDown,
    Unplace,  ///< index: row of an object
    AddLayer,
    Folds,
    Body,
    Export,
    Layers,  ///< upright: opens the drawer
    New,
    UndoNew,
    Designs,
    Fabrics,
    Quads,
    Drape,  ///< a switch: the garment hangs
    CloseDrawer,
    Size,         ///< index: of the sizes
    Measure,      ///< index: slider of the body drawer
    TypeMeasure,  ///< index: the same, to write its number
    PadKey,       ///< index: of the number pad
    PadCancel,
    PadDone,
    ResetBody,
    OwnBody,   ///< opens the list of own bodies
    BodyFile,  ///< index: its row there
    BodyUp,    ///< to the folder above
    BodyEarlier,
    BodyLater,
    Done,
    Fabric,    ///< index: in the list of fabrics
    Colour,    ///< index: of the swatches
    ExportAs,  ///< index: of the kinds of export
    NoteWay,   ///< the way on that a note offers
};
/// What Intent::item holds for Control::Garment.
[[nodiscard]] std::size_t garment_item(GarmentAction action, std::size_t index = 0);
struct GarmentIntent {
    GarmentAction action = GarmentAction::Tool;
    std::size_t index = 0;
};
[[nodiscard]] GarmentIntent garment_intent(std::size_t item);

struct LayerRow {
    std::string name;
    Colour swatch;
    bool shown = true, selected = false, clashing = false;
    bool body = false;    ///< the last one: neither moved nor removed
    bool object = false;  ///< worn or carried: chosen by its row, taken off by its cross
    bool can_up = false, can_down = false;
    friend bool operator==(const LayerRow&, const LayerRow&) = default;
};

struct HistoryRow {
    std::string name;
    bool undone = false;   ///< comes back with Redo
    bool current = false;  ///< the last one that counts
    friend bool operator==(const HistoryRow&, const HistoryRow&) = default;
};

enum class GarmentDrawer { None, Body, OwnBody, Fabric, Layers, Export };

/// One measure of the drawer.
struct MeasureSlider {
    std::string key;  ///< of its name
    double cm = 0, least = 0, most = 1;
    friend bool operator==(const MeasureSlider&, const MeasureSlider&) = default;
};

struct BodyDrawer {
    std::vector<std::string> sizes;   ///< as written on the switch
    std::optional<std::size_t> size;  ///< none: own measures or an own body
    std::size_t last_size = 0;        ///< what Reset goes back to
    std::array<MeasureSlider, kBodySliders> measures;
    std::optional<std::size_t> held;  ///< slider
    bool own_bodies = false;          ///< there is a folder of them
    bool own_body = false;            ///< of a file: sliders are off
    std::string problem;              ///< a sentence: these measures fit no body
    /// The number pad is open, for this slider's measure.
    std::optional<std::size_t> typed;
    NumberEdit number;
    bool number_wrong = false;  ///< beyond what the measure may be
    friend bool operator==(const BodyDrawer&, const BodyDrawer&) = default;
};

/// Files to choose a body from, in a folder.
struct BodyFiles {
    static constexpr std::size_t kRows = 6;
    struct Row {
        std::string name;
        bool folder = false;
        friend bool operator==(const Row&, const Row&) = default;
    };
    std::string title;      ///< the folder
    bool up = false;        ///< there is one above
    std::vector<Row> rows;  ///< kRows at the most, of all of them from `first` on
    std::size_t first = 0, all = 0;
    bool reading = false;  ///< one was chosen and is on its way
    std::string problem;   ///< why one could not be taken
    friend bool operator==(const BodyFiles&, const BodyFiles&) = default;
};

/// A fabric in the drawer: its picture is one tile of the cloth.
struct FabricTile {
    std::string name;
    PictureId picture{};
    bool chosen = false;
    friend bool operator==(const FabricTile&, const FabricTile&) = default;
};

/// What the stepper below the tools sets: how far off the body lines lie; where the plane of the view lies from the
/// middle of the body, to the front, to its left, or from the floor; how far above its point the temporary plane is;
/// how long quads are.
enum class StepperOf { Offset, Depth, Across, Height, AbovePoint, Quads };

[[nodiscard]] constexpr bool is_plane(StepperOf what) {
    return what == StepperOf::Depth || what == StepperOf::Across || what == StepperOf::Height;
}

struct Stepper {
    StepperOf of = StepperOf::Offset;
    std::optional<double> cm;  ///< none: the plane passes through what a stroke starts at
    bool less = true, more = true;
    bool held = false;
    friend bool operator==(const Stepper&, const Stepper&) = default;
};

/// The plane that is drawn in, as a small view shows it.
struct PlaneTrace {
    std::size_t tile = 0;
    core::Polyline px;
    friend bool operator==(const PlaneTrace&, const PlaneTrace&) = default;
};

/// Words at a place of the sheet: what keeps an outline open, what the tape reads.
struct PlacedNote {
    std::string words;
    core::Point at_px;
    bool warning = true;
    friend bool operator==(const PlacedNote&, const PlacedNote&) = default;
};

/// What the chosen object is moved, scaled and turned by, on the screen.
struct ObjectHandles {
    Rect box;                 ///< within it a drag moves
    core::Point scale, turn;  ///< at two of its corners
    bool scaling = false, turning = false;
    friend bool operator==(const ObjectHandles&, const ObjectHandles&) = default;
};

/// The five swatches of layers, then further ones for pieces.
inline constexpr std::array<std::uint32_t, 10> kSwatches{0xE2C690, 0xB4BFC9, 0xC9B1A8, 0xB7C2A4, 0xCFC6DA,
                                                         0xF1ECE0, 0x5B6F8C, 0x8C4A43, 0x55624C, 0x3B3733};

/// Everything that Garment shows, as values.
struct GarmentState {
    std::size_t language = 0;
    GarmentTool tool = GarmentTool::OnBody;
    std::size_t page = 0;
    GarmentView view = GarmentView::Front;
    std::array<GarmentView, kGarmentTiles> tiles{GarmentView::Front, GarmentView::Side, GarmentView::Back,
                                                 GarmentView::Solid};
    std::array<PictureId, kGarmentTiles> tile_pictures{};
    double offset_cm = 1.2;  ///< of lines on the body
    Stepper stepper;
    std::vector<PlaneTrace> plane_traces;
    bool can_undo = false, can_redo = false, empty = true, cleared = false;
    bool mirror = true, quads = true;
    bool designs_kept = false;  ///< there is a gallery
    bool line_open = false;     ///< the pen is down
    bool can_hang = false;      ///< there is cloth
    bool hanging = false;       ///< under gravity, not as drawn
    bool line_goes_on = false;  ///< the next stroke goes on with the last line

    std::vector<LayerRow> rows;
    std::vector<HistoryRow> history;
    bool history_shown = false;
    double scroll_px = 0;    ///< of the list
    std::string folds_name;  ///< of the piece the slider changes; empty: all of the layer
    double folds = 0;        ///< 0 flat … 1 deepest
    bool folds_on = false, folds_held = false;

    GarmentDrawer drawer = GarmentDrawer::None;
    BodyDrawer body;
    BodyFiles body_files;
    std::vector<FabricTile> fabrics;
    std::string fabric_problem;  ///< which of the own pictures could not be read
    std::size_t colour = 0;
    std::string export_message;  ///< under the buttons of the drawer
    bool export_busy = false;
    double export_share = 0;

    std::string problem;       ///< under the view's name: why the last stroke was not taken, and how to go on
    bool problem_way = false;  ///< a button "All measures" or the like is offered with it
    std::vector<PlacedNote> notes;

    PictureId figure{};
    std::uint64_t figure_revision = 0;  ///< another number when a picture changed
    std::vector<SheetWash> washes;
    std::vector<SheetLine> lines;
    std::vector<core::Point> handles_px, open_ends_px;
    std::optional<std::size_t> held_handle;
    std::optional<ObjectHandles> object;
    std::vector<core::Point> plane_px;  ///< corners of the temporary plane
    std::optional<std::array<core::Point, 2>> axis_px;
    std::optional<core::Point> pen_px;     ///< where a pen hovers that lies on a tablet
    std::optional<core::Point> eraser_px;  ///< the ring, while erasing
    std::vector<core::Point> brush_px;     ///< reach of the brush in use

    std::optional<Control> pressed;
    std::size_t pressed_item = 0;
    friend bool operator==(const GarmentState&, const GarmentState&) = default;
};

class GarmentScreen {
  public:
    /// Both must outlive the screen.
    GarmentScreen(const FontSet& fonts, const std::vector<Strings>& languages)
        : fonts_(&fonts), languages_(&languages) {}

    [[nodiscard]] DrawList draw(const GarmentState& state, const GarmentLayout& layout) const;
    /// What can be touched in this state. Sliders are targets too: whoever holds one reads slider_share.
    [[nodiscard]] std::vector<BoardTouch::Target> targets(const GarmentState& state, const GarmentLayout& layout) const;
    /// How far the list can be scrolled.
    [[nodiscard]] static double most_scroll_px(const GarmentState& state, const GarmentLayout& layout);

  private:
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

/// Where along its line a slider is held, 0 … 1.
[[nodiscard]] double slider_share(const Rect& slider, double x, double scale);
/// Tools of a page, in the order of its slots.
[[nodiscard]] std::array<std::optional<GarmentIntent>, kGarmentSlots> tools_of_page(std::size_t page);
/// The switch Find / Garment of both screens.
void draw_mode_switch(DrawList& list, const FontSet& fonts, const Rect& rect, const Strings& words, bool garment,
                      std::optional<std::size_t> pressed, double size_px);
[[nodiscard]] std::vector<BoardTouch::Target> mode_targets(const Rect& rect);

}  // namespace ui
