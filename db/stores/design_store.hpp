#pragma once
// Garment designs, kept in one SQLite file: what the gallery shows, and what a power cut must not take. A design is a
// snapshot of its design file and a journal of every step since.
//
//     core::Result<db::DesignStore> store = db::DesignStore::open("designs.db", db::OpenMode::Create);
//     const core::Result<std::int64_t> id = store->create(design);
//     store->append(*id, 1, entries);        // durable when it returns; db::DesignJournal does this beside the pen
//     core::Result<db::OpenedDesign> again = store->load(*id);
//
// Every row has a checksum. What can be read of a damaged design is read, and what was left out is said. Use one
// DesignStore per thread; several may be open on the same file. Every function may give, besides what it names:
// Damaged, DatabaseFailed (another program holds the lock), WriteFailed (disk full, read-only).

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "db/sqlite/database.hpp"
#include "db/stores/design_record.hpp"

namespace db {

/// What a gallery's card needs. Times in microseconds since 1970, UTC.
struct DesignEntry {
    std::int64_t id = 0;
    std::string name;
    std::int64_t created_us = 0, changed_us = 0;
    std::optional<std::int64_t> deleted_us;  ///< when it was put into the bin
    bool has_thumbnail = false;
};

struct OpenedDesign {
    std::int64_t id = 0;
    DesignState state;
    std::int64_t sequence = 0;        ///< of the journal's last entry; the next one has sequence + 1
    std::vector<std::string> faults;  ///< a sentence for each record that is damaged and was left out
};

struct DesignDamage {
    std::int64_t id = 0;   ///< 0: the file as a whole
    std::string sentence;  ///< with the design's name
};

struct DesignStoreOptions {
    int busy_timeout_ms = 5000;                 ///< how long to wait for another program's lock
    std::int64_t max_pages = 0;                 ///< largest size in pages of 4 kB; 0: as much as the disk holds
    std::function<std::int64_t()> now_us = {};  ///< microseconds since 1970, UTC; none: the system's clock
};

struct DesignRow;

enum class Shelf { Kept, Bin };

class DesignStore {
  public:
    /// Errors of Database::open: a file that is not ours, or of a newer version, is refused and not altered. With
    /// ReadOnly everything that reads works, and nothing else.
    [[nodiscard]] static core::Result<DesignStore> open(const std::filesystem::path& path, OpenMode mode,
                                                        DesignStoreOptions options = {});

    /// Kept designs, those changed last first; or those in the bin, those deleted last first.
    [[nodiscard]] core::Result<std::vector<DesignEntry>> list(Shelf shelf = Shelf::Kept) const;
    /// The entry of one design, on either shelf. BadArgument if there is no such id.
    [[nodiscard]] core::Result<DesignEntry> find(std::int64_t id) const;

    /// A new design; gives its id, which is never given twice.
    [[nodiscard]] core::Result<std::int64_t> create(const core::Design& design);
    /// BadArgument if there is no such id, NewerVersion for a design that a newer Croquis saved, Damaged where no
    /// snapshot can be read.
    [[nodiscard]] core::Result<OpenedDesign> load(std::int64_t id) const;
    /// Another design like it, under that name, its thumbnail too. Errors of load.
    [[nodiscard]] core::Result<std::int64_t> duplicate(std::int64_t id, const std::string& name);
    [[nodiscard]] core::Result<void> rename(std::int64_t id, const std::string& name);

    /// Into the bin, and out of it again. Nothing to do where it lies there already.
    [[nodiscard]] core::Result<void> remove(std::int64_t id);
    [[nodiscard]] core::Result<void> restore(std::int64_t id);
    /// Ends for good what lies in the bin for longer than that. Gives how many.
    [[nodiscard]] core::Result<int> purge(int days);
    /// Ends one design for good, from either shelf.
    [[nodiscard]] core::Result<void> erase(std::int64_t id);

    /// Stores entries numbered from `first` on, all of them or none; durable when it returns. Those that are stored
    /// already, because an earlier call said that it failed after it had not, stay as they are. BadArgument when others
    /// stand at their numbers, or `first` does not follow the last entry: another program draws on the same design.
    [[nodiscard]] core::Result<void> append(std::int64_t id, std::int64_t first, std::span<const JournalEntry> entries);
    /// Stores the whole design as it is after entry `sequence`, and forgets what of the journal is no longer needed; in
    /// one transaction.
    [[nodiscard]] core::Result<void> keep(std::int64_t id, const DesignState& state, std::int64_t sequence);
    /// How many entries load has to take after the snapshot.
    [[nodiscard]] core::Result<std::int64_t> entries_since_snapshot(std::int64_t id) const;
    /// The same as keep for what is stored. Damaged, and nothing changes, where something of it cannot be read.
    [[nodiscard]] core::Result<void> compact(std::int64_t id);

    /// BadArgument for what is no PNG.
    [[nodiscard]] core::Result<void> set_thumbnail(std::int64_t id, std::span<const std::byte> png);
    /// Empty where there is none, or it is damaged.
    [[nodiscard]] core::Result<std::vector<std::byte>> thumbnail(std::int64_t id) const;

    /// Looks at every page, row and checksum; empty when all is well. Goes on after each find.
    [[nodiscard]] core::Result<std::vector<DesignDamage>> check() const;

  private:
    DesignStore(Database database, DesignStoreOptions options);
    [[nodiscard]] core::Result<void> touch(std::int64_t id, const std::optional<std::string>& name);
    [[nodiscard]] core::Result<void> set_deleted(std::int64_t id, bool deleted);
    void check_design(const DesignRow& row, std::vector<DesignDamage>& damaged) const;

    Database database_;
    DesignStoreOptions options_;
};

}  // namespace db
