#include "input/trace/trace.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <random>

#include "../../support/hex_bytes.hpp"
#include "../../support/temporary_folder.hpp"
#include "core/exchange/inkml_reader.hpp"
#include "core/exchange/quickdraw_reader.hpp"
#include "core/exchange/svg_reader.hpp"
#include "input/formats/decode_capture.hpp"
#include "input/formats/ink_writers.hpp"
#include "input/trace/decode_trace.hpp"

using input::PenSample;
using input::Trace;
using input::TraceDevice;
using input::TraceRecord;

namespace {

PenSample rich_sample() {
    PenSample s;
    s.time_ns = 1'234'567'890'123;
    s.device = 1;
    s.x = 1.0 / 3.0;
    s.y = 0.1;
    s.x_mm = 84.66666666666667;
    s.y_mm = 12;
    s.pressure = 0.12345678901234567;
    s.tilt_x_rad = -0.5;
    s.tilt_y_rad = 1e-17;
    s.rotation_rad = 3.14;
    s.distance = 0;
    s.wheel = 1;
    s.tool = input::PenTool::Airbrush;
    s.serial = 0xfedcba9876543210ULL;
    s.tool_id = 0x140802;
    s.in_range = s.tip = true;
    s.buttons = 5;
    return s;
}

TraceDevice pen_device() {
    TraceDevice d;
    d.number = 1;
    d.identity.name = "Pen \"A\"\n*";
    d.identity.vendor = 0x1234;
    d.identity.product = 0x5678;
    d.source = "hidraw";
    d.parser = "descriptor";
    d.axes.x = input::AxisRange{0, 32767, 32767 / 254.0};
    d.axes.pressure = input::AxisRange{0, 8191, 0.0};
    d.reports_range = false;
    d.keys = {320, 330};
    d.descriptor = support::generic_pen_descriptor();
    return d;
}

std::vector<TraceRecord> one_of_each() {
    return {pen_device(),
            input::TraceChange{1, 5, input::DeviceChange::Attached},
            input::TraceReport{1, 10, {7, 0x81, 0, 255}},
            rich_sample(),
            input::TraceFrame{1, 20, {{20, 3, 0, -5}, {20, 0, 0, 0}}},
            PenSample{.time_ns = 30, .device = 1},
            input::TraceMarker{40, "second visitor"},
            input::TraceChange{1, 50, input::DeviceChange::Asleep},
            input::TraceChange{1, 60, input::DeviceChange::Detached}};
}

std::string text_of(const std::vector<TraceRecord>& records) {
    Trace trace;
    trace.records = records;
    return input::trace_text(trace);
}

}  // namespace

TEST_CASE("a trace comes back to the bit", "[trace]") {
    const std::string text = text_of(one_of_each());
    const auto trace = input::parse_trace(text);
    REQUIRE(trace);
    CHECK(trace->fault_count == 0);
    CHECK(trace->records == one_of_each());
    CHECK(input::trace_text(*trace) == text);
    CHECK(trace->damage().empty());
    REQUIRE(trace->device(1) != nullptr);
    CHECK(trace->device(2) == nullptr);
    CHECK(trace->samples().size() == 2);
}

TEST_CASE("the checksum is the common CRC-32", "[trace]") {
    CHECK(input::crc32("123456789") == 0xCBF43926U);
    CHECK(input::crc32("") == 0);
}

TEST_CASE("a torn tail costs the last record and no more, wherever it is torn", "[trace]") {
    const std::string text = text_of(one_of_each());
    const std::size_t header = text.find('\n') + 1;
    std::size_t whole_lines = 0;
    for (std::size_t length = header; length <= text.size(); ++length) {
        const auto trace = input::parse_trace(std::string_view(text).substr(0, length));
        whole_lines = static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(header),
                                                          text.begin() + static_cast<std::ptrdiff_t>(length), '\n'));
        if (!trace) {
            CHECK(whole_lines == 0);
            continue;
        }
        CHECK(trace->records.size() == whole_lines);
        CHECK(trace->fault_count == (text[length - 1] == '\n' ? 0U : 1U));
        if (trace->fault_count == 1) CHECK(trace->faults[0].torn);
    }
    const auto torn = input::parse_trace(std::string_view(text).substr(0, text.size() - 3));
    REQUIRE(torn);
    CHECK(torn->damage() == "the last record was cut off; the 8 before it are whole");
}

TEST_CASE("every flipped bit is found, and costs no more than its line and the next", "[trace]") {
    const std::string text =
        text_of({rich_sample(), input::TraceReport{1, 10, {7, 8}}, PenSample{.time_ns = 30, .device = 1}});
    const std::size_t header = text.find('\n') + 1;
    for (std::size_t at = header; at < text.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string flipped = text;
            flipped[at] = static_cast<char>(flipped[at] ^ (1 << bit));
            const auto trace = input::parse_trace(flipped);
            REQUIRE(trace);
            CHECK(trace->fault_count > 0);
            CHECK_FALSE(trace->records.empty());
        }
    }
    std::string flipped = text;
    flipped[header + 4] ^= 1;
    CHECK(input::parse_trace(flipped)->damage() ==
          "1 record is damaged, first in line 2 (its checksum is wrong); the other 2 are whole");
}

TEST_CASE("what is no trace, a newer trace, and one with nothing left", "[trace]") {
    CHECK(input::parse_trace("").error().code == core::ErrorCode::UnknownFormat);
    CHECK(input::parse_trace("hello\n").error().code == core::ErrorCode::UnknownFormat);
    std::string newer = "croquis-trace 2";
    char sum[16];
    std::snprintf(sum, sizeof sum, " *%08x\n", input::crc32(newer));
    CHECK(input::parse_trace(newer + sum).error().code == core::ErrorCode::NewerVersion);
    CHECK(input::parse_trace(input::trace_header() + "s 1 1 RT *00000000\n").error().code == core::ErrorCode::Damaged);
    CHECK(input::parse_trace(input::trace_header()));
    CHECK(input::read_trace("/nowhere").error().code == core::ErrorCode::FileMissing);
}

TEST_CASE("a right checksum does not make wrong content right", "[trace]") {
    const auto fault_of = [](const std::string& body) {
        char sum[16];
        std::snprintf(sum, sizeof sum, " *%08x\n", input::crc32(body));
        const auto trace =
            input::parse_trace(input::trace_header() + input::trace_line(input::TraceMarker{1, "m"}) + body + sum);
        REQUIRE(trace);
        return trace->fault_count;
    };
    CHECK(fault_of("s 1 1 RT x=0.5") == 0);
    for (const char* wrong : {"s 1 1 R",
                              "s 1 1 -T",
                              "s 1 1 RT x=",
                              "s 1 1 RT x=nan",
                              "s 1 1 RT q=1",
                              "s 1 1 RT to=99",
                              "s 1 x RT",
                              "r 1 1 ",
                              "r 1 1 0",
                              "r 1 1 zz",
                              "e 1 1",
                              "e 1 1 1:2",
                              "e 1 1 1:2:99999999999",
                              "v 1 1 gone",
                              "d 1 []",
                              "d 1 {\"descriptor\":\"0\"}",
                              "d 1 {\"keys\":[900]}",
                              "z 1 1",
                              "",
                              "s -1 1 RT"}) {
        INFO(wrong);
        CHECK(fault_of(wrong) == 1);
    }
}

TEST_CASE("reports and frames of a trace decode to the samples that were recorded", "[trace]") {
    const auto descriptor = input::parse_report_descriptor(support::generic_pen_descriptor());
    const auto pens = input::find_pens(*descriptor);
    TraceDevice device = pen_device();
    device.axes = pens[0].axes;
    Trace trace;
    trace.records.push_back(device);
    for (int i = 0; i < 20; ++i) {
        const std::vector<std::uint8_t> bytes{7,
                                              static_cast<std::uint8_t>(i < 15 ? 0x11 : 0x10),
                                              static_cast<std::uint8_t>(i),
                                              9,
                                              static_cast<std::uint8_t>(2 * i),
                                              20,
                                              5,
                                              6,
                                              1,
                                              0xff};
        trace.records.push_back(input::TraceReport{1, i * 5'000'000LL, bytes});
        input::PenReport report;
        REQUIRE(pens[0].decode(bytes, report));
        trace.records.push_back(to_sample(report, pens[0].axes, i * 5'000'000LL, 1));
    }
    const input::DecodedTrace decoded = input::decode_trace(trace);
    CHECK(decoded.differing == 0);
    CHECK(decoded.samples == trace.samples());
    std::get<PenSample>(trace.records[4]).x = 0.9;
    CHECK(input::decode_trace(trace).differing == 1);
}

TEST_CASE("strokes go out and come back the same", "[trace]") {
    std::vector<PenSample> samples;
    for (int i = 0; i < 30; ++i) {
        PenSample s;
        s.time_ns = 7'000'000'000 + i * 5'000'000LL;
        s.device = 1;
        s.x = 0.01 * i;
        s.y = 0.3 + 0.001 * i * i;
        s.x_mm = *s.x * 217.3;
        s.y_mm = *s.y * 135.9;
        s.pressure = i / 40.0;
        s.tilt_x_rad = 0.1;
        s.tilt_y_rad = -0.2;
        s.in_range = true;
        s.tip = i != 11 && i != 12;
        samples.push_back(s);
    }
    const auto strokes = input::strokes_of(samples);
    const core::Drawing drawing = input::drawing_of(strokes);
    REQUIRE(drawing.strokes.size() == 2);
    const auto same = [&](const core::Result<core::Drawing>& back, bool timed) {
        REQUIRE(back);
        REQUIRE(back->strokes.size() == 2);
        for (std::size_t i = 0; i < 2; ++i) {
            REQUIRE(back->strokes[i].samples.size() == drawing.strokes[i].samples.size());
            for (std::size_t k = 0; k < drawing.strokes[i].samples.size(); ++k) {
                const core::PenSample &a = drawing.strokes[i].samples[k], &b = back->strokes[i].samples[k];
                CHECK(a.x == Approx(b.x).margin(1e-9));
                CHECK(a.y == Approx(b.y).margin(1e-9));
                if (timed) CHECK(a.time_us == b.time_us);
            }
        }
    };
    const std::string ink = input::inkml_text(strokes);
    CHECK(ink.find("OTx") != std::string::npos);
    same(core::parse_inkml(ink), true);
    CHECK(core::parse_inkml(ink)->strokes[0].samples[5].pressure == Approx(5 / 40.0));
    same(core::parse_svg(input::svg_text(strokes)), false);
    same(core::parse_quickdraw_line(input::quickdraw_text(strokes)), true);
    same(input::drawing_of(input::strokes_of(input::trace_of_drawing(drawing).samples())), true);
    CHECK(core::parse_inkml(input::inkml_text({})).error().code == core::ErrorCode::EmptyDrawing);
}

TEST_CASE("a file is written whole or not at all", "[trace]") {
    const support::TemporaryFolder folder;
    const std::string path = folder.path("a.trace");
    REQUIRE(input::write_whole_file(path, "one"));
    CHECK_FALSE(std::filesystem::exists(path + ".new"));
    const auto failed = input::write_whole_file(folder.path("no/such/folder/a.trace"), "two");
    REQUIRE_FALSE(failed);
    CHECK(failed.error().code == core::ErrorCode::WriteFailed);
}

TEST_CASE("recordings of real tablets survive as traces", "[trace][data]") {
    const std::filesystem::path root = std::filesystem::path(CROQUIS_SHARED_DATA) / "tablets";
    if (!std::filesystem::exists(root)) {
        WARN("skipped: " + root.string() + " is not there");
        return;
    }
    for (const char* name :
         {"digimend/Huion_HS610/dumps/enabled/pen_buttons.txt",
          "digimend/Waltop_Slim_Tablet_5.8_inch/dumps/hid-tip.txt", "digimend/XP-Pen_G640S/dumps/pen_buttons.txt",
          "digimend/KYE_MousePen_i608X_v1/dumps/pen_axis.txt", "digimend/Huion_Kamvas_GT191/dumps/pen_buttons.txt",
          "digimend/KYE_G-Pen_560/dumps/evdev-buttons.txt", "evemu/tablets/dell_canvas_pen.evemu",
          "evemu/tablets/Wacom Intuos4 6x9.stylus-drag.events", "hid-descriptors/Wacom PenPartner/hidrecord.txt"}) {
        DYNAMIC_SECTION(name) {
            const std::string path = (root / name).string();
            const auto capture = input::read_capture(path);
            REQUIRE(capture);
            const input::Surroundings around = input::find_surroundings(path);
            const Trace trace = input::trace_of_capture(*capture, around);
            CHECK(trace.samples() == input::decode_capture(*capture, around).samples);
            const auto back = input::parse_trace(input::trace_text(trace));
            REQUIRE(back);
            CHECK(back->records == trace.records);
            const input::DecodedTrace decoded = input::decode_trace(*back);
            CHECK(decoded.differing == 0);
            CHECK(decoded.samples == trace.samples());
        }
    }
}
