#pragma once
// A model that may be seen from anywhere, for pictures that move: uploaded once, drawn again for every view.

#include <memory>
#include <span>
#include <vector>

#include "ui/draw/lit_model.hpp"
#include "ui/draw/palette.hpp"

namespace ui {

/// A place where the model stands on the ground: a disc that casts a soft shadow.
struct GroundContact {
    core::Vec3 centre;
    double radius = 0;
};

/// Discs under what lies within 4 % of the lowest point along `up` (unit). Linear in corners.
[[nodiscard]] std::vector<GroundContact> find_ground_contacts(const ModelGeometry& geometry, core::Vec3 up);

/// The camera turned about the up of `base` by `azimuth` and then raised by `elevation`, both in radians.
[[nodiscard]] core::Camera orbited(const core::Camera& base, double azimuth, double elevation);

/// How the model lies in the picture.
struct StageView {
    core::Camera camera;
    double scale_px = 100;          ///< pixels a unit of the normalised frame
    core::Point centre_px;          ///< where its origin appears, y down
    bool mirrored = false;          ///< shown flipped left-right
    core::Vec3 ground_up{0, 1, 0};  ///< normal of the ground its contacts lie on
    bool own_colours = false;       ///< the geometry's colours instead of clay
    friend bool operator==(const StageView& a, const StageView& b) {
        return a.camera.direction == b.camera.direction && a.camera.up == b.camera.up && a.scale_px == b.scale_px &&
               a.centre_px == b.centre_px && a.mirrored == b.mirrored && a.ground_up == b.ground_up &&
               a.own_colours == b.own_colours;
    }

    /// Where a point of the normalised frame appears.
    [[nodiscard]] core::Point to_px(core::Vec3 p) const;
};

class ModelStage {
  public:
    [[nodiscard]] static core::Result<ModelStage> create();

    /// What is drawn from now on. Uploads it.
    void set_model(const ModelGeometry& geometry, std::vector<GroundContact> contacts);
    void clear_model();
    /// Makes the picture of that size, empty: half of what the first draw costs, at another time.
    void make_picture(SizePx size);
    /// Draws a small picture that nobody sees; see ModelPainter::warm_up.
    void warm_up();
    /// The model with its shadow on a transparent ground, four samples a pixel. Cost: the model's triangles, and the
    /// pixels of its box now and before.
    void draw(const StageView& view, SizePx size);
    /// The same with fewer pixels, into a picture of its own: `share` of `size` each way, 0 < share < 1.
    void draw_draft(const StageView& view, SizePx size, double share);
    /// The same as draw, in pieces: after begin, as many calls of draw_piece as it takes until one is true. Until then
    /// texture() is what it was. Cost of a piece: its triangles; of the last one also the pixels.
    void begin(const StageView& view, SizePx size);
    [[nodiscard]] bool draw_piece(int triangles);
    [[nodiscard]] int triangles() const { return model_.triangles(); }
    /// The pixels that the last draw may have changed; without size when the texture is another.
    [[nodiscard]] Rect changed() const { return changed_; }
    /// Of the last draw.
    [[nodiscard]] const Texture& texture() const { return shown().target.texture(); }
    [[nodiscard]] core::RgbaImage read_back() const { return shown().target.read_back(); }

  private:
    struct Canvas {
        Target target{{1, 1}, PixelFormat::Colour, Target::Depth::Multisampled};
        bool fresh = true;  ///< nothing was drawn yet
        Rect drawn;         ///< px: beyond it all is transparent
    };
    explicit ModelStage(LitModel model);
    [[nodiscard]] std::vector<float> shadows(const StageView& view) const;
    [[nodiscard]] Rect box_of(const StageView& view, const std::vector<float>& shadows, SizePx size) const;
    [[nodiscard]] const Canvas& shown() const { return shows_draft_ ? draft_ : whole_; }
    static void fit(Canvas& canvas, SizePx size);
    void begin(Canvas& canvas, const StageView& view);
    bool draw_piece(Canvas& canvas, int triangles);
    LitModel model_;
    Canvas whole_, draft_;
    bool shows_draft_ = false;
    std::vector<GroundContact> contacts_;
    core::Vec3 low_, high_;  // box of the geometry
    bool empty_ = true;
    Rect changed_;
    // the picture that is being drawn
    StageView view_;
    Rect box_, part_;  // px: the model's, and what is drawn anew
    int next_triangle_ = 0;
};

}  // namespace ui
