#include "db/stores/two_view_index.hpp"

#include <algorithm>

#include "db/migrations/migrations.hpp"
#include "db/sqlite/database.hpp"
#include "db/sqlite/transaction.hpp"
#include "db_fixtures.hpp"

using db::IndexOptions;
using db::ModelRecord;
using db::OpenMode;
using db::TwoViewIndex;
using fixture::TemporaryFolder;

namespace {

TwoViewIndex open(const TemporaryFolder& folder, OpenMode mode = OpenMode::Create,
                  IndexOptions options = {.parameters = "p"}) {
    options.busy_timeout_ms = 20;
    return fixture::value(TwoViewIndex::open(folder / "models.db", mode, std::move(options)));
}

std::vector<ModelRecord> random_models(int from, int to) {
    std::vector<ModelRecord> models;
    for (int n = from; n < to; ++n) models.push_back(fixture::random_model(n));
    return models;
}

}  // namespace

TEST_CASE("models come back as they were stored, in the order of insertion", "[index]") {
    const TemporaryFolder folder;
    const std::vector<ModelRecord> models = random_models(0, 20);
    { CHECK(fixture::value(open(folder).add_all(models)).size() == 20); }
    const TwoViewIndex index = open(folder, OpenMode::ReadOnly);
    const db::LoadedModels loaded = fixture::value(index.load_views());
    CHECK(loaded.damaged.empty());
    REQUIRE(loaded.models.size() == models.size());
    const db::LoadedModels shared = fixture::value(index.load_views(3));
    REQUIRE(shared.models.size() == models.size());
    for (std::size_t i = 0; i < models.size(); ++i) {
        const ModelRecord expected = fixture::as_stored(models[i]);
        CHECK(fixture::same_views(shared.models[i], loaded.models[i]));
        CHECK(loaded.models[i].id == static_cast<std::int64_t>(i) + 1);
        CHECK(fixture::same_views(loaded.models[i], expected));
        CHECK(loaded.models[i].display_mesh.vertices.empty());
        CHECK(fixture::same_mesh(fixture::value(index.load_display_mesh(loaded.models[i].id)), expected.display_mesh));
        const ModelRecord whole = fixture::value(index.load(loaded.models[i].id));
        CHECK(fixture::same_views(whole, expected));
        CHECK(fixture::same_mesh(whole.display_mesh, expected.display_mesh));
        CHECK(loaded.models[i].views[0].thumbnail.empty());
        for (std::size_t v = 0; v < 2; ++v) {
            CHECK(whole.views[v].thumbnail == models[i].views[v].thumbnail);
            CHECK(fixture::value(index.load_thumbnail(whole.id, static_cast<int>(v))) == whole.views[v].thumbnail);
        }
    }
}

TEST_CASE("an outline that is the descriptor's samples is not stored twice", "[index]") {
    const TemporaryFolder folder;
    ModelRecord model = fixture::random_model(4);
    for (db::ModelView& view : model.views) view.outline = view.descriptor.samples;
    TwoViewIndex index = open(folder);
    fixture::value(index.add(model));
    const ModelRecord read = fixture::value(index.load(1));
    CHECK(read.views[0].outline == read.views[0].descriptor.samples);
    CHECK(read.views[1].outline == read.views[1].descriptor.samples);
    const db::Database database = fixture::value(db::open_collection(folder / "models.db", OpenMode::ReadOnly));
    CHECK(fixture::value(database.integer("SELECT max(length(outline)) FROM view")) == 3);
}

TEST_CASE("a model may have no thumbnails, and a replaced one loses its old ones", "[index]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder);
    ModelRecord model = fixture::random_model(0);
    fixture::value(index.add(model));
    for (db::ModelView& view : model.views) view.thumbnail.clear();
    CHECK(fixture::value(index.add(model)) == 1);
    CHECK(fixture::value(index.load_thumbnail(1, 0)).empty());
    CHECK(fixture::value(index.check()).empty());
    CHECK(fixture::sentence(index.load_thumbnail(2, 0)).find("there is no model 2") != std::string::npos);
}

TEST_CASE("the list names the models without their blobs", "[index]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder);
    CHECK(fixture::value(index.list()).empty());
    fixture::value(index.add_all(random_models(0, 3)));
    const std::vector<db::ModelEntry> entries = fixture::value(index.list());
    REQUIRE(entries.size() == 3);
    CHECK(entries[2].id == 3);
    CHECK(entries[2].name == "model 2");
    CHECK(entries[2].class_name == "class 2");
    CHECK(entries[2].source_path == "models/m2.off");
    CHECK(entries[2].content_hash == fixture::random_model(2).content_hash);
    CHECK(entries[2].file_size == fixture::random_model(2).file_size);
}

TEST_CASE("adding a path again replaces the model and keeps its id", "[index]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder);
    fixture::value(index.add_all(random_models(0, 3)));
    ModelRecord changed = fixture::random_model(50);
    changed.source_path = "models/m1.off";
    CHECK(fixture::value(index.add(changed)) == 2);
    CHECK(fixture::value(index.list()).size() == 3);
    CHECK(fixture::same_views(fixture::value(index.load(2)), fixture::as_stored(changed)));
    CHECK(fixture::value(index.check()).empty());
}

TEST_CASE("ids are not given twice", "[index]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder);
    fixture::value(index.add_all(random_models(0, 3)));
    fixture::ok(index.remove(3));
    CHECK(fixture::value(index.add(fixture::random_model(7))) == 4);
}

TEST_CASE("a removed model leaves nothing behind", "[index]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder);
    fixture::value(index.add_all(random_models(0, 3)));
    fixture::ok(index.remove(2));
    CHECK(fixture::value(index.load_views()).models.size() == 2);
    CHECK(fixture::value(index.check()).empty());
    const core::Result<core::TriangleMesh> mesh = index.load_display_mesh(2);
    CHECK(fixture::sentence(mesh).find("there is no model 2; `croquis index list` shows the numbers") !=
          std::string::npos);
    CHECK(mesh.error().code == core::ErrorCode::BadArgument);
    CHECK_FALSE(index.load(2));
    CHECK_FALSE(index.remove(2));
    CHECK_FALSE(index.relabel(2, "a", "b"));
    for (int n : {0, 2}) fixture::ok(index.remove(n + 1));
    const std::uintmax_t before = std::filesystem::file_size(folder / "models.db");
    fixture::ok(index.vacuum());
    CHECK(std::filesystem::file_size(folder / "models.db") <= before);
    CHECK(fixture::value(index.info()).models == 0);
}

TEST_CASE("unchanged models are known by path, content and parameters", "[index]") {
    const TemporaryFolder folder;
    const ModelRecord model = fixture::random_model(1);
    {
        TwoViewIndex index = open(folder);
        fixture::value(index.add(model));
        CHECK(fixture::value(index.is_unchanged(model.source_path, model.content_hash, model.file_size)));
        CHECK_FALSE(fixture::value(index.is_unchanged("models/other.off", model.content_hash, model.file_size)));
        CHECK_FALSE(fixture::value(index.is_unchanged(model.source_path, model.content_hash ^ 1, model.file_size)));
        CHECK_FALSE(fixture::value(index.is_unchanged(model.source_path, model.content_hash, model.file_size + 1)));
        CHECK_FALSE(fixture::value(index.find("models/other.off")));
        CHECK(fixture::value(index.find(model.source_path))->id == 1);
    }
    TwoViewIndex other = open(folder, OpenMode::ReadWrite, {.parameters = "q"});
    CHECK_FALSE(fixture::value(other.is_unchanged(model.source_path, model.content_hash, model.file_size)));
}

TEST_CASE("a stale index says so, model by model", "[index]") {
    const TemporaryFolder folder;
    {
        fixture::value(open(folder, OpenMode::Create, {.parameters = "old", .program_version = "1.0"})
                           .add_all(random_models(0, 3)));
    }
    TwoViewIndex index = open(folder, OpenMode::ReadWrite, {.parameters = "new", .program_version = "1.1"});
    CHECK(fixture::value(index.stale()).value() ==
          "3 of 3 models were described with other settings or by another version; call `croquis index build` on "
          "their files again");
    fixture::value(index.add(fixture::random_model(1)));
    CHECK(fixture::value(index.list())[0].stale);
    CHECK_FALSE(fixture::value(index.list())[1].stale);
    const db::IndexInfo info = fixture::value(index.info());
    CHECK(info.models == 3);
    CHECK(info.stale_models == 2);
    CHECK(info.schema_version == db::newest_version());
    CHECK(info.bytes > 0);
    REQUIRE(info.builds.size() == 2);
    CHECK(info.builds[0].parameters == "old");
    CHECK(info.builds[0].program_version == "1.0");
    CHECK(info.builds[1].models == 1);
    fixture::value(index.add_all(random_models(0, 3)));
    CHECK_FALSE(fixture::value(index.stale()));
}

TEST_CASE("a model gets another name and class without being described again", "[index]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder);
    fixture::value(index.add(fixture::random_model(1)));
    fixture::ok(index.relabel(1, "mare", "horse"));
    const db::ModelEntry entry = fixture::value(index.list()).front();
    CHECK(entry.name == "mare");
    CHECK(entry.class_name == "horse");
    CHECK_FALSE(entry.stale);
    CHECK(fixture::value(index.check()).empty());
}

TEST_CASE("a model that cannot be stored is named, and nothing of its batch is", "[index]") {
    const TemporaryFolder folder;
    TwoViewIndex index = open(folder);
    fixture::value(index.add_all(random_models(0, 2)));
    std::vector<ModelRecord> batch = random_models(2, 5);
    SECTION("mesh") {
        batch[1].display_mesh.vertices[0].x = 7.0;
    }
    SECTION("camera") {
        batch[1].views[1].camera.up = {};
    }
    SECTION("descriptor") {
        batch[1].views[0].descriptor.stop_points = {-1};
    }
    SECTION("thumbnail") {
        batch[1].views[1].thumbnail[3] = std::byte{0};
    }
    SECTION("length") {
        batch[1].views[0].skeletal_length = std::numeric_limits<double>::quiet_NaN();
    }
    const core::Result<std::vector<std::int64_t>> refused = index.add_all(batch);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().where == "models/m3.off");
    CHECK(fixture::value(index.list()).size() == 2);
    CHECK(fixture::value(index.check()).empty());
    CHECK(fixture::value(index.add(fixture::random_model(9))) == 3);
}

TEST_CASE("the same models give the same file in one batch or many", "[index]") {
    const auto bytes_of = [](int step) {
        const TemporaryFolder folder;
        {
            TwoViewIndex index = open(folder);
            for (int n = 0; n < 12; n += step) fixture::value(index.add_all(random_models(n, n + step)));
            fixture::ok(index.vacuum());
        }
        fixture::Bytes bytes = fixture::read_bytes(folder / "models.db");
        // Counters of commits and of schema changes: bytes 24, 40 and 92 to 99 of the header.
        for (const std::size_t at : {24, 40, 92, 96})
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), 4, '\0');
        return bytes;
    };
    CHECK(bytes_of(12) == bytes_of(3));
}

TEST_CASE("a full disk leaves the index as it was", "[index]") {
    const TemporaryFolder folder;
    { fixture::value(open(folder).add_all(random_models(0, 3))); }
    {
        TwoViewIndex index = open(folder, OpenMode::ReadWrite, {.parameters = "p", .max_pages = 20});
        const core::Result<std::vector<std::int64_t>> full = index.add_all(random_models(3, 60));
        CHECK(fixture::sentence(full).find("models.db: the disk is full; free some space and try again") !=
              std::string::npos);
        CHECK(full.error().code == core::ErrorCode::WriteFailed);
        CHECK(fixture::value(index.check()).empty());
    }
    CHECK(fixture::value(open(folder, OpenMode::ReadOnly).load_views()).models.size() == 3);
}

TEST_CASE("an index being written to is read meanwhile, a second writer is told", "[index]") {
    const TemporaryFolder folder;
    TwoViewIndex writer = open(folder);
    fixture::value(writer.add_all(random_models(0, 4)));
    const TwoViewIndex reader = open(folder, OpenMode::ReadOnly);
    CHECK(fixture::value(reader.load_views()).models.size() == 4);
    fixture::value(writer.add_all(random_models(4, 8)));
    CHECK(fixture::value(reader.load_views()).models.size() == 8);
    const db::Database holder = fixture::value(db::Database::open(
        folder / "models.db", OpenMode::ReadWrite, {.application_id = 0x43525153, .newest_version = 99}));
    const db::Transaction held = fixture::value(db::Transaction::begin(holder, db::Transaction::Kind::Write));
    const core::Result<std::int64_t> refused = writer.add(fixture::random_model(9));
    CHECK(fixture::sentence(refused).find("another program is using it; wait") != std::string::npos);
    CHECK(fixture::value(reader.load_views()).models.size() == 8);
    CHECK(fixture::value(open(folder, OpenMode::ReadOnly).list()).size() == 8);
}

TEST_CASE("an index opened for reading refuses to be written", "[index]") {
    const TemporaryFolder folder;
    { fixture::value(open(folder).add(fixture::random_model(1))); }
    TwoViewIndex index = open(folder, OpenMode::ReadOnly);
    CHECK(fixture::sentence(index.add(fixture::random_model(2))).find("it cannot be written") != std::string::npos);
    CHECK_FALSE(index.remove(1));
}
