#include "ui/draw/painter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {
namespace {

constexpr int kAtlasPx = 2048;
constexpr double kMostShare = 0.7;  // of the target; more than that in parts costs more than the whole at once

void push(std::vector<float>& floats, std::initializer_list<double> values) {
    for (const double v : values) floats.push_back(static_cast<float>(v));
}
void push(std::vector<float>& floats, Colour c) {
    floats.insert(floats.end(), {c.r, c.g, c.b, c.a});
}

/// Quarters of a pixel that a letter is shifted by.
int phase_of(double x) {
    return std::min(static_cast<int>((x - std::floor(x)) * 4), 3);
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
    changed_pictures_[id] = {};
}

void Painter::picture_changed(PictureId id, const Rect& part) {
    if (part.width <= 0 || part.height <= 0) return;
    const auto [entry, is_new] = changed_pictures_.emplace(id, part);
    if (is_new || entry->second.width <= 0) return;
    entry->second = around(entry->second, part);
}

void Painter::paint(const DrawList& list, SizePx viewport, bool flip) {
    viewport_ = viewport;
    flip_ = flip ? -1.0F : 1.0F;
    set_depth_test(false);
    for (const DrawCommand& command : list.commands) place_letters(command);
    for (const DrawCommand& command : list.commands) {
        std::visit([this](const auto& c) { draw(c); }, command);
    }
    flush();
}

/// Where the list shows pictures that are not what they were.
void Painter::add_picture_changes(const DrawList& list, Damage& damage) const {
    for (const DrawCommand& command : list.commands) {
        const auto* picture = std::get_if<PictureCommand>(&command);
        if (picture == nullptr) continue;
        const auto changed = changed_pictures_.find(picture->picture);
        if (changed == changed_pictures_.end()) continue;
        const auto texture = pictures_.find(picture->picture);
        const Rect& part = changed->second;
        if (part.width <= 0 || texture == pictures_.end()) {
            damage.add(picture->rect);
            continue;
        }
        const Rect &to = picture->rect, &from = picture->source;
        const double sx = to.width / (from.width * texture->second->size().width);
        const double sy = to.height / (from.height * texture->second->size().height);
        // filtering reads one pixel beyond
        const double x = to.x - from.x * to.width / from.width, y = to.y - from.y * to.height / from.height;
        damage.add(
            common(to, {x + (part.x - 1) * sx, y + (part.y - 1) * sy, (part.width + 2) * sx, (part.height + 2) * sy}));
    }
}

void Painter::paint_part(const DrawList& list, const std::vector<Rect>& reaches, const Rect& part) {
    for (std::size_t i = 0; i < list.commands.size(); ++i) {
        if (overlap(reaches[i], part)) place_letters(list.commands[i]);
    }
    part_ = part;
    unlimit();
    for (std::size_t i = 0; i < list.commands.size(); ++i) {
        if (overlap(reaches[i], part)) std::visit([this](const auto& c) { draw(c); }, list.commands[i]);
    }
    flush();
    part_.reset();
    unlimit();
}

void Painter::paint_changes(DrawList list, SizePx viewport, bool flip) {
    const Rect whole{0, 0, viewport.width + 0.0, viewport.height + 0.0};
    painted_ = {};
    if (frame_ && frame_->viewport == viewport && frame_->flip == flip) {
        painted_ = difference(frame_->list, list, *fonts_);
        add_picture_changes(list, painted_);
    } else {
        painted_.add(whole);
    }
    changed_pictures_.clear();
    viewport_ = viewport;
    flip_ = flip ? -1.0F : 1.0F;
    set_depth_test(false);
    if (painted_.area() > kMostShare * whole.width * whole.height) {
        painted_ = {};
        painted_.add(whole);
    }
    std::vector<Rect> reaches;
    if (!painted_.empty()) {
        reaches.reserve(list.commands.size());
        for (const DrawCommand& command : list.commands) reaches.push_back(reach_of(command, *fonts_));
    }
    for (const Rect& part : painted_.rects()) paint_part(list, reaches, part);
    frame_ = Frame{std::move(list), viewport, flip};
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

/// To the part that is being drawn.
void Painter::unlimit() const {
    if (part_) {
        (void)limit_to(*part_);
    } else {
        set_scissor(0, 0, {});
    }
}

/// False when nothing is left of it.
bool Painter::limit_to(const Rect& wanted) const {
    const Rect rect = part_ ? common(wanted, *part_) : wanted;
    const int left = static_cast<int>(std::lround(std::clamp(rect.x, 0.0, viewport_.width + 0.0)));
    const int right = static_cast<int>(std::lround(std::clamp(rect.right(), 0.0, viewport_.width + 0.0)));
    const int top = static_cast<int>(std::lround(std::clamp(rect.y, 0.0, viewport_.height + 0.0)));
    const int bottom = static_cast<int>(std::lround(std::clamp(rect.bottom(), 0.0, viewport_.height + 0.0)));
    if (right <= left || bottom <= top) return false;
    set_scissor(left, flip_ < 0 ? viewport_.height - bottom : top, {right - left, bottom - top});
    return true;
}

/// Large plain areas are cleared, which costs a fraction of drawing them pixel by pixel.
bool Painter::fill_flat(const BoxCommand& box) {
    const bool whole = box.rect.x == std::floor(box.rect.x) && box.rect.y == std::floor(box.rect.y) &&
                       box.rect.width == std::floor(box.rect.width) && box.rect.height == std::floor(box.rect.height);
    if (!whole || box.radius > 0 || box.softness > 0 || box.border_px > 0 || box.fill.a < 1) return false;
    flush();
    if (limit_to(box.rect)) clear(box.fill.r, box.fill.g, box.fill.b, 1);
    unlimit();
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

Painter::Slot Painter::slot_of(const TextCommand& text, const PlacedGlyph& glyph, int phase) {
    const SlotKey key{glyph.font, glyph.glyph, static_cast<int>(std::lround(text.style.size_px * 64)), phase};
    const auto found = slots_.find(key);
    if (found != slots_.end()) return found->second;
    return place(key, fonts_->rasterise(glyph.font, glyph.glyph, text.style.size_px, phase));
}

Painter::Slot Painter::slot_of(const IconCommand& icon) {
    const int size = std::max(1, static_cast<int>(std::lround(icon.size_px)));
    const SlotKey key{-1, static_cast<unsigned>(icon.icon), size, static_cast<int>(std::lround(icon.line_px * 64))};
    const auto found = slots_.find(key);
    if (found != slots_.end()) return found->second;
    return place(key, {rasterise_icon(icon.icon, size, icon.line_px), 0, 0});
}

/// Letters come to the atlas before anything is drawn: in between, a driver that draws in software would wait for all
/// that was drawn so far at each of them.
void Painter::place_letters(const DrawCommand& command) {
    if (const auto* text = std::get_if<TextCommand>(&command)) {
        for (const PlacedGlyph& g : fonts_->shape(text->text, text->style).glyphs) {
            (void)slot_of(*text, g, phase_of(text->x + g.x));
        }
    } else if (const auto* icon = std::get_if<IconCommand>(&command)) {
        (void)slot_of(*icon);
    }
}

void Painter::draw(const TextCommand& text) {
    start(Batch::Glyphs);
    const double baseline = std::round(text.y);
    for (const PlacedGlyph& g : fonts_->shape(text.text, text.style).glyphs) {
        const double x = text.x + g.x;
        const Slot slot = slot_of(text, g, phase_of(x));
        add_glyph(slot, std::floor(x) + slot.left, baseline + std::round(g.y) + slot.top, text.colour);
    }
}

void Painter::draw(const IconCommand& icon) {
    start(Batch::Glyphs);
    const Slot slot = slot_of(icon);
    const int size = std::max(1, static_cast<int>(std::lround(icon.size_px)));
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
    const bool partly = picture.within.width > 0 && picture.within.height > 0;
    if (!partly || limit_to(picture.within)) picture_.draw_quads(1);
    if (partly) unlimit();
}

void Painter::draw(const InkCommand& ink) {
    if (ink.pieces.empty()) return;
    flush();
    use(ink_program_);
    ink_program_.set("tint", ink.colour.r, ink.colour.g, ink.colour.b, ink.colour.a);
    set_blend(Blend::Over);
    ink_.fill({&ink.pieces.front().x0, ink.pieces.size() * 6});
    if (limit_to(ink.clip)) ink_.draw_quads(static_cast<int>(ink.pieces.size()));
    unlimit();
}

}  // namespace ui
