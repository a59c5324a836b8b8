#pragma once
// What the hand holds at the garment desk, and how it is set.

#include <optional>
#include <string>
#include <vector>

#include "core/garment/drawing.hpp"
#include "core/garment/snapping.hpp"

namespace core {

enum class DeskTool {
    Select,         ///< picks a vertex, a line, a region
    DrawOnPlane,    ///< in the plane that the view looks at: x = , y = or z = constant
    DrawOnBody,     ///< on the body or the cloth below, DeskSettings::offset_cm outside of it
    DrawTemporary,  ///< in the plane through the last point, along the view (thesis 3.1, figure 3.3)
    Add,   ///< on the body, from the edge of a piece to its edge: the piece between the two; a tap fills an outline
    Cut,   ///< across a piece
    Hole,  ///< a closed line inside a piece
    RemoveRegion,  ///< the piece under the pen, and lines that no other has
    Corner,        ///< on and off, by a tap at a piece's edge
    Move,          ///< a vertex with its neighbours
    Smooth,        ///< along a line
    Bump,          ///< along a line: folds
    Erase,         ///< the line under the pen, or else the piece
    Tape,          ///< a tap: girth at this height; a stroke: length along it
    Weld           ///< from one vertex to another
};

/// Whether the tool draws a new line.
[[nodiscard]] constexpr bool draws_line(DeskTool tool) {
    return tool == DeskTool::DrawOnPlane || tool == DeskTool::DrawOnBody || tool == DeskTool::DrawTemporary ||
           tool == DeskTool::Add;
}

/// Whether a line that such a tool draws may go on with another of them.
[[nodiscard]] constexpr bool goes_on_with(DeskTool tool) {
    return draws_line(tool) && tool != DeskTool::Add;
}

struct DeskSettings {
    DeskTool tool = DeskTool::DrawOnPlane;
    double offset_cm = 1.0;  ///< from the body
    /// Where the plane lies along its axis; none: through the vertex or line that the stroke starts at, else at 0.
    std::optional<double> plane_cm;
    double temporary_cm = 0.0;     ///< of the temporary plane from its point, upwards in the view
    double reach_cm = 1.5;         ///< how far from the pen a vertex or line is met, in the view
    double move_radius_cm = 12.0;  ///< Move: how far its neighbours follow
    double wave_cm = 8.0;          ///< Bump: length of a wave
    double wave_depth_cm = 1.5;    ///< Bump: to either side
    bool to_landmarks = true;      ///< ends of lines are put to landmarks that they are near
    bool joins_in_view = true;     ///< ends that the pen draws onto a vertex or line meet it, whatever their depth
    bool cuts_on_body = false;     ///< Cut, Hole: drawn offset_cm from the body; else on the piece itself
    bool closes_middle = true;     ///< with mirror: an outline that is open in the middle alone gets its line there
    bool closes_regions = true;    ///< outlines become pieces by themselves
    double alpha = kCoonsAlpha;    ///< of new pieces
};

/// Something to tell the designer, at its place. The screen has the words for each key; the sentence is the engine's,
/// in English, for logs and tests.
struct DeskNote {
    enum class Key {
        OutlineOpen,  ///< at an end; gap_cm
        OpenMiddle,   ///< at an end on the middle plane
        OffBody,      ///< the line left the body, or passes it
        NoPoint,      ///< the temporary plane has no point to hang on
        PlaneEdgeOn,
        TooShort,
        NoRegion,  ///< there is no piece to cut
        NotAcross,
        NotFilled,    ///< `name`: the piece
        LayersTouch,  ///< `name`: the layer's number
        NothingHere,
        BodyUnfit,
        Refused  ///< what has no word of its own
    };
    Key key = Key::Refused;
    std::string sentence;
    Vec3 place;
    std::string name;     ///< of the line or piece, or empty
    double gap_cm = 0.0;  ///< OutlineOpen: to the nearest line that the end could join; 0 where there is none
};

/// A piece of a line by its name: "hem", or "hem/2" where the name has several pieces.
struct Pick {
    enum class Kind { None, Vertex, Line, Region };
    Kind kind = Kind::None;
    int index = -1;    ///< of the vertex, line or region in the network
    std::string name;  ///< of the line (as above) or region
    Vec3 place;        ///< on it
    int layer = 0;
};

struct TapeReading {
    double cm = 0.0;
    bool girth = false;  ///< or a length
    SpaceLine tape;      ///< to draw; closed for a girth
};

/// What a pen call or an action did.
struct DeskReply {
    bool changed = false;  ///< the design has new steps, or went back or on
    std::vector<DeskNote> notes;
    std::optional<TapeReading> tape;
    Pick pick;  ///< Select
};

}  // namespace core
