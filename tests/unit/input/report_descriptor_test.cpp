#include "input/parse/report_descriptor.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "../../support/hex_bytes.hpp"

using input::HidField;
using input::HidKind;
using input::parse_report_descriptor;
using support::hex_bytes;

namespace {

const HidField* field_of(const input::ReportDescriptor& d, input::Usage usage) {
    for (const HidField& f : d.fields) {
        if (f.usage == usage) return &f;
    }
    return nullptr;
}

std::string fault_of(std::string_view bytes) {
    const auto parsed = parse_report_descriptor(hex_bytes(bytes));
    return parsed ? "parsed" : parsed.error().message;
}

}  // namespace

TEST_CASE("a pen's descriptor gives fields with places, ranges and units", "[report_descriptor]") {
    const auto d = parse_report_descriptor(support::generic_pen_descriptor());
    REQUIRE(d);
    CHECK(d->has_report_ids);
    CHECK(d->notes.empty());
    CHECK(d->report_bytes(HidKind::Input, 7) == 10);
    CHECK(d->report_bytes(HidKind::Input, 8) == 0);

    const HidField* tip = field_of(*d, 0x000D0042);
    REQUIRE(tip != nullptr);
    CHECK(tip->bit_offset == 0);
    CHECK(tip->bit_size == 1);
    CHECK(d->collections[static_cast<std::size_t>(d->application_of(*tip))].usage == 0x000D0002);

    const HidField* x = field_of(*d, 0x00010030);
    REQUIRE(x != nullptr);
    CHECK(x->bit_offset == 8);
    CHECK(x->bit_size == 16);
    CHECK(x->logical_max == 32767);
    CHECK(input::steps_per_unit(*x) == Approx(32767 / 254.0));

    const HidField* tilt = field_of(*d, 0x000D003E);
    REQUIRE(tilt != nullptr);
    CHECK(tilt->bit_offset == 64);
    CHECK(tilt->logical_min == -60);
    CHECK(input::steps_per_unit(*tilt) == Approx(57.29578));
}

TEST_CASE("a maximum is signed only when its minimum is negative", "[report_descriptor]") {
    const auto plain = parse_report_descriptor(hex_bytes("05 01 09 30 15 00 25 ff 75 08 95 01 81 02"));
    REQUIRE(plain);
    CHECK(plain->fields.at(0).logical_max == 255);
    const auto centred = parse_report_descriptor(hex_bytes("05 01 09 30 15 80 25 7f 75 08 95 01 81 02"));
    REQUIRE(centred);
    CHECK(centred->fields.at(0).logical_min == -128);
    CHECK(centred->fields.at(0).logical_max == 127);
}

TEST_CASE("usages in ranges and usages that run out", "[report_descriptor]") {
    const auto keys = parse_report_descriptor(hex_bytes("05 09 19 01 29 03 15 00 25 01 75 01 95 05 81 02"));
    REQUIRE(keys);
    REQUIRE(keys->fields.size() == 3);
    CHECK(keys->fields[1].usage == 0x00090002);
    CHECK(keys->fields[2].count == 3);  // the last usage goes on
    const auto list = parse_report_descriptor(hex_bytes("05 07 19 00 29 65 15 00 25 65 75 08 95 06 81 00"));
    REQUIRE(list);
    REQUIRE(list->fields.size() == 1);
    CHECK(list->fields[0].array);
    CHECK(list->fields[0].count == 6);
    CHECK(list->fields[0].usage_max == 0x00070065);
}

TEST_CASE("push and pop, and a usage that names its page", "[report_descriptor]") {
    const auto d = parse_report_descriptor(hex_bytes("05 01 75 08 95 01 a4 75 10 0b 30 00 0d 00 81 02 b4 09 31 81 02"));
    REQUIRE(d);
    REQUIRE(d->fields.size() == 2);
    CHECK(d->fields[0].usage == 0x000D0030);
    CHECK(d->fields[0].bit_size == 16);
    CHECK(d->fields[1].usage == 0x00010031);
    CHECK(d->fields[1].bit_size == 8);
    CHECK(d->fields[1].bit_offset == 16);
}

TEST_CASE("each malformation has its name and its place", "[report_descriptor]") {
    CHECK(fault_of("") == "empty descriptor");
    CHECK(fault_of("05 01 26 ff") == "truncated item");
    CHECK(fault_of("fe 05 00 01") == "truncated item");
    CHECK(fault_of("05 01 c0") == "end of a collection that was never begun");
    CHECK(fault_of("b4") == "pop without push");
    CHECK(fault_of("85 00") == "report id 0");
    CHECK(fault_of("86 00 01") == "report id above 255");
    CHECK(fault_of("09 01 77 00 00 00 10 95 01 81 03") == "report longer than 16384 bytes");
    CHECK(fault_of("75 20 97 ff ff ff ff 81 03") == "report longer than 16384 bytes");
    std::string deep, pushes;
    for (int i = 0; i < 40; ++i) deep += "a1 00 ", pushes += "a4 ";
    CHECK(fault_of(deep) == "collections nested deeper than 32");
    CHECK(fault_of(pushes) == "more than 16 pushes");
    CHECK(parse_report_descriptor(hex_bytes("05 01 c0")).error().where == "byte 2");
    std::vector<std::uint8_t> longest(4097, 0x05);
    CHECK(parse_report_descriptor(longest).error().message == "descriptor longer than 4096 bytes");
}

TEST_CASE("what is odd but harmless is noted", "[report_descriptor]") {
    const auto open = parse_report_descriptor(hex_bytes("05 0d 09 02 a1 01"));
    REQUIRE(open);
    CHECK(open->notes.size() == 1);
    const auto wide = parse_report_descriptor(hex_bytes("06 00 ff 09 01 a1 01 85 08 75 58 95 01 09 01 81 02 c0"));
    REQUIRE(wide);
    CHECK(wide->fields.empty());
    CHECK(wide->report_bytes(HidKind::Input, 8) == 12);
    CHECK(wide->notes.size() == 1);
}

TEST_CASE("bits come out little-endian and end with the report", "[report_descriptor]") {
    const std::vector<std::uint8_t> data = hex_bytes("34 12 f0 ff");
    CHECK(input::extract_bits(data, 0, 16) == 0x1234);
    CHECK(input::extract_bits(data, 4, 8) == 0x23);
    CHECK(input::extract_bits(data, 20, 4) == 0xf);
    CHECK(input::extract_bits(data, 24, 16) == 0xff);
    CHECK(input::extract_bits(data, 400, 32) == 0);
    HidField field;
    field.bit_offset = 20;
    field.bit_size = 4;
    CHECK(input::field_value(data, field) == 15);
    field.logical_min = -8;
    CHECK(input::field_value(data, field) == -1);
}

TEST_CASE("every recorded descriptor parses or has a malformation with a name", "[report_descriptor][data]") {
    const std::filesystem::path root = std::filesystem::path(CROQUIS_SHARED_DATA) / "tablets/hid-descriptors";
    if (!std::filesystem::exists(root)) {
        WARN("skipped: " + root.string() + " is not there");
        return;
    }
    int parsed = 0;
    std::multiset<std::string> faults;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        if (entry.path().extension() != ".bin") continue;
        std::ifstream in(entry.path(), std::ios::binary);
        const std::vector<char> chars{std::istreambuf_iterator<char>(in), {}};
        const std::vector<std::uint8_t> bytes(chars.begin(), chars.end());
        const auto d = parse_report_descriptor(bytes);
        d ? ++parsed : (faults.insert(d.error().message), 0);
    }
    CHECK(parsed == 574);
    CHECK(faults.size() == 46);
    CHECK(faults.count("empty descriptor") == 46);  // files of no bytes
}
