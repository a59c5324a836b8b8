#include "input/formats/decode_capture.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "../../support/hex_bytes.hpp"
#include "../../support/plausible_pen.hpp"
#include "../../support/temporary_folder.hpp"

using input::DecodedCapture;
using support::PenAction;

namespace {

DecodedCapture decode_file(const std::string& path) {
    const auto capture = input::read_capture(path);
    REQUIRE(capture);
    return input::decode_capture(*capture, input::find_surroundings(path));
}

constexpr const char* kPenReports =
    "003:007:000:STREAM 1.000\n 08 80 00 00 00 00 00 00 00 00 00 00\n\n003:007:000:STREAM 1.004\n 08 81 70 C6 06 7C FF "
    "1F 00 00 00 00\n\n";

}  // namespace

TEST_CASE("what lies beside a recording makes it readable", "[decode_capture]") {
    const support::TemporaryFolder folder;
    const std::string dump = folder.write("Tablet/dumps/pen_coords.txt", kPenReports);
    CHECK(decode_file(dump).why_none);
    folder.write("Tablet/descriptors.txt", "Bus 003 Device 004: ID 256c:006d  \n  iProduct 2 Huion Tablet\n");
    folder.write("Tablet/probe.txt",
                 "S C8 13 03 70 C6 00 06 7C 00 FF 1F D8 13 03 0D 10 01 04 3C 3E\nS C9 0A 03 48 00 55 00 49 00 4F 00\n");
    const DecodedCapture d = decode_file(dump);
    CHECK(input::vendor_product(d.device) == "256c:006d");
    CHECK(d.device.name == "Huion Tablet");
    CHECK(d.device.firmware == "HUIO");
    CHECK(d.parser == "fields (huion.json)");
    CHECK_FALSE(d.ranges_from_recording);
    REQUIRE(d.samples.size() == 2);
    CHECK(d.samples[0].hover());
    CHECK(*d.samples[1].x == Approx(1.0));
    CHECK(*d.samples[1].x_mm == Approx(254.0));
    CHECK(d.samples[1].tip);
}

TEST_CASE("of a machine's devices the one that a data file knows counts", "[decode_capture]") {
    const support::TemporaryFolder folder;
    const std::string dump = folder.write("t/dumps/pen.txt", kPenReports);
    folder.write(
        "t/lsusb.txt",
        "Bus 1 Device 1: ID 1d6b:0002 hub\nBus 1 Device 2: ID 046d:c517 mouse\nBus 1 Device 3: ID 256c:006e tablet\n");
    CHECK(input::vendor_product(decode_file(dump).device) == "256c:006e");
}

TEST_CASE("without any range the recording's own end counts, and it says so", "[decode_capture]") {
    const support::TemporaryFolder folder;
    const std::string dump = folder.write("t/dumps/pen.txt", kPenReports);
    folder.write("t/index.md", "VID: \"256c\"\nPID: \"006e\"\n");
    const DecodedCapture d = decode_file(dump);
    CHECK(d.ranges_from_recording);
    CHECK(d.axes.x->max == 0xC670);
    CHECK_FALSE(d.samples[1].x_mm);
}

TEST_CASE("an evemu description beside the events", "[decode_capture]") {
    const support::TemporaryFolder folder;
    folder.write(
        "Pen A.desc",
        "# EVEMU 1.2\nN: Pen A\nI: 0003 1234 0001 0110\nB: 01 00 00 00 00 00 00 00 00\nB: 01 00 00 00 00 00 00 00 00\n"
        "B: 01 00 00 00 00 00 00 00 00\nB: 01 00 00 00 00 00 00 00 00\nB: 01 00 00 00 00 00 00 00 00\n"
        "B: 01 01 04 00 00 00 00 00 00\nA: 00 0 1000 0 0 10\nA: 01 0 1000 0 0 10\n");
    const std::string events =
        folder.write("Pen A.move.events", "E: 1.0 0001 0140 1\nE: 1.0 0003 0000 500\nE: 1.0 0000 0000 0\n");
    const DecodedCapture d = decode_file(events);
    CHECK(d.device.name == "Pen A");
    CHECK(d.parser == "evdev");
    REQUIRE(d.samples.size() == 1);
    CHECK(*d.samples[0].x_mm == Approx(50.0));
}

TEST_CASE("the rate of reports leaves pauses out", "[decode_capture]") {
    std::vector<input::PenSample> samples;
    for (int i = 0; i < 20; ++i) {
        input::PenSample s;
        s.time_ns = i * 5'000'000LL + (i >= 10 ? 3'000'000'000LL : 0);
        s.in_range = true;
        samples.push_back(s);
    }
    CHECK(input::report_rate_hz(samples) == Approx(200.0));
    CHECK(input::report_rate_hz({}) == 0.0);
}

TEST_CASE("every recording of a tablet shows what its name says", "[decode_capture][data]") {
    const std::filesystem::path root = std::filesystem::path(CROQUIS_SHARED_DATA) / "tablets";
    if (!std::filesystem::exists(root)) {
        WARN("skipped: " + root.string() + " is not there");
        return;
    }
    // Recordings in which what the name says did not happen, each with the reason.
    const std::map<std::string, std::string> kExceptions{
        {"Huion_H610/dumps/pen_tilt.txt", "the pen has no tilt"},
        {"KYE_EasyPen_M610X/dumps/general.txt", "four reports"},
        {"KYE_G-Pen_560/dumps/evdev-hover.txt", "the events lack the key that says the tip is up"},
        {"KYE_MousePen_i608X_v2/dumps/pen_pressure.txt", "recorded in the mode of a mouse, which has no pressure"},
        {"KYE_PenSketch_M912/dumps/pen_pressure.txt", "recorded in the mode of a mouse, which has no pressure"},
        {"KYE_PenSketch_M912/dumps/pen_tilt.txt", "the pen has no tilt"},
        {"UC-Logic_TWHA60_v1/dumps/pen_coords.txt", "170 reports: less than a second"},
        {"UC-Logic_TWHA60_v1/dumps/pen_tilt.txt", "the pen has no tilt"},
        {"UC-Logic_TWHA60_v2/dumps3/pen_tilt.txt", "the pen has no tilt"},
        {"UGTizer_GP0610/dumps1/pen_tilt.txt", "the pen has no tilt"},
        {"Ugee_1000L/dumps/pen_tilt.txt", "the pen has no tilt"},
        {"Ugee_EX07/dumps/buttons.txt", "buttons of the frame"},
        {"Waltop_Media_Tablet_14.1_inch_1.14/dumps/buttons.txt", "buttons of the frame"},
        {"Waltop_Media_Tablet_14.1_inch_1.14/dumps/hid-hover-wide.txt", "the pen touched once"},
        {"XP-Pen_Artist_10S/dumps/pen_tilt.txt", "the pen has no tilt"},
        {"XP-Pen_Artist_16_Pro/dumps/pen_tilt.txt", "the pen has no tilt, its bytes stay 0"},
        {"XP-Pen_G430/dumps/pen_tilt.txt", "the pen has no tilt"},
        {"XP-Pen_Star_06/dumps/pen_tilt.txt", "recorded in the mode of a mouse, which has no tilt"},
        {"Yiynova_MVP20U+RH/dumps/pen_pressure.txt", "34 reports: a third of a second"},
        {"Yiynova_MVP20U+RH/dumps/pen_tilt.txt", "the pen has no tilt"},
        {"QEMU 0.12.1 QEMU USB Tablet.scroll-up-down.events", "a mouse"},
        {"eGalax Inc. USB TouchController.events", "fingers"},
    };
    int shown = 0, faulty = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        const std::string path = entry.path().string(), extension = entry.path().extension().string();
        const bool recording =
            extension == ".events" || extension == ".evemu" || path.find("/dump") != std::string::npos;
        const PenAction action = support::action_of(path);
        if (!entry.is_regular_file() || !recording || action == PenAction::None) continue;
        const auto capture = input::read_capture(path);
        if (!capture) continue;  // notes, lists and empty files between the recordings
        const DecodedCapture d = input::decode_capture(*capture, input::find_surroundings(path));
        const std::string missing =
            d.why_none ? *d.why_none : support::what_is_missing(action, support::look_at(d.samples), d.axes);
        std::string name = path.substr(root.string().size() + 1);
        for (const char* folder : {"digimend/", "evemu/tablets/"}) {
            if (name.starts_with(folder)) name = name.substr(std::string(folder).size());
        }
        INFO(name << ": " << missing);
        CHECK(missing.empty() != (kExceptions.count(name) > 0));
        (missing.empty() ? shown : faulty) += 1;
    }
    CHECK(shown >= 155);
    CHECK(faulty == static_cast<int>(kExceptions.size()));
}
