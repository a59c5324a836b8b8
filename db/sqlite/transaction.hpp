#pragma once
// All or nothing: what is written between begin and commit is stored together, or not at all.

#include <memory>

#include "core/base/result.hpp"
#include "db/sqlite/database.hpp"

namespace db {

class Transaction {
  public:
    enum class Kind {
        Read,   ///< everything read is of one moment; writers go on beside it
        Write,  ///< takes the write lock at once, waiting for it as long as the database's busy timeout
    };
    enum class State { Open, Committed, RolledBack };

    /// Transactions do not nest: a second one on the same database gives DatabaseFailed.
    [[nodiscard]] static core::Result<Transaction> begin(const Database& database, Kind kind);

    Transaction(Transaction&& other) noexcept;
    Transaction& operator=(Transaction&&) = delete;
    /// Rolls back what is still open.
    ~Transaction();

    /// Stores durably. On failure the transaction is still Open where trying again may help (another program's lock),
    /// and RolledBack where SQLite gave it up (disk full). BadArgument when it is not Open.
    [[nodiscard]] core::Result<void> commit();
    /// Forgets everything since begin. Nothing to do when not Open.
    void rollback();

    /// Also notices that SQLite rolled back by itself after an earlier failure.
    [[nodiscard]] State state() const;

  private:
    explicit Transaction(std::shared_ptr<const Connection> connection);
    std::shared_ptr<const Connection> connection_;
    State state_ = State::Open;
};

}  // namespace db
