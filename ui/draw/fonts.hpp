#pragma once
// Text: Inter shaped by HarfBuzz and rasterised by FreeType, Noto Sans where Inter lacks a letter. No GL in here.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/silhouette/image.hpp"

namespace ui {

enum class Face { Regular, Medium, SemiBold, DisplaySemiBold };

struct TextStyle {
    Face face = Face::Regular;
    double size_px = 20;     ///< of the em square
    double tracking_em = 0;  ///< added after every glyph, in ems; negative is tighter
    friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

/// One glyph of a shaped line; x from the start of the line, y from the baseline, y down.
struct PlacedGlyph {
    int font = 0;  ///< which of the set's fonts
    std::uint32_t glyph = 0;
    double x = 0, y = 0;
};

struct ShapedText {
    std::vector<PlacedGlyph> glyphs;
    double width_px = 0;
};

/// Grey picture of one glyph; left and top say where its corner lies from the pen position, y down.
struct GlyphImage {
    core::GrayImage coverage;
    int left = 0;
    int top = 0;
};

class FontSet {
  public:
    /// Loads Inter from `folders`, or Noto Sans where Inter is absent. ErrorCode::FileMissing naming the package when
    /// neither is there. The default folders are Debian's.
    [[nodiscard]] static core::Result<FontSet> load(std::vector<std::string> folders = {});
    FontSet(FontSet&&) noexcept;
    FontSet& operator=(FontSet&&) noexcept;
    ~FontSet();

    /// One line of UTF-8, tabular figures. Remembered, so asking again costs a look-up.
    [[nodiscard]] const ShapedText& shape(const std::string& text, const TextStyle& style) const;
    [[nodiscard]] double width_px(const std::string& text, const TextStyle& style) const {
        return shape(text, style).width_px;
    }
    /// The text itself when it fits, else its longest beginning with an ellipsis that fits.
    [[nodiscard]] std::string cut(const std::string& text, const TextStyle& style, double width_px) const;
    /// Lines of whole words, each as wide as fits; a single longer word stands alone.
    [[nodiscard]] std::vector<std::string> wrap(const std::string& text, const TextStyle& style, double width_px) const;
    /// `phase` shifts the glyph right by quarters of a pixel, 0 … 3.
    [[nodiscard]] GlyphImage rasterise(int font, std::uint32_t glyph, double size_px, int phase) const;
    /// Whether letters come from Inter, not the fallback.
    [[nodiscard]] bool has_inter() const;

  private:
    struct Impl;
    explicit FontSet(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace ui
