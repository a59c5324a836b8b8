#include "input/formats/capture.hpp"

#include <linux/input-event-codes.h>

#include <catch2/catch.hpp>

#include "input/formats/text_lines.hpp"

using input::CaptureFormat;

namespace {

std::string fault_of(std::string_view text) {
    const auto capture = input::parse_capture(text);
    return capture ? "" : capture.error().sentence();
}

}  // namespace

TEST_CASE("times are read to the nanosecond", "[capture]") {
    CHECK(input::nanoseconds_of_text("1.010000") == 1'010'000'000);
    CHECK(input::nanoseconds_of_text("0.000001") == 1000);
    CHECK(input::nanoseconds_of_text("1300039392.959569") == 1'300'039'392'959'569'000);
    CHECK(input::nanoseconds_of_text("12") == 12'000'000'000);
    for (const char* wrong : {"", ".", "1.", "-1.0", "1.0000000001", "a", "1.x", "1e3", "99999999999"}) {
        INFO(wrong);
        CHECK_FALSE(input::nanoseconds_of_text(wrong));
    }
}

TEST_CASE("hid-recorder output", "[capture]") {
    const auto c = input::parse_capture(
        "# Some Tablet\nR: 5 05 0d 09 02 c0\nN: Some Tablet\nP: usb-1/input0\nI: 3 256c 006e\nE: 0.500000 3 07 81 00\n"
        "# a comment\nE: 0.504000 3 07 80 00\n");
    REQUIRE(c);
    CHECK(c->format == CaptureFormat::HidRecorder);
    CHECK(c->device.name == "Some Tablet");
    CHECK(input::vendor_product(c->device) == "256c:006e");
    REQUIRE(c->descriptors.size() == 1);
    CHECK(c->descriptors[0].bytes.size() == 5);
    REQUIRE(c->reports.size() == 2);
    CHECK(c->reports[1].time_ns == 504'000'000);
    CHECK(c->reports[1].bytes == std::vector<std::uint8_t>{7, 0x80, 0});
    CHECK(fault_of("R: 5 05 0d\n").starts_with("line 1: R: needs a length"));
    CHECK(fault_of("R: 1 05\nE: x 1 05\n").starts_with("line 2: E: needs a time"));
    CHECK(fault_of("R: 1 05\nI: 3 zz 1\n").starts_with("line 2: I: needs"));
}

TEST_CASE("several devices in one hid-recorder file: the pen's descriptor decides", "[capture]") {
    const auto c = input::parse_capture(
        "D: 0\nR: 4 05 01 09 02\nN: Mouse\nD: 1\nR: 36 05 0d 09 02 a1 01 85 01 09 20 a1 00 09 42 15 00 25 01 75 01 95 "
        "01 "
        "81 02 05 01 09 30 09 31 75 10 95 02 81 02\nN: Pen\nE: 0.1 1 01\n");
    REQUIRE(c);
    CHECK(c->device.name == "Pen");
    CHECK(c->reports[0].interface == 1);
}

TEST_CASE("usbhid-dump output, new and old headings", "[capture]") {
    const auto c = input::parse_capture(
        "003:007:000:DESCRIPTOR         1.500000\n 05 0D\n 09 02\n\n003:007:000:STREAM             1.600000\n 08 80 FA "
        "52\n 52\n\n"
        "001:STREAM 1.700000\n 07 00\n\ngarbage\n003:007:000:STREAM             1.800000\n zz\n");
    REQUIRE(c);
    CHECK(c->format == CaptureFormat::UsbhidDump);
    REQUIRE(c->descriptors.size() == 1);
    CHECK(c->descriptors[0].bytes.size() == 4);
    REQUIRE(c->reports.size() == 2);
    CHECK(c->reports[0].bytes.size() == 5);
    CHECK(c->reports[0].time_ns == 1'600'000'000);
    CHECK(c->reports[1].interface == 1);
    CHECK(c->notes.size() == 2);
    CHECK(fault_of("000:STREAM 1.0\n\n") == "the usbhid-dump output holds no report and no descriptor");
}

TEST_CASE("evemu recordings, with and without description", "[capture]") {
    const auto c = input::parse_capture(
        "# EVEMU 1.3\nN: Pen\nI: 0003 056a 00b9 0110\nP: 01 00\nB: 00 0b 00\nB: 01 00 00 00 00 00 00 00 00 00 00 00 "
        "00\n"
        "A: 00 0 44704 4 0 200\nA: 01 0 27940 4 0\nE: 1.000000 0003 0000 4488\nE: 1.000000 0000 0000 0\n");
    REQUIRE(c);
    CHECK(c->format == CaptureFormat::Evemu);
    CHECK(c->has_evdev_description);
    CHECK(c->evdev.properties[0]);
    CHECK(c->evdev.axes[ABS_X]->resolution == 200);
    CHECK(c->evdev.axes[ABS_Y]->resolution == 0);
    REQUIRE(c->events.size() == 2);
    CHECK(c->events[0].value == 4488);
    const auto bare = input::parse_capture("E: 1.0 0001 0140 1\n");
    REQUIRE(bare);
    CHECK_FALSE(bare->has_evdev_description);
    CHECK(fault_of("# EVEMU 1.3\nE: 1.0 0003 0000\n").starts_with("line 2: E: needs"));
    CHECK(fault_of("# EVEMU 1.3\nA: 00 0 x\n").starts_with("line 2: A: needs"));
}

TEST_CASE("the bits of keys run over several lines", "[capture]") {
    std::string text = "# EVEMU 1.3\nN: x\n";
    for (int i = 0; i < 40; i += 8) text += "B: 01 00 00 00 00 00 00 00 00\n";
    text += "B: 01 01 04 00 00 00 00 00 00\n";  // bytes 40 …: bit 320 and bit 330
    const auto c = input::parse_capture(text);
    REQUIRE(c);
    CHECK(c->evdev.keys[BTN_TOOL_PEN]);
    CHECK(c->evdev.keys[BTN_TOUCH]);
    CHECK(c->evdev.keys.count() == 2);
}

TEST_CASE("libinput record output", "[capture]") {
    const auto c = input::parse_capture(
        "# libinput record\nversion: 1\nndevices: 2\ndevices:\n- node: /dev/input/event3\n  evdev:\n    name: "
        "\"Mouse\"\n"
        "    id: [3, 1, 2, 3]\n    codes:\n      1: [272]\n- node: /dev/input/event9\n  evdev:\n    # Name: Pen\n"
        "    name: \"Wacom Pen\"\n    id: [3, 1386, 855, 272]\n    codes:\n      0: [0, 1] # EV_SYN\n"
        "      1: [320, 321,\n          330] # EV_KEY\n      3: [0, 1] # EV_ABS\n    absinfo:\n"
        "      0: [0, 44800, 0, 0, 200]\n      1: [0, 29600, 0, 0, 200]\n    properties: [0]\n  hid: [\n    0x05, "
        "0x0d,\n"
        "    0x09, 0x02\n  ]\n  udev:\n    properties:\n    - ID_INPUT=1\n  events:\n  # a comment\n  - evdev:\n"
        "    - [  1, 500000,   3,   0,    2000] # EV_ABS / ABS_X\n    - [  1, 500000,   0,   0,       0] # --- "
        "SYN_REPORT\n");
    REQUIRE(c);
    CHECK(c->format == CaptureFormat::LibinputRecord);
    CHECK(c->device.name == "Wacom Pen");
    CHECK(input::vendor_product(c->device) == "056a:0357");
    CHECK(c->evdev.keys[BTN_TOUCH]);
    CHECK(c->evdev.axes[ABS_X]->max == 44800);
    CHECK(c->evdev.axes[ABS_Y]->resolution == 200);
    CHECK(c->evdev.properties[0]);
    CHECK(c->descriptors.at(0).bytes.size() == 4);
    REQUIRE(c->events.size() == 2);
    CHECK(c->events[0].time_ns == 1'500'000'000);
    CHECK(c->events[0].value == 2000);
    const std::string head = "ndevices: 1\ndevices:\n- node: /dev/input/event3\n";
    CHECK(fault_of("ndevices: 0\n") == "the libinput recording holds no device");
    CHECK(fault_of(head + "    - [1, 2, 3]\n").starts_with("line 4: an event needs"));
    CHECK(fault_of(head + "    - [1, 2000000, 3, 0, 0]\n").find("out of range") != std::string::npos);
    CHECK(fault_of(head + "  hid: [\n 0x05, 0x100\n ]\n").find("hid needs bytes") != std::string::npos);
    CHECK(fault_of(head + "  hid: [\n 0x05\n").find("ends inside a list") != std::string::npos);
}

TEST_CASE("older text formats", "[capture]") {
    const auto events = input::parse_capture(
        "/dev/input/event9  1281178415.886711 EV_KEY BTN_DIGI 0x00000001\n/dev/input/event9  1281178415.886728 EV_ABS "
        "ABS_X 0xFFFFFFFF\n"
        "/dev/input/event9  1281178415.886728 EV_REL REL_WHEEL 0x00000001\n");
    REQUIRE(events);
    CHECK(events->format == CaptureFormat::EvdevText);
    REQUIRE(events->events.size() == 2);
    CHECK(events->events[0].code == BTN_TOOL_PEN);
    CHECK(events->events[1].value == -1);
    CHECK(events->notes.size() == 1);
    const auto bytes = input::parse_capture("10 80 4b 2c 6f 1d 00 00\n10 81 4b 2c 6f 1d 00 00\n");
    REQUIRE(bytes);
    CHECK(bytes->format == CaptureFormat::HexReports);
    CHECK(bytes->reports.at(1).time_ns == input::kUntimedReport_ns);
}

TEST_CASE("what is no recording says what could be given", "[capture]") {
    CHECK(fault_of("").starts_with("this is no recording of a tablet"));
    CHECK(fault_of("hello\nworld\n").starts_with("this is no recording of a tablet"));
    for (const char* picture : {"P5\n10 10\n255\n", "P2\r\n2 2\r\n15\r\n00 11\r\n15 00\r\n", "P4 10 10\n"})
        CHECK(fault_of(picture).starts_with("this is no recording of a tablet"));
    const auto missing = input::read_capture("/nowhere/at/all");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().code == core::ErrorCode::FileMissing);
}
