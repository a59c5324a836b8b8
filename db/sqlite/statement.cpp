#include "db/sqlite/statement.hpp"

#include <sqlite3.h>

#include <utility>

#include "db/sqlite/connection.hpp"

namespace db {

void Statement::Finalizer::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

Statement::Statement(std::shared_ptr<const Connection> connection, sqlite3_stmt* statement)
    : connection_(std::move(connection)), statement_(statement) {}

Statement& Statement::note(int code) {
    if (bind_failure_ == SQLITE_OK) bind_failure_ = code;
    return *this;
}

Statement& Statement::bind_integer(std::int64_t value) {
    return note(sqlite3_bind_int64(statement_.get(), next_parameter_++, value));
}

Statement& Statement::bind(double value) {
    return note(sqlite3_bind_double(statement_.get(), next_parameter_++, value));
}

Statement& Statement::bind(std::string_view value) {
    // A null pointer would bind NULL.
    const char* data = value.empty() ? "" : value.data();
    return note(
        sqlite3_bind_text64(statement_.get(), next_parameter_++, data, value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
}

Statement& Statement::bind(std::span<const std::byte> value) {
    if (value.empty()) return note(sqlite3_bind_zeroblob(statement_.get(), next_parameter_++, 0));
    return note(sqlite3_bind_blob64(statement_.get(), next_parameter_++, value.data(), value.size(), SQLITE_TRANSIENT));
}

core::Result<bool> Statement::step() {
    if (bind_failure_ != SQLITE_OK) {
        const int code = bind_failure_;
        reset();
        return core::unexpected(describe_failure(code, sqlite3_errstr(code), connection_->where, connection_->words));
    }
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW) return true;
    if (code == SQLITE_DONE) {
        reset();
        return false;
    }
    core::Unexpected failure = connection_->failure();
    reset();
    return failure;
}

core::Result<void> Statement::run() {
    for (;;) {
        const core::Result<bool> row = step();
        if (!row) return core::unexpected(row.error());
        if (!*row) return {};
    }
}

void Statement::reset() {
    sqlite3_reset(statement_.get());
    sqlite3_clear_bindings(statement_.get());
    next_parameter_ = 1;
    bind_failure_ = SQLITE_OK;
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
    return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
    const unsigned char* data = sqlite3_column_text(statement_.get(), column);
    if (data == nullptr) return {};
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return {reinterpret_cast<const char*>(data), static_cast<std::size_t>(size)};
}

std::span<const std::byte> Statement::blob(int column) const {
    const void* data = sqlite3_column_blob(statement_.get(), column);
    if (data == nullptr) return {};
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return {static_cast<const std::byte*>(data), static_cast<std::size_t>(size)};
}

}  // namespace db
