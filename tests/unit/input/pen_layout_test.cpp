#include "input/parse/pen_layout.hpp"

#include <catch2/catch.hpp>

#include "../../support/hex_bytes.hpp"

using input::PenLayout;
using input::PenReport;
using input::PenTool;
using support::hex_bytes;

namespace {

std::vector<PenLayout> pens_of(const std::vector<std::uint8_t>& bytes) {
    const auto descriptor = input::parse_report_descriptor(bytes);
    REQUIRE(descriptor);
    return input::find_pens(*descriptor);
}

PenReport decoded(const PenLayout& layout, std::string_view bytes) {
    PenReport report;
    REQUIRE(layout.decode(hex_bytes(bytes), report));
    return report;
}

}  // namespace

TEST_CASE("a generic pen decodes by its descriptor", "[pen_layout]") {
    const auto pens = pens_of(support::generic_pen_descriptor());
    REQUIRE(pens.size() == 1);
    const PenLayout& pen = pens[0];
    CHECK(pen.report_id == 7);
    CHECK(pen.bytes == 10);
    CHECK(pen.reports_range());
    CHECK(*pen.axes.width_mm() == Approx(254.0));
    CHECK(*pen.axes.height_mm() == Approx(152.4));

    const PenReport down = decoded(pen, "07 13 10 27 20 4e ff 1f 0a f6");
    CHECK(down.in_range);
    CHECK(down.tip);
    CHECK(down.buttons == input::kBarrel1);
    CHECK(down.x == 10000);
    CHECK(down.y == 20000);
    CHECK(down.pressure == 8191);
    CHECK(down.tilt_x == 10);
    CHECK(down.tilt_y == -10);
    CHECK(down.tool == PenTool::Pen);

    CHECK(decoded(pen, "07 18 00 00 00 00 00 00 00 00").tool == PenTool::Eraser);
    CHECK_FALSE(decoded(pen, "07 18 00 00 00 00 00 00 00 00").tip);
    CHECK(decoded(pen, "07 14 00 00 00 00 00 00 00 00").tip);
    CHECK(decoded(pen, "07 30 00 00 00 00 00 00 00 00").buttons == input::kBarrel2);
    CHECK_FALSE(decoded(pen, "07 00 00 00 00 00 00 00 00 00").in_range);
}

TEST_CASE("reports of another kind or length are not decoded", "[pen_layout]") {
    const auto pens = pens_of(support::generic_pen_descriptor());
    PenReport report;
    report.x = 77;
    CHECK_FALSE(pens[0].decode(hex_bytes("08 13 10 27 20 4e ff 1f 0a f6"), report));
    CHECK_FALSE(pens[0].decode(hex_bytes("07 13 10 27"), report));
    CHECK_FALSE(pens[0].decode({}, report));
    CHECK(report.x == 77);
}

TEST_CASE("an eraser bit without an invert bit is the second button", "[pen_layout]") {
    const auto pens = pens_of(hex_bytes(
        "05 0d 09 02 a1 01 85 07 09 20 a1 00 09 42 09 44 09 45 09 32 15 00 25 01 75 01 95 04 81 02 95 04 81 03 05 01 "
        "09 30 09 31 26 ff 7f 75 10 95 02 81 02 c0 c0"));
    REQUIRE(pens.size() == 1);
    const PenReport r = decoded(pens[0], "07 0c 00 00 00 00");
    CHECK(r.buttons == input::kBarrel2);
    CHECK(r.tool == PenTool::Pen);
    CHECK_FALSE(r.tip);
}

TEST_CASE("Wacom's own usage page is read like the standard one", "[pen_layout]") {
    const auto pens = pens_of(hex_bytes(
        "06 0d ff 09 01 a1 01 85 10 09 20 a1 00 09 42 09 32 15 00 25 01 75 01 95 02 81 02 95 06 81 03 0a 30 01 26 60 "
        "3b 75 10 95 01 65 11 55 0d 35 00 46 e0 05 81 02 0a 31 01 26 1c 25 46 b6 03 81 02 09 30 26 ff 0f 81 02 0a 32 "
        "01 25 3f 75 08 81 02 c0 c0"));
    REQUIRE(pens.size() == 1);
    CHECK(pens[0].axes.pressure->max == 4095);
    CHECK(pens[0].axes.distance->max == 63);
    const PenReport r = decoded(pens[0], "10 02 60 3b 1c 25 00 08 20");
    CHECK(r.x == 15200);
    CHECK(r.y == 9500);
    CHECK(r.distance == 32);
}

TEST_CASE("a mouse with places and pressure is a tablet, one without is a mouse", "[pen_layout]") {
    const std::string head =
        "05 01 09 02 a1 01 85 09 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02 95 05 "
        "81 01 05 01 09 30 09 31 26 ff 7f 75 10 95 02 81 02 ";
    const auto tablet = pens_of(hex_bytes(head + "05 0d 09 30 26 ff 03 95 01 81 02 c0 c0"));
    REQUIRE(tablet.size() == 1);
    CHECK_FALSE(tablet[0].reports_range());
    const PenReport r = decoded(tablet[0], "09 05 01 00 02 00 ff 03");
    CHECK(r.tip);
    CHECK(r.in_range);
    CHECK(r.buttons == input::kBarrel2);
    CHECK(pens_of(hex_bytes(head + "c0 c0")).empty());
}

TEST_CASE("fingers are no pens", "[pen_layout]") {
    CHECK(pens_of(hex_bytes("05 0d 09 04 a1 01 85 01 09 22 a1 02 09 42 15 00 25 01 75 01 95 01 81 02 95 07 81 03 05 01 "
                            "09 30 09 31 26 ff 0f 75 10 95 02 81 02 c0 c0"))
              .empty());
}

TEST_CASE("a descriptor that makes the tablet an inch wide is not believed", "[pen_layout]") {
    const auto pens =
        pens_of(hex_bytes("05 0d 09 02 a1 01 85 07 09 20 a1 00 09 42 09 32 15 00 25 01 75 01 95 02 81 02 95 06 81 03 "
                          "05 01 09 30 55 0d 65 "
                          "13 35 00 46 34 03 26 ff 7f 75 10 95 01 81 02 09 31 46 4d 04 81 02 c0 c0"));
    REQUIRE(pens.size() == 1);
    CHECK_FALSE(pens[0].axes.width_mm());
    CHECK(pens[0].axes.x->max == 32767);
}

TEST_CASE("flags may be listed by usage", "[pen_layout]") {
    const auto pens = pens_of(hex_bytes(
        "05 0d 09 02 a1 01 09 20 a1 00 19 42 29 45 15 01 25 04 75 08 95 02 81 00 05 01 09 30 09 31 15 00 26 ff 7f 75 "
        "10 95 02 81 02 c0 c0"));
    REQUIRE(pens.size() == 1);
    CHECK(decoded(pens[0], "01 03 00 00 00 00").tip);
    CHECK(decoded(pens[0], "00 03 00 00 00 00").buttons == input::kBarrel1);
    CHECK_FALSE(decoded(pens[0], "00 03 00 00 00 00").tip);
}
