#include "db/stores/neighbour_rows.hpp"

#include <cmath>

#include "db/sqlite/transaction.hpp"
#include "db/stores/model_rows.hpp"

namespace db {

namespace {

std::uint64_t checksum_of_row(const NeighbourRow& row) {
    ByteWriter out;
    out.u64(static_cast<std::uint64_t>(row.model_id));
    out.u64(static_cast<std::uint64_t>(row.place));
    out.u64(static_cast<std::uint64_t>(row.neighbour.id));
    out.f64(static_cast<double>(row.neighbour.distance));
    return checksum_of(out.bytes());
}

bool is_sound(const NeighbourList& list) {
    float last = 0.0F;
    for (const StoredNeighbour& neighbour : list.nearest) {
        if (neighbour.id == list.model_id || !std::isfinite(neighbour.distance) || neighbour.distance < last) {
            return false;
        }
        last = neighbour.distance;
    }
    return true;
}

/// Writes one list, its places counted on where a model is no longer there.
core::Result<void> write_list(const NeighbourList& list, Statement& remove, Statement& insert) {
    if (core::Result<void> done = remove.bind(list.model_id).run(); !done) return done;
    NeighbourRow row{.model_id = list.model_id, .place = 0, .neighbour = {}};
    for (const StoredNeighbour& neighbour : list.nearest) {
        // SQLite does not keep the sign of zero.
        row.neighbour = {neighbour.id, neighbour.distance + 0.0F};
        insert.bind(row.model_id).bind(row.place).bind(row.neighbour.id);
        insert.bind(static_cast<double>(row.neighbour.distance)).bind(checksum_of_row(row));
        const core::Result<bool> stored = insert.bind(row.model_id).bind(row.neighbour.id).step();
        if (!stored) return core::unexpected(stored.error());
        if (*stored) ++row.place;
        insert.reset();
    }
    return {};
}

}  // namespace

NeighbourRow neighbour_row(const Statement& row) {
    NeighbourRow out{.model_id = row.integer(0),
                     .place = row.integer(1),
                     .neighbour = {row.integer(2), static_cast<float>(row.real(3))}};
    out.sound = checksum_of_row(out) == static_cast<std::uint64_t>(row.integer(4));
    return out;
}

core::Result<std::optional<std::string>> TwoViewIndex::likeness_measure() const {
    core::Result<Statement> find = database_.prepare("SELECT measure, measure_hash FROM likeness");
    if (!find) return core::unexpected(find.error());
    const core::Result<bool> row = find->step();
    if (!row) return core::unexpected(row.error());
    if (!*row) return std::optional<std::string>();
    std::string measure = find->text(0);
    // A damaged name is that of no distance, so that the lists are measured again.
    if (checksum_of(measure) != static_cast<std::uint64_t>(find->integer(1))) measure.clear();
    return std::optional<std::string>(std::move(measure));
}

core::Result<void> TwoViewIndex::keep_likeness(const std::string& measure) {
    core::Result<Transaction> transaction = Transaction::begin(database_, Transaction::Kind::Write);
    if (!transaction) return core::unexpected(transaction.error());
    const core::Result<std::optional<std::string>> before = likeness_measure();
    if (!before) return core::unexpected(before.error());
    if (*before == measure) return {};
    if (core::Result<void> done = database_.execute("DELETE FROM neighbour; DELETE FROM likeness"); !done) return done;
    core::Result<Statement> insert =
        database_.prepare("INSERT INTO likeness (id, measure, measure_hash) VALUES (1, ?, ?)");
    if (!insert) return core::unexpected(insert.error());
    if (core::Result<void> done = insert->bind(measure).bind(checksum_of(measure)).run(); !done) return done;
    return transaction->commit();
}

core::Result<std::vector<NeighbourList>> TwoViewIndex::neighbour_lists() const {
    core::Result<Statement> rows = database_.prepare(kNeighbourRows);
    if (!rows) return core::unexpected(rows.error());
    std::vector<NeighbourList> lists;
    for (;;) {
        const core::Result<bool> there = rows->step();
        if (!there) return core::unexpected(there.error());
        if (!*there) return lists;
        const NeighbourRow row = neighbour_row(*rows);
        if (lists.empty() || lists.back().model_id != row.model_id) lists.push_back({row.model_id, {}});
        if (row.sound) lists.back().nearest.push_back(row.neighbour);
    }
}

core::Result<void> TwoViewIndex::store_neighbours(std::span<const NeighbourList> lists) {
    core::Result<Transaction> transaction = Transaction::begin(database_, Transaction::Kind::Write);
    if (!transaction) return core::unexpected(transaction.error());
    core::Result<Statement> remove = database_.prepare("DELETE FROM neighbour WHERE model_id = ?");
    if (!remove) return core::unexpected(remove.error());
    core::Result<Statement> insert = database_.prepare(
        "INSERT INTO neighbour (model_id, place, other_id, distance, checksum) SELECT ?, ?, ?, ?, ? "
        "WHERE EXISTS (SELECT 1 FROM model WHERE id = ?) AND EXISTS (SELECT 1 FROM model WHERE id = ?) "
        "RETURNING place");
    if (!insert) return core::unexpected(insert.error());
    for (const NeighbourList& list : lists) {
        if (!is_sound(list)) {
            return core::unexpected(core::ErrorCode::BadArgument, "a list of neighbours is not sound",
                                    std::to_string(list.model_id));
        }
        if (core::Result<void> done = write_list(list, *remove, *insert); !done) return done;
    }
    return transaction->commit();
}

}  // namespace db
