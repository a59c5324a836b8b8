#include "ui/draw/lit_model.hpp"

#include <array>
#include <utility>

#include "ui/draw/palette.hpp"

namespace ui {
namespace {

constexpr int kCornerNumbers = 9, kQuadNumbers = 8;

void set_vector(const Program& program, const char* uniform, const core::Vec3& v) {
    program.set(uniform, static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

}  // namespace

core::Result<LitModel> LitModel::create() {
    core::Result<Program> model = Program::load("model");
    if (!model) return core::unexpected(model.error());
    core::Result<Program> soft = Program::load("soft");
    if (!soft) return core::unexpected(soft.error());
    return LitModel(std::move(*model), std::move(*soft));
}

LitModel::LitModel(Program model, Program soft)
    : model_program_(std::move(model)),
      soft_program_(std::move(soft)),
      corners_({3, 3, 3}, false),
      shadows_({4, 4}, true),
      no_parts_({1, 1}, PixelFormat::Colour) {
    const std::array<std::uint8_t, 4> nothing{};
    no_parts_.upload(0, 0, {1, 1}, nothing);
}

void LitModel::set_corners(const std::vector<float>& corners) {
    corners_.fill(corners);
    corner_count_ = static_cast<int>(corners.size()) / kCornerNumbers;
}

void LitModel::draw_shadows(const std::vector<float>& quads, SizePx size) {
    if (quads.empty()) return;
    soft_program_.use();
    soft_program_.set("viewport", static_cast<float>(size.width), static_cast<float>(size.height));
    soft_program_.set("flip", 1.0F);
    set_blend(Blend::Over);
    shadows_.fill(quads);
    shadows_.draw_quads(static_cast<int>(quads.size()) / kQuadNumbers);
}

void LitModel::draw(const ModelLook& look, int first, int count) {
    if (count <= 0) return;
    set_blend(Blend::Off);
    set_depth_test(true);
    (look.parts != nullptr ? *look.parts : no_parts_).bind(0);
    model_program_.use();
    model_program_.set("parts", 0);
    set_vector(model_program_, "right", look.camera.right());
    set_vector(model_program_, "up", look.camera.up);
    set_vector(model_program_, "toward", look.camera.direction);
    model_program_.set("fit", static_cast<float>(look.sx), static_cast<float>(look.sy), static_cast<float>(look.ox),
                       static_cast<float>(look.oy));
    model_program_.set("mirror", look.mirrored ? -1.0F : 1.0F);
    model_program_.set("clay", palette::kClay.r, palette::kClay.g, palette::kClay.b);
    model_program_.set("part_share", look.part_share);
    model_program_.set("own_share", look.own_colours ? 1.0F : 0.0F);
    corners_.draw_triangles(3 * first, 3 * count);
    set_depth_test(false);
}

}  // namespace ui
