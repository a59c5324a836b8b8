#include "core/garment/pattern/pattern.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/exchange/pattern_files.hpp"
#include "core/garment/pattern/allowance.hpp"
#include "support/simple_body.hpp"
#include "support/temporary_folder.hpp"

using core::DesignStep;
using core::PatternSide;
using core::Point;
using Kind = DesignStep::Kind;
using Tool = core::DrawingTool::Kind;

namespace {

core::SketchStroke stroke(const char* view, Tool tool, double offset, std::vector<Point> points) {
    return {{*core::named_view(view), {tool, offset}, std::move(points)}};
}

DesignStep line(const char* name, core::SketchStroke drawn) {
    DesignStep step;
    step.name = name;
    step.stroke = std::move(drawn);
    return step;
}

DesignStep region(const char* name, std::vector<std::string> lines) {
    DesignStep step;
    step.kind = Kind::Region;
    step.name = name;
    step.lines = std::move(lines);
    return step;
}

std::vector<Point> arc(double radius, double sign) {
    std::vector<Point> points;
    for (int k = 0; k <= 40; ++k) {
        const double angle = 0.5 * 3.141592653589793 * k / 40;
        points.push_back({radius * std::cos(angle), sign * radius * std::sin(angle)});
    }
    return points;
}

/// A round tube about a post: front and back, both mirrored at the middle.
core::Design tube() {
    core::Design design;
    design.name = "tube & co";
    design.body = *core::measures_of_size("38");
    design.steps = {line("top", stroke("top", Tool::PlaneXZ, 40, arc(14, -1))),
                    line("top_back", stroke("top", Tool::PlaneXZ, 40, arc(14, 1))),
                    line("hem", stroke("top", Tool::PlaneXZ, 20, arc(14, -1))),
                    line("hem_back", stroke("top", Tool::PlaneXZ, 20, arc(14, 1))),
                    line("side", stroke("front", Tool::PlaneXY, 0, {{14, 40}, {14, 20}})),
                    line("middle", stroke("left", Tool::PlaneYZ, 0, {{-14, 40}, {-14, 20}})),
                    line("middle_back", stroke("left", Tool::PlaneYZ, 0, {{14, 40}, {14, 20}})),
                    region("front", {"top", "side", "hem", "middle"}),
                    region("back", {"top_back", "side", "hem_back", "middle_back"})};
    return design;
}

const core::Pattern& tube_pattern() {
    static const core::Pattern pattern = [] {
        const auto garment = core::make_garment(tube(), support::post(10.0, 60.0));
        return *core::make_pattern(tube(), *garment, {});
    }();
    return pattern;
}

double area(const core::Polygon& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) sum += 0.5 * core::cross(ring[i], ring[(i + 1) % ring.size()]);
    return sum;
}

}  // namespace

TEST_CASE("a tube becomes two rectangles on the fold, sewn at the sides", "[pattern]") {
    const core::Pattern& pattern = tube_pattern();
    CHECK(pattern.faults.empty());
    REQUIRE(pattern.pieces.size() == 2);
    for (const core::PatternPiece& piece : pattern.pieces) {
        CHECK(piece.on_fold);
        CHECK(piece.copies == 1);
        REQUIRE(piece.sides.size() == 4);
        CHECK(piece.largest_strain < 0.005);
        int folds = 0, hems = 0, seams = 0;
        for (const PatternSide& side : piece.sides) {
            folds += side.kind == PatternSide::Kind::Fold ? 1 : 0;
            hems += side.kind == PatternSide::Kind::Hem ? 1 : 0;
            seams += side.kind == PatternSide::Kind::Seam ? 1 : 0;
            CHECK(core::line_length_cm(side.line) == Approx(side.in_space_cm).epsilon(0.005));
        }
        CHECK(folds == 1);
        CHECK(hems == 2);
        CHECK(seams == 1);
        // grain runs upwards, inside
        CHECK(piece.grain[1].y - piece.grain[0].y > 8.0);
        CHECK(piece.grain[1].x == Approx(piece.grain[0].x));
        CHECK(piece.notches.size() == 1);
        // 22 x 20 cm; 1 cm beyond the seam, 3 cm beyond the hems, nothing beyond the fold
        CHECK(area(piece.cut_line) == Approx(23.0 * 26.0).epsilon(0.02));
    }
    REQUIRE(pattern.seams.size() == 1);
    const core::PatternSeam& seam = pattern.seams[0];
    CHECK_FALSE(seam.mirrored);
    CHECK(pattern.pieces[seam.piece_a].sides[seam.side_a].name == "side");
    CHECK(pattern.pieces[seam.piece_a].sides[seam.side_a].edges ==
          pattern.pieces[seam.piece_b].sides[seam.side_b].edges);
    CHECK(seam.mismatch() < 0.005);
    // both notches are as high: they meet when sewn
    CHECK(pattern.pieces[0].notches[0].at.y == Approx(pattern.pieces[1].notches[0].at.y).margin(0.05));
}

TEST_CASE("allowances: corners mitred, hollow places without loops", "[pattern]") {
    const core::Polygon square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    const core::Polygon wider = core::moved_outward(square, {1, 2, 1, 0});
    CHECK(area(wider) == Approx(12.0 * 12.0));
    const core::Polygon same = core::moved_outward(square, {0, 0, 0, 0});
    CHECK(area(same) == Approx(100.0));
    // a narrow notch cut into the side closes when moved by more than half its width
    const core::Polygon notched{{0, 0}, {10, 0}, {10.4, 4.8}, {5, 4.9}, {5, 5.1}, {10.4, 5.2}, {10, 10}, {0, 10}};
    const core::Polygon closed = core::moved_outward(notched, std::vector<double>(8, 1.0));
    CHECK(area(closed) == Approx(147.0).epsilon(0.02));
    for (const Point p : closed) CHECK(core::distance(p, {5, 5}) > 5.0);
    // a spike is cut off
    const core::Polygon spike{{0, 0}, {20, 0.5}, {0, 1}};
    for (const Point p : core::moved_outward(spike, {1, 1, 1})) CHECK(p.x < 23.0);
}

TEST_CASE("files of a pattern say the same in one unit", "[pattern]") {
    const core::PatternSheet sheet = core::lay_out_sheet(tube_pattern(), 140.0);
    CHECK(sheet.width_mm > 460.0);  // both pieces side by side
    CHECK(sheet.width_mm < 700.0);
    const std::string svg = core::sheet_svg(sheet);
    CHECK(svg.find("<path class=\"frame\" stroke-width=\"0.2\" d=\"M5.000,5.000 L105.000,5.000 L105.000,105.000 "
                   "L5.000,105.000 Z\"/>") != std::string::npos);
    CHECK(svg.find("tube &amp; co") != std::string::npos);
    CHECK(svg.find("cut 1 on the fold") != std::string::npos);
    const std::string dxf = core::pattern_dxf(tube_pattern(), sheet);
    CHECK(dxf.find("\nBLOCK\n8\n1\n2\nfront\n") != std::string::npos);
    CHECK(dxf.substr(dxf.size() - 6) == "0\nEOF\n");
    const auto json = nlohmann::json::parse(core::pattern_json(tube_pattern()));
    REQUIRE(json["pieces"].size() == 2);
    CHECK(json["seams"][0]["mismatch"].get<double>() < 0.005);
    CHECK(json["pieces"][0]["cut_line"].size() == tube_pattern().pieces[0].cut_line.size());
    CHECK(core::strain_svg(tube_pattern(), sheet).find("<circle") == std::string::npos);
}

TEST_CASE("pages cover the sheet, empty ones are left out, the same bytes each time", "[pattern]") {
    const core::PatternSheet sheet = core::lay_out_sheet(tube_pattern(), 140.0);
    const auto pages = [&](const core::PaperSize& paper) {
        const std::string pdf = *core::sheet_pdf(sheet, paper);
        CHECK(pdf.substr(0, 5) == "%PDF-");
        CHECK(pdf == *core::sheet_pdf(sheet, paper));
        std::size_t count = 0;
        for (std::size_t at = pdf.find("/MediaBox"); at != std::string::npos; at = pdf.find("/MediaBox", at + 1))
            ++count;
        return count;
    };
    const std::size_t a4 = pages(core::kA4), a3 = pages(core::kA3);
    CHECK(a4 >= 4);
    CHECK(a3 < a4);
    core::PatternSheet one;
    one.width_mm = 150.0, one.height_mm = 2000.0;
    one.lines.push_back({core::SheetLine::Style::Cut, {{10, 10}, {20, 20}}, false});
    one.lines.push_back({core::SheetLine::Style::Cut, {{10, 1990}, {20, 1980}}, false});
    const std::string pdf = *core::sheet_pdf(one, core::kLetter);
    CHECK(pdf.find("/Count 2") != std::string::npos);
}

TEST_CASE("patterns are written into a folder; what cannot be is named", "[pattern]") {
    const support::TemporaryFolder folder;
    const auto files = core::write_pattern_folder(folder.path("out"), tube_pattern());
    REQUIRE(files);
    CHECK(files->size() == 7);
    for (const std::string& file : *files) CHECK(std::filesystem::file_size(file) > 500);
    CHECK(core::write_pattern_folder("/proc/nowhere", tube_pattern()).error().code == core::ErrorCode::WriteFailed);
    core::PatternOptions wrong;
    wrong.seam_allowance_cm = -1.0;
    CHECK_FALSE(core::make_pattern(tube(), {core::Network(), {}, {}}, wrong));
    CHECK_FALSE(core::make_pattern(tube(), {core::Network(), {}, {}}, {}));
}
