#include "ui/draw/fonts.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include <hb-ot.h>
#include <hb.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>
#include <utility>

namespace ui {
namespace {

constexpr std::array<const char*, 4> kInterFiles{"Inter-Regular.otf", "Inter-Medium.otf", "Inter-SemiBold.otf",
                                                 "InterDisplay-SemiBold.otf"};
constexpr const char* kNotoFile = "NotoSans-Regular.ttf";
constexpr std::size_t kRemembered = 2000;  // shaped lines

struct LoadedFont {
    FT_Face face = nullptr;
    hb_font_t* shaper = nullptr;
};

std::string find_file(const std::vector<std::string>& folders, const char* name) {
    for (const std::string& folder : folders) {
        const std::filesystem::path path = std::filesystem::path(folder) / name;
        std::error_code ignored;
        if (std::filesystem::is_regular_file(path, ignored)) return path.string();
    }
    return {};
}

}  // namespace

struct FontSet::Impl {
    FT_Library library = nullptr;
    std::vector<LoadedFont> fonts;  // the four faces, then the fallback when there is one
    std::array<int, 4> of_face{};
    int fallback = -1;
    bool inter = false;
    mutable std::map<std::tuple<std::string, Face, double, double>, ShapedText> shaped;

    Impl() { FT_Init_FreeType(&library); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        for (const LoadedFont& f : fonts) {
            hb_font_destroy(f.shaper);
            FT_Done_Face(f.face);
        }
        FT_Done_FreeType(library);
    }

    int open(const std::string& path) {
        LoadedFont font;
        if (path.empty() || FT_New_Face(library, path.c_str(), 0, &font.face) != 0) return -1;
        hb_blob_t* blob = hb_blob_create_from_file(path.c_str());
        hb_face_t* face = hb_face_create(blob, 0);
        font.shaper = hb_font_create(face);
        hb_ot_font_set_funcs(font.shaper);
        hb_face_destroy(face);
        hb_blob_destroy(blob);
        fonts.push_back(font);
        return static_cast<int>(fonts.size()) - 1;
    }

    /// Shapes with one font; false when a letter is missing there.
    bool shape_with(int font, const std::string& text, const TextStyle& style, ShapedText& out) const {
        hb_font_t* shaper = fonts[static_cast<std::size_t>(font)].shaper;
        const int scale = static_cast<int>(std::lround(style.size_px * 64));
        hb_font_set_scale(shaper, scale, scale);
        hb_buffer_t* buffer = hb_buffer_create();
        hb_buffer_add_utf8(buffer, text.c_str(), static_cast<int>(text.size()), 0, -1);
        hb_buffer_guess_segment_properties(buffer);
        const hb_feature_t tabular{HB_TAG('t', 'n', 'u', 'm'), 1, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
        hb_shape(shaper, buffer, &tabular, 1);
        unsigned count = 0;
        const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
        const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer, &count);
        out = {};
        bool complete = true;
        double x = 0;
        for (unsigned i = 0; i < count; ++i) {
            if (infos[i].codepoint == 0) complete = false;
            out.glyphs.push_back({font, infos[i].codepoint, x + places[i].x_offset / 64.0, -places[i].y_offset / 64.0});
            x += places[i].x_advance / 64.0 + style.tracking_em * style.size_px;
        }
        out.width_px = count > 0 ? x - style.tracking_em * style.size_px : 0.0;
        hb_buffer_destroy(buffer);
        return complete;
    }
};

FontSet::FontSet(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FontSet::FontSet(FontSet&&) noexcept = default;
FontSet& FontSet::operator=(FontSet&&) noexcept = default;
FontSet::~FontSet() = default;

core::Result<FontSet> FontSet::load(std::vector<std::string> folders) {
    if (folders.empty()) folders = {"/usr/share/fonts/opentype/inter", "/usr/share/fonts/truetype/noto"};
    auto impl = std::make_unique<Impl>();
    impl->inter = true;
    for (std::size_t i = 0; i < kInterFiles.size(); ++i) {
        impl->of_face[i] = impl->open(find_file(folders, kInterFiles[i]));
        if (impl->of_face[i] < 0) impl->inter = false;
    }
    impl->fallback = impl->open(find_file(folders, kNotoFile));
    if (impl->fallback < 0 && !impl->inter) {
        return core::unexpected(core::ErrorCode::FileMissing,
                                "neither Inter nor Noto Sans is installed, so no text can be shown; install the "
                                "package fonts-inter",
                                folders.front());
    }
    for (int& font : impl->of_face) {
        if (font < 0) font = impl->fallback >= 0 ? impl->fallback : 0;
    }
    return FontSet(std::move(impl));
}

bool FontSet::has_inter() const {
    return impl_->inter;
}

const ShapedText& FontSet::shape(const std::string& text, const TextStyle& style) const {
    auto& shaped = impl_->shaped;
    const auto key = std::make_tuple(text, style.face, style.size_px, style.tracking_em);
    if (const auto found = shaped.find(key); found != shaped.end()) return found->second;
    if (shaped.size() >= kRemembered) shaped.clear();
    ShapedText line;
    const bool complete = impl_->shape_with(impl_->of_face[static_cast<std::size_t>(style.face)], text, style, line);
    if (!complete && impl_->fallback >= 0) {
        ShapedText other;
        if (impl_->shape_with(impl_->fallback, text, style, other)) line = std::move(other);
    }
    return shaped.emplace(key, std::move(line)).first->second;
}

std::string FontSet::cut(const std::string& text, const TextStyle& style, double limit_px) const {
    if (width_px(text, style) <= limit_px) return text;
    std::string head = text;
    while (!head.empty()) {
        while (!head.empty() && (static_cast<unsigned char>(head.back()) & 0xC0U) == 0x80U) head.pop_back();
        if (!head.empty()) head.pop_back();
        while (!head.empty() && head.back() == ' ') head.pop_back();
        if (width_px(head + "…", style) <= limit_px) break;
    }
    return head + "…";
}

std::vector<std::string> FontSet::wrap(const std::string& text, const TextStyle& style, double limit_px) const {
    std::vector<std::string> lines;
    std::string line;
    std::size_t at = 0;
    while (at <= text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        std::string longer = line;
        if (!line.empty()) longer += ' ';
        longer += word;
        if (!line.empty() && width_px(longer, style) > limit_px) {
            lines.push_back(line);
            line = word;
        } else {
            line = longer;
        }
        at = end + 1;
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

GlyphImage FontSet::rasterise(int font, std::uint32_t glyph, double size_px, int phase) const {
    GlyphImage image;
    FT_Face face = impl_->fonts[static_cast<std::size_t>(font)].face;
    FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(std::lround(size_px * 64)), 72, 72);
    if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) return image;
    if (face->glyph->format == FT_GLYPH_FORMAT_OUTLINE) FT_Outline_Translate(&face->glyph->outline, phase * 16, 0);
    if (FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) != 0) return image;
    const FT_Bitmap& bitmap = face->glyph->bitmap;
    image.coverage = core::GrayImage(static_cast<int>(bitmap.width), static_cast<int>(bitmap.rows));
    for (int y = 0; y < image.coverage.height; ++y) {
        const unsigned char* row = bitmap.buffer + y * bitmap.pitch;
        for (int x = 0; x < image.coverage.width; ++x) image.coverage.at(x, y) = row[x];
    }
    image.left = face->glyph->bitmap_left;
    image.top = -face->glyph->bitmap_top;
    return image;
}

}  // namespace ui
