#pragma once
// A garment as the steps it was drawn in: what is saved, and what the same garment is made from again on any body.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/cloth.hpp"
#include "core/garment/drawing.hpp"
#include "core/garment/fitting.hpp"
#include "core/garment/snapping.hpp"
#include "core/mannequin/dress_form.hpp"

namespace core {

/// What a piece is made of, for the eye only.
struct ClothMaterial {
    std::string colour;  ///< "#rrggbb"; empty: the layer's own
    std::string fabric;  ///< what the screen calls it, "linen", or the path of a picture; empty: plain
    friend bool operator==(const ClothMaterial&, const ClothMaterial&) = default;
};

/// A retrieved model that the figure wears or carries: a bag, a hat.
struct PlacedObject {
    std::string name;    ///< no other object of the design has it
    std::string model;   ///< as the collection calls it
    Vec3 at;             ///< of the model's middle, cm
    double scale = 1.0;  ///< cm for one unit of the model
    Vec3 turn;           ///< about x, then y, then z, rad
    friend bool operator==(const PlacedObject&, const PlacedObject&) = default;
};

struct DesignStep {
    enum class Kind {
        Line,
        Region,
        Cut,
        Hole,
        Remove,
        Corner,
        Alpha,
        Move,
        Weld,
        Layer,
        Associate,
        Erase,     ///< a line goes, with the regions it bounds; their other lines stay
        Join,      ///< the loose end at `at` comes to a line that passes it
        Meet,      ///< two lines, or one with itself, get a vertex where they cross, near `at` and `to`
        Smooth,    ///< a stretch of a line loses its small waves
        Bump,      ///< a stretch of a line gets waves: folds
        Rename,    ///< a region, or where `region` is empty a layer
        Material,  ///< of a region
        Mirror,    ///< whether the drawn half is mirrored and joined
        Work,      ///< goes on drawing on a layer made before
        Order,     ///< of the layers, inner ones first
        Show,      ///< a layer is seen or hidden; it is worn all the same
        Body,      ///< what was drawn is carried to another body, and what follows is drawn there
        Place,     ///< an object, or one of the same name elsewhere
        Unplace,
        Edges  ///< how long quads are along lines, about: `radius`
    };
    Kind kind = Kind::Line;
    std::string name;    ///< of the line or the region made; of the new half of a cut or hole; Rename, Unplace
    std::string region;  ///< that is cut, removed, changed; Region: that it takes the place of, or empty
    /// Of a region: names of lines, all pieces of each; "hem/2" is the second piece of its name on the layer. Erase,
    /// Smooth, Bump, Join: one; Meet: two.
    std::vector<std::string> lines;
    SketchStroke stroke;               ///< of a line, cut or hole
    double alpha = kCoonsAlpha;        ///< Region, Alpha
    Vec3 at, to;                       ///< Corner: at; Move: from at to `to`; Weld: at stays, `to` joins it;
                                       ///< Smooth, Bump: ends of the stretch
    double radius = 0.0;               ///< Move; Bump: length of a wave; Edges; cm
    double depth = 0.0;                ///< Bump: how far a wave reaches to either side, cm
    bool on = true;                    ///< Corner, Mirror, Show
    int layer = 0;                     ///< Rename, Work, Show: counted from 0 in the order they were made
    std::vector<int> order;            ///< Order
    ClothMaterial material;            ///< Material
    std::optional<BodyMeasures> body;  ///< Body: a mannequin; none: the user's own body, the file `name`
    PlacedObject object;               ///< Place
    bool with_last = false;            ///< one act of the designer with the step before: undone together
    /// Landmarks that the ends of a line or cut are put to, as far from the body as the stroke's end; empty: none.
    std::string starts_at, ends_at;
    /// Places, of a vertex or on a line, that the pen met in its view: the ends are put there whatever their depth.
    std::optional<Vec3> starts_to, ends_to;
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
    std::vector<ClothFault> faults;  ///< regions that could not be filled
};

/// A layer of a garment, and its cloth.
struct BuiltLayer {
    int layer = 0;  ///< counted from 0 in the order they were made
    std::shared_ptr<const FinishedLayer> cloth;
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

/// What a design says beside its lines and cloth.
struct DesignLook {
    struct Layer {
        std::string name;  ///< may be empty
        bool shown = true;
    };
    bool mirror = true;
    std::vector<Layer> layers{{}};                   ///< in the order they were made
    std::vector<int> order{0};                       ///< inner ones first
    std::map<std::string, ClothMaterial> materials;  ///< by region
    std::vector<PlacedObject> objects;
};

/// Gives the user's own body of this name, stood up; or one sentence why not.
using FormSource = std::function<Result<DressForm>(const std::string& name)>;

class LayerStore;

/// A body to draw on, with its field. Shared, never changed.
struct WornForm {
    DressForm form;
    Obstacle obstacle;
    std::uint64_t key = 0;  ///< tells it from others
};

/// Takes the steps of a design one by one, as the screen does while it is drawn. A copy costs its lines only: bodies
/// and finished layers are shared, and made once for all copies.
class DesignRunner {
  public:
    /// `form`: what is drawn on, closed, in centimetres. ErrorCode::BadMesh when it is not closed. `source` is asked
    /// for by Body steps without measures.
    [[nodiscard]] static Result<DesignRunner> start(const Design& design, const DressForm& form,
                                                    FormSource source = {});
    [[nodiscard]] static Result<DesignRunner> start(const Design& design, const TriangleMesh& body);
    /// On the body that another wears, at no cost; what that one finished is found here and the reverse.
    [[nodiscard]] static DesignRunner start(const Design& design, const DesignRunner& on);

    /// Gives the step as it is to be saved: a region with the parts of the body that it was found to lie over. Or the
    /// step's error, with its line or region in the sentence; the garment stays as it was then. Layer, Work, Order and
    /// Body finish the layers below the one that is drawn on, unless these were finished before.
    [[nodiscard]] Result<DesignStep> take(const DesignStep& step);

    /// The step of a line or cut with its ends put to the landmarks nearer than `reach_cm`, unless they meet a vertex
    /// there: what the screen makes of a stroke before it takes it. Other steps as they are.
    [[nodiscard]] DesignStep snapped(DesignStep step, double reach_cm) const;

    /// The line of a Line, Cut or Hole step: lifted, without the trembling of the hand, its ends at their landmarks.
    [[nodiscard]] Result<SpaceLine> drawn_line(const DesignStep& step) const;

    /// Every layer, inner ones first: filled, mirrored, fitted to what is below it. Those that were finished before and
    /// did not change since cost nothing. Looks at `stop` between layers and gives those done then.
    [[nodiscard]] std::vector<BuiltLayer> finish(const std::stop_token& stop = {}) const;

    [[nodiscard]] const Network& network() const { return network_; }
    /// The body, and the layers below the one that is drawn on.
    [[nodiscard]] const Obstacle& obstacle() const { return *obstacle_; }
    [[nodiscard]] std::shared_ptr<const Obstacle> shared_obstacle() const { return obstacle_; }  ///< the same
    [[nodiscard]] int layer() const { return layer_; }
    [[nodiscard]] const std::vector<Landmark>& landmarks() const { return worn_->form.landmarks; }
    [[nodiscard]] const DesignLook& look() const { return look_; }
    [[nodiscard]] std::shared_ptr<const WornForm> worn() const { return worn_; }
    [[nodiscard]] const Design& settings() const { return settings_; }  ///< without steps

  private:
    struct Below {
        std::shared_ptr<const Obstacle> obstacle;
        std::uint64_t key = 0;
    };
    DesignRunner(const Design& design, std::shared_ptr<const WornForm> worn, FormSource source);
    void put_to_landmark(Vec3& end, const std::string& name, const StrokePart& part) const;
    [[nodiscard]] PartSet parts_under(const NetworkRegion& region) const;
    [[nodiscard]] std::optional<QuadMesh> piece_under(const DesignStep& step) const;
    [[nodiscard]] Result<void> change(Network& next, const DesignStep& step) const;
    [[nodiscard]] Result<void> change_look(const DesignStep& step);
    [[nodiscard]] Result<void> wear(const DesignStep& step);
    void rename(const DesignStep& step);
    void look_below();
    [[nodiscard]] std::shared_ptr<const FinishedLayer> finish_layer(int layer, const Below& below) const;
    [[nodiscard]] Below add_to(const Below& below, int layer, const FinishedLayer& cloth) const;
    [[nodiscard]] std::uint64_t layer_key(int layer, const Below& below) const;

    Design settings_;  // without steps
    std::shared_ptr<const WornForm> worn_;
    FormSource source_;
    std::shared_ptr<LayerStore> store_;
    std::shared_ptr<const Obstacle> obstacle_;
    Network network_;
    DesignLook look_;
    int layer_ = 0;
};

/// The whole garment on a form. On the design's own mannequin, and on a form without landmarks, it is drawn there. On
/// any other it is drawn on its own mannequin (the last one it was drawn on), carried over by the landmarks
/// (core/garment/body_warp.hpp) and fitted again: lines that met there still do. Steps that fail are named and passed
/// over. ErrorCode::BadMesh when the form is not closed, ErrorCode::BadArgument when the design's measures fit no body.
[[nodiscard]] Result<Garment> make_garment(const Design& design, const DressForm& form, const FormSource& source = {});

/// The same, drawn on this body whatever it is.
[[nodiscard]] Result<Garment> make_garment(const Design& design, const TriangleMesh& body);

/// The design with what was found while drawing it: the parts of the body that its regions lie over. Steps that fail
/// stay as they are.
[[nodiscard]] Design recorded(const Design& design, const DressForm& form);

}  // namespace core
