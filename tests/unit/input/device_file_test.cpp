#include "input/devices/device_file.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>

using input::DeviceFile;
using input::DeviceIdentity;

namespace {

std::string fault_of(const std::string& text) {
    const auto file = input::parse_device_file(text, "t.json");
    return file ? "" : file.error().message;
}

/// A whole file with one member put in place of another or added.
std::string with(const std::string& member) {
    return R"({"name":"T","why":"w","parser":"descriptor","claims":[{"vendor":"1234","products":["5678"]}],)" + member +
           "}";
}

DeviceIdentity device(std::uint16_t vendor, std::uint16_t product, int interface = -1, std::string firmware = {}) {
    DeviceIdentity d;
    d.vendor = vendor;
    d.product = product;
    d.interface = interface;
    d.firmware = std::move(firmware);
    return d;
}

}  // namespace

TEST_CASE("every built-in device file is right", "[device_file]") {
    const auto embedded = input::embedded_device_files();
    REQUIRE(embedded.size() > 50);
    for (const auto& e : embedded) {
        DYNAMIC_SECTION(e.name) {
            const auto file = input::parse_device_file(e.text, std::string(e.name));
            if (!file) FAIL(file.error().sentence());
            CHECK_FALSE(file->claims.empty());
            CHECK(file->why.size() > 20);  // a sentence, not a word
            for (const input::FileLayout& l : file->layouts) {
                CHECK(l.layout.has(input::PenRole::X));
                const bool ranged = l.layout.axes.x.has_value() || l.axes_from != input::AxesFrom::Descriptor ||
                                    file->axes.x.has_value() || file->parser == "fields";
                CHECK(ranged);
            }
            if (file->parser == "wacom-intuos") {
                CHECK(file->axes.x);
                CHECK(file->axes.pressure);
            }
        }
    }
    CHECK(input::device_files().size() == embedded.size());
}

TEST_CASE("no two device files claim one device", "[device_file]") {
    std::set<std::string> seen;
    for (const DeviceFile& file : input::device_files()) {
        for (const input::DeviceClaim& c : file.claims) {
            DeviceIdentity d = device(c.vendor, c.product);
            const std::string key =
                input::vendor_product(d) + " interface " + std::to_string(c.interface) + " " + c.firmware;
            INFO(file.file << " claims " << key);
            CHECK(seen.insert(key).second);
        }
    }
    std::set<std::string> names;
    for (const DeviceFile& file : input::device_files()) {
        for (const std::string& name : file.names) CHECK(names.insert(name).second);
    }
}

TEST_CASE("the claim that says more wins", "[device_file]") {
    const auto files = input::device_files();
    REQUIRE(input::find_device_file(device(0x256c, 0x006e), files) != nullptr);
    CHECK(input::find_device_file(device(0x256c, 0x006e), files)->file == "huion.json");
    CHECK(input::find_device_file(device(0x256c, 0x006e, -1, "HUION_T165_180101"), files)->file == "huion-gt191.json");
    CHECK(input::find_device_file(device(0x056a, 0x0027), files)->parser == "wacom-intuos");
    CHECK(input::find_device_file(device(0xdead, 0xbeef), files) == nullptr);
    CHECK(input::find_device_file_by_name("Waltop_Q_Pad", files)->file == "waltop-q-pad.json");
    CHECK(input::find_device_file_by_name("nothing", files) == nullptr);
}

TEST_CASE("a faulty device file is refused with the member named", "[device_file]") {
    CHECK(fault_of("[]") == "this is no JSON object");
    CHECK(fault_of("{") == "this is no JSON object");
    CHECK(fault_of("{}") == "name needs a text");
    CHECK(fault_of(with(R"("silence_ms":100)")).empty());
    CHECK(fault_of(with(R"("silence_ms":"soon")")) == "silence_ms needs a whole number from 5 to 5000");
    CHECK(fault_of(with(R"("colour":1)")) == "colour is not known");
    CHECK(fault_of(with(R"("size_mm":[1,2])")) == "size_mm needs [width, height] between 20 and 2500");
    CHECK(fault_of(with(R"("axes":{"x":[5,5]})")) == "x is an empty range, or of no sense");
    CHECK(fault_of(with(R"("axes":{"z":[0,5]})")) == "axes has a member that is not known: z");
    CHECK(fault_of(with(R"("wake":[{"write":"xx"}])")) == "wake needs bytes in hexadecimal");
    const auto report = [](const std::string& rest) {
        return with("\"reports\":[{\"id\":\"07\",\"bytes\":8," + rest + "}]");
    };
    CHECK(fault_of(report(R"("fields":{"x":"8:16","y":"24:16"})")).empty());
    CHECK(fault_of(report(R"("fields":{"x":"8:16"})")) == "fields has no x and y");
    CHECK(fault_of(report(R"("fields":{"x":"8:16","y":"60:16"})")) == "fields y lies behind the end of the report");
    CHECK(fault_of(report(R"("fields":{"x":"8:16","y":"24:16","tail":"1"})")) ==
          "fields has a name that is not known: tail");
    CHECK(fault_of(report(R"("fields":{"x":"8:16","y":"24:99"})")) == "fields y is no place in a report");
    CHECK(fault_of(report(R"("when":{"byte":1,"mask":"0f","value":"10"},"fields":{"x":"8:16","y":"24:16"})"))
              .starts_with("when needs mask and value"));
}

TEST_CASE("places of fields", "[device_file]") {
    const auto split = input::parse_field_spec("16:16+64:8");
    REQUIRE(split);
    CHECK(split->bit_offset == 16);
    CHECK(split->bit_size == 16);
    CHECK(split->high_offset == 64);
    CHECK(split->high_size == 8);
    const auto turned = input::parse_field_spec("-s88:8");
    REQUIRE(turned);
    CHECK(turned->negated);
    CHECK(turned->is_signed);
    CHECK(input::parse_field_spec("!14")->negated);
    CHECK(input::parse_field_spec("14")->bit_size == 1);
    for (const char* wrong : {"", ":", "8:", "8:0", "8:33", "a", "8:16+", "16:24+64:16", "8:16x", "+8"}) {
        INFO(wrong);
        CHECK_FALSE(input::parse_field_spec(wrong));
    }
}

TEST_CASE("the udev rules open every tablet that a data file claims", "[device_file]") {
    std::ifstream in(CROQUIS_SOURCE_DIR "/firmware_like_app/appliance/70-croquis-tablets.rules");
    const std::string rules{std::istreambuf_iterator<char>(in), {}};
    REQUIRE_FALSE(rules.empty());
    for (const DeviceFile& file : input::device_files()) {
        const bool asks = std::any_of(file.wake.begin(), file.wake.end(), [](const input::WakeStep& step) {
            return step.kind == input::WakeStep::Kind::ReadString;
        });
        for (const input::DeviceClaim& c : file.claims) {
            char upper[8], lower[8];
            std::snprintf(upper, sizeof upper, "%04X", c.vendor);
            std::snprintf(lower, sizeof lower, "%04x", c.vendor);
            INFO(file.file);
            CHECK(rules.find("KERNELS==\"*:" + std::string(upper) + ":*\"") != std::string::npos);
            if (asks) CHECK(rules.find("ATTR{idVendor}==\"" + std::string(lower) + "\"") != std::string::npos);
        }
    }
}
