#include "firmware_like_app/garment/design_sources.hpp"

#include <catch2/catch.hpp>

#include "firmware_like_app/collection/index_builder.hpp"
#include "tests/support/block_models.hpp"
#include "tests/support/temporary_folder.hpp"

TEST_CASE("a model that was added to the collection meanwhile is found", "[design sources]") {
    const support::TemporaryFolder folder;
    app::IndexBuildOptions build;
    build.paths = {folder.path("models")};
    build.database = folder.path("a.db");
    build.jobs = 1;
    build.parameters.silhouette_px = 48;
    build.parameters.thumbnail = {32, 24};
    const auto add = [&](int number, const char* name) {
        folder.write(std::string("models/") + name, support::off_text(support::block_model(number)));
        REQUIRE(app::build_index(build, {}, {}));
    };
    add(0, "bag.off");
    const app::ModelSource models = app::models_of_index(build.database);
    const auto bag = models("Bag");
    if (!bag) FAIL(bag.error().sentence());
    CHECK(models("Hat").error().code == core::ErrorCode::FileMissing);
    add(1, "hat.off");
    const auto hat = models("Hat");
    if (!hat) FAIL(hat.error().sentence());
    CHECK_FALSE(hat->vertices.empty());
    CHECK(models("Bag"));
    CHECK_FALSE(models("Shoe"));
}
