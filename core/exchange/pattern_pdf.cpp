#include <cairo-pdf.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "core/exchange/pattern_files.hpp"

namespace core {
namespace {

using Style = SheetLine::Style;

constexpr double kPoint_mm = 25.4 / 72.0;
constexpr double kCross_mm = 5.0;

cairo_status_t append(void* target, const unsigned char* bytes, unsigned int count) {
    static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(bytes), count);  // NOLINT: cairo's bytes
    return CAIRO_STATUS_SUCCESS;
}

struct Pages {
    double step_x, step_y;  // from one page's corner to the next one's
    int columns, rows;
};

/// What a page shows is its paper without margins; a page's step is less by the overlap.
Pages pages_of(const PatternSheet& sheet, const PaperSize& paper) {
    const double x = paper.width_mm - 2.0 * kPageMargin_mm - kPageOverlap_mm,
                 y = paper.height_mm - 2.0 * kPageMargin_mm - kPageOverlap_mm;
    const auto count = [](double size, double step) {
        return std::max(1, static_cast<int>(std::ceil((size - kPageOverlap_mm) / step - 1e-9)));
    };
    return {x, y, count(sheet.width_mm, x), count(sheet.height_mm, y)};
}

/// Whether a segment comes into a box, by halves of the plane (Liang and Barsky).
bool enters(Point a, Point b, Point low, Point high) {
    double from = 0.0, to = 1.0;
    const Point d = b - a;
    for (const auto& [start, step, least, most] :
         {std::array{a.x, d.x, low.x, high.x}, std::array{a.y, d.y, low.y, high.y}}) {
        if (step == 0.0) {
            if (start < least || start > most) return false;
            continue;
        }
        const double t = (least - start) / step, u = (most - start) / step;
        from = std::max(from, std::min(t, u));
        to = std::min(to, std::max(t, u));
    }
    return from <= to;
}

bool anything_on(const PatternSheet& sheet, Point low, Point high) {
    for (const SheetLine& line : sheet.lines)
        for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i)
            if (enters(line.points[i], line.points[(i + 1) % line.points.size()], low, high)) return true;
    return std::any_of(sheet.texts.begin(), sheet.texts.end(), [&](const SheetText& t) {
        return t.at.x > low.x && t.at.x < high.x && t.at.y > low.y && t.at.y < high.y;
    });
}

void set_look(cairo_t* cr, Style style) {
    const double width = style == Style::Cut || style == Style::Fold ? 0.5 : style == Style::Notch ? 0.6 : 0.3;
    cairo_set_line_width(cr, width);
    cairo_set_line_cap(cr, style == Style::Fold ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    const double sew[] = {4.0, 2.0}, fold[] = {0.5, 2.0};  // NOLINT: cairo takes arrays
    if (style == Style::Sew) {
        cairo_set_dash(cr, sew, 2, 0.0);
    } else if (style == Style::Fold) {
        cairo_set_dash(cr, fold, 2, 0.0);
    } else {
        cairo_set_dash(cr, nullptr, 0, 0.0);
    }
}

void write_text(cairo_t* cr, const SheetText& text) {
    cairo_set_font_size(cr, text.height_mm);
    cairo_move_to(cr, text.at.x, text.at.y);
    cairo_show_text(cr, text.text.c_str());
}

void draw_sheet(cairo_t* cr, const PatternSheet& sheet) {
    for (const SheetLine& line : sheet.lines) {
        set_look(cr, line.style);
        for (const Point p : line.points) cairo_line_to(cr, p.x, p.y);
        if (line.closed) cairo_close_path(cr);
        cairo_stroke(cr);
    }
    for (const SheetText& text : sheet.texts) write_text(cr, text);
}

/// In sheet coordinates: a cross at each corner of the overlap, and the page's name.
void draw_marks(cairo_t* cr, Point low, const Pages& pages, int row, int column) {
    set_look(cr, Style::Frame);
    const double half = 0.5 * kPageOverlap_mm;
    for (const double x : {low.x + half, low.x + half + pages.step_x})
        for (const double y : {low.y + half, low.y + half + pages.step_y}) {
            cairo_move_to(cr, x - 0.5 * kCross_mm, y);
            cairo_line_to(cr, x + 0.5 * kCross_mm, y);
            cairo_move_to(cr, x, y - 0.5 * kCross_mm);
            cairo_line_to(cr, x, y + 0.5 * kCross_mm);
            cairo_stroke(cr);
        }
    const std::string name = "row " + std::to_string(row + 1) + " of " + std::to_string(pages.rows) + ", column " +
                             std::to_string(column + 1) + " of " + std::to_string(pages.columns);
    write_text(cr, {{low.x + half + 4.0, low.y + half + pages.step_y - 1.5}, 3.0, name});
}

}  // namespace

Result<std::string> sheet_pdf(const PatternSheet& sheet, const PaperSize& paper) {
    std::string bytes;
    const Pages pages = pages_of(sheet, paper);
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
        cairo_pdf_surface_create_for_stream(append, &bytes, paper.width_mm / kPoint_mm, paper.height_mm / kPoint_mm),
        cairo_surface_destroy);
    cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    const std::unique_ptr<cairo_t, void (*)(cairo_t*)> cr(cairo_create(surface.get()), cairo_destroy);
    cairo_select_font_face(cr.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    const double wide = pages.step_x + kPageOverlap_mm, high = pages.step_y + kPageOverlap_mm;
    for (int row = 0; row < pages.rows; ++row)
        for (int column = 0; column < pages.columns; ++column) {
            const Point low{column * pages.step_x, row * pages.step_y};
            if (!anything_on(sheet, low, low + Point{wide, high})) continue;
            cairo_save(cr.get());
            cairo_scale(cr.get(), 1.0 / kPoint_mm, 1.0 / kPoint_mm);
            cairo_translate(cr.get(), kPageMargin_mm - low.x, kPageMargin_mm - low.y);
            cairo_rectangle(cr.get(), low.x, low.y, wide, high);
            cairo_clip(cr.get());
            draw_sheet(cr.get(), sheet);
            draw_marks(cr.get(), low, pages, row, column);
            cairo_restore(cr.get());
            cairo_show_page(cr.get());
        }
    cairo_surface_finish(surface.get());
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS || cairo_status(cr.get()) != CAIRO_STATUS_SUCCESS)
        return unexpected(ErrorCode::WriteFailed, "The pages of the pattern could not be made.");
    return bytes;
}

}  // namespace core
