#pragma once
// The pictures of the dressed figure: the large one on the sheet and the four small ones on the board, each drawn again
// only when what it shows has changed, and the cameras of all.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/garment/desk/build_request.hpp"
#include "ui/draw/depth_map.hpp"
#include "ui/draw/figure_stage.hpp"
#include "ui/draw/painter.hpp"
#include "ui/screens/garment_screen.hpp"

namespace app {

/// What of the design a picture needs beside the cloth.
struct FigureDress {
    struct Layer {
        int layer = 0;
        bool shown = true;
        std::shared_ptr<const core::FinishedLayer> cloth;
        std::shared_ptr<const core::Cloth> textured;  ///< null: patterns lie as seen from the front
        std::vector<ui::FabricLook> looks;            ///< of its pieces
    };
    std::shared_ptr<const core::DressForm> form;
    std::vector<Layer> layers;
    bool body_shown = true;
};

class FigureViews {
  public:
    [[nodiscard]] static core::Result<FigureViews> create();

    void lay_out(const ui::GarmentLayout& layout, ui::Painter& painter);
    void set_dress(FigureDress dress);
    /// Other places for the vertices of a layer, while it moves; null: all are as they were made again.
    void set_places(int layer, const std::vector<core::Vec3>* places);
    /// The same for several layers; those that are not among them are as they were made.
    void set_places(std::map<int, std::vector<core::Vec3>> places);
    /// Those of a layer that moves; null for the others.
    [[nodiscard]] const std::vector<core::Vec3>* places_of(int layer) const;
    /// What the figure wears beside cloth, in place; null: not found.
    void set_objects(std::vector<std::shared_ptr<const core::TriangleMesh>> objects);
    void set_quads(bool quads);
    /// While something moves and pictures take long: a quarter of the pixels. The picture is drawn whole when it ends.
    void set_moving(bool moving);
    /// The large picture, as it was drawn last.
    [[nodiscard]] const ui::Texture& figure_texture() const {
        return drawn_draft_ ? draft_.texture() : large_.texture();
    }
    void set_own_fabric(const std::string& name, const core::RgbaImage& picture);

    void show(ui::GarmentView view);
    [[nodiscard]] ui::GarmentView view() const { return view_; }
    /// What each tile shows.
    [[nodiscard]] const std::array<ui::GarmentView, ui::kGarmentTiles>& tiles() const { return tiles_; }
    /// Of the large picture, in pixels of the screen.
    [[nodiscard]] const ui::FigureCamera& camera() const { return camera_; }

    /// Of a small picture, in pixels of the screen.
    [[nodiscard]] ui::FigureCamera tile_camera(std::size_t tile) const;

    /// Turns the 3D view; the others have their place.
    void turn(double azimuth_rad, double elevation_rad);
    void move_by(core::Point px);
    /// `doublings` about a place of the screen; 1 to 8 times the framed size. Back at 1 the figure is framed again.
    void zoom(double doublings, core::Point about_px);
    void reset_cameras();

    /// Whether the figure, its cloth included, is within `reach_px` of a place of the screen.
    [[nodiscard]] bool near_figure(core::Point px, double reach_px);
    /// Whether a place lies behind what is seen there.
    [[nodiscard]] bool hides(core::Vec3 place);

    /// Before a frame: the large picture if it changed, else one small one that did. Gives whether something was drawn.
    bool draw();
    /// All that is due, for pictures that are looked at.
    void draw_all();
    [[nodiscard]] bool due() const;
    /// Grows with every picture drawn.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    /// Grows when camera or surfaces change: what is projected or hidden may differ.
    [[nodiscard]] std::uint64_t geometry() const { return geometry_; }
    [[nodiscard]] const ui::Texture& fabric_tile(const ui::FabricLook& look) { return stage_.tile(look); }
    /// From the front, 3 wide to 4 high, on paper: for a card.
    [[nodiscard]] core::RgbaImage thumbnail();
    [[nodiscard]] double height_cm() const { return height_cm_; }

    static constexpr ui::PictureId kFigure{1};
    [[nodiscard]] static ui::PictureId tile_picture(std::size_t tile) {
        return ui::PictureId{2 + static_cast<int>(tile)};
    }

  private:
    explicit FigureViews(ui::FigureStage stage);
    struct Place {  // of one of the large views
        double zoom = 1;
        core::Point moved_px;
    };
    void upload();
    void upload_layer(std::size_t layer);
    void upload_object(std::size_t object);
    [[nodiscard]] const std::vector<core::Vec3>& vertices_of(const FigureDress::Layer& layer) const;
    void surfaces_changed();
    void aim();
    [[nodiscard]] core::DrawingView view_of(ui::GarmentView view) const;
    [[nodiscard]] ui::FigureStage::Look look(bool quads) const;
    void draw_large();
    void draw_tile(std::size_t tile);
    void fill_depth();

    ui::FigureStage stage_;
    ui::Target large_, draft_;
    std::vector<ui::Target> small_;
    ui::GarmentLayout layout_;
    FigureDress dress_;
    std::vector<std::shared_ptr<const core::TriangleMesh>> objects_;
    std::shared_ptr<const core::DressForm> uploaded_form_;
    std::map<int, std::vector<core::Vec3>> live_;  // of layers that move
    double height_cm_ = 170;
    bool quads_ = false, moving_ = false, drawn_draft_ = false;
    int slow_pictures_ = 0;

    ui::GarmentView view_ = ui::GarmentView::Front;
    std::array<ui::GarmentView, ui::kGarmentTiles> tiles_{ui::GarmentView::Front, ui::GarmentView::Side,
                                                          ui::GarmentView::Back, ui::GarmentView::Solid};
    std::array<Place, 6> places_;
    double azimuth_ = 0.5, elevation_ = 0.1;
    ui::FigureCamera camera_;
    ui::DepthMap depth_;
    bool depth_fresh_ = false;
    bool large_due_ = true;
    std::array<bool, ui::kGarmentTiles> tile_due_{true, true, true, true};
    std::uint64_t revision_ = 0, geometry_ = 0;
};

}  // namespace app
