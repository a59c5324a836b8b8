#include "db/sqlite/transaction.hpp"

#include <sqlite3.h>

#include <utility>

#include "db/sqlite/connection.hpp"

namespace db {

core::Result<Transaction> Transaction::begin(const Database& database, Kind kind) {
    const core::Result<void> begun = database.execute(kind == Kind::Write ? "BEGIN IMMEDIATE" : "BEGIN");
    if (!begun) return core::unexpected(begun.error());
    return Transaction(database.connection());
}

Transaction::Transaction(std::shared_ptr<const Connection> connection) : connection_(std::move(connection)) {}

Transaction::Transaction(Transaction&& other) noexcept
    : connection_(std::move(other.connection_)), state_(std::exchange(other.state_, State::RolledBack)) {}

Transaction::~Transaction() {
    rollback();
}

core::Result<void> Transaction::commit() {
    if (state() != State::Open) {
        return core::unexpected(core::ErrorCode::BadArgument, "the transaction has ended and cannot be stored",
                                connection_ ? connection_->where : "");
    }
    if (sqlite3_exec(connection_->handle, "COMMIT", nullptr, nullptr, nullptr) != SQLITE_OK) {
        core::Unexpected failure = connection_->failure();
        state_ = state();
        return failure;
    }
    state_ = State::Committed;
    return {};
}

void Transaction::rollback() {
    if (state() == State::Open) {
        // It fails only where SQLite has already rolled back, which is what was wanted.
        sqlite3_exec(connection_->handle, "ROLLBACK", nullptr, nullptr, nullptr);
    }
    if (state_ == State::Open) state_ = State::RolledBack;
}

Transaction::State Transaction::state() const {
    if (state_ == State::Open && connection_->outside_transaction()) return State::RolledBack;
    return state_;
}

}  // namespace db
