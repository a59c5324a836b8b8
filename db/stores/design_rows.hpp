#pragma once
// A design <-> its rows in `design`, `snapshot`, `journal` and `design_thumbnail`, checksums included. Of use inside
// db/stores only; the caller holds the transaction.

#include <optional>
#include <string>
#include <vector>

#include "db/stores/design_store.hpp"

namespace db {

/// An entry, and whether it has the checksum it was written with.
struct DesignRow {
    DesignEntry entry;
    bool sound = true;
};

/// The columns of kDesignRow, from 0.
inline constexpr const char* kDesignRow =
    "SELECT id, name, created_us, changed_us, deleted_us, checksum, "
    "EXISTS (SELECT 1 FROM design_thumbnail WHERE design_id = id) FROM design ";
[[nodiscard]] DesignRow design_row(const Statement& row);
[[nodiscard]] core::Result<DesignRow> find_design_row(const Database& database, std::int64_t id);
[[nodiscard]] core::Result<void> update_design_row(const Database& database, const DesignEntry& entry);
[[nodiscard]] core::Result<std::int64_t> insert_design_row(const Database& database, DesignEntry entry);

[[nodiscard]] core::Result<void> insert_snapshot(const Database& database, std::int64_t id, std::int64_t sequence,
                                                 const DesignState& state);
[[nodiscard]] core::Result<void> insert_entries(const Database& database, std::int64_t id, std::int64_t first,
                                                std::span<const JournalEntry> entries);
/// How many of these entries, numbered from `first`, are stored already, the same; nothing where others stand there.
[[nodiscard]] core::Result<std::optional<std::size_t>> stored_already(const Database& database, std::int64_t id,
                                                                      std::int64_t first,
                                                                      std::span<const JournalEntry> entries);
/// Entries after the newest snapshot.
[[nodiscard]] core::Result<std::int64_t> journal_length(const Database& database, std::int64_t id);
/// Of the newest entry or snapshot, 0 where there is none.
[[nodiscard]] core::Result<std::int64_t> last_design_sequence(const Database& database, std::int64_t id);
/// All but the two newest snapshots go, and what of the journal the older of these already has.
[[nodiscard]] core::Result<void> shorten_journal(const Database& database, std::int64_t id);

/// The state from the best snapshot that is there and the journal after it. Errors of DesignStore::load.
[[nodiscard]] core::Result<OpenedDesign> read_design_rows(const Database& database, std::int64_t id,
                                                          const std::string& name);

/// How many snapshots are damaged, those too that reading has no need of.
[[nodiscard]] core::Result<int> damaged_snapshots(const Database& database, std::int64_t id);

[[nodiscard]] core::Result<void> put_thumbnail(const Database& database, std::int64_t id,
                                               std::span<const std::byte> png);
struct ThumbnailRow {
    std::vector<std::byte> png;  ///< empty: there is none, or it is damaged
    bool damaged = false;
};
[[nodiscard]] core::Result<ThumbnailRow> read_thumbnail_row(const Database& database, std::int64_t id);

}  // namespace db
