#include "db/stores/design_journal.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "db/migrations/migrations.hpp"
#include "db_fixtures.hpp"
#include "design_fixtures.hpp"

using db::DesignJournal;
using db::DesignStore;
using db::OpenMode;
using fixture::small_design;
using fixture::TemporaryFolder;
using fixture::text_of;
using fixture::value;
using std::chrono::milliseconds;

namespace {

std::int64_t new_design(const std::filesystem::path& path) {
    DesignStore store = value(DesignStore::open(path, OpenMode::Create));
    return value(store.create(small_design("Dress", 1)));
}

db::OpenedDesign stored(const std::filesystem::path& path, std::int64_t id) {
    return value(value(DesignStore::open(path, OpenMode::ReadWrite)).load(id));
}

}  // namespace

TEST_CASE("what is drawn is on the disk soon, and all of it when the journal ends", "[design_journal]") {
    const TemporaryFolder folder;
    const std::int64_t id = new_design(folder / "d.db");
    db::DesignState drawn{small_design("Dress", 1), {}};
    {
        DesignJournal journal(folder / "d.db", id, 0, {.compact_after = 30});
        for (int n = 0; n < 40; ++n) {
            CHECK(journal.append(fixture::drawn_entry(n)) == n + 1);
            db::apply(fixture::drawn_entry(n), drawn);
        }
        REQUIRE(journal.wait(milliseconds(5000)));
        CHECK(journal.acknowledged() == 40);
        CHECK_FALSE(journal.fault());
        CHECK(text_of(stored(folder / "d.db", id).state) == text_of(drawn));
        CHECK(journal.append(fixture::step_entry(77)));
        db::apply(fixture::step_entry(77), drawn);
    }
    const db::OpenedDesign opened = stored(folder / "d.db", id);
    CHECK(opened.sequence == 41);
    CHECK(opened.faults.empty());
    CHECK(text_of(opened.state) == text_of(drawn));
    const db::Database database = value(db::open_designs(folder / "d.db", OpenMode::ReadOnly));
    CHECK(value(database.integer("SELECT max(sequence) FROM snapshot")) == 41);  // compacted at its end
}

TEST_CASE("a disk that refuses keeps nobody waiting, and gets all of it later", "[design_journal]") {
    const TemporaryFolder folder;
    const std::int64_t id = new_design(folder / "d.db");
    std::filesystem::rename(folder / "d.db", folder / "away.db");
    db::DesignState drawn{small_design("Dress", 1), {}};
    DesignJournal journal(folder / "d.db", id, 0, {.most_waiting = 3, .retry = milliseconds(5)});
    for (int n = 0; n < 3; ++n) {
        CHECK(journal.append(fixture::step_entry(n)));
        db::apply(fixture::step_entry(n), drawn);
    }
    CHECK_FALSE(journal.wait(milliseconds(50)));
    REQUIRE(journal.fault());
    CHECK(journal.fault()->code == core::ErrorCode::FileMissing);
    CHECK(journal.acknowledged() == 0);
    bool refused = false;
    for (int n = 3; n < 9 && !refused; ++n) {
        if (!journal.append(fixture::step_entry(n))) refused = true;
        db::apply(fixture::step_entry(n), drawn);
    }
    CHECK(refused);
    SECTION("the whole design takes the place of the queue") {
        const std::int64_t number = journal.keep(drawn);
        CHECK(journal.append(fixture::step_entry(20)) == number + 1);
        db::apply(fixture::step_entry(20), drawn);
    }
    SECTION("twice, the newest wins") {
        journal.keep({});
        journal.keep(drawn);
    }
    std::filesystem::rename(folder / "away.db", folder / "d.db");
    REQUIRE(journal.wait(milliseconds(5000)));
    CHECK_FALSE(journal.fault());
    CHECK(journal.acknowledged() == journal.appended());
    CHECK(text_of(stored(folder / "d.db", id).state) == text_of(drawn));
}

TEST_CASE("a picture is stored with what it shows", "[design_journal]") {
    const TemporaryFolder folder;
    const std::int64_t id = new_design(folder / "d.db");
    std::vector<std::byte> png;
    for (const int byte : {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 7}) png.push_back(std::byte(byte));
    DesignJournal journal(folder / "d.db", id, 0);
    journal.set_thumbnail({std::byte{1}});  // no PNG
    journal.set_thumbnail(png);
    REQUIRE(journal.wait(milliseconds(5000)));
    CHECK(value(value(DesignStore::open(folder / "d.db", OpenMode::ReadWrite)).thumbnail(id)) == png);
}

TEST_CASE("the journal ends soon even where the disk never takes it", "[design_journal]") {
    const TemporaryFolder folder;
    DesignJournal journal(folder / "none.db", 1, 0, {.retry = milliseconds(5), .last_words = milliseconds(20)});
    CHECK(journal.append(fixture::step_entry(1)));
}

TEST_CASE("killed at any moment, every acknowledged entry is there", "[design_journal]") {
    fixture::Random random(5);
    for (int round = 0; round < 6; ++round) {
        const TemporaryFolder folder;
        const std::int64_t id = new_design(folder / "d.db");
        std::array<int, 2> pipe_ends{};
        REQUIRE(pipe(pipe_ends.data()) == 0);
        const pid_t child = fork();
        if (child == 0) {
            DesignJournal journal(folder / "d.db", id, 0);
            for (int n = 0;; ++n) {
                static_cast<void>(journal.append(fixture::drawn_entry(n)));
                std::this_thread::sleep_for(std::chrono::microseconds(300));
                const std::int64_t sure = journal.acknowledged();
                if (write(pipe_ends[1], &sure, sizeof sure) < 0) _exit(1);
            }
        }
        close(pipe_ends[1]);
        std::this_thread::sleep_for(milliseconds(fixture::whole(random, 5, 60)));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        std::int64_t sure = 0, told = 0;
        while (read(pipe_ends[0], &told, sizeof told) == sizeof told) sure = told;
        close(pipe_ends[0]);
        const db::OpenedDesign opened = stored(folder / "d.db", id);
        CHECK(opened.faults.empty());
        CHECK(opened.sequence >= sure);
        db::DesignState drawn{small_design("Dress", 1), {}};
        for (int n = 0; n < opened.sequence; ++n) db::apply(fixture::drawn_entry(n), drawn);
        CHECK(text_of(opened.state) == text_of(drawn));
    }
}
