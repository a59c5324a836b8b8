// Designs as older versions of the format had them, written by hand: they must go on being read.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "core/exchange/design_file.hpp"
#include "support/simple_body.hpp"

TEST_CASE("designs of every version are read, made, and written as this one's", "[design_versions]") {
    const std::filesystem::path folder = std::filesystem::path(CROQUIS_SOURCE_DIR) / "tests/data/designs";
    const core::TriangleMesh body = support::post(10.0, 60.0);
    std::set<std::string> found;
    for (int version = 1; version < core::kDesignVersion; ++version) {
        const std::filesystem::path file = folder / ("version-" + std::to_string(version) + ".json");
        DYNAMIC_SECTION(file.filename().string()) {
            const core::Result<core::Design> design = core::read_design(file.string());
            if (!design) FAIL(design.error().sentence());
            CHECK(design->steps.size() >= 11);
            const core::Result<core::Garment> garment = core::make_garment(*design, body);
            REQUIRE(garment);
            for (const core::DesignFault& fault : garment->faults) FAIL_CHECK(fault.step << ": " << fault.sentence);
            REQUIRE(garment->layers.size() == 2);
            CHECK(garment->layers[0].fitted.pieces.size() == 4);
            CHECK(garment->network.inconsistency().empty());
            const core::Result<core::Design> again = core::parse_design(core::design_text(*design));
            REQUIRE(again);
            CHECK(core::design_text(*again) == core::design_text(*design));
            const core::Result<core::Garment> same = core::make_garment(*again, body);
            REQUIRE(same);
            CHECK(same->layers[0].fitted.mesh.vertices == garment->layers[0].fitted.mesh.vertices);
        }
    }
}
