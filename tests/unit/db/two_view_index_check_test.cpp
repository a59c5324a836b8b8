// Damage of every kind is found, named, and passed over by a search.

#include <algorithm>

#include "db/migrations/migrations.hpp"
#include "db/stores/two_view_index.hpp"
#include "db_fixtures.hpp"

using db::Damage;
using db::OpenMode;
using db::TwoViewIndex;
using fixture::TemporaryFolder;

namespace {

constexpr int kModels = 12;

/// An index of a few models, closed.
void make_index(const std::filesystem::path& path) {
    TwoViewIndex index = fixture::value(TwoViewIndex::open(path, OpenMode::Create, {.parameters = "p"}));
    std::vector<db::ModelRecord> models;
    for (int n = 0; n < kModels; ++n) models.push_back(fixture::random_model(n));
    fixture::value(index.add_all(models));
    CHECK(fixture::value(index.check()).empty());
    CHECK(fixture::value(index.damaged_models()).empty());
}

void alter(const std::filesystem::path& path, const std::string& sql) {
    const db::Database database = fixture::value(db::open_collection(path, OpenMode::ReadWrite));
    fixture::ok(database.execute("PRAGMA foreign_keys = OFF;" + sql));
}

std::vector<std::string> sentences(const std::vector<Damage>& damaged) {
    std::vector<std::string> all;
    for (const Damage& damage : damaged) all.push_back(damage.sentence());
    return all;
}

}  // namespace

TEST_CASE("damage is named by model and part, and a search goes on without the model", "[check]") {
    struct Case {
        std::string sql, found;
        bool for_the_eye_only = false;
    };
    const std::string differs = "it is damaged (its checksum differs); build the model again";
    const auto of = [&](const std::string& part) { return "model 3 (model 2), " + part + ": " + differs; };
    const Case c = GENERATE_COPY(
        Case{"UPDATE view SET camera_number = camera_number + 1 WHERE model_id = 3 AND number = 0", of("view 0")},
        Case{"UPDATE view SET asymmetry = asymmetry * 2 WHERE model_id = 3 AND number = 1", of("view 1")},
        Case{"UPDATE view SET camera = zeroblob(50) WHERE model_id = 3 AND number = 1", of("camera of view 1")},
        Case{"UPDATE view SET outline = x'' WHERE model_id = 3 AND number = 0", of("outline of view 0")},
        Case{"UPDATE view SET descriptor = outline WHERE model_id = 3 AND number = 1", of("descriptor of view 1")},
        Case{"UPDATE view SET descriptor = outline, descriptor_checksum = outline_checksum WHERE model_id = 3 AND "
             "number = 1",
             "model 3 (model 2), descriptor of view 1: it is damaged (it holds something else)"},
        Case{"DELETE FROM thumbnail WHERE model_id = 3; DELETE FROM view WHERE model_id = 3 AND number = 1",
             "model 3 (model 2), view 1: it is missing; build the model again"},
        Case{"UPDATE view SET contour = x'' WHERE model_id = 3 AND number = 1", of("contour of view 1")},
        Case{"UPDATE model SET class_name = 'cow' WHERE id = 3", of("record")},
        Case{"UPDATE thumbnail SET png = zeroblob(99) WHERE model_id = 3 AND number = 1", of("thumbnail of view 1"),
             true},
        Case{"UPDATE display_mesh SET mesh = zeroblob(9) WHERE model_id = 3", of("display mesh"), true},
        Case{"DELETE FROM display_mesh WHERE model_id = 3",
             "model 3 (model 2), display mesh: it is missing; build the model again", true});
    const TemporaryFolder folder;
    make_index(folder / "a.db");
    alter(folder / "a.db", c.sql);
    const TwoViewIndex index = fixture::value(TwoViewIndex::open(folder / "a.db", OpenMode::ReadOnly));
    CHECK(sentences(fixture::value(index.check())) == std::vector<std::string>{c.found});
    const bool by_checksum = c.found.find("it holds something else") == std::string::npos;
    CHECK(fixture::value(index.damaged_models()) == std::vector<std::int64_t>(by_checksum ? 1 : 0, 3));
    CHECK(fixture::value(index.load_views()).models.size() == (c.for_the_eye_only ? kModels : kModels - 1));
    CHECK(fixture::value(index.load_views()).damaged.size() == (c.for_the_eye_only ? 0 : 1));
    CHECK(fixture::sentence(index.load(3)).find(c.found) != std::string::npos);
    CHECK((index.load_display_mesh(3).has_value() && index.load_thumbnail(3, 1).has_value()) != c.for_the_eye_only);
}

TEST_CASE("every changed byte of every blob is noticed", "[check]") {
    const TemporaryFolder folder;
    make_index(folder / "a.db");
    const std::string column = GENERATE("camera", "outline", "descriptor", "contour");
    const db::Database database = fixture::value(db::open_collection(folder / "a.db", OpenMode::ReadWrite));
    const TwoViewIndex index = fixture::value(TwoViewIndex::open(folder / "a.db", OpenMode::ReadOnly));
    db::Statement read =
        fixture::value(database.prepare("SELECT " + column + " FROM view WHERE model_id = 2 AND number = 1"));
    REQUIRE(fixture::value(read.step()));
    const std::vector<std::byte> blob(read.blob(0).begin(), read.blob(0).end());
    read.reset();
    fixture::ok(database.execute("PRAGMA synchronous = OFF"));
    db::Statement write =
        fixture::value(database.prepare("UPDATE view SET " + column + " = ? WHERE model_id = 2 AND number = 1"));
    for (std::size_t at = 0; at < blob.size(); ++at) {
        std::vector<std::byte> flipped = blob;
        flipped[at] ^= static_cast<std::byte>(1 << (at % 8));
        fixture::ok(write.bind(std::span<const std::byte>(flipped)).run());
        const core::Result<db::ModelRecord> model = index.load(2);
        if (model) FAIL("byte " << at << " of " << column << " changed unnoticed");
    }
}

TEST_CASE("changed parameters and rows of nobody are reported", "[check]") {
    const TemporaryFolder folder;
    make_index(folder / "a.db");
    const TwoViewIndex index = fixture::value(TwoViewIndex::open(folder / "a.db", OpenMode::ReadOnly));
    alter(folder / "a.db", "UPDATE build SET parameters = 'x'");
    CHECK(sentences(fixture::value(index.check())) ==
          std::vector<std::string>{"the parameters of build 1 are damaged; build the index again"});
    alter(folder / "a.db", "UPDATE build SET parameters = 'p'; DELETE FROM model WHERE id = 12");
    const std::vector<Damage> orphans = fixture::value(index.check());
    CHECK(orphans.size() == 3);  // two views and a mesh; the thumbnails belong to the views
    for (const Damage& damage : orphans) CHECK(damage.sentence().find("belongs to nothing") != std::string::npos);
}

TEST_CASE("a damaged page is reported, whichever page it is", "[check]") {
    const TemporaryFolder folder;
    make_index(folder / "a.db");
    const fixture::Bytes good = fixture::read_bytes(folder / "a.db");
    const std::size_t pages = good.size() / db::kPageSize;
    REQUIRE(pages > 10);
    const int fill = GENERATE(0x00, 0xa5);
    for (std::size_t page = 0; page < pages; ++page) {
        fixture::Bytes bad = good;
        // The first page keeps its header, so that the file is still ours.
        const std::size_t from = page == 0 ? 100 : page * db::kPageSize;
        std::fill(bad.begin() + static_cast<std::ptrdiff_t>(from),
                  bad.begin() + static_cast<std::ptrdiff_t>((page + 1) * db::kPageSize), static_cast<char>(fill));
        fixture::write_bytes(folder / "bad.db", bad);
        const core::Result<TwoViewIndex> index = TwoViewIndex::open(folder / "bad.db", OpenMode::ReadOnly);
        if (!index) {
            CHECK_FALSE(index.error().message.empty());
            continue;
        }
        const core::Result<std::vector<Damage>> damaged = index->check();
        if (damaged && damaged->empty()) FAIL("page " << page << " is damaged, but the check finds nothing");
        if (damaged) CHECK_FALSE(damaged->front().sentence().empty());
        (void)index->load_views();
        (void)index->list();
        (void)index->info();
    }
}

TEST_CASE("an index cut off anywhere never brings the program down", "[check]") {
    const TemporaryFolder folder;
    make_index(folder / "a.db");
    const fixture::Bytes good = fixture::read_bytes(folder / "a.db");
    for (std::size_t size = 1; size < good.size(); size += 1537) {
        fixture::write_bytes(folder / "bad.db",
                             fixture::Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)));
        const core::Result<TwoViewIndex> index = TwoViewIndex::open(folder / "bad.db", OpenMode::ReadOnly);
        if (!index) continue;
        const core::Result<std::vector<Damage>> damaged = index->check();
        if (damaged && damaged->empty()) FAIL("the first " << size << " bytes pass for a whole index");
    }
}
