#include "ui/draw/painter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {
namespace {

constexpr int kAtlasPx = 2048;

void push(std::vector<float>& floats, std::initializer_list<double> values) {
    for (const double v : values) floats.push_back(static_cast<float>(v));
}
void push(std::vector<float>& floats, Colour c) {
    floats.insert(floats.end(), {c.r, c.g, c.b, c.a});
}

}  // namespace

core::Result<Painter> Painter::create(const FontSet& fonts) {
    core::Result<Program> box = Program::load("box");
    if (!box) return core::unexpected(box.error());
    core::Result<Program> glyph = Program::load("glyph");
    if (!glyph) return core::unexpected(glyph.error());
    core::Result<Program> picture = Program::load("picture");
    if (!picture) return core::unexpected(picture.error());
    core::Result<Program> ink = Program::load("ink");
    if (!ink) return core::unexpected(ink.error());
    return Painter(fonts, std::move(*box), std::move(*glyph), std::move(*picture), std::move(*ink));
}

Painter::Painter(const FontSet& fonts, Program box, Program glyph, Program picture, Program ink)
    : fonts_(&fonts),
      box_program_(std::move(box)),
      glyph_program_(std::move(glyph)),
      picture_program_(std::move(picture)),
      ink_program_(std::move(ink)),
      boxes_({4, 3, 4, 4}, true),
      glyphs_({4, 4, 4}, true),
      picture_({4, 4}, true),
      ink_({4, 2}, true),
      atlas_({kAtlasPx, kAtlasPx}, PixelFormat::Coverage) {}

void Painter::set_picture(PictureId id, const Texture* texture) {
    if (texture == nullptr) {
        pictures_.erase(id);
    } else {
        pictures_[id] = texture;
    }
}

void Painter::paint(const DrawList& list, SizePx viewport, bool flip) {
    viewport_ = viewport;
    flip_ = flip ? -1.0F : 1.0F;
    set_depth_test(false);
    for (const DrawCommand& command : list.commands) {
        std::visit([this](const auto& c) { draw(c); }, command);
    }
    flush();
}

void Painter::start(Batch batch) {
    if (batch_ == batch) return;
    flush();
    batch_ = batch;
}

void Painter::use(const Program& program) const {
    program.use();
    program.set("viewport", static_cast<float>(viewport_.width), static_cast<float>(viewport_.height));
    program.set("flip", flip_);
}

void Painter::flush() {
    if (!floats_.empty()) {
        const bool boxes = batch_ == Batch::Boxes;
        use(boxes ? box_program_ : glyph_program_);
        set_blend(Blend::Over);
        if (!boxes) {
            atlas_.bind(0);
            glyph_program_.set("atlas", 0);
        }
        VertexStream& stream = boxes ? boxes_ : glyphs_;
        stream.fill(floats_);
        stream.draw_quads(static_cast<int>(floats_.size() / (boxes ? 15 : 12)));
    }
    floats_.clear();
    batch_ = Batch::None;
}

void Painter::limit_to(const Rect& rect) const {
    const int left = static_cast<int>(std::lround(std::clamp(rect.x, 0.0, viewport_.width + 0.0)));
    const int right = static_cast<int>(std::lround(std::clamp(rect.right(), 0.0, viewport_.width + 0.0)));
    const int top = static_cast<int>(std::lround(std::clamp(rect.y, 0.0, viewport_.height + 0.0)));
    const int bottom = static_cast<int>(std::lround(std::clamp(rect.bottom(), 0.0, viewport_.height + 0.0)));
    const SizePx size{std::max(right - left, 1), std::max(bottom - top, 1)};
    set_scissor(left, flip_ < 0 ? viewport_.height - bottom : top, size);
}

/// Large plain areas are cleared, which costs a fraction of drawing them pixel by pixel.
bool Painter::fill_flat(const BoxCommand& box) {
    const bool whole = box.rect.x == std::floor(box.rect.x) && box.rect.y == std::floor(box.rect.y) &&
                       box.rect.width == std::floor(box.rect.width) && box.rect.height == std::floor(box.rect.height);
    if (!whole || box.radius > 0 || box.softness > 0 || box.border_px > 0 || box.fill.a < 1) return false;
    flush();
    limit_to(box.rect);
    clear(box.fill.r, box.fill.g, box.fill.b, 1);
    set_scissor(0, 0, {});
    return true;
}

void Painter::draw(const BoxCommand& box) {
    if (fill_flat(box)) return;
    start(Batch::Boxes);
    push(floats_, {box.rect.x, box.rect.y, box.rect.width, box.rect.height, box.radius, box.border_px, box.softness});
    push(floats_, box.fill);
    push(floats_, box.border);
}

const Painter::Slot& Painter::place(const SlotKey& key, const GlyphImage& image) {
    const int width = image.coverage.width, height = image.coverage.height;
    if (shelf_x_ + width + 1 > kAtlasPx) {
        shelf_y_ += shelf_height_ + 1;
        shelf_x_ = shelf_height_ = 0;
    }
    if (shelf_y_ + height + 1 > kAtlasPx) {  // full: what this frame still needs comes again
        const Batch batch = batch_;
        flush();
        batch_ = batch;
        slots_.clear();
        shelf_x_ = shelf_y_ = shelf_height_ = 0;
    }
    const Slot slot{shelf_x_, shelf_y_, width, height, image.left, image.top};
    if (width > 0 && height > 0) atlas_.upload(slot.x, slot.y, {width, height}, image.coverage.pixels);
    shelf_x_ += width + 1;
    shelf_height_ = std::max(shelf_height_, height);
    return slots_[key] = slot;
}

void Painter::add_glyph(const Slot& slot, double x, double y, Colour colour) {
    if (slot.width == 0) return;
    constexpr double kScale = 1.0 / kAtlasPx;
    push(floats_, {x, y, static_cast<double>(slot.width), static_cast<double>(slot.height), slot.x * kScale,
                   slot.y * kScale, slot.width * kScale, slot.height * kScale});
    push(floats_, colour);
}

void Painter::draw(const TextCommand& text) {
    start(Batch::Glyphs);
    const double baseline = std::round(text.y);
    for (const PlacedGlyph& g : fonts_->shape(text.text, text.style).glyphs) {
        const double x = text.x + g.x, whole = std::floor(x);
        const int phase = std::min(static_cast<int>((x - whole) * 4), 3);
        const SlotKey key{g.font, g.glyph, static_cast<int>(std::lround(text.style.size_px * 64)), phase};
        const auto found = slots_.find(key);
        const Slot slot = found != slots_.end()
                              ? found->second
                              : place(key, fonts_->rasterise(g.font, g.glyph, text.style.size_px, phase));
        add_glyph(slot, whole + slot.left, baseline + std::round(g.y) + slot.top, text.colour);
    }
}

void Painter::draw(const IconCommand& icon) {
    start(Batch::Glyphs);
    const int size = std::max(1, static_cast<int>(std::lround(icon.size_px)));
    const SlotKey key{-1, static_cast<unsigned>(icon.icon), size, static_cast<int>(std::lround(icon.line_px * 64))};
    const auto found = slots_.find(key);
    const Slot slot =
        found != slots_.end() ? found->second : place(key, {rasterise_icon(icon.icon, size, icon.line_px), 0, 0});
    add_glyph(slot, std::round(icon.centre_x - size * 0.5), std::round(icon.centre_y - size * 0.5), icon.colour);
}

void Painter::draw(const PictureCommand& picture) {
    const auto found = pictures_.find(picture.picture);
    if (found == pictures_.end() || picture.opacity <= 0) return;
    flush();
    use(picture_program_);
    found->second->bind(0);
    picture_program_.set("picture", 0);
    picture_program_.set("mode", static_cast<int>(picture.mode));
    picture_program_.set("tint", picture.tint.r, picture.tint.g, picture.tint.b, picture.tint.a);
    picture_program_.set("opacity", static_cast<float>(picture.opacity));
    picture_program_.set("ramp", static_cast<float>(picture.ramp.from), static_cast<float>(picture.ramp.to));
    set_blend(picture.mode == PictureCommand::Mode::Wash ? Blend::Multiply : Blend::Over);
    std::vector<float> quad;
    push(quad, {picture.rect.x, picture.rect.y, picture.rect.width, picture.rect.height, picture.source.x,
                picture.source.y, picture.source.width, picture.source.height});
    picture_.fill(quad);
    picture_.draw_quads(1);
}

void Painter::draw(const InkCommand& ink) {
    if (ink.pieces.empty()) return;
    flush();
    use(ink_program_);
    ink_program_.set("tint", ink.colour.r, ink.colour.g, ink.colour.b, ink.colour.a);
    set_blend(Blend::Over);
    limit_to(ink.clip);
    ink_.fill({&ink.pieces.front().x0, ink.pieces.size() * 6});
    ink_.draw_quads(static_cast<int>(ink.pieces.size()));
    set_scissor(0, 0, {});
}

}  // namespace ui
