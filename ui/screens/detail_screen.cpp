#include "ui/screens/detail_screen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui {
namespace {

constexpr double kTag_px = 42, kDrawingTag_px = 34;

/// Boxes of the design at 1920 × 1080, moved and mirrored.
class Placer {
  public:
    Placer(const ScreenScale& s, Hand hand) : s_(s), hand_(hand) {}
    [[nodiscard]] Rect at(double x, double y, double width, double height) const {
        const Rect r{s_.px(x), s_.px(y), s_.px(width), s_.px(height)};
        if (hand_ == Hand::Right) return r;
        return {s_.width() - r.x - r.width, r.y, r.width, r.height};
    }

  private:
    const ScreenScale& s_;
    Hand hand_;
};

/// Of a similar card, three a row.
double row_of(std::size_t i) {
    return i < 3 ? 0 : 1;
}

void lay_out_wide(DetailLayout& l) {
    const ScreenScale& s = l.scale;
    const Placer place(s, l.hand);
    const double board = s.px(592), height = s.height();
    l.board = {l.hand == Hand::Right ? 0.0 : s.width() - board, 0, board, height};
    l.sheet = {l.hand == Hand::Right ? board : 0.0, 0, s.width() - board, height};
    l.back = place.at(40, 36, 232, 64);
    // where there is height to spare, the board's things stand apart from the button, which never shrinks below a
    // finger
    const double down = std::round(std::clamp((height - s.px(1080)) * 0.4, 0.0, s.px(48)));
    l.drawing = place.at(40, 172, 512, 436);
    l.drawing.y += down;
    l.your_drawing_y = s.px(158) + down;
    l.also_close_y = s.px(658) + down;
    Rect block = place.at(40, 672, 512, 360);
    block.y += down;
    for (std::size_t i = 0; i < kSimilarCount; ++i) {
        l.similar[i] = {block.x + s.px(176.0 * static_cast<double>(i % 3)), block.y + s.px(188.0 * row_of(i)),
                        s.px(160), s.px(172)};
    }
    l.name_x = l.sheet.x + s.px(72);
    l.name_y = s.px(106);
    l.caption_y = s.px(154);
    l.text_width = l.sheet.width - s.px(144);
    const double cx = l.sheet.x + s.px(648);
    l.ring = {std::min(cx, l.sheet.centre_x()), height - s.px(274)};
    l.ring_radius = s.px(400);
    l.model = {l.ring.x - s.px(434), s.px(190), s.px(868), l.ring.y - s.px(190)};
    l.stage = {l.sheet.x, s.px(166), l.sheet.width, height - s.px(166)};
    l.hint_y = height - s.px(76);
}

void lay_out_upright(DetailLayout& l) {
    const ScreenScale& s = l.scale;
    const double board = s.px(640);
    l.board = {0, 0, s.width(), board};
    l.sheet = {0, board, s.width(), s.height() - board};
    l.back = {s.px(40), s.px(36), s.px(232), s.px(64)};
    l.drawing = {s.px(40), s.px(164), s.px(452), s.px(428)};
    l.your_drawing_y = s.px(150);
    l.also_close_y = s.px(150);
    for (std::size_t i = 0; i < kSimilarCount; ++i) {
        l.similar[i] = {s.width() - s.px(40) - s.px(532) + s.px(182.0 * static_cast<double>(i % 3)),
                        s.px(164) + s.px(220.0 * row_of(i)), s.px(168), s.px(208)};
    }
    l.name_x = s.px(64);
    l.name_y = board + s.px(106);
    l.caption_y = board + s.px(154);
    l.text_width = s.width() - s.px(128);
    l.ring = {s.width() / 2, s.height() - s.px(330)};
    l.ring_radius = s.px(400);
    l.model = {l.ring.x - s.px(434), board + s.px(230), s.px(868), l.ring.y - board - s.px(230)};
    l.stage = {0, board + s.px(170), s.width(), s.height() - board - s.px(170)};
    l.hint_y = s.height() - s.px(110);
}

class Drawer {
  public:
    Drawer(DrawList& list, const FontSet& fonts, const Strings& words, const DetailState& state,
           const DetailLayout& layout)
        : list_(list), fonts_(fonts), words_(words), state_(state), l_(layout), s_(layout.scale) {}

    void board() {
        list_.box(l_.board, 0, palette::kBoard);
        const bool above = l_.sheet.y > 0;
        const double reach = s_.px(32);
        if (above) {
            list_.shadow({-2 * reach, l_.board.bottom(), s_.width() + 4 * reach, 2 * reach}, 0, 0, reach,
                         palette::kShade.faded(1.5F));
        } else {
            const double edge = l_.hand == Hand::Right ? l_.board.right() : l_.board.x;
            const double x = l_.hand == Hand::Right ? edge : edge - 2 * reach;
            list_.shadow({x, -2 * reach, 2 * reach, s_.height() + 4 * reach}, 0, 0, reach, palette::kShade.faded(1.5F));
        }
        list_.box(l_.sheet, 0, palette::kSheet);
        const TextStyle back = s_.text(Face::SemiBold, 20);
        way(l_.back, Icon::Back, words_["keep_drawing"], back, state_.pressed == Control::KeepDrawing);
        if (state_.wear) way(l_.wear, Icon::OnBody, words_["wear_it"], back, state_.pressed == Control::Wear);
    }

    void drawing() {
        const TextStyle label = s_.text(Face::Medium, 17);
        list_.text(fonts_, words_["your_drawing"], label, palette::kMuted, l_.drawing.x, l_.your_drawing_y);
        card(l_.drawing, s_.px(20), false);
        for (const WashPart& part : state_.wash) {
            const Colour c = palette::parts()[static_cast<std::size_t>(part.colour)];
            list_.wash(part.coverage, part.rect, c.faded(palette::kWashShare * dim(part.colour)), part.opacity);
        }
        const Rect& inked = state_.inked;
        if (inked.width > 0 && inked.height > 0) {
            list_.tinted(state_.ink, l_.drawing, palette::kInk,
                         {inked.x + l_.drawing.x, inked.y + l_.drawing.y, inked.width, inked.height});
        }
        for (const DetailTag& t : state_.drawing_tags) tag(t, kDrawingTag_px, true);
    }

    void similar() {
        const TextStyle label = s_.text(Face::Medium, 17), name = s_.text(Face::Medium, 17);
        if (!state_.similar.empty()) {
            list_.text(fonts_, words_["also_close"], label, palette::kMuted, l_.similar[0].x, l_.also_close_y);
        }
        for (std::size_t i = 0; i < std::min(state_.similar.size(), kSimilarCount); ++i) {
            const Rect& r = l_.similar[i];
            card(r, s_.px(16), state_.pressed == Control::Card && state_.pressed_item == i);
            const double text = s_.px(40), inset = s_.px(6);
            list_.picture(state_.similar[i].picture,
                          {r.x + inset, r.y + inset, r.width - 2 * inset, r.height - text - inset});
            const bool alone = state_.similar[i].picture == PictureId{} && !state_.similar[i].to_come;
            const double y = alone ? r.centre_y() : r.bottom() - s_.px(17);
            list_.text(fonts_, fonts_.cut(state_.similar[i].name, name, r.width - s_.px(12)), name, palette::kInk,
                       r.centre_x(), y, Align::Centre);
        }
    }

    void words() {
        draw_fitted(list_, fonts_, state_.name, s_.text(Face::DisplaySemiBold, 64, -0.015), palette::kInk, l_.name_x,
                    l_.name_y, l_.text_width, Align::Left);
        list_.text(fonts_, fonts_.cut(state_.caption, s_.text(Face::Regular, 28), l_.text_width),
                   s_.text(Face::Regular, 28), palette::kMuted, l_.name_x, l_.caption_y);
        if (!state_.touched) {
            const TextStyle hint = s_.text(Face::Medium, 20);
            list_.text(fonts_, words_["drag_to_turn"], hint, palette::kMuted.faded(opened()), l_.ring.x, l_.hint_y,
                       Align::Centre);
        }
    }

    void ring(bool front) {
        const double ry = l_.ring_radius * std::max(std::abs(std::sin(state_.elevation)), 0.04);
        const double pi = std::numbers::pi, line = std::max(1.5, s_.px(3));
        if (!front) {
            draw_arc(list_, l_.ring.x, l_.ring.y, l_.ring_radius, ry, 0, 2 * pi, line, palette::kLine.faded(opened()));
            return;
        }
        const double home = pi / 2, knob = home + state_.azimuth;
        if (std::abs(state_.azimuth) > 0.01) {
            const double swing = std::clamp(state_.azimuth, -2 * pi, 2 * pi);
            draw_arc(list_, l_.ring.x, l_.ring.y, l_.ring_radius, ry, knob, knob - swing, s_.px(6),
                     palette::kSanguine.faded(opened()));
        }
        const core::Point p{l_.ring.x + l_.ring_radius * std::cos(knob), l_.ring.y + ry * std::sin(knob)};
        const double d = s_.px(64);
        list_.box({p.x - d / 2, p.y - d / 2, d, d}, d / 2, palette::kSheet.faded(opened()),
                  palette::kSanguine.faded(opened()), s_.px(5));
        list_.icon(Icon::Turn, p.x, p.y, s_.px(32), s_.px(32) / 32 * 2.6, palette::kSanguine.faded(opened()));
    }

    void model() {
        if (state_.model != PictureId{}) list_.picture(state_.model, l_.stage);
        if (state_.still_opacity > 0) list_.picture(state_.still, state_.still_rect, state_.still_opacity);
    }

    void model_tags() {
        if (state_.opened < 1) return;
        for (const DetailTag& t : state_.model_tags) {
            if (t.hidden) continue;
            draw_line(list_, t.anchor, t.place, std::max(1.5, s_.px(2)), palette::kInk.faded(0.62F * dim(t.colour)));
            const double d = s_.px(10);
            list_.box({t.anchor.x - d / 2, t.anchor.y - d / 2, d, d}, d / 2, palette::kInk.faded(dim(t.colour)));
        }
        for (const DetailTag& t : state_.model_tags) tag(t, kTag_px, false);
    }

    void zoom() {
        const double line = std::max(1.5, s_.px(2));
        for (const bool more : {false, true}) {
            const Control control = more ? Control::Larger : Control::Smaller;
            const Rect r = more ? l_.larger : l_.smaller;
            const Rect button = state_.pressed == control ? scaled(r, 0.97) : r;
            list_.box(button, button.height / 2, state_.pressed == control ? palette::kWell : palette::kSheet,
                      palette::kLine, line);
            list_.icon(more ? Icon::Plus : Icon::Minus, r.centre_x(), r.centre_y(), s_.px(32), s_.px(32) / 32 * 2.4,
                       palette::kInk);
        }
    }

  private:
    [[nodiscard]] float opened() const { return static_cast<float>(state_.opened); }
    [[nodiscard]] float dim(int colour) const { return state_.focus && *state_.focus != colour ? 0.25F : 1.0F; }

    /// A way from here: icon and words together in the middle of a button.
    void way(const Rect& rect, Icon icon, const std::string& words, const TextStyle& style, bool down) {
        const Rect r = down ? scaled(rect, 0.97) : rect;
        list_.box(r, r.height / 2, down ? palette::kWell : palette::kSheet, palette::kLine, std::max(1.0, s_.px(2)));
        const double size = s_.px(32), gap = s_.px(12), room = r.width - size - gap - 2 * s_.px(16);
        const double wide = std::min(fonts_.width_px(words, style), room);
        const double x = r.centre_x() - (size + gap + wide) / 2;
        list_.icon(icon, x + size / 2, r.centre_y(), size, size / 32 * 2.2, palette::kInk);
        draw_fitted(list_, fonts_, words, style, palette::kInk, x + size + gap, r.centre_y() + cap_drop(style), room,
                    Align::Left);
    }

    void card(const Rect& r, double radius, bool pressed) {
        const double line = std::max(1.0, s_.px(1));
        list_.box({r.x - line, r.y - line, r.width + 2 * line, r.height + 2 * line}, radius + line, palette::kNone,
                  palette::kEdge, line);
        list_.box(r, radius, pressed ? palette::kWell : palette::kSheet);
    }

    void tag(const DetailTag& t, double design, bool ringed) {
        const std::size_t c = static_cast<std::size_t>(t.colour);
        const double d = std::max(s_.px(design), 24.0), edge = std::max(1.5, s_.px(3));
        const float a = dim(t.colour);
        const Rect r{t.place.x - d / 2, t.place.y - d / 2, d, d};
        if (ringed) list_.box({r.x - edge, r.y - edge, d + 2 * edge, d + 2 * edge}, d, palette::kSheet);
        if (t.hidden) {
            list_.box(r, d / 2, palette::kSheet, palette::parts()[c].faded(a), edge);
        } else {
            list_.box(r, d / 2, palette::kSheet);
            list_.box(r, d / 2, palette::parts()[c].faded(a));
        }
        const TextStyle style{Face::SemiBold, d * 0.52, 0};
        list_.text(fonts_, std::to_string(t.colour + 1), style,
                   (t.hidden ? palette::kMuted : palette::tag_text()[c]).faded(a), t.place.x,
                   t.place.y + cap_drop(style), Align::Centre);
    }

    DrawList& list_;
    const FontSet& fonts_;
    const Strings& words_;
    const DetailState& state_;
    const DetailLayout& l_;
    const ScreenScale& s_;
};

}  // namespace

DetailLayout detail_layout(SizePx screen, Hand hand) {
    DetailLayout l;
    l.scale = ScreenScale::of(screen);
    l.hand = hand;
    if (l.scale.upright) {
        lay_out_upright(l);
    } else {
        lay_out_wide(l);
    }
    const ScreenScale& s = l.scale;
    const double side = s.target(64), y = s.height() - s.px(40) - side;
    l.back.height = std::max(l.back.height, side);
    l.wear = l.back;
    l.wear.x += (hand == Hand::Right || s.upright ? 1 : -1) * (l.back.width + s.px(16));
    const double gap = s.px(16), x = hand == Hand::Right ? s.width() - s.px(40) - 2 * side - gap : l.sheet.x + s.px(40);
    l.smaller = {x, y, side, side};
    l.larger = {x + side + gap, y, side, side};
    return l;
}

DrawList DetailScreen::draw(const DetailState& state, const DetailLayout& layout) const {
    DrawList list;
    Drawer drawer(list, *fonts_, (*languages_)[state.language], state, layout);
    drawer.board();
    drawer.drawing();
    drawer.similar();
    drawer.words();
    drawer.ring(false);
    drawer.model();
    drawer.ring(true);
    drawer.zoom();
    drawer.model_tags();
    return list;
}

std::vector<BoardTouch::Target> DetailScreen::targets(const DetailState& state, const DetailLayout& l) const {
    std::vector<BoardTouch::Target> all{
        {Control::KeepDrawing, 0, l.back}, {Control::Smaller, 0, l.smaller}, {Control::Larger, 0, l.larger}};
    if (state.wear) all.push_back({Control::Wear, 0, l.wear});
    for (std::size_t i = 0; i < std::min(state.similar.size(), kSimilarCount); ++i)
        all.push_back({Control::Card, i, l.similar[i]});
    for (const std::vector<DetailTag>* tags : {&state.model_tags, &state.drawing_tags}) {
        for (const DetailTag& t : *tags) {
            const double reach = l.scale.target(64) / 2;
            all.push_back({Control::Tag,
                           static_cast<std::size_t>(t.colour),
                           {t.place.x - reach, t.place.y - reach, 2 * reach, 2 * reach}});
        }
    }
    return all;
}

}  // namespace ui
