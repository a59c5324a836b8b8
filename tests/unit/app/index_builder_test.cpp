#include "firmware_like_app/collection/index_builder.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "db/migrations/migrations.hpp"
#include "tests/support/block_models.hpp"
#include "tests/support/index_rows.hpp"
#include "tests/support/temporary_folder.hpp"

using app::IndexBuildOptions;
using app::IndexBuildReport;
using support::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

/// Small silhouettes and pictures: what is tested is which models get in, not how they look.
app::ViewParameters quick() {
    app::ViewParameters parameters;
    parameters.silhouette_px = 48;
    parameters.thumbnail = {32, 24};
    return parameters;
}

IndexBuildOptions options(const TemporaryFolder& folder, int jobs = 2) {
    IndexBuildOptions build;
    build.paths = {folder.path("models")};
    build.database = folder.path("a.db");
    build.jobs = jobs;
    build.parameters = quick();
    return build;
}

void write_models(const TemporaryFolder& folder, int count) {
    for (int n = 0; n < count; ++n) {
        folder.write("models/m" + std::to_string(10 + n) + ".off", support::off_text(support::block_model(n)));
    }
}

IndexBuildReport build(const IndexBuildOptions& wanted) {
    auto report = app::build_index(wanted, {}, {});
    if (!report) FAIL(report.error().sentence());
    return std::move(*report);
}

db::TwoViewIndex open(const TemporaryFolder& folder, const std::string& parameters = app::parameters_text(quick())) {
    auto index = db::TwoViewIndex::open(folder.path("a.db"), db::OpenMode::ReadOnly, {.parameters = parameters});
    if (!index) FAIL(index.error().sentence());
    return std::move(*index);
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("new models are added, unchanged ones skipped, changed ones described again under their ids", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 3);
    CHECK(build(options(folder)).added == 3);
    const IndexBuildReport again = build(options(folder));
    CHECK(again.added == 0);
    CHECK(again.skipped == 3);
    folder.write("models/m11.off", support::off_text(support::block_model(77)));
    folder.write("models/m09.off", support::off_text(support::block_model(78)));
    const IndexBuildReport changed = build(options(folder));
    CHECK(changed.added == 2);
    CHECK(changed.skipped == 2);
    const auto entries = open(folder).list();
    REQUIRE(entries->size() == 4);
    CHECK((*entries)[1].name == "m11");
    CHECK((*entries)[3].name == "m09");
    CHECK(open(folder).check()->empty());
}

TEST_CASE("the index does not depend on the number of jobs", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 5);
    folder.write("models/m12b.off", "OFF\n3 1 0\n");
    IndexBuildOptions wanted = options(folder, 1);
    CHECK(build(wanted).failed.size() == 1);
    wanted.jobs = 4;
    wanted.database = folder.path("b.db");
    CHECK(build(wanted).failed.size() == 1);
    CHECK((support::index_rows(folder.path("a.db")) == support::index_rows(folder.path("b.db"))));
}

TEST_CASE("a build that was asked once which models are near to which keeps that up to date", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 4);
    IndexBuildOptions wanted = options(folder, 1);
    wanted.likeness = true;
    std::size_t described = 0, measured = 0;
    const auto report = app::build_index(wanted, {}, [&](app::IndexBuildProgress p) {
        (p.measuring ? measured : described) = p.done;
        CHECK(p.total == 4);
    });
    REQUIRE(report);
    CHECK(report->measured == 4);
    CHECK(described == 4);
    CHECK(measured == 4);
    const std::string expected = support::index_rows(folder.path("a.db"));
    CHECK(build(options(folder)).measured == 0);
    CHECK((support::index_rows(folder.path("a.db")) == expected));
    wanted.jobs = 3;
    wanted.database = folder.path("b.db");
    CHECK(build(wanted).measured == 4);
    CHECK((support::index_rows(folder.path("b.db")) == expected));
    write_models(folder, 6);
    CHECK(build(options(folder)).measured == 6);  // lists of three were short
    CHECK(open(folder).neighbour_lists()->size() == 6);
}

TEST_CASE("bad files are named, each in one sentence, and the rest goes on", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 2);
    const std::string zip = std::string("PK\x03\x04\x14\x00\x00\x00\x08\x00", 10) + std::string(200, 'z');
    struct Case {
        std::string name, content, says;
    };
    const std::vector<Case> cases{
        {"a_zip.obj", zip, "archive"},
        {"b_nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 inf 0\n3 0 1 2\n", "no usable faces"},
        {"c_range.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "corner 3"},
        {"d_faceless.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no usable faces"},
        {"e_empty.ply", "", "empty"},
        {"f_short.stl", "abc", "cut short"},
        {"g_bomb.3mf", zip, "no directory"},
        {"h_large.stl", "x", "larger than"},
    };
    for (const Case& bad : cases) folder.write("models/" + bad.name, bad.content);
    fs::resize_file(folder.path("models/h_large.stl"), 3ULL << 30);
    fs::create_directories(folder.path("empty"));
    IndexBuildOptions wanted = options(folder);
    wanted.paths.push_back(folder.path("empty"));
    wanted.paths.push_back(folder.path("gone.off"));
    const IndexBuildReport report = build(wanted);
    CHECK(report.added == 2);
    REQUIRE(report.failed.size() == cases.size() + 2);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const app::PassedOver& failed = report.failed[i + 2];
        CHECK(failed.file == folder.path("models/" + cases[i].name));
        CHECK_THAT(failed.why, Catch::Contains(cases[i].says));
        CHECK(failed.why.find('\n') == std::string::npos);
    }
    CHECK(open(folder).check()->empty());
    CHECK(build(wanted).skipped == 2);
}

TEST_CASE("an empty folder or a missing path alone makes no index", "[builder]") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path("models"));
    const auto empty = app::build_index(options(folder), {}, {});
    REQUIRE_FALSE(empty);
    CHECK_THAT(empty.error().sentence(), Catch::Contains("models: there is no 3D model in it; give a folder"));
    IndexBuildOptions missing = options(folder);
    missing.paths = {folder.path("gone")};
    CHECK_FALSE(app::build_index(missing, {}, {}));
    CHECK_FALSE(fs::exists(folder.path("a.db")));
}

TEST_CASE("stopped after any file, a build goes on to the same index", "[builder]") {
    const TemporaryFolder whole;
    write_models(whole, 3);
    whole.write("models/m11b.off", "OFF\n");
    build(options(whole));
    const std::string expected = support::index_rows(whole.path("a.db"));
    for (std::size_t stop_after = 1; stop_after <= 4; ++stop_after) {
        fs::remove(whole.path("a.db"));
        std::stop_source stop;
        const auto first = app::build_index(options(whole, 3), stop.get_token(), [&](app::IndexBuildProgress p) {
            CHECK(p.total == 4);
            if (p.done == stop_after) stop.request_stop();
        });
        REQUIRE(first);
        const auto there = open(whole).list();
        CHECK(there->size() == static_cast<std::size_t>(first->added));
        CHECK(first->interrupted == (first->added + first->failed.size() < 4));
        CHECK(open(whole).check()->empty());
        build(options(whole));
        CHECK((support::index_rows(whole.path("a.db")) == expected));
    }
}

TEST_CASE("classes name models, and stay when a later build names none", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 2);
    IndexBuildOptions wanted = options(folder);
    wanted.classes = {{folder.path("models/m10.off"), "crab"}};
    build(wanted);
    CHECK((*open(folder).list())[0].class_name == "crab");
    wanted.classes[0].class_name = "spider";
    CHECK(build(wanted).skipped == 2);
    CHECK((*open(folder).list())[0].class_name == "spider");
    folder.write("models/m10.off", support::off_text(support::block_model(5)));
    CHECK(build(options(folder)).added == 1);
    CHECK((*open(folder).list())[0].class_name == "spider");
}

TEST_CASE("models described with other settings are described again, or kept and named", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 3);
    build(options(folder));
    fs::remove(folder.path("models/m11.off"));
    folder.write("more/m20.off", support::off_text(support::block_model(9)));
    IndexBuildOptions other = options(folder);
    other.parameters.silhouette_px = 50;
    other.paths = {folder.path("more")};
    const std::string parameters = app::parameters_text(other.parameters);
    CHECK(open(folder, parameters).info()->stale_models == 3);
    const IndexBuildReport report = build(other);
    CHECK(report.added == 3);
    CHECK(report.failed.empty());
    REQUIRE(report.kept.size() == 1);
    CHECK(report.kept[0].file == folder.path("models/m11.off"));
    CHECK_THAT(report.kept[0].why, Catch::Contains("the file is gone"));
    const auto entries = open(folder, parameters).list();
    REQUIRE(entries->size() == 4);
    CHECK_FALSE((*entries)[0].stale);
    CHECK((*entries)[1].stale);
    CHECK((*entries)[3].name == "m20");
    CHECK(build(other).added == 0);
}

TEST_CASE("damaged models are described again, wherever they are", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 3);
    build(options(folder));
    const std::string expected = support::index_rows(folder.path("a.db"));
    {
        const auto database = db::open_collection(folder.path("a.db"), db::OpenMode::ReadWrite);
        REQUIRE(database);
        REQUIRE(
            database->execute("UPDATE view SET descriptor = zeroblob(40) WHERE model_id = 1 AND number = 1;"
                              "DELETE FROM display_mesh WHERE model_id = 2; DELETE FROM view WHERE model_id = 3"));
    }
    fs::remove(folder.path("models/m12.off"));
    IndexBuildOptions one = options(folder);
    one.paths = {folder.path("models/m11.off")};
    const IndexBuildReport report = build(one);
    CHECK(report.added == 2);
    REQUIRE(report.kept.size() == 1);
    CHECK(report.kept[0].file == folder.path("models/m12.off"));
    CHECK_THAT(report.kept[0].why, Catch::Contains("damaged in the index"));
    write_models(folder, 3);
    CHECK(build(options(folder)).added == 1);
    CHECK(open(folder).check()->empty());
    CHECK((support::index_rows(folder.path("a.db")) == expected));
}

TEST_CASE("a full disk is told in one sentence, and what was stored before is whole", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 2);
    build(options(folder));
    write_models(folder, 6);
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limits{};
    getrlimit(RLIMIT_FSIZE, &limits);
    const rlimit tight{30000, limits.rlim_max};
    setrlimit(RLIMIT_FSIZE, &tight);
    const auto full = app::build_index(options(folder), {}, {});
    setrlimit(RLIMIT_FSIZE, &limits);
    std::signal(SIGXFSZ, before);
    REQUIRE_FALSE(full);
    CHECK_THAT(full.error().sentence(), Catch::Contains("a.db: "));
    CHECK(open(folder).check()->empty());
    CHECK(open(folder).list()->size() == 2);
    CHECK(build(options(folder)).added == 4);
}

TEST_CASE("a file that is no index, or of a newer program, is refused and not altered", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 1);
    SECTION("text") {
        folder.write("a.db", "Dear all,\n");
    }
    SECTION("another program's database") {
        const auto other = db::Database::open(folder.path("a.db"), db::OpenMode::Create, {.application_id = 7});
        REQUIRE(other);
        REQUIRE(other->execute("PRAGMA application_id = 7; CREATE TABLE t (a); INSERT INTO t VALUES (1)"));
    }
    SECTION("of a newer program") {
        build(options(folder));
        const auto ours = db::open_collection(folder.path("a.db"), db::OpenMode::ReadWrite);
        REQUIRE(ours);
        REQUIRE(ours->execute("PRAGMA user_version = 99"));
    }
    const std::string before = bytes_of(folder.path("a.db"));
    const auto refused = app::build_index(options(folder), {}, {});
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().sentence(), Catch::Contains("was left as it is"));
    CHECK(bytes_of(folder.path("a.db")) == before);
}

TEST_CASE("a build on a damaged index says so or goes on, and never makes it worse", "[builder]") {
    const TemporaryFolder folder;
    write_models(folder, 3);
    build(options(folder));
    const std::string good = bytes_of(folder.path("a.db"));
    folder.write("models/m50.off", support::off_text(support::block_model(50)));
    for (std::size_t page = 1; page < good.size() / db::kPageSize; ++page) {
        std::string bad = good;
        std::fill_n(bad.begin() + static_cast<std::ptrdiff_t>(page * db::kPageSize), db::kPageSize, '\xa5');
        folder.write("a.db", bad);
        std::stop_source at_once;
        at_once.request_stop();  // what is tested is how the index is opened and asked
        const auto report = app::build_index(options(folder), at_once.get_token(), {});
        if (!report) CHECK_THAT(report.error().sentence(), Catch::Contains("damaged"));
        CHECK(bytes_of(folder.path("a.db")) == bad);
    }
}

TEST_CASE("soup, flipped and doubled faces and another unit give the same views", "[builder]") {
    const TemporaryFolder folder;
    const core::TriangleMesh mesh = support::block_model(4);
    core::TriangleMesh soup, flipped = mesh, doubled = mesh, larger = mesh;
    for (const auto& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t i : t) soup.vertices.push_back(mesh.vertices[i]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    for (std::size_t i = 0; i < flipped.triangles.size(); i += 2)
        std::swap(flipped.triangles[i][0], flipped.triangles[i][1]);
    doubled.triangles.insert(doubled.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    for (core::Vec3& v : larger.vertices) v = v * 1024.0;
    int n = 0;
    for (const core::TriangleMesh* m :
         std::initializer_list<const core::TriangleMesh*>{&mesh, &soup, &flipped, &doubled, &larger}) {
        folder.write("models/" + std::to_string(n++) + ".off", support::off_text(*m));
    }
    build(options(folder));
    const auto models = open(folder).load_views();
    REQUIRE(models->models.size() == 5);
    for (const db::ModelRecord& model : models->models) {
        for (std::size_t v = 0; v < 2; ++v) {
            CHECK(model.views[v].camera_number == models->models[0].views[v].camera_number);
            CHECK(model.views[v].descriptor == models->models[0].views[v].descriptor);
            CHECK(model.views[v].contour == models->models[0].views[v].contour);
        }
    }
}
