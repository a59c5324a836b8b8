#pragma once
// Strokes of the pen become lines in space: on the body, in a plane, or in the temporary plane (thesis 3.1).
//
// A stroke is a chain of parts; the designer may change the view or the tool in the middle of it, and the samples that
// follow are lifted by the new ones. Lengths in centimetres; views show the body at its size.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/obstacle.hpp"
#include "core/geometry/point.hpp"
#include "core/mesh/quad_mesh.hpp"

namespace core {

/// How a flat drawing stands in space. Points of the drawing are centimetres to the right and up from `centre`.
struct DrawingView {
    Vec3 centre, right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, 1};  ///< toward: to the viewer; unit vectors
    double eye_distance = 0.0;                                  ///< from centre; 0 for parallel views

    struct Ray {
        Vec3 origin, direction;  ///< direction has length 1 and leads away from the viewer
    };
    [[nodiscard]] Ray ray(Point at) const;
    /// Where a place is seen; not finite for one beside or behind the eye.
    [[nodiscard]] Point project(Vec3 place) const;
    /// How far before the view's plane a place lies, toward the viewer.
    [[nodiscard]] double depth(Vec3 place) const { return dot(place - centre, toward); }
};

/// "front", "back", "left" (from the body's left, +x), "right", "top": parallel views about the origin. ErrorCode::
/// BadArgument for another name.
[[nodiscard]] Result<DrawingView> named_view(std::string_view name);

/// The axis that a view looks along most: 0 x, 1 y, 2 z. Planes drawn on in that view lie across it.
[[nodiscard]] int axis_toward(const DrawingView& view);

/// From `eye` to `target`, y up as far as possible. The two must not coincide: ErrorCode::BadArgument.
[[nodiscard]] Result<DrawingView> perspective_view(Vec3 eye, Vec3 target);

struct DrawingTool {
    enum class Kind {
        Body,  ///< on the surface below the pen, `offset` outside of it; beside the body, where the ray passes nearest
        PlaneXY,    ///< z = offset
        PlaneXZ,    ///< y = offset
        PlaneYZ,    ///< x = offset
        Temporary,  ///< the drawing turned about the view's right axis through the last point, into the view: up is
                    ///< away; the plane lies `offset` above that point, as the view sees it
        Piece       ///< Cut, Hole: on the piece as it is filled; what passes beside it is left out
    };
    Kind kind = Kind::Body;
    double offset = 0.0;
};

struct StrokePart {
    DrawingView view;
    DrawingTool tool;
    std::vector<Point> points;
};

using SketchStroke = std::vector<StrokePart>;

/// Lifts a stroke sample by sample, as lift_stroke does.
class StrokeLifter {
  public:
    /// `piece`: what the tool Piece draws on; null where no part of the stroke has it. Both must outlive the lifter.
    explicit StrokeLifter(const Obstacle& body, const QuadMesh* piece = nullptr) : body_(body), piece_(piece) {}

    /// A part begins; samples that follow belong to it.
    void begin_part(const DrawingView& view, DrawingTool tool);
    /// One more sample of the part. Nothing changes when it cannot be lifted, see lift_stroke.
    [[nodiscard]] Result<void> add(Point at);

    [[nodiscard]] const std::vector<Vec3>& line() const { return line_; }
    /// Where the temporary plane hangs: the last point before it.
    [[nodiscard]] std::optional<Vec3> anchor() const;

  private:
    struct Anchor {
        Vec3 place;
        Point drawn;
    };
    [[nodiscard]] Result<std::optional<Vec3>> lift(Point at) const;

    const Obstacle& body_;
    const QuadMesh* piece_;
    DrawingView view_;
    DrawingTool tool_;
    bool part_is_new_ = false;
    std::size_t number_ = 0;
    std::optional<Anchor> anchor_;
    std::vector<Vec3> line_;
};

/// How far beside the body a ray may pass for the body tool.
inline constexpr double kBodyToolReach_cm = 25.0;

/// The stroke as a line in space. Points closer than 0.01 cm to the one before are left out. ErrorCode::BadArgument
/// with the number of the point for one that is not finite, passes too far from the body, or lies in a plane seen
/// edge-on, and for a stroke that begins with the temporary plane or has fewer than two different points.
[[nodiscard]] Result<std::vector<Vec3>> lift_stroke(const SketchStroke& stroke, const Obstacle& body,
                                                    const QuadMesh* piece = nullptr);

/// The stroke beyond the plane x = 0: drawn in the mirrored view.
[[nodiscard]] StrokePart mirrored_part(StrokePart part);

/// Where a ray first meets a mesh.
[[nodiscard]] std::optional<Vec3> first_on_mesh(const QuadMesh& mesh, const DrawingView::Ray& ray);

}  // namespace core
