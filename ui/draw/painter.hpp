#pragma once
// Draws lists: boxes, text and icons in batches, pictures one by one; a whole frame, or what changed since the last.

#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "ui/draw/damage.hpp"
#include "ui/draw/draw_list.hpp"
#include "ui/gl/objects.hpp"

namespace ui {

class Painter {
  public:
    /// `fonts` must outlive the painter.
    [[nodiscard]] static core::Result<Painter> create(const FontSet& fonts);

    /// The texture behind a picture's name until it is named anew; null forgets it. Unknown pictures are not drawn.
    void set_picture(PictureId id, const Texture* texture);

    /// The picture of that name is another in this part of it (in its own pixels).
    void picture_changed(PictureId id, const Rect& part);

    /// Draws into the target that is bound. `flip`: true for a window, whose first row is the bottom one.
    void paint(const DrawList& list, SizePx viewport, bool flip);
    /// The same pixels, where the target still holds what the last call of this function left there: draws only where
    /// the two lists or the pictures in them differ. The list must cover the whole target with opaque ground. After
    /// forget_frame(), or with another viewport or flip, everything is drawn. Cost: that of the difference.
    void paint_changes(DrawList list, SizePx viewport, bool flip);
    /// The target holds something else now.
    void forget_frame() { frame_.reset(); }
    /// What the last paint_changes() drew.
    [[nodiscard]] const Damage& painted() const { return painted_; }

  private:
    enum class Batch { None, Boxes, Glyphs };
    /// Place of a glyph or icon in the atlas.
    struct Slot {
        int x = 0, y = 0, width = 0, height = 0;
        int left = 0, top = 0;
    };
    using SlotKey = std::tuple<int, unsigned, int, int>;  ///< font (or -1 for icons), glyph, size in 1/64 px, phase

    Painter(const FontSet& fonts, Program box, Program glyph, Program picture, Program ink);
    void start(Batch batch);
    void flush();
    void use(const Program& program) const;
    [[nodiscard]] bool limit_to(const Rect& rect) const;
    void unlimit() const;
    void paint_part(const DrawList& list, const std::vector<Rect>& reaches, const Rect& part);
    void add_picture_changes(const DrawList& list, Damage& damage) const;
    bool fill_flat(const BoxCommand& box);
    const Slot& place(const SlotKey& key, const GlyphImage& image);
    [[nodiscard]] Slot slot_of(const TextCommand& text, const PlacedGlyph& glyph, int phase);
    [[nodiscard]] Slot slot_of(const IconCommand& icon);
    void place_letters(const DrawCommand& command);
    void add_glyph(const Slot& slot, double x, double y, Colour colour);

    void draw(const BoxCommand& box);
    void draw(const TextCommand& text);
    void draw(const IconCommand& icon);
    void draw(const PictureCommand& picture);
    void draw(const InkCommand& ink);

    const FontSet* fonts_;
    Program box_program_, glyph_program_, picture_program_, ink_program_;
    VertexStream boxes_, glyphs_, picture_, ink_;
    Texture atlas_;
    std::map<SlotKey, Slot> slots_;
    int shelf_x_ = 0, shelf_y_ = 0, shelf_height_ = 0;
    std::map<PictureId, const Texture*> pictures_;
    std::map<PictureId, Rect> changed_pictures_;  // since the last frame, in their own pixels; without size: the whole
    /// What the target holds.
    struct Frame {
        DrawList list;
        SizePx viewport;
        bool flip;
    };
    std::optional<Frame> frame_;
    Damage painted_;
    std::optional<Rect> part_;  // of the target, that is being drawn; none: all
    Batch batch_ = Batch::None;
    std::vector<float> floats_;
    SizePx viewport_;
    float flip_ = 1;
};

}  // namespace ui
