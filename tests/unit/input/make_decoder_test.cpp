#include "input/devices/make_decoder.hpp"

#include <catch2/catch.hpp>

#include "../../support/hex_bytes.hpp"
#include "input/devices/uclogic_strings.hpp"

using input::PenAxes;
using input::PenDecoder;
using input::PenReport;
using support::hex_bytes;

namespace {

const input::DeviceFile* file_of(std::uint16_t vendor, std::uint16_t product) {
    input::DeviceIdentity d;
    d.vendor = vendor;
    d.product = product;
    return input::find_device_file(d, input::device_files());
}

struct Decoded {
    PenReport report;
    const PenAxes* axes = nullptr;
};

std::optional<Decoded> decode(PenDecoder& decoder, std::string_view bytes) {
    Decoded d;
    if (!decoder.decode(hex_bytes(bytes), d.report, d.axes)) return std::nullopt;
    return d;
}

const std::vector<std::uint8_t> kString200 = hex_bytes("13 03 70 C6 00 06 7C 00 FF 1F D8 13 03 0D 10 01 04 3C 3E");

}  // namespace

TEST_CASE("string 200 and string 100 tell ranges and size", "[make_decoder]") {
    const auto v2 = input::axes_of_string_200(kString200);
    REQUIRE(v2);
    CHECK(v2->x->max == 50800);
    CHECK(v2->y->max == 31750);
    CHECK(v2->pressure->max == 8191);
    CHECK(*v2->width_mm() == Approx(254.0));
    CHECK(v2->tilt_x->max == 60);
    const auto v1 = input::axes_of_string_100(hex_bytes("0C 03 98 B2 1A 72 03 00 FF 07 D8 13"));
    REQUIRE(v1);
    CHECK(v1->x->max == 45720);
    CHECK(v1->y->max == 29210);
    CHECK(v1->pressure->max == 2047);
    CHECK_FALSE(v1->tilt_x);
    CHECK_FALSE(input::axes_of_string_100(hex_bytes("0E 03 54 00 61 00 62 00 6C 00 65 00 74 00")));  // words
    CHECK_FALSE(input::axes_of_string_200(hex_bytes("C8 0E 00 20 65 01 00 08 FD 08 00 08")));
    CHECK_FALSE(input::axes_of_string_200(hex_bytes("13 03 70")));
    CHECK_FALSE(input::axes_of_string_200({}));
    CHECK(input::text_of_string(hex_bytes("0A 03 48 00 69 00 E9 00 21 01")) == "Hi??");
}

TEST_CASE("a Huion tablet: ranges from its string, range bit, split coordinates, turned tilt", "[make_decoder]") {
    const auto decoder = make_decoder(file_of(0x256c, 0x006d), std::nullopt, {{200, kString200}});
    REQUIRE(decoder);
    const auto hover = decode(*decoder, "08 80 FA 52 52 3C 00 00 00 00 3C ED");
    REQUIRE(hover);
    CHECK(hover->report.in_range);
    CHECK_FALSE(hover->report.tip);
    CHECK(hover->report.x == 0x52FA);
    CHECK(hover->report.tilt_x == 60);
    CHECK(hover->report.tilt_y == 19);
    CHECK(hover->axes->x->max == 50800);
    const auto far = decode(*decoder, "08 81 00 00 00 00 FF 1F 01 00 00 00");
    REQUIRE(far);
    CHECK(far->report.x == 0x10000);
    CHECK(far->report.tip);
    CHECK_FALSE(decode(*decoder, "08 E0 01 01 01 00 00 00 00 00 DD 10"));  // keys of the frame
    CHECK_FALSE(decode(*decoder, "08 00 00 00 00 00 00 00 00 00 00 00")->report.in_range);
    CHECK(decoder->name() == "fields");
}

TEST_CASE("older UC-Logic pens have the range bit upside down", "[make_decoder]") {
    const auto decoder = make_decoder(file_of(0x5543, 0x0081), std::nullopt,
                                      {{100, hex_bytes("0E 03 40 9C C0 5D 03 00 FF 07 A0 0F 08 00")}});
    REQUIRE(decoder);
    CHECK(decode(*decoder, "07 81 10 00 20 00 FF 07")->report.tip);
    CHECK(decode(*decoder, "07 80 10 00 20 00 00 00")->report.in_range);
    CHECK_FALSE(decode(*decoder, "07 C0 10 00 20 00 00 00")->report.in_range);
    CHECK_FALSE(decode(*decoder, "07 E0 01 01 10 00 00 00"));
    CHECK(*decoder->axes().width_mm() == Approx(254.0));
}

TEST_CASE("an XP-Pen leaves with 0xC0 and has ten or twelve bytes", "[make_decoder]") {
    const auto decoder =
        make_decoder(file_of(0x28bd, 0x0934), std::nullopt, {{100, hex_bytes("0C 03 38 63 03 3E 08 00 FF 1F EC 09")}});
    REQUIRE(decoder);
    const auto ten = decode(*decoder, "02 A1 10 00 20 00 FF 1F C4 3C");
    REQUIRE(ten);
    CHECK(ten->report.tip);
    CHECK(ten->report.tilt_x == -60);
    CHECK(ten->report.tilt_y == 60);
    CHECK(ten->axes->x->max == 25400);
    CHECK(decode(*decoder, "02 A4 10 00 20 00 00 00 00 00")->report.buttons == input::kBarrel2);
    CHECK_FALSE(decode(*decoder, "02 C0 10 00 20 00 00 00 00 00")->report.in_range);
    CHECK_FALSE(decode(*decoder, "02 F0 01 00 00 00 00 00 00 00"));
    CHECK(decode(*decoder, "02 A0 10 00 20 00 00 00 00 00 01 02")->report.x == 0x10010);
    CHECK(decode(*decoder, "02 A0 10 00 20 00 00 00 00 00 01 02")->report.y == 0x20020);
}

TEST_CASE("Waltop counts its buttons, and pressure with a button is noise", "[make_decoder]") {
    const auto decoder = make_decoder(file_of(0x172f, 0x0037), std::nullopt, {});
    REQUIRE(decoder);
    const auto tip = decode(*decoder, "10 11 10 00 20 00 50 01");
    CHECK(tip->report.tip);
    CHECK(tip->report.pressure == 0x150);
    const auto upper = decode(*decoder, "10 13 10 00 20 00 FF 03");
    CHECK(upper->report.buttons == input::kBarrel2);
    CHECK_FALSE(upper->report.tip);
    CHECK(upper->report.pressure == 0);
    CHECK_FALSE(decode(*decoder, "10 00 10 00 20 00 00 00")->report.in_range);
}

TEST_CASE("Wacom's Graphire and Bamboo tablets", "[make_decoder]") {
    const auto graphire = make_decoder(file_of(0x056a, 0x0015), std::nullopt, {});
    REQUIRE(graphire);
    const auto pen = decode(*graphire, "02 83 E0 04 4C 04 34 01");
    CHECK(pen->report.tip);
    CHECK(pen->report.buttons == input::kBarrel1);
    CHECK(pen->report.x == 0x4E0);
    CHECK(pen->report.pressure == 0x134);
    CHECK(decode(*graphire, "02 A0 E0 04 4C 04 00 00")->report.tool == input::PenTool::Eraser);
    CHECK_FALSE(decode(*graphire, "02 00 E0 04 4C 04 00 00")->report.in_range);
    CHECK_FALSE(decode(*graphire, "02 C0 E0 04 4C 04 00 00"));  // the mouse

    const auto bamboo = make_decoder(file_of(0x056a, 0x00d1), std::nullopt, {});
    REQUIRE(bamboo);
    const auto hover = decode(*bamboo, "02 20 10 27 88 13 00 00 14");
    CHECK(hover->report.in_range);
    CHECK(hover->report.x == 10000);
    CHECK(hover->report.distance == 20);
    CHECK(decode(*bamboo, "02 29 10 27 88 13 FF 03 00")->report.tool == input::PenTool::Eraser);
    CHECK(decode(*bamboo, "02 29 10 27 88 13 FF 03 00")->report.pressure == 1023);
}

TEST_CASE("Wacom's Intuos: a pen comes, draws, turns and leaves", "[make_decoder]") {
    const auto decoder = make_decoder(file_of(0x056a, 0x0027), std::nullopt, {});
    REQUIRE(decoder);
    CHECK(decoder->name() == "wacom-intuos");
    CHECK_FALSE(decode(*decoder, "02 E1 10 00 20 00 80 40 40 00"));  // nobody was announced
    CHECK_FALSE(decode(*decoder, "02 C2 80 21 23 45 67 81 40 00"));
    const auto draws = decode(*decoder, "02 A2 12 34 23 45 80 7F C0 0B");
    REQUIRE(draws);
    CHECK(draws->report.in_range);
    CHECK(draws->report.x == (0x1234 << 1 | 1));
    CHECK(draws->report.y == (0x2345 << 1 | 1));
    CHECK(draws->report.distance == 2);
    CHECK(draws->report.pressure == (0x80 << 3 | (0x7F & 0xC0) >> 5));
    CHECK(draws->report.tip);
    CHECK(draws->report.buttons == input::kBarrel1);
    CHECK(draws->report.tilt_x == (((0x7F << 1) & 0x7E) | 1) - 64);
    CHECK(draws->report.tilt_y == 0x40 - 64);
    CHECK(draws->report.serial == 0x12345678);
    CHECK(draws->report.tool_id == 0x140802);
    CHECK(draws->report.tool == input::PenTool::Pen);
    const auto turns = decode(*decoder, "02 AA 12 34 23 45 10 00 00 00");
    REQUIRE(turns);
    CHECK(turns->report.rotation == 450 - (0x10 << 3) / 2);
    CHECK(turns->report.pressure == draws->report.pressure);
    CHECK_FALSE(decode(*decoder, "02 80 00 00 00 00 00 00 00 00")->report.in_range);
    CHECK_FALSE(decode(*decoder, "02 A0 12 34 23 45 80 7F C0 0B"));
    CHECK_FALSE(decode(*decoder, "02 A0 12"));
    CHECK_FALSE(decode(*decoder, "03 A0 12 34 23 45 80 7F C0 0B"));
}

TEST_CASE("the first Intuos tablets see two pens at once", "[make_decoder]") {
    const auto decoder = make_decoder(file_of(0x056a, 0x0043), std::nullopt, {});
    REQUIRE(decoder);
    CHECK_FALSE(decode(*decoder, "02 C2 82 21 23 45 67 80 00 00"));
    const auto first = decode(*decoder, "02 A0 12 34 23 45 80 7F C0 0B");
    REQUIRE(first);
    CHECK(first->report.x == 0x1234);
    CHECK(first->report.pressure == 0x201);
    CHECK_FALSE(decode(*decoder, "02 A1 12 34 23 45 80 7F C0 0B"));  // the second was not announced
    CHECK_FALSE(decode(*decoder, "02 C3 82 A1 23 45 67 80 00 00"));
    CHECK(decode(*decoder, "02 A1 12 34 23 45 80 7F C0 0B")->report.tool == input::PenTool::Eraser);
    CHECK(decode(*decoder, "02 A0 12 34 23 45 80 7F C0 0B")->report.tool == input::PenTool::Pen);
    CHECK_FALSE(decode(*decoder, "02 81 00 00 00 00 00 00 00 00")->report.in_range);
    CHECK(decode(*decoder, "02 A0 12 34 23 45 80 7F C0 0B")->report.in_range);
}

TEST_CASE("what a Wacom pen's number says", "[make_decoder]") {
    CHECK(input::wacom_tool(0x802) == input::PenTool::Pen);
    CHECK(input::wacom_tool(0x80a) == input::PenTool::Eraser);
    CHECK(input::wacom_tool(0x14080a) == input::PenTool::Eraser);
    CHECK(input::wacom_tool(0x902) == input::PenTool::Airbrush);
    CHECK(input::wacom_tool(0x90a) == input::PenTool::Eraser);
    CHECK(input::wacom_tool(0x006) == input::PenTool::Lens);
    CHECK(input::wacom_tool(0x007) == input::PenTool::Mouse);
}

TEST_CASE("without file and descriptor there is no decoder", "[make_decoder]") {
    CHECK(input::make_decoder(nullptr, std::nullopt, {}) == nullptr);
    const auto descriptor = input::parse_report_descriptor(support::generic_pen_descriptor());
    REQUIRE(descriptor);
    const auto generic = input::make_decoder(nullptr, *descriptor, {});
    REQUIRE(generic);
    CHECK(generic->name() == "descriptor");
    CHECK(generic->reports_range());
}
