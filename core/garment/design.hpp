#pragma once
// A garment as the steps it was drawn in: what is saved, and what the same garment is made from again on any body.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/cloth.hpp"
#include "core/garment/drawing.hpp"
#include "core/garment/fitting.hpp"
#include "core/garment/snapping.hpp"
#include "core/mannequin/dress_form.hpp"

namespace core {

struct DesignStep {
    enum class Kind { Line, Region, Cut, Hole, Remove, Corner, Alpha, Move, Weld, Layer, Associate };
    Kind kind = Kind::Line;
    std::string name;                ///< of the line or the region made; of the new half of a cut or hole
    std::string region;              ///< that is cut, removed, changed
    std::vector<std::string> lines;  ///< of a region
    SketchStroke stroke;             ///< of a line, cut or hole
    double alpha = kCoonsAlpha;      ///< Region, Alpha
    Vec3 at, to;                     ///< Corner: at; Move: from at to `to`; Weld: at stays, `to` joins it
    double radius = 0.0;             ///< Move
    bool on = true;                  ///< Corner
    /// Landmarks that the ends of a line or cut are put to, as far from the body as the stroke's end; empty: none.
    std::string starts_at, ends_at;
    PartSet parts = 0;  ///< Region, Associate: what the cloth lies over; Region: 0 finds out
};

struct Design {
    std::string name;
    BodyMeasures body;
    bool mirror = true;  ///< drawn is the half with x >= 0; it is mirrored and joined
    NetworkOptions network;
    FittingOptions fitting;
    std::vector<DesignStep> steps;
};

/// One layer, finished: inner ones first.
struct FinishedLayer {
    Cloth drawn;  ///< as filled, before it was fitted
    Cloth fitted;
    FittingReport report;
};

/// A step that could not be done, and why. Steps and layers are counted from 1.
struct DesignFault {
    int step = 0;
    std::string sentence;
};

struct Garment {
    Network network;  ///< as drawn, of the last layer and all before
    std::vector<FinishedLayer> layers;
    std::vector<DesignFault> faults;
    bool carried = false;  ///< over from the design's own mannequin, where the network lies
};

/// Takes the steps of a design one by one, as the screen does while it is drawn.
class DesignRunner {
  public:
    /// `form`: what is drawn on, closed, in centimetres. ErrorCode::BadMesh when it is not closed.
    [[nodiscard]] static Result<DesignRunner> start(const Design& design, const DressForm& form);
    [[nodiscard]] static Result<DesignRunner> start(const Design& design, const TriangleMesh& body);

    /// Gives the step as it is to be saved: a region with the parts of the body that it was found to lie over. Or the
    /// step's error, with its line or region in the sentence; the garment stays as it was then.
    [[nodiscard]] Result<DesignStep> take(const DesignStep& step);

    /// The step of a line or cut with its ends put to the landmarks they are near to, unless they meet a vertex there:
    /// what the screen makes of a stroke before it takes it. Other steps as they are.
    [[nodiscard]] DesignStep snapped(DesignStep step) const;

    /// The layer drawn so far: filled, mirrored, fitted. Regions that cannot be filled are faults.
    [[nodiscard]] FinishedLayer finish_layer(std::vector<DesignFault>& faults) const;

    [[nodiscard]] const Network& network() const { return network_; }
    [[nodiscard]] const Obstacle& obstacle() const { return obstacle_; }
    [[nodiscard]] int layer() const { return layer_; }
    [[nodiscard]] const std::vector<Landmark>& landmarks() const { return landmarks_; }

    /// Finishes the layer and goes on above it.
    void next_layer(Garment& garment);

  private:
    DesignRunner(const Design& design, Obstacle obstacle, std::vector<Landmark> landmarks);
    [[nodiscard]] Result<SpaceLine> drawn_line(const DesignStep& step) const;
    void put_to_landmark(Vec3& end, const std::string& name, const StrokePart& part) const;
    [[nodiscard]] PartSet parts_under(const NetworkRegion& region) const;

    Design settings_;  // without steps
    Obstacle obstacle_;
    std::vector<Landmark> landmarks_;
    Network network_;
    int layer_ = 0;
};

/// The whole garment on a form. On the design's own mannequin, and on a form without landmarks, it is drawn there. On
/// any other it is drawn on its own mannequin, carried over by the landmarks (core/garment/body_warp.hpp) and fitted
/// again: lines that met there still do. Steps that fail are named and passed over. ErrorCode::BadMesh when the form is
/// not closed, ErrorCode::BadArgument when the design's measures fit no body.
[[nodiscard]] Result<Garment> make_garment(const Design& design, const DressForm& form);

/// The same, drawn on this body whatever it is.
[[nodiscard]] Result<Garment> make_garment(const Design& design, const TriangleMesh& body);

/// The design with what was found while drawing it: the parts of the body that its regions lie over. Steps that fail
/// stay as they are.
[[nodiscard]] Design recorded(const Design& design, const DressForm& form);

}  // namespace core
