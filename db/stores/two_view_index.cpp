#include "db/stores/two_view_index.hpp"

#include <utility>

#include "core/base/parallel.hpp"
#include "db/migrations/migrations.hpp"
#include "db/sqlite/transaction.hpp"
#include "db/stores/model_rows.hpp"

namespace db {

namespace {

constexpr const char* kEntryColumns =
    "SELECT model.id, name, class_name, source_path, content_hash, file_size, "
    "parameters <> ?1 OR program_version <> ?2 "
    "FROM model JOIN build ON build.id = model.build_id ";

ModelEntry entry_of(const Statement& row) {
    return {.id = row.integer(0),
            .name = row.text(1),
            .class_name = row.text(2),
            .source_path = row.text(3),
            .content_hash = static_cast<std::uint64_t>(row.integer(4)),
            .file_size = static_cast<std::uint64_t>(row.integer(5)),
            .stale = row.integer(6) != 0};
}

core::Unexpected damage_error(const Damage& damage, const std::string& where) {
    return core::unexpected(core::ErrorCode::Damaged, damage.sentence(), where);
}

}  // namespace

TwoViewIndex::TwoViewIndex(Database database, IndexOptions options)
    : database_(std::move(database)), options_(std::move(options)) {}

core::Result<TwoViewIndex> TwoViewIndex::open(const std::filesystem::path& path, OpenMode mode, IndexOptions options) {
    if (options.program_version.empty()) options.program_version = CROQUIS_VERSION;
    core::Result<Database> database =
        open_collection(path, mode, {.busy_timeout_ms = options.busy_timeout_ms, .max_pages = options.max_pages});
    if (!database) return core::unexpected(database.error());
    return TwoViewIndex(std::move(*database), std::move(options));
}

core::Error TwoViewIndex::no_such_model(std::int64_t id) const {
    return {core::ErrorCode::BadArgument,
            "there is no model " + std::to_string(id) + "; `croquis index list` shows the numbers", database_.where()};
}

core::Result<std::int64_t> TwoViewIndex::add(const ModelRecord& model) {
    const core::Result<std::vector<std::int64_t>> ids = add_all(std::span(&model, 1));
    if (!ids) return core::unexpected(ids.error());
    return ids->front();
}

core::Result<std::vector<std::int64_t>> TwoViewIndex::add_all(std::span<const ModelRecord> models) {
    core::Result<Transaction> transaction = Transaction::begin(database_, Transaction::Kind::Write);
    if (!transaction) return core::unexpected(transaction.error());
    const core::Result<std::int64_t> build = build_id();
    if (!build) return core::unexpected(build.error());
    core::Result<ModelWriter> writer = ModelWriter::prepare(database_);
    if (!writer) return core::unexpected(writer.error());
    std::vector<std::int64_t> ids;
    for (const ModelRecord& model : models) {
        const core::Result<std::int64_t> id = writer->write(model, *build);
        if (!id) return core::unexpected(id.error());
        ids.push_back(*id);
    }
    if (const core::Result<void> stored = transaction->commit(); !stored) return core::unexpected(stored.error());
    return ids;
}

core::Result<std::int64_t> TwoViewIndex::build_id() {
    core::Result<Statement> find =
        database_.prepare("SELECT id FROM build WHERE parameters = ? AND program_version = ?");
    if (!find) return core::unexpected(find.error());
    const core::Result<bool> there = find->bind(options_.parameters).bind(options_.program_version).step();
    if (!there) return core::unexpected(there.error());
    if (*there) return find->integer(0);
    core::Result<Statement> insert =
        database_.prepare("INSERT INTO build (parameters, parameters_hash, program_version) VALUES (?, ?, ?)");
    if (!insert) return core::unexpected(insert.error());
    const core::Result<void> done =
        insert->bind(options_.parameters).bind(checksum_of(options_.parameters)).bind(options_.program_version).run();
    if (!done) return core::unexpected(done.error());
    return database_.last_insert_id();
}

core::Result<std::optional<ModelEntry>> TwoViewIndex::find(const std::string& source_path) const {
    core::Result<Statement> find = database_.prepare(std::string(kEntryColumns) + "WHERE source_path = ?3");
    if (!find) return core::unexpected(find.error());
    const core::Result<bool> row =
        find->bind(options_.parameters).bind(options_.program_version).bind(source_path).step();
    if (!row) return core::unexpected(row.error());
    if (!*row) return std::optional<ModelEntry>();
    return std::optional<ModelEntry>(entry_of(*find));
}

core::Result<bool> TwoViewIndex::is_unchanged(const std::string& source_path, std::uint64_t content_hash,
                                              std::uint64_t file_size) const {
    const core::Result<std::optional<ModelEntry>> entry = find(source_path);
    if (!entry) return core::unexpected(entry.error());
    const std::optional<ModelEntry>& found = *entry;
    return found && !found->stale && found->content_hash == content_hash && found->file_size == file_size;
}

core::Result<void> TwoViewIndex::relabel(std::int64_t id, const std::string& name, const std::string& class_name) {
    core::Result<Transaction> transaction = Transaction::begin(database_, Transaction::Kind::Write);
    if (!transaction) return core::unexpected(transaction.error());
    core::Result<ModelReader> reader = ModelReader::prepare(database_);
    if (!reader) return core::unexpected(reader.error());
    core::Result<ModelWriter> writer = ModelWriter::prepare(database_);
    if (!writer) return core::unexpected(writer.error());
    std::vector<Damage> damaged;
    std::optional<ModelRecord> model = reader->read(id, damaged);
    // A new checksum must not make good what was damaged before.
    if (!damaged.empty()) return damage_error(damaged.front(), database_.where());
    if (!model) return core::unexpected(no_such_model(id));
    model->name = name;
    model->class_name = class_name;
    if (core::Result<void> done = writer->update(id, *model, reader->build_id()); !done) return done;
    return transaction->commit();
}

core::Result<void> TwoViewIndex::remove(std::int64_t id) {
    core::Result<Statement> remove = database_.prepare("DELETE FROM model WHERE id = ? RETURNING id");
    if (!remove) return core::unexpected(remove.error());
    const core::Result<bool> removed = remove->bind(id).step();
    if (!removed) return core::unexpected(removed.error());
    if (!*removed) return core::unexpected(no_such_model(id));
    return remove->run();  // the row's end stores the change
}

core::Result<std::vector<ModelEntry>> TwoViewIndex::list() const {
    core::Result<Statement> all = database_.prepare(std::string(kEntryColumns) + "ORDER BY model.id");
    if (!all) return core::unexpected(all.error());
    all->bind(options_.parameters).bind(options_.program_version);
    std::vector<ModelEntry> entries;
    for (;;) {
        const core::Result<bool> row = all->step();
        if (!row) return core::unexpected(row.error());
        if (!*row) return entries;
        entries.push_back(entry_of(*all));
    }
}

core::Result<LoadedModels> TwoViewIndex::load_views(int jobs) const {
    core::Result<Transaction> moment = Transaction::begin(database_, Transaction::Kind::Read);
    if (!moment) return core::unexpected(moment.error());
    core::Result<Statement> ids = database_.prepare("SELECT id FROM model ORDER BY id");
    if (!ids) return core::unexpected(ids.error());
    core::Result<ModelReader> reader = ModelReader::prepare(database_);
    if (!reader) return core::unexpected(reader.error());
    LoadedModels loaded;
    std::vector<StoredModel> stored;
    for (;;) {
        const core::Result<bool> row = ids->step();
        if (!row) return core::unexpected(row.error());
        if (!*row) break;
        std::optional<StoredModel> model = reader->fetch(ids->integer(0), loaded.damaged);
        if (model) stored.push_back(std::move(*model));
    }
    std::vector<ModelRecord> models(stored.size());
    std::vector<std::vector<Damage>> damaged(stored.size());
    core::parallel_for(stored.size(), jobs,
                       [&](std::size_t i, int) { models[i] = decode_model(std::move(stored[i]), damaged[i]); });
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (damaged[i].empty()) {
            loaded.models.push_back(std::move(models[i]));
        } else {
            loaded.damaged.insert(loaded.damaged.end(), damaged[i].begin(), damaged[i].end());
        }
    }
    return loaded;
}

core::Result<ModelRecord> TwoViewIndex::load(std::int64_t id) const {
    core::Result<Transaction> moment = Transaction::begin(database_, Transaction::Kind::Read);
    if (!moment) return core::unexpected(moment.error());
    core::Result<ModelReader> reader = ModelReader::prepare(database_);
    if (!reader) return core::unexpected(reader.error());
    std::vector<Damage> damaged;
    std::optional<ModelRecord> model = reader->read(id, damaged);
    if (!model && damaged.empty()) return core::unexpected(no_such_model(id));
    if (model) {
        std::optional<core::TriangleMesh> mesh = reader->read_mesh(id, model->name, damaged);
        if (mesh) model->display_mesh = std::move(*mesh);
        for (int v = 0; v < 2; ++v) {
            model->views[static_cast<std::size_t>(v)].thumbnail = reader->read_thumbnail(id, v, model->name, damaged);
        }
    }
    if (!damaged.empty()) return damage_error(damaged.front(), database_.where());
    return std::move(*model);
}

core::Result<std::string> TwoViewIndex::name_of(std::int64_t id) const {
    core::Result<Statement> find = database_.prepare("SELECT name FROM model WHERE id = ?");
    if (!find) return core::unexpected(find.error());
    const core::Result<bool> row = find->bind(id).step();
    if (!row) return core::unexpected(row.error());
    if (!*row) return core::unexpected(no_such_model(id));
    return find->text(0);
}

core::Result<core::TriangleMesh> TwoViewIndex::load_display_mesh(std::int64_t id) const {
    core::Result<Transaction> moment = Transaction::begin(database_, Transaction::Kind::Read);
    if (!moment) return core::unexpected(moment.error());
    const core::Result<std::string> name = name_of(id);
    if (!name) return core::unexpected(name.error());
    core::Result<ModelReader> reader = ModelReader::prepare(database_);
    if (!reader) return core::unexpected(reader.error());
    std::vector<Damage> damaged;
    std::optional<core::TriangleMesh> mesh = reader->read_mesh(id, *name, damaged);
    if (!mesh) return damage_error(damaged.front(), database_.where());
    return std::move(*mesh);
}

core::Result<std::vector<std::byte>> TwoViewIndex::load_thumbnail(std::int64_t id, int view) const {
    core::Result<Transaction> moment = Transaction::begin(database_, Transaction::Kind::Read);
    if (!moment) return core::unexpected(moment.error());
    const core::Result<std::string> name = name_of(id);
    if (!name) return core::unexpected(name.error());
    core::Result<ModelReader> reader = ModelReader::prepare(database_);
    if (!reader) return core::unexpected(reader.error());
    std::vector<Damage> damaged;
    std::vector<std::byte> png = reader->read_thumbnail(id, view, *name, damaged);
    if (!damaged.empty()) return damage_error(damaged.front(), database_.where());
    return png;
}

core::Result<void> TwoViewIndex::vacuum() {
    // The log is folded in as well, so that the space is free when this returns.
    return database_.execute("VACUUM; PRAGMA wal_checkpoint(TRUNCATE)");
}

core::Result<IndexInfo> TwoViewIndex::info() const {
    core::Result<Transaction> moment = Transaction::begin(database_, Transaction::Kind::Read);
    if (!moment) return core::unexpected(moment.error());
    const core::Result<std::int64_t> version = database_.integer("PRAGMA user_version");
    if (!version) return core::unexpected(version.error());
    const core::Result<std::int64_t> pages = database_.integer("PRAGMA page_count");
    if (!pages) return core::unexpected(pages.error());
    const core::Result<std::int64_t> page_size = database_.integer("PRAGMA page_size");
    if (!page_size) return core::unexpected(page_size.error());
    core::Result<Statement> builds = database_.prepare(
        "SELECT program_version, parameters, parameters_hash, count(*) FROM model "
        "JOIN build ON build.id = model.build_id GROUP BY build.id ORDER BY build.id");
    if (!builds) return core::unexpected(builds.error());
    IndexInfo info;
    info.schema_version = static_cast<int>(*version);
    info.bytes = *pages * *page_size;
    for (;;) {
        const core::Result<bool> row = builds->step();
        if (!row) return core::unexpected(row.error());
        if (!*row) return info;
        info.builds.push_back({.program_version = builds->text(0),
                               .parameters = builds->text(1),
                               .parameters_hash = static_cast<std::uint64_t>(builds->integer(2)),
                               .models = builds->integer(3)});
        info.models += info.builds.back().models;
        const BuildInfo& build = info.builds.back();
        const bool current =
            build.parameters == options_.parameters && build.program_version == options_.program_version;
        if (!current) info.stale_models += build.models;
    }
}

core::Result<std::optional<std::string>> TwoViewIndex::stale() const {
    const core::Result<IndexInfo> known = info();
    if (!known) return core::unexpected(known.error());
    if (known->stale_models == 0) return std::optional<std::string>();
    return std::optional<std::string>(std::to_string(known->stale_models) + " of " + std::to_string(known->models) +
                                      " models were described with other settings or by another version; call `croquis "
                                      "index build` on their files again");
}

}  // namespace db
