#include "db/sqlite/transaction.hpp"
#include "db/stores/model_rows.hpp"
#include "db/stores/neighbour_rows.hpp"
#include "db/stores/two_view_index.hpp"

namespace db {

namespace {

void report(std::vector<Damage>& damaged, const std::string& message) {
    damaged.push_back({0, {}, "file", message});
}

/// SQLite's own look at pages and indexes; at most 100 lines.
void check_pages(const Database& database, std::vector<Damage>& damaged) {
    core::Result<Statement> check = database.prepare("PRAGMA integrity_check(100)");
    if (!check) return report(damaged, check.error().message);
    for (;;) {
        const core::Result<bool> row = check->step();
        if (!row) return report(damaged, row.error().message);
        if (!*row) return;
        if (const std::string line = check->text(0); line != "ok") {
            report(damaged, "it is damaged (" + line + "); build the index again");
        }
    }
}

void check_references(const Database& database, std::vector<Damage>& damaged) {
    core::Result<Statement> check = database.prepare("PRAGMA foreign_key_check");
    if (!check) return report(damaged, check.error().message);
    for (;;) {
        const core::Result<bool> row = check->step();
        if (!row) return report(damaged, row.error().message);
        if (!*row) return;
        report(damaged, "row " + std::to_string(check->integer(1)) + " of table " + check->text(0) +
                            " belongs to nothing; build the index again");
    }
}

void check_builds(const Database& database, std::vector<Damage>& damaged) {
    core::Result<Statement> builds = database.prepare("SELECT id, parameters, parameters_hash FROM build ORDER BY id");
    if (!builds) return report(damaged, builds.error().message);
    for (;;) {
        const core::Result<bool> row = builds->step();
        if (!row) return report(damaged, row.error().message);
        if (!*row) return;
        if (checksum_of(builds->text(1)) != static_cast<std::uint64_t>(builds->integer(2))) {
            report(damaged, "the parameters of build " + std::to_string(builds->integer(0)) +
                                " are damaged; build the index again");
        }
    }
}

/// A damaged row of a neighbour list costs no model: the list is measured again.
void check_neighbours(const Database& database, std::vector<Damage>& damaged) {
    core::Result<Statement> rows = database.prepare(kNeighbourRows);
    if (!rows) return report(damaged, rows.error().message);
    for (std::int64_t last = 0;;) {
        const core::Result<bool> row = rows->step();
        if (!row) return report(damaged, row.error().message);
        if (!*row) return;
        const NeighbourRow neighbour = neighbour_row(*rows);
        if (neighbour.sound || neighbour.model_id == last) continue;
        last = neighbour.model_id;
        damaged.push_back({neighbour.model_id, {}, "neighbours", "they are damaged; build the index again"});
    }
}

void check_models(const Database& database, std::vector<Damage>& damaged) {
    core::Result<Statement> ids = database.prepare("SELECT id FROM model ORDER BY id");
    if (!ids) return report(damaged, ids.error().message);
    core::Result<ModelReader> reader = ModelReader::prepare(database);
    if (!reader) return report(damaged, reader.error().message);
    for (;;) {
        const core::Result<bool> row = ids->step();
        if (!row) return report(damaged, row.error().message);
        if (!*row) return;
        const std::int64_t id = ids->integer(0);
        const std::optional<ModelRecord> model = reader->read(id, damaged);
        const std::string name = model ? model->name : std::string();
        (void)reader->read_mesh(id, name, damaged);
        for (int v = 0; v < 2; ++v) (void)reader->read_thumbnail(id, v, name, damaged);
    }
}

}  // namespace

std::string Damage::sentence() const {
    if (model_id == 0) return message;
    const std::string label = model.empty() ? "" : " (" + model + ")";
    return "model " + std::to_string(model_id) + label + ", " + part + ": " + message;
}

core::Result<std::vector<std::int64_t>> TwoViewIndex::damaged_models() const {
    core::Result<Transaction> moment = Transaction::begin(database_, Transaction::Kind::Read);
    if (!moment) return core::unexpected(moment.error());
    core::Result<Statement> ids = database_.prepare("SELECT id FROM model ORDER BY id");
    if (!ids) return core::unexpected(ids.error());
    core::Result<ModelReader> reader = ModelReader::prepare(database_);
    if (!reader) return core::unexpected(reader.error());
    std::vector<std::int64_t> damaged;
    for (;;) {
        const core::Result<bool> row = ids->step();
        if (!row) return core::unexpected(row.error());
        if (!*row) return damaged;
        if (const std::int64_t id = ids->integer(0); !reader->is_whole(id)) damaged.push_back(id);
    }
}

core::Result<std::vector<Damage>> TwoViewIndex::check() const {
    core::Result<Transaction> moment = Transaction::begin(database_, Transaction::Kind::Read);
    if (!moment) return core::unexpected(moment.error());
    std::vector<Damage> damaged;
    check_pages(database_, damaged);
    check_references(database_, damaged);
    check_builds(database_, damaged);
    check_models(database_, damaged);
    check_neighbours(database_, damaged);
    return damaged;
}

}  // namespace db
