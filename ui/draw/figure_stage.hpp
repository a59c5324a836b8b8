#pragma once
// The dressed figure in a picture: body and cloth uploaded once and drawn again for every view.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/cloth.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "ui/draw/fabric.hpp"
#include "ui/draw/figure_camera.hpp"
#include "ui/gl/objects.hpp"

namespace ui {

/// What a piece is made of.
struct FabricLook {
    Fabric fabric = Fabric::Plain;
    Colour colour = palette::kClay;
    std::string picture;  ///< of the user's own; wins over the fabric where it can be read
    friend bool operator==(const FabricLook&, const FabricLook&) = default;
};

/// Three corners a triangle, ten floats a corner: position, normal, place on the fabric, place on the quad.
struct FigureCorners {
    std::vector<float> floats;
    [[nodiscard]] int count() const { return static_cast<int>(floats.size() / 10); }
};

[[nodiscard]] FigureCorners corners_of_body(const core::TriangleMesh& body);

/// Pieces of one look, as one range of corners.
struct ClothRun {
    FabricLook look;
    int first = 0, count = 0;
};
struct ClothCorners {
    FigureCorners corners;
    std::vector<ClothRun> runs;
};
/// `looks`: one for each piece. `places` instead of the mesh's own where they are given. Normals are smooth over the
/// cloth. Without texture coordinates a fabric lies as if seen from the front. Linear.
[[nodiscard]] ClothCorners corners_of_cloth(const core::Cloth& cloth, const std::vector<FabricLook>& looks,
                                            const std::vector<core::Vec3>* places = nullptr);

class FigureStage {
  public:
    [[nodiscard]] static core::Result<FigureStage> create();

    void set_body(const FigureCorners& corners);
    /// Uploads one layer; the others stay.
    void set_layer(std::size_t layer, const ClothCorners& corners);
    void set_layer_count(std::size_t count);
    /// A picture of the user's own for looks that name it; its tile is 10 cm wide.
    void set_own_fabric(const std::string& name, const core::RgbaImage& picture);

    struct Look {
        bool quads = false;
        bool body = true;
        bool shadow = true;
        std::vector<bool> shown;  ///< of the layers; beyond its end: shown
        friend bool operator==(const Look&, const Look&) = default;
    };
    /// Into the target: four samples a pixel, transparent where nothing is. Cost: all triangles.
    void draw(const FigureCamera& camera, const Look& look, Target& target);
    /// The tile of a look, made on the first call.
    [[nodiscard]] const Texture& tile(const FabricLook& look);

    [[nodiscard]] static Target make_target(SizePx size) {
        return Target(size, PixelFormat::Colour, Target::Depth::Multisampled);
    }

  private:
    FigureStage(Program figure, Program soft);
    struct Layer {
        VertexStream stream{{3, 3, 2, 2}, false};
        std::vector<ClothRun> runs;
    };
    void draw_shadows(const FigureCamera& camera, SizePx size);
    Program figure_, soft_;
    VertexStream body_, shadows_;
    int body_count_ = 0;
    std::vector<std::unique_ptr<Layer>> layers_;
    std::map<std::string, Texture> tiles_;
    std::map<std::string, core::RgbaImage> own_;
};

}  // namespace ui
