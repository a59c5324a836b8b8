#include "db/stores/design_rows.hpp"

#include <algorithm>
#include <utility>

#include "core/base/checksum.hpp"
#include "core/exchange/design_file.hpp"
#include "db/codec/bytes.hpp"

namespace db {
namespace {

using Kind = JournalEntry::Kind;

/// Stands for an act that could not be read until all is replayed, so that places in the history stay what they were.
/// No step of a drawing has such a name.
constexpr const char* kLost = "\x01lost";

std::uint64_t sum(const ByteWriter& out) {
    return core::fnv1a64(out.bytes());
}

std::uint64_t sum_of_design(const DesignEntry& entry) {
    ByteWriter out;
    out.u64(static_cast<std::uint64_t>(entry.id));
    out.text(entry.name);
    out.u64(static_cast<std::uint64_t>(entry.created_us));
    out.u64(static_cast<std::uint64_t>(entry.changed_us));
    out.u64(static_cast<std::uint64_t>(entry.deleted_us.value_or(0)));
    return sum(out);
}

std::uint64_t sum_of_snapshot(std::int64_t id, std::int64_t sequence, std::int64_t acts, const std::string& design,
                              const std::string& undone) {
    ByteWriter out;
    for (const std::int64_t number : {id, sequence, acts}) out.u64(static_cast<std::uint64_t>(number));
    out.text(design);
    out.text(undone);
    return sum(out);
}

std::uint64_t sum_of_entry(std::int64_t id, std::int64_t sequence, std::int64_t kind, std::int64_t version,
                           const std::string& payload) {
    ByteWriter out;
    for (const std::int64_t number : {id, sequence, kind, version}) out.u64(static_cast<std::uint64_t>(number));
    out.text(payload);
    return sum(out);
}

std::uint64_t sum_of_thumbnail(std::int64_t id, std::span<const std::byte> png) {
    ByteWriter out;
    out.u64(static_cast<std::uint64_t>(id));
    return core::fnv1a64(png, sum(out));
}

struct Snapshot {
    std::int64_t sequence = 0, acts = 0;
    bool sound = false;
    core::Result<DesignState> state;
};

core::Result<DesignState> state_of(const std::string& design, const std::string& undone) {
    core::Result<core::Design> read = core::parse_design(design);
    if (!read) return core::unexpected(read.error());
    core::Result<std::vector<core::DesignStep>> again = parse_steps(undone);
    if (!again) return core::unexpected(again.error());
    return DesignState{std::move(*read), std::move(*again)};
}

/// Newest first.
core::Result<std::vector<Snapshot>> snapshots_of(const Database& database, std::int64_t id) {
    core::Result<Statement> rows = database.prepare(
        "SELECT sequence, acts, design, undone, checksum FROM snapshot WHERE design_id = ? ORDER BY sequence DESC");
    if (!rows) return core::unexpected(rows.error());
    rows->bind(id);
    std::vector<Snapshot> found;
    for (;;) {
        const core::Result<bool> row = rows->step();
        if (!row) return core::unexpected(row.error());
        if (!*row) return found;
        const std::int64_t sequence = rows->integer(0), acts = rows->integer(1);
        const std::string design = rows->text(2), undone = rows->text(3);
        const bool sound =
            sum_of_snapshot(id, sequence, acts, design, undone) == static_cast<std::uint64_t>(rows->integer(4));
        found.push_back({sequence, acts, sound, state_of(design, undone)});
    }
}

/// The newest whole snapshot; without one the newest that can still be read; without one an empty design, if the
/// journal goes back to its start.
core::Result<OpenedDesign> start_from(std::vector<Snapshot> snapshots, std::int64_t first_entry) {
    for (const Snapshot& s : snapshots)
        if (s.sound && !s.state && s.state.error().code == core::ErrorCode::NewerVersion)
            return core::unexpected(s.state.error());
    OpenedDesign opened;
    for (const bool sound : {true, false})
        for (Snapshot& s : snapshots) {
            if (s.sound != sound || !s.state) continue;
            if (&s != snapshots.data())
                opened.faults.emplace_back("its newest copy is damaged; an older one and the steps since were used");
            else if (!sound)
                opened.faults.emplace_back("its copy is damaged; look whether all of it is as it was");
            opened.sequence = s.sequence;
            opened.state = std::move(*s.state);
            return opened;
        }
    if (first_entry != 1)
        return core::unexpected(core::ErrorCode::Damaged,
                                "the design is damaged and cannot be opened; restore a copy of the file");
    opened.state.design.body = *core::measures_of_size("38");
    if (!snapshots.empty()) {
        core::DesignStep lost;
        lost.name = kLost;
        opened.state.design.steps.assign(
            static_cast<std::size_t>(std::clamp<std::int64_t>(snapshots.back().acts, 0, 100000)), lost);
    }
    opened.faults.emplace_back("its copy is damaged; its steps were taken again on a mannequin of size 38");
    return opened;
}

class Replay {
  public:
    explicit Replay(OpenedDesign& opened) : opened_(opened) {}

    /// The present row of the journal. NewerVersion where a newer Croquis wrote it.
    core::Result<void> take(const Statement& row) {
        const std::int64_t sequence = row.integer(0), kind = row.integer(1), version = row.integer(2);
        const std::string payload = row.text(3);
        if (sequence != opened_.sequence + 1) note(opened_.sequence + 1, sequence - 1);
        opened_.sequence = sequence;
        const bool sound =
            sum_of_entry(opened_.id, sequence, kind, version, payload) == static_cast<std::uint64_t>(row.integer(4));
        if (sound && version > core::kDesignVersion)
            return core::unexpected(core::ErrorCode::NewerVersion,
                                    "a newer Croquis drew on the design; update this one to open it");
        core::Result<JournalEntry> entry = parse_entry(kind, payload);
        if (!sound || !entry) {
            note(sequence, sequence);
            // which kind a damaged row was can only be believed; an act may have had any number of steps
            if (kind == static_cast<std::int64_t>(Kind::Place) || kind == static_cast<std::int64_t>(Kind::Rename))
                return {};
            entry = JournalEntry{.kind = Kind::Steps, .steps = {core::DesignStep{}}};
            entry->steps.front().name = kLost;
        }
        apply(*entry, opened_.state);
        return {};
    }

    void finish() {
        const auto lost = [](const core::DesignStep& step) { return step.name == kLost; };
        std::erase_if(opened_.state.design.steps, lost);
        std::erase_if(opened_.state.undone, lost);
    }

  private:
    void note(std::int64_t first, std::int64_t last) {
        opened_.faults.push_back(first == last ? "its record " + std::to_string(first) + " is damaged and was left out"
                                               : "its records " + std::to_string(first) + " to " +
                                                     std::to_string(last) + " are missing and were left out");
    }
    OpenedDesign& opened_;
};

core::Result<void> replay_journal(const Database& database, OpenedDesign& opened) {
    core::Result<Statement> rows = database.prepare(
        "SELECT sequence, kind, version, payload, checksum FROM journal WHERE design_id = ? AND sequence > ? "
        "ORDER BY sequence");
    if (!rows) return core::unexpected(rows.error());
    rows->bind(opened.id).bind(opened.sequence);
    Replay replay(opened);
    for (;;) {
        const core::Result<bool> row = rows->step();
        if (!row) return core::unexpected(row.error());
        if (!*row) break;
        if (core::Result<void> taken = replay.take(*rows); !taken) return taken;
    }
    replay.finish();
    return {};
}

/// One number of a statement with one parameter.
core::Result<std::int64_t> number(const Database& database, const char* sql, std::int64_t id) {
    core::Result<Statement> statement = database.prepare(sql);
    if (!statement) return core::unexpected(statement.error());
    const core::Result<bool> row = statement->bind(id).step();
    if (!row) return core::unexpected(row.error());
    return *row ? statement->integer(0) : 0;
}

}  // namespace

DesignRow design_row(const Statement& row) {
    DesignRow found{{.id = row.integer(0),
                     .name = row.text(1),
                     .created_us = row.integer(2),
                     .changed_us = row.integer(3),
                     .deleted_us = {},
                     .has_thumbnail = row.integer(6) != 0}};
    if (row.integer(4) != 0) found.entry.deleted_us = row.integer(4);
    found.sound = sum_of_design(found.entry) == static_cast<std::uint64_t>(row.integer(5));
    return found;
}

core::Result<DesignRow> find_design_row(const Database& database, std::int64_t id) {
    core::Result<Statement> find = database.prepare(std::string(kDesignRow) + "WHERE id = ?");
    if (!find) return core::unexpected(find.error());
    const core::Result<bool> row = find->bind(id).step();
    if (!row) return core::unexpected(row.error());
    if (!*row)
        return core::unexpected(core::ErrorCode::BadArgument, "there is no design " + std::to_string(id),
                                database.where());
    return design_row(*find);
}

core::Result<void> update_design_row(const Database& database, const DesignEntry& entry) {
    core::Result<Statement> update = database.prepare(
        "UPDATE design SET name = ?, created_us = ?, changed_us = ?, deleted_us = ?, checksum = ? WHERE id = ?");
    if (!update) return core::unexpected(update.error());
    return update->bind(entry.name)
        .bind(entry.created_us)
        .bind(entry.changed_us)
        .bind(entry.deleted_us.value_or(0))
        .bind(sum_of_design(entry))
        .bind(entry.id)
        .run();
}

core::Result<std::int64_t> insert_design_row(const Database& database, DesignEntry entry) {
    core::Result<Statement> insert = database.prepare(
        "INSERT INTO design (name, created_us, changed_us, deleted_us, checksum) VALUES ('', 0, 0, 0, 0)");
    if (!insert) return core::unexpected(insert.error());
    if (const core::Result<void> done = insert->run(); !done) return core::unexpected(done.error());
    entry.id = database.last_insert_id();  // which the checksum covers
    if (const core::Result<void> done = update_design_row(database, entry); !done)
        return core::unexpected(done.error());
    return entry.id;
}

core::Result<void> insert_snapshot(const Database& database, std::int64_t id, std::int64_t sequence,
                                   const DesignState& state) {
    core::Result<Statement> insert = database.prepare(
        "INSERT OR REPLACE INTO snapshot (design_id, sequence, acts, design, undone, checksum) VALUES (?, ?, ?, ?, ?, "
        "?)");
    if (!insert) return core::unexpected(insert.error());
    const std::string design = core::design_text(state.design), undone = steps_text(state.undone);
    const auto acts = static_cast<std::int64_t>(count_acts(state.design.steps));
    return insert->bind(id)
        .bind(sequence)
        .bind(acts)
        .bind(design)
        .bind(undone)
        .bind(sum_of_snapshot(id, sequence, acts, design, undone))
        .run();
}

core::Result<void> insert_entries(const Database& database, std::int64_t id, std::int64_t first,
                                  std::span<const JournalEntry> entries) {
    core::Result<Statement> insert = database.prepare(
        "INSERT INTO journal (design_id, sequence, kind, version, payload, checksum) VALUES (?, ?, ?, ?, ?, ?)");
    if (!insert) return core::unexpected(insert.error());
    for (const JournalEntry& entry : entries) {
        const auto kind = static_cast<std::int64_t>(entry.kind);
        const std::string payload = payload_text(entry);
        core::Result<void> done = insert->bind(id)
                                      .bind(first)
                                      .bind(kind)
                                      .bind(core::kDesignVersion)
                                      .bind(payload)
                                      .bind(sum_of_entry(id, first, kind, core::kDesignVersion, payload))
                                      .run();
        if (!done) return done;
        ++first;
    }
    return {};
}

core::Result<std::optional<std::size_t>> stored_already(const Database& database, std::int64_t id, std::int64_t first,
                                                        std::span<const JournalEntry> entries) {
    core::Result<Statement> rows = database.prepare(
        "SELECT sequence, kind, payload FROM journal WHERE design_id = ? AND sequence >= ? ORDER BY sequence");
    if (!rows) return core::unexpected(rows.error());
    rows->bind(id).bind(first);
    for (std::size_t n = 0;; ++n) {
        const core::Result<bool> row = rows->step();
        if (!row) return core::unexpected(row.error());
        if (!*row) return std::optional(n);
        const bool same = n < entries.size() && rows->integer(0) == first + static_cast<std::int64_t>(n) &&
                          rows->integer(1) == static_cast<std::int64_t>(entries[n].kind) &&
                          rows->text(2) == payload_text(entries[n]);
        if (!same) return std::optional<std::size_t>();
    }
}

core::Result<std::int64_t> journal_length(const Database& database, std::int64_t id) {
    return number(database,
                  "SELECT count(*) FROM journal WHERE design_id = ?1 AND sequence > "
                  "(SELECT ifnull(max(sequence), 0) FROM snapshot WHERE design_id = ?1)",
                  id);
}

core::Result<std::int64_t> last_design_sequence(const Database& database, std::int64_t id) {
    return number(database,
                  "SELECT max((SELECT ifnull(max(sequence), 0) FROM journal WHERE design_id = ?1), "
                  "(SELECT ifnull(max(sequence), 0) FROM snapshot WHERE design_id = ?1))",
                  id);
}

core::Result<void> shorten_journal(const Database& database, std::int64_t id) {
    const core::Result<std::int64_t> older = number(
        database, "SELECT sequence FROM snapshot WHERE design_id = ? ORDER BY sequence DESC LIMIT 1 OFFSET 1", id);
    if (!older) return core::unexpected(older.error());
    for (const char* sql : {"DELETE FROM snapshot WHERE design_id = ? AND sequence < ?",
                            "DELETE FROM journal WHERE design_id = ? AND sequence <= ?"}) {
        core::Result<Statement> forget = database.prepare(sql);
        if (!forget) return core::unexpected(forget.error());
        if (core::Result<void> done = forget->bind(id).bind(*older).run(); !done) return done;
    }
    return {};
}

core::Result<OpenedDesign> read_design_rows(const Database& database, std::int64_t id, const std::string& name) {
    core::Result<std::vector<Snapshot>> snapshots = snapshots_of(database, id);
    if (!snapshots) return core::unexpected(snapshots.error());
    const core::Result<std::int64_t> first =
        number(database, "SELECT ifnull(min(sequence), 0) FROM journal WHERE design_id = ?", id);
    if (!first) return core::unexpected(first.error());
    core::Result<OpenedDesign> opened = start_from(std::move(*snapshots), *first);
    if (!opened) return opened;
    opened->id = id;
    if (opened->state.design.name.empty()) opened->state.design.name = name;
    if (const core::Result<void> done = replay_journal(database, *opened); !done) return core::unexpected(done.error());
    return opened;
}

core::Result<int> damaged_snapshots(const Database& database, std::int64_t id) {
    const core::Result<std::vector<Snapshot>> all = snapshots_of(database, id);
    if (!all) return core::unexpected(all.error());
    return static_cast<int>(std::count_if(all->begin(), all->end(), [](const Snapshot& s) { return !s.sound; }));
}

core::Result<void> put_thumbnail(const Database& database, std::int64_t id, std::span<const std::byte> png) {
    core::Result<Statement> put =
        database.prepare("INSERT OR REPLACE INTO design_thumbnail (design_id, png, checksum) VALUES (?, ?, ?)");
    if (!put) return core::unexpected(put.error());
    return put->bind(id).bind(png).bind(sum_of_thumbnail(id, png)).run();
}

core::Result<ThumbnailRow> read_thumbnail_row(const Database& database, std::int64_t id) {
    core::Result<Statement> find = database.prepare("SELECT png, checksum FROM design_thumbnail WHERE design_id = ?");
    if (!find) return core::unexpected(find.error());
    const core::Result<bool> row = find->bind(id).step();
    if (!row) return core::unexpected(row.error());
    if (!*row) return ThumbnailRow{};
    const std::span<const std::byte> png = find->blob(0);
    if (sum_of_thumbnail(id, png) != static_cast<std::uint64_t>(find->integer(1))) return ThumbnailRow{{}, true};
    return ThumbnailRow{{png.begin(), png.end()}, false};
}

}  // namespace db
