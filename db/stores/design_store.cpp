#include "db/stores/design_store.hpp"

#include <chrono>
#include <utility>

#include "db/codec/png_signature.hpp"
#include "db/migrations/migrations.hpp"
#include "db/sqlite/transaction.hpp"
#include "db/stores/design_rows.hpp"

namespace db {
namespace {

constexpr std::int64_t kDay_us = 86'400'000'000;

std::int64_t system_now_us() {
    using std::chrono::microseconds;
    return std::chrono::duration_cast<microseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Runs `work` in one transaction, of which nothing stays when it fails.
template <typename Work>
auto together(const Database& database, Transaction::Kind kind, Work work) -> decltype(work()) {
    core::Result<Transaction> transaction = Transaction::begin(database, kind);
    if (!transaction) return core::unexpected(transaction.error());
    auto result = work();
    if (!result) return result;
    if (const core::Result<void> stored = transaction->commit(); !stored) return core::unexpected(stored.error());
    return result;
}

core::Error drawn_by_others(const std::string& where) {
    return {core::ErrorCode::BadArgument,
            "another program draws on the same design; end it, then open the design again", where};
}

core::Error named(const core::Error& error, const std::string& design, const std::string& where) {
    return {error.code, "\"" + design + "\": " + error.message, where};
}

}  // namespace

DesignStore::DesignStore(Database database, DesignStoreOptions options)
    : database_(std::move(database)), options_(std::move(options)) {}

core::Result<DesignStore> DesignStore::open(const std::filesystem::path& path, OpenMode mode,
                                            DesignStoreOptions options) {
    if (!options.now_us) options.now_us = system_now_us;
    core::Result<Database> database =
        open_designs(path, mode, {.busy_timeout_ms = options.busy_timeout_ms, .max_pages = options.max_pages});
    if (!database) return core::unexpected(database.error());
    return DesignStore(std::move(*database), std::move(options));
}

core::Result<std::vector<DesignEntry>> DesignStore::list(Shelf shelf) const {
    const char* order = shelf == Shelf::Kept ? "WHERE deleted_us = 0 ORDER BY changed_us DESC, id DESC"
                                             : "WHERE deleted_us <> 0 ORDER BY deleted_us DESC, id DESC";
    core::Result<Statement> rows = database_.prepare(std::string(kDesignRow) + order);
    if (!rows) return core::unexpected(rows.error());
    std::vector<DesignEntry> entries;
    for (;;) {
        const core::Result<bool> row = rows->step();
        if (!row) return core::unexpected(row.error());
        if (!*row) return entries;
        entries.push_back(design_row(*rows).entry);
    }
}

core::Result<DesignEntry> DesignStore::find(std::int64_t id) const {
    core::Result<DesignRow> row = find_design_row(database_, id);
    if (!row) return core::unexpected(row.error());
    return std::move(row->entry);
}

core::Result<std::int64_t> DesignStore::create(const core::Design& design) {
    return together(database_, Transaction::Kind::Write, [&]() -> core::Result<std::int64_t> {
        const std::int64_t now = options_.now_us();
        core::Result<std::int64_t> id =
            insert_design_row(database_, {.name = design.name, .created_us = now, .changed_us = now, .deleted_us = {}});
        if (!id) return id;
        const core::Result<void> kept = insert_snapshot(database_, *id, 0, {design, {}});
        if (!kept) return core::unexpected(kept.error());
        return id;
    });
}

core::Result<OpenedDesign> DesignStore::load(std::int64_t id) const {
    return together(database_, Transaction::Kind::Read, [&]() -> core::Result<OpenedDesign> {
        const core::Result<DesignRow> row = find_design_row(database_, id);
        if (!row) return core::unexpected(row.error());
        core::Result<OpenedDesign> opened = read_design_rows(database_, id, row->entry.name);
        if (!opened) return core::unexpected(named(opened.error(), row->entry.name, database_.where()));
        if (row->sound)
            opened->state.design.name = row->entry.name;  // it may have got another name without being opened
        else
            opened->faults.emplace_back("its name and dates are damaged");
        return opened;
    });
}

core::Result<std::int64_t> DesignStore::duplicate(std::int64_t id, const std::string& name) {
    core::Result<OpenedDesign> opened = load(id);
    if (!opened) return core::unexpected(opened.error());
    opened->state.design.name = name;
    return together(database_, Transaction::Kind::Write, [&]() -> core::Result<std::int64_t> {
        const std::int64_t now = options_.now_us();
        core::Result<std::int64_t> copy =
            insert_design_row(database_, {.name = name, .created_us = now, .changed_us = now, .deleted_us = {}});
        if (!copy) return copy;
        core::Result<void> done = insert_snapshot(database_, *copy, 0, opened->state);
        if (!done) return core::unexpected(done.error());
        const core::Result<ThumbnailRow> picture = read_thumbnail_row(database_, id);
        if (!picture) return core::unexpected(picture.error());
        if (!picture->png.empty()) done = put_thumbnail(database_, *copy, picture->png);
        if (!done) return core::unexpected(done.error());
        return copy;
    });
}

core::Result<void> DesignStore::touch(std::int64_t id, const std::optional<std::string>& name) {
    core::Result<DesignRow> row = find_design_row(database_, id);
    if (!row) return core::unexpected(row.error());
    if (!row->sound && !name) return {};  // a new checksum must not make good what is damaged
    row->entry.changed_us = options_.now_us();
    if (name) row->entry.name = *name;
    return update_design_row(database_, row->entry);
}

core::Result<void> DesignStore::append(std::int64_t id, std::int64_t first, std::span<const JournalEntry> entries) {
    return together(database_, Transaction::Kind::Write, [&]() -> core::Result<void> {
        const core::Result<std::int64_t> last = last_design_sequence(database_, id);
        if (!last) return core::unexpected(last.error());
        const core::Result<std::optional<std::size_t>> stored = stored_already(database_, id, first, entries);
        if (!stored) return core::unexpected(stored.error());
        const auto done = static_cast<std::int64_t>(stored->value_or(0));
        if (!*stored || first + done != *last + 1) return core::unexpected(drawn_by_others(database_.where()));
        const std::span<const JournalEntry> rest = entries.subspan(**stored);
        if (rest.empty()) return {};
        std::optional<std::string> name;
        for (const JournalEntry& entry : rest)
            if (entry.kind == JournalEntry::Kind::Rename) name = entry.name;
        if (core::Result<void> touched = touch(id, name); !touched) return touched;
        return insert_entries(database_, id, first + done, rest);
    });
}

core::Result<void> DesignStore::rename(std::int64_t id, const std::string& name) {
    return together(database_, Transaction::Kind::Write, [&] { return touch(id, name); });
}

core::Result<std::int64_t> DesignStore::entries_since_snapshot(std::int64_t id) const {
    return journal_length(database_, id);
}

core::Result<void> DesignStore::keep(std::int64_t id, const DesignState& state, std::int64_t sequence) {
    return together(database_, Transaction::Kind::Write, [&]() -> core::Result<void> {
        const core::Result<std::int64_t> last = last_design_sequence(database_, id);
        if (!last) return core::unexpected(last.error());
        if (sequence < *last) return core::unexpected(drawn_by_others(database_.where()));
        if (core::Result<void> done = touch(id, state.design.name); !done) return done;
        if (core::Result<void> done = insert_snapshot(database_, id, sequence, state); !done) return done;
        return shorten_journal(database_, id);
    });
}

core::Result<void> DesignStore::compact(std::int64_t id) {
    return together(database_, Transaction::Kind::Write, [&]() -> core::Result<void> {
        const core::Result<DesignRow> row = find_design_row(database_, id);
        if (!row) return core::unexpected(row.error());
        const core::Result<OpenedDesign> opened = read_design_rows(database_, id, row->entry.name);
        if (!opened) return core::unexpected(named(opened.error(), row->entry.name, database_.where()));
        if (!opened->faults.empty())
            return core::unexpected(
                named({core::ErrorCode::Damaged, opened->faults.front(), {}}, row->entry.name, database_.where()));
        if (core::Result<void> done = insert_snapshot(database_, id, opened->sequence, opened->state); !done)
            return done;
        return shorten_journal(database_, id);
    });
}

core::Result<void> DesignStore::set_deleted(std::int64_t id, bool deleted) {
    return together(database_, Transaction::Kind::Write, [&]() -> core::Result<void> {
        core::Result<DesignRow> row = find_design_row(database_, id);
        if (!row) return core::unexpected(row.error());
        if (row->entry.deleted_us.has_value() == deleted) return {};
        row->entry.deleted_us = deleted ? std::optional(options_.now_us()) : std::nullopt;
        return update_design_row(database_, row->entry);
    });
}

core::Result<void> DesignStore::remove(std::int64_t id) {
    return set_deleted(id, true);
}

core::Result<void> DesignStore::restore(std::int64_t id) {
    return set_deleted(id, false);
}

core::Result<int> DesignStore::purge(int days) {
    core::Result<Statement> remove =
        database_.prepare("DELETE FROM design WHERE deleted_us <> 0 AND deleted_us < ? RETURNING id");
    if (!remove) return core::unexpected(remove.error());
    remove->bind(options_.now_us() - kDay_us * days);
    for (int count = 0;; ++count) {
        const core::Result<bool> row = remove->step();
        if (!row) return core::unexpected(row.error());
        if (!*row) return count;
    }
}

core::Result<void> DesignStore::erase(std::int64_t id) {
    return together(database_, Transaction::Kind::Write, [&]() -> core::Result<void> {
        if (const core::Result<DesignRow> row = find_design_row(database_, id); !row)
            return core::unexpected(row.error());
        core::Result<Statement> remove = database_.prepare("DELETE FROM design WHERE id = ?");
        if (!remove) return core::unexpected(remove.error());
        return remove->bind(id).run();
    });
}

core::Result<void> DesignStore::set_thumbnail(std::int64_t id, std::span<const std::byte> png) {
    if (!is_png(png)) return core::unexpected(core::ErrorCode::BadArgument, "a design's picture is no PNG");
    return together(database_, Transaction::Kind::Write, [&]() -> core::Result<void> {
        if (const core::Result<DesignRow> row = find_design_row(database_, id); !row)
            return core::unexpected(row.error());
        return put_thumbnail(database_, id, png);
    });
}

core::Result<std::vector<std::byte>> DesignStore::thumbnail(std::int64_t id) const {
    core::Result<ThumbnailRow> row = read_thumbnail_row(database_, id);
    if (!row) return core::unexpected(row.error());
    return std::move(row->png);
}

core::Result<std::vector<DesignDamage>> DesignStore::check() const {
    return together(database_, Transaction::Kind::Read, [&]() -> core::Result<std::vector<DesignDamage>> {
        std::vector<DesignDamage> damaged;
        core::Result<Statement> pages = database_.prepare("PRAGMA integrity_check(20)");
        if (!pages) return core::unexpected(pages.error());
        for (core::Result<bool> row = pages->step();; row = pages->step()) {
            if (!row) return core::unexpected(row.error());
            if (!*row) break;
            if (pages->text(0) != "ok") damaged.push_back({0, pages->text(0)});
        }
        core::Result<Statement> rows = database_.prepare(std::string(kDesignRow) + "ORDER BY id");
        if (!rows) return core::unexpected(rows.error());
        for (core::Result<bool> row = rows->step();; row = rows->step()) {
            if (!row) return core::unexpected(row.error());
            if (!*row) return damaged;
            check_design(design_row(*rows), damaged);
        }
    });
}

void DesignStore::check_design(const DesignRow& row, std::vector<DesignDamage>& damaged) const {
    const std::string name = "\"" + row.entry.name + "\": ";
    if (!row.sound) damaged.push_back({row.entry.id, name + "its name and dates are damaged"});
    const core::Result<OpenedDesign> opened = read_design_rows(database_, row.entry.id, row.entry.name);
    if (!opened) damaged.push_back({row.entry.id, name + opened.error().message});
    if (opened)
        for (const std::string& fault : opened->faults) damaged.push_back({row.entry.id, name + fault});
    const core::Result<int> copies = damaged_snapshots(database_, row.entry.id);
    if (opened && opened->faults.empty() && copies && *copies > 0)
        damaged.push_back({row.entry.id, name + "its older copy is damaged; the newer one is whole"});
    const core::Result<ThumbnailRow> picture = read_thumbnail_row(database_, row.entry.id);
    if (picture && picture->damaged) damaged.push_back({row.entry.id, name + "its picture is damaged"});
}

}  // namespace db
