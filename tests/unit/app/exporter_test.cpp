#include "firmware_like_app/garment/exporter.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <iterator>
#include <new>
#include <set>
#include <thread>

#include "core/exchange/design_file.hpp"
#include "core/garment/wardrobe.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fs = std::filesystem;
using Stage = app::ExportState::Stage;
using Kind = app::ExportFault::Kind;

namespace {

core::Design skirt() {
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    core::Design design = *core::wardrobe_design("skirt_flat", body);
    design.network.edge_cm = 6.0;
    return design;
}

core::TriangleMesh bag() {
    return {{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, {}};
}

core::Result<core::TriangleMesh> models(const std::string& name) {
    if (name == "bag") return bag();
    return core::unexpected(core::ErrorCode::FileMissing, "there is no such model", name);
}

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void place_bag(core::Design& design, const std::string& model) {
    core::DesignStep step;
    step.kind = core::DesignStep::Kind::Place;
    step.object = {.name = "my " + model, .model = model, .at = {30, 80, 0}, .scale = 10, .turn = {}};
    design.steps.push_back(step);
}

}  // namespace

TEST_CASE("an export has the garment, its pattern, its pictures and its objects", "[exporter]") {
    const support::TemporaryFolder folder;
    app::ExportJob job{.design = skirt(), .models = models, .place = app::folder_place(folder.path(""))};
    place_bag(job.design, "bag");
    place_bag(job.design, "hat");
    job.plan.pictures = 2;
    job.plan.picture_px = 160;
    std::vector<double> shares;
    const app::ExportState state =
        app::run_export(job, [&](const app::ExportState& now) { shares.push_back(now.share); }, {});
    if (state.fault) FAIL(state.fault->error.sentence());
    REQUIRE(state.stage == Stage::Saved);
    CHECK(std::is_sorted(shares.begin(), shares.end()));
    CHECK(shares.back() == 1.0);
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(state.folder)) names.insert(entry.path().filename().string());
    std::set<std::string> expected{"design.json",    "garment.obj",    "garment.glb",        "pattern.svg",
                                   "pattern-a4.pdf", "pattern-a3.pdf", "pattern-letter.pdf", "pattern.dxf",
                                   "seams.json",     "strain.svg",     "turn-01.png",        "turn-02.png"};
    CHECK(names == expected);
    CHECK(read(state.folder / "design.json") == core::design_text(job.design));
    CHECK(read(state.folder / "garment.obj").find("g my_bag\n") != std::string::npos);
    CHECK(read(state.folder / "garment.glb").find("my bag") != std::string::npos);
    CHECK(read(state.folder / "turn-01.png").substr(1, 3) == "PNG");
    CHECK(read(state.folder / "turn-01.png") != read(state.folder / "turn-02.png"));
    REQUIRE(state.warnings.size() == 1);
    CHECK(state.warnings[0].find("my hat") != std::string::npos);

    SECTION("the same again, byte for byte, beside the first") {
        const app::ExportState again = app::run_export(job, {}, {});
        REQUIRE(again.stage == Stage::Saved);
        CHECK(again.folder != state.folder);
        for (const std::string& name : expected) CHECK(read(again.folder / name) == read(state.folder / name));
    }
}

TEST_CASE("an export that cannot be says why", "[exporter]") {
    const support::TemporaryFolder folder;
    app::ExportJob job;
    job.design.body = *core::measures_of_size("38");
    CHECK(app::run_export(job, {}, {}).fault->kind == Kind::NoPlace);
    job.place = app::folder_place(folder.path(""));
    const app::ExportState nothing = app::run_export(job, {}, {});
    CHECK(nothing.stage == Stage::Failed);
    CHECK(nothing.fault->kind == Kind::Nothing);
    std::stop_source stop;
    stop.request_stop();
    job.design = skirt();
    CHECK(app::run_export(job, {}, stop.get_token()).fault->kind == Kind::Cancelled);
    CHECK(fs::is_empty(folder.path("")));
}

TEST_CASE("the exporter works beside the screen, one export at a time", "[exporter]") {
    const support::TemporaryFolder folder;
    app::Exporter exporter;
    CHECK(exporter.state().stage == Stage::Idle);
    app::ExportJob job{.design = skirt(), .place = app::folder_place(folder.path(""))};
    job.plan = {.model = true, .print_pattern = false, .cut_pattern = false, .design = false, .pictures = 0};
    REQUIRE(exporter.start(job));
    CHECK_FALSE(exporter.start(job));
    for (int k = 0; exporter.is_running() && k < 2000; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    CHECK(exporter.state().stage == Stage::Saved);
    REQUIRE(exporter.start(job));
    exporter.cancel();
    for (int k = 0; exporter.is_running() && k < 2000; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    CHECK_FALSE(exporter.is_running());
}

TEST_CASE("an export that runs out of memory has failed, and the program goes on", "[exporter]") {
    const support::TemporaryFolder folder;
    app::ExportJob job{.design = skirt(), .place = app::folder_place(folder.path(""))};
    job.models = [](const std::string&) -> core::Result<core::TriangleMesh> { throw std::bad_alloc(); };
    job.plan.pictures = 0;
    place_bag(job.design, "bag");
    const app::ExportState state = app::run_export(job, {}, {});
    CHECK(state.stage == Stage::Failed);
    REQUIRE(state.fault);
    CHECK(state.fault->kind == Kind::Failed);
    CHECK(fs::is_empty(folder.path("")));
}

TEST_CASE("what was exported for a visitor who left is not told to the next", "[exporter]") {
    const support::TemporaryFolder folder;
    app::Exporter exporter;
    app::ExportJob job{.design = skirt(), .place = app::folder_place(folder.path(""))};
    job.design.name = "Anna";
    job.plan = {.model = false, .print_pattern = false, .cut_pattern = false, .design = true, .pictures = 0};
    const auto end = [&] {
        for (int k = 0; exporter.is_running() && k < 2000; ++k)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
    };
    REQUIRE(exporter.start(job));
    SECTION("while it runs") {
        exporter.forget();
        end();
    }
    SECTION("when it has ended") {
        end();
        CHECK(exporter.state().stage == Stage::Saved);
        exporter.forget();
    }
    CHECK(exporter.state().stage == Stage::Idle);
    CHECK(exporter.state().folder.empty());
    CHECK(fs::exists(folder.path("Anna/design.json")));
    REQUIRE(exporter.start(job));
    end();
    CHECK(exporter.state().stage == Stage::Saved);
}

TEST_CASE("a placed model is scaled about its middle and turned about x, y, z in this order", "[exporter]") {
    constexpr double kQuarter = 1.5707963267948966;
    core::TriangleMesh model;
    model.vertices = {{0, 0, 0}, {2, 4, 6}};
    const auto at = [&](core::Vec3 turn) {
        return app::placed_mesh({.name = "", .model = "", .at = {10, 20, 30}, .scale = 2, .turn = turn}, model)
            .vertices[1];
    };
    const auto same = [](core::Vec3 a, core::Vec3 b) { return core::length(a - b) < 1e-9; };
    CHECK(same(at({}), {12, 24, 36}));
    CHECK(same(at({kQuarter, 0, 0}), {12, 14, 34}));         // y to z
    CHECK(same(at({0, kQuarter, 0}), {16, 24, 28}));         // z to x
    CHECK(same(at({0, 0, kQuarter}), {6, 22, 36}));          // x to y
    CHECK(same(at({kQuarter, kQuarter, 0}), {14, 14, 28}));  // first about x
    CHECK(app::placed_mesh({}, {}).vertices.empty());
}
