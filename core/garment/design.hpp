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
#include "core/mannequin/body_measures.hpp"

namespace core {

struct DesignStep {
    enum class Kind { Line, Region, Cut, Hole, Remove, Corner, Alpha, Move, Weld, Layer };
    Kind kind = Kind::Line;
    std::string name;                ///< of the line or the region made; of the new half of a cut or hole
    std::string region;              ///< that is cut, removed, changed
    std::vector<std::string> lines;  ///< of a region
    SketchStroke stroke;             ///< of a line, cut or hole
    double alpha = kCoonsAlpha;      ///< Region, Alpha
    Vec3 at, to;                     ///< Corner: at; Move: from at to `to`; Weld: at stays, `to` joins it
    double radius = 0.0;             ///< Move
    bool on = true;                  ///< Corner
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
    Network network;  ///< of the last layer and all before
    std::vector<FinishedLayer> layers;
    std::vector<DesignFault> faults;
};

/// Takes the steps of a design one by one, as the screen does while it is drawn.
class DesignRunner {
  public:
    /// `body`: what is dressed, closed, in centimetres. ErrorCode::BadMesh when it is not closed.
    [[nodiscard]] static Result<DesignRunner> start(const Design& design, const TriangleMesh& body);

    /// The step's error, with its line or region in the sentence; the garment stays as it was.
    [[nodiscard]] Result<void> take(const DesignStep& step);

    /// The layer drawn so far: filled, mirrored, fitted. Regions that cannot be filled are faults.
    [[nodiscard]] FinishedLayer finish_layer(std::vector<DesignFault>& faults) const;

    [[nodiscard]] const Network& network() const { return network_; }
    [[nodiscard]] const Obstacle& obstacle() const { return obstacle_; }
    [[nodiscard]] int layer() const { return layer_; }

    /// Finishes the layer and goes on above it.
    void next_layer(Garment& garment);

  private:
    DesignRunner(const Design& design, Obstacle obstacle);
    Design settings_;  // without steps
    Obstacle obstacle_;
    Network network_;
    int layer_ = 0;
};

/// The whole garment. Steps that fail are named and passed over. ErrorCode::BadMesh when the body is not closed.
[[nodiscard]] Result<Garment> make_garment(const Design& design, const TriangleMesh& body);

}  // namespace core
