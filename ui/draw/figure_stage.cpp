#include "ui/draw/figure_stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ui {
namespace {

constexpr double kNear_cm = 260, kFar_cm = -320;  // towards the viewer from a view's centre: what can be seen
constexpr double kOwnTile_cm = 10;                // of a picture of the user's

void push(std::vector<float>& floats, std::initializer_list<double> values) {
    for (const double v : values) floats.push_back(static_cast<float>(v));
}

std::string tile_key(const FabricLook& look) {
    if (!look.picture.empty()) return "own " + look.picture;
    return std::string(fabric_name(look.fabric)) + hex_of(look.colour);
}

void set_vector(const Program& program, const char* uniform, const core::Vec3& v) {
    program.set(uniform, static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

}  // namespace

FigureCorners corners_of_body(const core::TriangleMesh& body) {
    std::vector<core::Vec3> normals(body.vertices.size());
    for (const auto& t : body.triangles) {
        const core::Vec3 n =
            core::cross(body.vertices[t[1]] - body.vertices[t[0]], body.vertices[t[2]] - body.vertices[t[0]]);
        for (const std::uint32_t v : t) normals[v] = normals[v] + n;
    }
    FigureCorners out;
    out.floats.reserve(body.triangles.size() * 30);
    for (const auto& t : body.triangles) {
        for (const std::uint32_t v : t) {
            const core::Vec3 p = body.vertices[v], n = core::normalised(normals[v]);
            push(out.floats, {p.x, p.y, p.z, n.x, n.y, n.z, 0, 0, 0.5, 0.5});
        }
    }
    return out;
}

ClothCorners corners_of_cloth(const core::Cloth& cloth, const std::vector<FabricLook>& looks,
                              const std::vector<core::Vec3>* places) {
    const std::vector<core::Vec3>& at = places != nullptr ? *places : cloth.mesh.vertices;
    const std::vector<core::Quad>& quads = cloth.mesh.quads;
    std::vector<core::Vec3> normals(at.size());
    for (const core::Quad& q : quads) {
        const core::Vec3 n = core::cross(at[q[2]] - at[q[0]], at[q[3]] - at[q[1]]);
        for (const std::uint32_t v : q) normals[v] = normals[v] + n;
    }
    for (core::Vec3& n : normals) n = core::normalised(n);
    ClothCorners out;
    out.corners.floats.reserve(quads.size() * 60);
    for (std::size_t i = 0; i < cloth.pieces.size(); ++i) {
        const core::ClothPiece& piece = cloth.pieces[i];
        const FabricLook look = i < looks.size() ? looks[i] : FabricLook{};
        const double tile = look.picture.empty() ? fabric_tile_cm(look.fabric) : kOwnTile_cm;
        const int first = out.corners.count();
        for (std::size_t k = piece.first; k < piece.first + piece.count; ++k) {
            const core::Quad& q = quads[k];
            constexpr std::array<std::array<double, 2>, 4> kSides{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
            for (const std::size_t c : {0U, 1U, 2U, 0U, 2U, 3U}) {
                const core::Vec3 p = at[q[c]], n = normals[q[c]];
                const core::Point on = k < cloth.texture.size() ? cloth.texture[k][c] : core::Point{p.x, p.y};
                push(out.corners.floats,
                     {p.x, p.y, p.z, n.x, n.y, n.z, on.x / tile, -on.y / tile, kSides[c][0], kSides[c][1]});
            }
        }
        const int count = out.corners.count() - first;
        if (!out.runs.empty() && out.runs.back().look == look) {
            out.runs.back().count += count;
        } else {
            out.runs.push_back({look, first, count});
        }
    }
    return out;
}

core::Result<FigureStage> FigureStage::create() {
    core::Result<Program> figure = Program::load("figure");
    if (!figure) return core::unexpected(figure.error());
    core::Result<Program> soft = Program::load("soft");
    if (!soft) return core::unexpected(soft.error());
    return FigureStage(std::move(*figure), std::move(*soft));
}

FigureStage::FigureStage(Program figure, Program soft)
    : figure_(std::move(figure)), soft_(std::move(soft)), body_({3, 3, 2, 2}, false), shadows_({4, 4}, true) {}

void FigureStage::set_body(const FigureCorners& corners) {
    body_.fill(corners.floats);
    body_count_ = corners.count();
}

void FigureStage::set_layer_count(std::size_t count) {
    layers_.resize(std::min(count, layers_.size()));
    while (layers_.size() < count) layers_.push_back(std::make_unique<Layer>());
}

void FigureStage::set_layer(std::size_t layer, const ClothCorners& corners) {
    if (layer >= layers_.size()) set_layer_count(layer + 1);
    layers_[layer]->stream.fill(corners.corners.floats);
    layers_[layer]->runs = corners.runs;
}

void FigureStage::set_own_fabric(const std::string& name, const core::RgbaImage& picture) {
    own_[name] = picture;
    tiles_.erase("own " + name);
}

const Texture& FigureStage::tile(const FabricLook& look) {
    const std::string key = tile_key(look);
    const auto found = tiles_.find(key);
    if (found != tiles_.end()) return found->second;
    const auto own = own_.find(look.picture);
    const bool has_own = !look.picture.empty() && own != own_.end();
    const core::RgbaImage picture = has_own ? own->second : weave(look.fabric, look.colour);
    return tiles_.emplace(key, Texture::repeating({picture.width, picture.height}, picture.pixels)).first->second;
}

/// Feet on the floor.
void FigureStage::draw_shadows(const FigureCamera& camera, SizePx size) {
    const double flat = std::max(std::abs(camera.view.toward.y), 0.10);
    if (camera.view.toward.y > 0.9) return;  // from above the figure covers it
    std::vector<float> quads;
    const auto add = [&](core::Vec3 centre, double radius_cm, double strength) {
        const core::Point p = camera.to_px(centre);
        const double r = radius_cm * camera.scale_px;
        push(quads, {p.x - r, p.y - r * flat, 2 * r, 2 * r * flat, palette::kInk.r, palette::kInk.g, palette::kInk.b,
                     strength});
    };
    add({0, 0, 2}, 46, 0.20);
    add({10, 0, 5}, 15, 0.34);
    add({-10, 0, 5}, 15, 0.34);
    soft_.use();
    soft_.set("viewport", static_cast<float>(size.width), static_cast<float>(size.height));
    soft_.set("flip", 1.0F);
    set_blend(Blend::Over);
    shadows_.fill(quads);
    shadows_.draw_quads(static_cast<int>(quads.size()) / 8);
}

void FigureStage::draw(const FigureCamera& camera, const Look& look, Target& target) {
    const SizePx size = target.size();
    for (const auto& layer : layers_) {
        for (const ClothRun& run : layer->runs) (void)tile(run.look);  // uploads bind other things
    }
    target.bind();
    clear(0, 0, 0, 0, true);
    if (look.shadow) draw_shadows(camera, size);
    set_blend(Blend::Off);
    set_depth_test(true);
    figure_.use();
    set_vector(figure_, "centre", camera.view.centre);
    set_vector(figure_, "right", camera.view.right);
    set_vector(figure_, "up", camera.view.up);
    set_vector(figure_, "toward", camera.view.toward);
    const double sx = 2 * camera.scale_px / size.width, sy = -2 * camera.scale_px / size.height;
    figure_.set("fit", static_cast<float>(sx), static_cast<float>(sy),
                static_cast<float>(camera.centre_px.x * 2 / size.width - 1),
                static_cast<float>(camera.centre_px.y * 2 / size.height - 1));
    const double eye = camera.view.eye_distance > 0 ? 1 / camera.view.eye_distance : 0;
    const double near = eye > 0 ? std::min(kNear_cm, 0.9 / eye) : kNear_cm;
    const double at_near = -(1 - near * eye), at_far = 1 - kFar_cm * eye;
    const double b = (at_near - at_far) / (near - kFar_cm);
    figure_.set("depth", static_cast<float>(at_near - b * near), static_cast<float>(b), static_cast<float>(eye));
    figure_.set("tile", 0);
    if (look.body && body_count_ > 0) {
        figure_.set("plain", palette::kClay.r, palette::kClay.g, palette::kClay.b);
        figure_.set("woven", 0.0F);
        figure_.set("lines", 0.0F);
        body_.draw_triangles(body_count_);
    }
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        if (i < look.shown.size() && !look.shown[i]) continue;
        for (const ClothRun& run : layers_[i]->runs) {
            tile(run.look).bind(0);
            figure_.set("woven", 1.0F);
            figure_.set("lines", look.quads ? 0.42F : 0.0F);
            layers_[i]->stream.draw_triangles(run.first, run.count);
        }
    }
    set_depth_test(false);
    target.resolve();
}

}  // namespace ui
