#include "ui/screens/card_text.hpp"

#include <algorithm>

namespace ui {
namespace {

constexpr double kAscent = 0.75, kDescent = 0.25;  // of a line's size, above and below its baseline
constexpr double kGap = 8;                         // between a line and the model, pixels of the design
constexpr double kMostLean = 0.5;                  // as far to the right as there is room

/// A line of text as a box on its card.
struct Line {
    double right, top, bottom;
};

/// What stands on one card, in pixels from the corner of its picture.
class Placing {
  public:
    Placing(const FontSet& fonts, const FindLayout& layout, std::size_t card, const CardText& text)
        : fonts_(fonts), text_(text), gap_(layout.px(kGap)) {
        const Rect &whole = layout.cards[card], &picture = layout.card_pictures[card];
        left_ = whole.x + text.x - picture.x;
        top_ = whole.y - picture.y;
    }

    [[nodiscard]] Line line(const std::string& words, const TextStyle& style, double baseline) const {
        return {left_ + fonts_.width_px(words, style), top_ + baseline - kAscent * style.size_px,
                top_ + baseline + kDescent * style.size_px};
    }
    [[nodiscard]] std::vector<Line> name(const std::vector<std::string>& lines) const {
        std::vector<Line> out;
        for (const std::string& words : lines) {
            const double down = static_cast<double>(out.size()) * kNameLineHeight * text_.name.size_px;
            out.push_back(line(words, text_.name, text_.name_baseline + down));
        }
        return out;
    }
    [[nodiscard]] bool is_free(const Line& line, const CardModel& model, const ModelPictureOptions& options) const {
        return line.right + gap_ <= free_at_left(model, options, line.top - gap_ / 2, line.bottom + gap_ / 2);
    }
    [[nodiscard]] bool are_free(const std::vector<Line>& lines, const CardModel& model,
                                const ModelPictureOptions& options) const {
        return std::all_of(lines.begin(), lines.end(), [&](const Line& l) { return is_free(l, model, options); });
    }
    /// Room for a line above the model.
    [[nodiscard]] double headroom(const Line& line, const ModelPictureOptions& options) const {
        return std::max((line.bottom + gap_ / 2) / options.size.height - options.margin, 0.0);
    }

  private:
    const FontSet& fonts_;
    const CardText& text_;
    double gap_, left_ = 0, top_ = 0;
};

}  // namespace

CardText card_text(const FindLayout& layout, std::size_t card) {
    const auto px = [&](double wide, double compact) { return layout.px(layout.compact ? compact : wide); };
    CardText text;
    text.caption = {Face::Medium, layout.px(17), 0};
    if (card == 0) {
        text.name = {Face::SemiBold, px(28, 21), -0.02};
        text.x = px(24, 18);
        text.name_baseline = px(46, 36);
        text.caption_baseline = layout.px(72);
        text.captioned = !layout.compact;
        text.most_px = layout.cards[card].width - layout.px(48);
    } else {
        text.name = {Face::Medium, px(18, 16), 0};
        text.x = px(18, 14);
        text.name_baseline = px(31, 27);
        text.most_px = layout.cards[card].width - 2 * text.x;
    }
    return text;
}

CardPlace place_on_card(const FontSet& fonts, const FindLayout& layout, std::size_t card, const std::string& name,
                        const std::string& caption, const CardModel& model) {
    const CardText text = card_text(layout, card);
    const Rect& picture = layout.card_pictures[card];
    CardPlace place;
    place.name = {fonts.cut(name, text.name, text.most_px)};
    ModelPictureOptions& options = place.picture;
    options.size = {std::max(1, static_cast<int>(picture.width)), std::max(1, static_cast<int>(picture.height))};
    options.margin = card == 0 ? 0.03 : 0.06;
    options.ground_margin = card == 0 ? 0.09 : 0.08;  // the best card's tags stand below the model
    const double lean = card == 0 ? 0.1 : 0;          // away from the name, which stands at the top left
    const Placing placing(fonts, layout, card, text);
    std::vector<Line> lines = placing.name(place.name);
    if (text.captioned && !caption.empty()) {
        const std::string cut = fonts.cut(caption, text.caption, text.most_px);
        lines.push_back(placing.line(cut, text.caption, text.caption_baseline));
    }
    for (const double tried : {lean, kMostLean}) {
        options.lean = tried;
        if (placing.are_free(lines, model, options)) return place;
    }
    if (card > 0) {
        const double room = free_at_left(model, options, 0, lines[0].bottom + kNameLineHeight * text.name.size_px);
        const std::vector<std::string> two =
            fonts.wrap(name, text.name, room + picture.x - layout.cards[card].x - text.x);
        if (two.size() == 2 && placing.are_free(placing.name(two), model, options)) {
            place.name = two;
            return place;
        }
    }
    options.lean = lean;
    for (const Line& line : lines) {
        if (!placing.is_free(line, model, options)) options.headroom = placing.headroom(line, options);
    }
    return place;
}

}  // namespace ui
