#include "db/stores/design_store.hpp"

#include "core/base/checksum.hpp"
#include "db/codec/bytes.hpp"
#include "db/migrations/migrations.hpp"
#include "db_fixtures.hpp"
#include "design_fixtures.hpp"

using core::ErrorCode;
using db::DesignEntry;
using db::DesignStore;
using db::JournalEntry;
using db::OpenMode;
using db::Shelf;
using fixture::small_design;
using fixture::TemporaryFolder;
using fixture::text_of;
using fixture::value;

namespace {

constexpr std::int64_t kDay_us = 86'400'000'000;

/// A store whose clock is set by hand.
struct Desk {
    std::int64_t now_us = 1'000'000;
    DesignStore store;
    explicit Desk(const TemporaryFolder& folder)
        : store(value(
              DesignStore::open(folder / "designs.db", OpenMode::Create, {.now_us = [this] { return now_us; }}))) {}
};

void run_sql(const TemporaryFolder& folder, const std::string& sql) {
    const db::Database database = value(db::open_designs(folder / "designs.db", OpenMode::ReadWrite));
    fixture::ok(database.execute(sql));
}

std::vector<std::string> names(const std::vector<DesignEntry>& entries) {
    std::vector<std::string> out;
    for (const DesignEntry& entry : entries) out.push_back(entry.name);
    return out;
}

std::vector<std::byte> tiny_png(int n) {
    std::vector<std::byte> png;
    for (const int byte : {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, n}) png.push_back(std::byte(byte));
    return png;
}

}  // namespace

TEST_CASE("a design comes back as the steps it was drawn in", "[design_store]") {
    const TemporaryFolder folder;
    Desk desk(folder);
    const std::int64_t id = value(desk.store.create(small_design("Dress", 3)));
    db::DesignState drawn{small_design("Dress", 3), {}};
    std::int64_t sequence = 0;
    for (int n = 0; n < 60; n += 3) {
        std::vector<JournalEntry> entries;
        for (int k = n; k < n + 3; ++k) entries.push_back(fixture::drawn_entry(k));
        fixture::ok(desk.store.append(id, sequence + 1, entries));
        sequence += 3;
        for (const JournalEntry& entry : entries) db::apply(entry, drawn);
        const db::OpenedDesign opened = value(desk.store.load(id));
        CHECK(opened.faults.empty());
        CHECK(opened.sequence == sequence);
        CHECK(text_of(opened.state) == text_of(drawn));
    }
    CHECK(value(desk.store.find(id)).name == drawn.design.name);
    SECTION("and so after its journal became a snapshot, twice") {
        for (int round = 0; round < 2; ++round) {
            fixture::ok(desk.store.compact(id));
            CHECK(text_of(value(desk.store.load(id)).state) == text_of(drawn));
        }
        const JournalEntry next = fixture::step_entry(99);
        fixture::ok(desk.store.append(id, sequence + 1, std::span(&next, 1)));
        db::apply(next, drawn);
        fixture::ok(desk.store.compact(id));
        fixture::ok(desk.store.keep(id, drawn, sequence + 2));
        CHECK(text_of(value(desk.store.load(id)).state) == text_of(drawn));
        CHECK(value(desk.store.load(id)).sequence == sequence + 2);
        const db::Database database = value(db::open_designs(folder / "designs.db", OpenMode::ReadOnly));
        CHECK(value(database.integer("SELECT count(*) FROM snapshot")) == 2);
        CHECK(value(database.integer("SELECT count(*) FROM journal")) == 0);
    }
    CHECK(value(desk.store.check()).empty());
}

TEST_CASE("a place in the history counts acts, not steps", "[design_store]") {
    db::DesignState state{small_design("A", 5), {}};
    state.design.steps[1].with_last = state.design.steps[2].with_last = true;  // 3 acts: 0 1 2, 3, 4
    const db::DesignState whole = state;
    CHECK(db::count_acts(state.design.steps) == 3);
    const auto go_to = [&](std::size_t place) {
        db::apply({.kind = JournalEntry::Kind::Place, .place = place}, state);
    };
    go_to(1);
    CHECK(state.design.steps.size() == 3);
    CHECK(state.undone.size() == 2);
    go_to(2);
    CHECK(state.design.steps.size() == 4);
    go_to(0);
    CHECK(state.design.steps.empty());
    go_to(3);
    CHECK(text_of(state) == text_of(whole));
    go_to(99);
    CHECK(text_of(state) == text_of(whole));
    go_to(2);
    db::apply(fixture::step_entry(9), state);  // a new act ends what was undone
    CHECK(state.undone.empty());
    CHECK(state.design.steps.back().name == "line 9");
}

TEST_CASE("the gallery's order, copies, names and the bin", "[design_store]") {
    const TemporaryFolder folder;
    Desk desk(folder);
    const std::int64_t dress = value(desk.store.create(small_design("Dress", 2)));
    desk.now_us += 10;
    const std::int64_t skirt = value(desk.store.create(small_design("Skirt", 1)));
    CHECK(names(value(desk.store.list())) == std::vector<std::string>{"Skirt", "Dress"});
    fixture::ok(desk.store.set_thumbnail(dress, tiny_png(1)));
    desk.now_us += 10;
    const std::int64_t copy = value(desk.store.duplicate(dress, "Dress 2"));
    CHECK(value(desk.store.thumbnail(copy)) == tiny_png(1));
    CHECK(value(desk.store.find(copy)).has_thumbnail);
    CHECK(value(desk.store.thumbnail(skirt)).empty());
    desk.now_us += 10;
    fixture::ok(desk.store.rename(dress, "Evening"));
    CHECK(value(desk.store.load(dress)).state.design.name == "Evening");
    CHECK(value(desk.store.load(copy)).state.design.name == "Dress 2");
    CHECK(names(value(desk.store.list())) == std::vector<std::string>{"Evening", "Dress 2", "Skirt"});

    fixture::ok(desk.store.remove(copy));
    desk.now_us += 5 * kDay_us;
    fixture::ok(desk.store.remove(skirt));
    CHECK(names(value(desk.store.list())) == std::vector<std::string>{"Evening"});
    CHECK(names(value(desk.store.list(Shelf::Bin))) == std::vector<std::string>{"Skirt", "Dress 2"});
    CHECK(value(desk.store.load(copy)).state.design.steps.size() == 2);  // the bin can be looked at
    fixture::ok(desk.store.restore(skirt));
    fixture::ok(desk.store.restore(skirt));
    CHECK(names(value(desk.store.list())) == std::vector<std::string>{"Evening", "Skirt"});
    CHECK(value(desk.store.purge(6)) == 0);
    CHECK(value(desk.store.purge(4)) == 1);
    CHECK(value(desk.store.list(Shelf::Bin)).empty());
    fixture::ok(desk.store.erase(skirt));
    CHECK(desk.store.load(skirt).error().code == ErrorCode::BadArgument);
    CHECK(desk.store.erase(skirt).error().code == ErrorCode::BadArgument);
    CHECK(value(desk.store.create(small_design("New", 0))) > copy);  // ids are never given twice
    CHECK(desk.store.set_thumbnail(dress, {}).error().code == ErrorCode::BadArgument);
    CHECK(value(desk.store.check()).empty());
}

TEST_CASE("two that draw on the same design do not mix", "[design_store]") {
    const TemporaryFolder folder;
    Desk desk(folder);
    const std::int64_t id = value(desk.store.create(small_design("A", 0)));
    const JournalEntry entry = fixture::step_entry(1);
    fixture::ok(desk.store.append(id, 1, std::span(&entry, 1)));
    const JournalEntry other = fixture::step_entry(2);
    const core::Result<void> refused = desk.store.append(id, 1, std::span(&other, 1));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::BadArgument);
    CHECK_FALSE(desk.store.append(id, 3, std::span(&entry, 1)));
    CHECK_FALSE(desk.store.keep(id, {}, 0));
    CHECK_FALSE(desk.store.append(id + 1, 1, std::span(&entry, 1)));
    CHECK(value(desk.store.load(id)).state.design.steps.size() == 1);
}

TEST_CASE("entries that were stored although it was said that they were not are stored once", "[design_store]") {
    const TemporaryFolder folder;
    Desk desk(folder);
    const std::int64_t id = value(desk.store.create(small_design("A", 0)));
    const std::vector<JournalEntry> entries{fixture::step_entry(1), fixture::step_entry(2), fixture::step_entry(3)};
    fixture::ok(desk.store.append(id, 1, std::span(entries).first(2)));
    fixture::ok(desk.store.append(id, 1, std::span(entries).first(2)));
    fixture::ok(desk.store.append(id, 1, entries));
    CHECK_FALSE(desk.store.append(id, 1, std::span(entries).first(2)));  // a third stands behind them by now
    CHECK(value(desk.store.load(id)).sequence == 3);
    CHECK(value(desk.store.entries_since_snapshot(id)) == 3);
    CHECK(value(desk.store.check()).empty());
}

TEST_CASE("a name that is no UTF-8 is stored with signs in place of what is none", "[design_store]") {
    const TemporaryFolder folder;
    Desk desk(folder);
    core::Design design = small_design("A\xff", 1);
    design.steps[0].name = "line \xc3";
    const std::int64_t id = value(desk.store.create(design));
    JournalEntry entry = fixture::step_entry(1);
    entry.steps[0].name = "\xfe";
    fixture::ok(desk.store.append(id, 1, std::span(&entry, 1)));
    const db::OpenedDesign opened = value(desk.store.load(id));
    CHECK(opened.faults.empty());
    REQUIRE(opened.state.design.steps.size() == 2);
    CHECK(opened.state.design.steps[0].name == "line \xef\xbf\xbd");
}

TEST_CASE("a new name does not come between a drawing and its journal", "[design_store]") {
    const TemporaryFolder folder;
    Desk desk(folder);
    const std::int64_t id = value(desk.store.create(small_design("A", 0)));
    fixture::ok(desk.store.rename(id, "B"));
    const JournalEntry entry = fixture::step_entry(1);
    fixture::ok(desk.store.append(id, 1, std::span(&entry, 1)));
    CHECK(value(desk.store.load(id)).state.design.name == "B");
    fixture::ok(desk.store.compact(id));
    CHECK(value(desk.store.load(id)).state.design.name == "B");
}

TEST_CASE("what can be read of a damaged design is read, and what was left out is said", "[design_store]") {
    const TemporaryFolder folder;
    Desk desk(folder);
    const std::int64_t id = value(desk.store.create(small_design("Dress", 1)));
    const std::vector<JournalEntry> entries{fixture::step_entry(1),
                                            fixture::step_entry(2),
                                            {.kind = JournalEntry::Kind::Place, .place = 2},
                                            fixture::step_entry(3)};
    fixture::ok(desk.store.append(id, 1, entries));
    const auto left = [&] {
        std::vector<std::string> lines;
        for (const core::DesignStep& step : value(desk.store.load(id)).state.design.steps) lines.push_back(step.name);
        return lines;
    };
    using Lines = std::vector<std::string>;
    REQUIRE(left() == Lines{"line 0", "line 1", "line 3"});

    SECTION("a step that was undone: nothing is missing but the record") {
        run_sql(folder, "UPDATE journal SET payload = 'x' WHERE sequence = 2");
        CHECK(left() == Lines{"line 0", "line 1", "line 3"});
        CHECK(value(desk.store.load(id)).faults == Lines{"its record 2 is damaged and was left out"});
    }
    SECTION("a step that was not") {
        run_sql(folder, "UPDATE journal SET payload = replace(payload, '90', '91') WHERE sequence = 1");
        CHECK(left() == Lines{"line 0", "line 3"});
        CHECK(value(desk.store.load(id)).faults.size() == 1);
    }
    SECTION("a record that is gone") {
        run_sql(folder, "DELETE FROM journal WHERE sequence = 1");
        CHECK(value(desk.store.load(id)).faults == Lines{"its record 1 is damaged and was left out"});
        CHECK(value(desk.store.load(id)).sequence == 4);
    }
    SECTION("the copy, when the journal goes back to the start") {
        run_sql(folder, "UPDATE snapshot SET design = '{'");
        CHECK(left() == Lines{"line 1", "line 3"});
        CHECK(value(desk.store.load(id)).state.design.name == "Dress");
        CHECK(value(desk.store.load(id)).faults.size() == 1);
    }
    SECTION("the newest copy, when there is an older one") {
        fixture::ok(desk.store.compact(id));
        run_sql(folder, "UPDATE snapshot SET design = '{' WHERE sequence = 4");
        CHECK(left() == Lines{"line 0", "line 1", "line 3"});
        CHECK(value(desk.store.load(id)).faults.size() == 1);
    }
    SECTION("a copy that has another checksum and can still be read") {
        run_sql(folder, "UPDATE snapshot SET checksum = 5");
        CHECK(left() == Lines{"line 0", "line 1", "line 3"});
    }
    SECTION("name and dates") {
        run_sql(folder, "UPDATE design SET name = 'other'");
        CHECK(value(desk.store.load(id)).faults == Lines{"its name and dates are damaged"});
        const JournalEntry next = fixture::step_entry(7);
        fixture::ok(desk.store.append(id, 5, std::span(&next, 1)));
        CHECK(value(desk.store.load(id)).faults.size() == 1);
        fixture::ok(desk.store.rename(id, "Dress"));  // makes it good
        CHECK(value(desk.store.load(id)).faults.empty());
        return;
    }
    CHECK_FALSE(value(desk.store.check()).empty());
    const core::Result<void> compacted = desk.store.compact(id);  // damaged rows stay for whoever can mend them
    REQUIRE_FALSE(compacted);
    CHECK(compacted.error().code == ErrorCode::Damaged);
    CHECK(value(desk.store.list()).size() == 1);
    CHECK(value(desk.store.duplicate(id, "Saved")) > id);
}

TEST_CASE("a design of which nothing is left, a picture that is damaged", "[design_store]") {
    const TemporaryFolder folder;
    Desk desk(folder);
    const std::int64_t id = value(desk.store.create(small_design("Dress", 1)));
    fixture::ok(desk.store.set_thumbnail(id, tiny_png(3)));
    run_sql(folder, "UPDATE snapshot SET design = ''; UPDATE design_thumbnail SET png = x'00'");
    CHECK(fixture::sentence(desk.store.load(id)).find("\"Dress\": the design is damaged") != std::string::npos);
    CHECK(value(desk.store.thumbnail(id)).empty());
    CHECK(value(desk.store.check()).size() == 2);
}

TEST_CASE("designs of a newer Croquis are left as they are and said so", "[design_store]") {
    const TemporaryFolder folder;
    Desk desk(folder);
    const std::int64_t id = value(desk.store.create(small_design("Dress", 1)));
    SECTION("the file") {
        run_sql(folder, "PRAGMA user_version = 99");
        const core::Result<DesignStore> refused = DesignStore::open(folder / "designs.db", OpenMode::ReadWrite);
        REQUIRE_FALSE(refused);
        CHECK(refused.error().code == ErrorCode::NewerVersion);
    }
    SECTION("its copy") {
        std::string text = core::design_text(small_design("Dress", 1));
        text.replace(text.find("\"version\": " + std::to_string(core::kDesignVersion)), 12, "\"version\": 9");
        db::ByteWriter row;
        row.u64(static_cast<std::uint64_t>(id));
        row.u64(0);
        row.u64(1);
        row.text(text);
        row.text("");
        run_sql(folder, "UPDATE snapshot SET design = '" + text +
                            "', checksum = " + std::to_string(static_cast<std::int64_t>(core::fnv1a64(row.bytes()))));
        const core::Result<db::OpenedDesign> refused = desk.store.load(id);
        REQUIRE_FALSE(refused);
        CHECK(refused.error().code == ErrorCode::NewerVersion);
        CHECK_FALSE(desk.store.compact(id));
    }
    SECTION("a number that says so and is none") {
        const JournalEntry entry = fixture::step_entry(1);
        fixture::ok(desk.store.append(id, 1, std::span(&entry, 1)));
        run_sql(folder, "UPDATE journal SET version = 99");
        CHECK(value(desk.store.load(id)).faults.size() == 1);
    }
    CHECK(value(desk.store.list()).size() == 1);
}

TEST_CASE("sentences name a file of designs, not an index", "[design_store]") {
    const TemporaryFolder folder;
    fixture::write_bytes(folder / "other.db", {'h', 'o', 'r', 's', 'e'});
    CHECK(fixture::sentence(DesignStore::open(folder / "other.db", OpenMode::Create)).find("file of designs") !=
          std::string::npos);
    CHECK(fixture::sentence(DesignStore::open(folder / "none.db", OpenMode::ReadOnly)).find("drawn at the kiosk") !=
          std::string::npos);
    value(db::open_collection(folder / "models.db", OpenMode::Create));
    CHECK_FALSE(DesignStore::open(folder / "models.db", OpenMode::ReadWrite));
}

TEST_CASE("a file that may only be read can be read", "[design_store]") {
    const TemporaryFolder folder;
    {
        Desk desk(folder);
        value(desk.store.create(small_design("Dress", 2)));
    }
    DesignStore store = value(DesignStore::open(folder / "designs.db", OpenMode::ReadOnly));
    CHECK(value(store.load(1)).state.design.steps.size() == 2);
    const core::Result<std::int64_t> refused = store.create(small_design("B", 0));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::WriteFailed);
}

TEST_CASE("a full disk takes nothing that was stored before", "[design_store]") {
    const TemporaryFolder folder;
    DesignStore store = value(DesignStore::open(folder / "designs.db", OpenMode::Create, {.max_pages = 24}));
    const std::int64_t id = value(store.create(small_design("Dress", 1)));
    int stored = 0;
    for (core::Result<void> done; done; ++stored) {
        const JournalEntry entry = fixture::step_entry(stored);
        done = store.append(id, stored + 1, std::span(&entry, 1));
        if (!done) {
            CHECK(done.error().code == ErrorCode::WriteFailed);
            break;
        }
        REQUIRE(stored < 1000);
    }
    REQUIRE(stored > 3);
    CHECK(value(store.load(id)).state.design.steps.size() == static_cast<std::size_t>(stored) + 1);
    CHECK(value(store.check()).empty());
}
