#include "core/exchange/svg_reader.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "core/exchange/svg_path.hpp"

namespace {

core::Result<core::Drawing> svg(const std::string& body) {
    return core::parse_svg("<svg xmlns=\"http://www.w3.org/2000/svg\">" + body + "</svg>");
}

/// "x,y x,y | x,y": strokes with rounded coordinates.
std::string written(const core::Result<core::Drawing>& drawing) {
    if (!drawing) return drawing.error().message;
    std::string text;
    for (const core::Stroke& stroke : drawing->strokes) {
        if (!text.empty()) text += " |";
        for (const core::PenSample& s : stroke.samples) {
            text +=
                (text.empty() ? "" : " ") + std::to_string(std::lround(s.x)) + "," + std::to_string(std::lround(s.y));
        }
    }
    return text;
}

std::string path(const std::string& data) {
    return written(svg("<path d=\"" + data + "\"/>"));
}

core::Point end_of(const std::string& data) {
    const auto chains = core::parse_svg_path(data);
    REQUIRE(chains);
    return chains->back().back();
}

}  // namespace

TEST_CASE("straight path commands, absolute and relative", "[svg_reader]") {
    CHECK(path("M1 2 L3 4 H5 V6") == "1,2 3,4 5,4 5,6");
    CHECK(path("m1,2 l2,2 h2 v2") == "1,2 3,4 5,4 5,6");
    CHECK(path("M1 2 3 4 5 6") == "1,2 3,4 5,6");
    CHECK(path("m1 2 3 4-5-6") == "1,2 4,6 -1,0");
    CHECK(path("M0 0 4 0 4 4Z") == "0,0 4,0 4,4 0,0");
    CHECK(path("M0 0H4Zm10 10h4z") == "0,0 4,0 0,0 | 10,10 14,10 10,10");
    CHECK(path("M1 1H4ZL9 9") == "1,1 4,1 1,1 | 1,1 9,9");
    CHECK(path("M.5.5.6.6e1") == "1,1 1,6");
}

TEST_CASE("curves pass where they should", "[svg_reader]") {
    const auto cubic = core::parse_svg_path("M0 0C0 10 10 10 10 0");
    REQUIRE(cubic);
    REQUIRE((*cubic)[0].size() == 1 + core::kChordsPerCurve);
    CHECK((*cubic)[0][core::kChordsPerCurve / 2].x == Approx(5.0));
    CHECK((*cubic)[0][core::kChordsPerCurve / 2].y == Approx(7.5));
    const auto smooth = core::parse_svg_path("M0 0C0 10 10 10 10 0S20 -10 20 0");
    CHECK((*smooth)[0][core::kChordsPerCurve * 3 / 2].y == Approx(-7.5));
    const auto quadratic = core::parse_svg_path("M0 0q5 10 10 0t10 0");
    CHECK((*quadratic)[0][core::kChordsPerCurve / 2].y == Approx(5.0));
    CHECK((*quadratic)[0][core::kChordsPerCurve * 3 / 2].y == Approx(-5.0));
    CHECK(end_of("M5 5c1 1 2 2 3 3") == core::Point{8, 8});
}

TEST_CASE("arcs keep to their circle", "[svg_reader]") {
    const auto half = core::parse_svg_path("M-10 0A10 10 0 0 1 10 0");
    REQUIRE(half);
    double highest = 0.0;
    for (const core::Point p : (*half)[0]) {
        CHECK(core::length(p) == Approx(10.0));
        highest = std::min(highest, p.y);
    }
    CHECK(highest == Approx(-10.0));
    CHECK(end_of("M0 0a5 5 0 1110 0") == core::Point{10, 0});    // flags without separators
    CHECK(end_of("M0 0A1 1 0 0 0 10 0") == core::Point{10, 0});  // radii too small are enlarged
    CHECK(path("M0 0A0 5 0 0 1 10 0") == "0,0 10,0");
}

TEST_CASE("basic shapes become their outlines", "[svg_reader]") {
    CHECK(written(svg("<line x1='1' y1='2' x2='3mm' y2='4'/>")) == "1,2 3,4");
    CHECK(written(svg("<polyline points='1,2 3,4 5 6'/>")) == "1,2 3,4 5,6");
    CHECK(written(svg("<polygon points='0,0 4,0 4,4'/>")) == "0,0 4,0 4,4 0,0");
    CHECK(written(svg("<rect x='1' y='1' width='3' height='2'/>")) == "1,1 4,1 4,3 1,3 1,1");
    const auto circle = svg("<circle cx='5' cy='5' r='2'/>");
    REQUIRE(circle);
    CHECK(circle->strokes[0].samples.front().x == circle->strokes[0].samples.back().x);
    CHECK(svg("<ellipse rx='5' ry='2'/>")->strokes[0].samples[16].y == Approx(2.0));
}

TEST_CASE("groups nest and transforms apply from the inside out", "[svg_reader]") {
    CHECK(written(svg("<g transform='translate(10 20)'><g transform='scale(2)'><path d='M0 0L1 1'/></g></g>")) ==
          "10,20 12,22");
    CHECK(written(svg("<path transform='translate(10,0) rotate(90)' d='M1 0L2 0'/>")) == "10,1 10,2");
    CHECK(written(svg("<path transform='rotate(90 1 1)' d='M1 0L2 1'/>")) == "2,1 1,2");
    CHECK(written(svg("<path transform='matrix(1 0 0 -1 0 10)' d='M1 1L2 2'/>")) == "1,9 2,8");
    CHECK(written(svg("<path transform='skewX(45)skewY(0)' d='M0 0L0 5'/>")) == "0,0 5,5");
}

TEST_CASE("what is defined but not drawn is passed over", "[svg_reader]") {
    CHECK(written(svg("<defs><path d='M0 0L1 1'/></defs><path display='none' d='M5 5L6 6'/><path d='M7 7L8 8'/>")) ==
          "7,7 8,8");
}

TEST_CASE("texts that are no SVG drawings are refused with a sentence", "[svg_reader]") {
    CHECK(core::parse_svg("<svg><path").error().message.starts_with("the text is no well-formed XML"));
    CHECK(core::parse_svg("").error().code == core::ErrorCode::BadFormat);
    CHECK(core::parse_svg("<ink/>").error().message == "the XML is no SVG; its first element is not <svg>");
    CHECK(core::parse_svg("<svg/>").error().code == core::ErrorCode::EmptyDrawing);
    const std::string damaged = "a path or shape is damaged or too long; save the drawing again as plain SVG";
    for (const char* data : {"L1 1", "M1", "M1 1 X", "M0 0 A1 1 0 2 0 5 5", "M nan nan", "M1e999 0", "M0 0Z5"}) {
        INFO(data);
        CHECK(path(data) == damaged);
    }
    CHECK(written(svg("<polygon points='1 2 3'/>")) == damaged);
    CHECK(written(svg("<rect width='wide'/>")) == damaged);
    CHECK(written(svg("<g transform='turn(3)'/>")) == "a transform is damaged; save the drawing again as plain SVG");
    CHECK(written(svg("<path transform='scale(1e200)' d='M1 1L2 2'/>")) ==
          "a coordinate is no finite number within ten million; check the file");
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<g>";
    for (int i = 0; i < 100'000; ++i) deep += "</g>";
    CHECK(svg(deep).error().message == "the XML nests deeper than 200 elements; save it flatter");
}
