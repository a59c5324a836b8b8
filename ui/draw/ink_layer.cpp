#include "ui/draw/ink_layer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {
namespace {

/// Spans of a stroke that no later sample can bend.
std::size_t settled_spans(const core::Stroke& stroke, bool open) {
    const std::size_t spans = ink_span_count(stroke.samples);
    return open && spans > 0 ? spans - 1 : spans;
}

/// The box grown by a piece, whole pixels, cut to the page.
Rect joined(const Rect& box, const InkPiece& piece, SizePx page) {
    const double r = std::max(piece.r0, piece.r1) + 1.0;
    double left = std::floor(std::min(piece.x0, piece.x1) - r), right = std::ceil(std::max(piece.x0, piece.x1) + r);
    double top = std::floor(std::min(piece.y0, piece.y1) - r), bottom = std::ceil(std::max(piece.y0, piece.y1) + r);
    if (box.width > 0) {
        left = std::min(left, box.x);
        right = std::max(right, box.right());
        top = std::min(top, box.y);
        bottom = std::max(bottom, box.bottom());
    }
    left = std::clamp(left, 0.0, page.width + 0.0);
    right = std::clamp(right, 0.0, page.width + 0.0);
    top = std::clamp(top, 0.0, page.height + 0.0);
    bottom = std::clamp(bottom, 0.0, page.height + 0.0);
    return {left, top, right - left, bottom - top};
}

}  // namespace

core::Result<InkLayer> InkLayer::create(SizePx size) {
    core::Result<Program> program = Program::load("ink");
    if (!program) return core::unexpected(program.error());
    return InkLayer(std::move(*program), size);
}

InkLayer::InkLayer(Program program, SizePx size)
    : program_(std::move(program)), target_(size, PixelFormat::Coverage), stream_({4, 2}, true) {}

void InkLayer::resize(SizePx size) {
    if (size == target_.size()) return;
    target_ = Target(size, PixelFormat::Coverage);
    fresh_ = true;
}

int InkLayer::update(const Ink& ink) {
    target_.bind();
    if (fresh_ || ink.epoch != epoch_ || !(ink.frame == frame_) || ink.width_px != width_px_) {
        clear(0, 0, 0, 0);
        changed_ = {0, 0, size().width + 0.0, size().height + 0.0};
        fresh_ = false;
        epoch_ = ink.epoch;
        frame_ = ink.frame;
        width_px_ = ink.width_px;
        stroke_ = span_ = 0;
        inked_ = {};
    }
    std::vector<InkPiece> pieces;
    while (stroke_ < ink.strokes.size()) {
        const bool last = stroke_ + 1 == ink.strokes.size();
        const std::vector<core::PenSample>& samples = ink.strokes[stroke_].samples;
        const double width = ink.width_of(stroke_);
        const std::size_t settled = settled_spans(ink.strokes[stroke_], last && ink.last_open);
        for (; span_ < settled; ++span_) append_ink_span(samples, span_, ink.frame, width, pieces);
        if (last) break;
        ++stroke_;
        span_ = 0;
    }
    if (pieces.empty()) return 0;
    for (const InkPiece& piece : pieces) {
        inked_ = joined(inked_, piece, size());
        changed_ = joined(changed_, piece, size());
    }
    static_assert(sizeof(InkPiece) == 6 * sizeof(float));
    stream_.fill({&pieces.front().x0, pieces.size() * 6});
    program_.use();
    program_.set("viewport", static_cast<float>(size().width), static_cast<float>(size().height));
    program_.set("flip", 1.0F);
    program_.set("tint", 0.0F, 0.0F, 0.0F, 0.0F);
    set_blend(Blend::Maximum);
    stream_.draw_quads(static_cast<int>(pieces.size()));
    return static_cast<int>(pieces.size());
}

std::vector<InkPiece> InkLayer::wet_end(const Ink& ink) {
    std::vector<InkPiece> pieces;
    if (!ink.last_open || ink.strokes.empty()) return pieces;
    const std::vector<core::PenSample>& samples = ink.strokes.back().samples;
    const double width = ink.width_of(ink.strokes.size() - 1);
    if (!samples.empty()) append_ink_span(samples, ink_span_count(samples) - 1, ink.frame, width, pieces);
    return pieces;
}

}  // namespace ui
