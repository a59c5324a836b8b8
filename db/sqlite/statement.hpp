#pragma once
// One prepared SQL statement. Values are bound in the order of the question marks and asked for once, at step():
//
//     core::Result<Statement> find = database.prepare("SELECT id FROM model WHERE name = ?");
//     if (!find) return core::unexpected(find.error());
//     core::Result<bool> row = find->bind("horse").step();
//     if (row && *row) use(find->integer(0));

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

struct sqlite3_stmt;

namespace db {

struct Connection;

class Statement {
  public:
    /// Binds the next parameter; the value is copied. A failure is kept and comes out of the next step().
    /// A double must be finite: SQLite turns NaN into NULL. Unsigned 64-bit values are stored by their bits.
    template <std::integral T>
    Statement& bind(T value) {
        return bind_integer(static_cast<std::int64_t>(value));
    }
    Statement& bind(double value);
    Statement& bind(std::string_view value);
    Statement& bind(std::span<const std::byte> value);

    /// True: a row is there to be read. False: done, and the statement is ready to be bound and stepped again.
    [[nodiscard]] core::Result<bool> step();
    /// Steps to the end, whatever rows come, and makes ready for the next run.
    [[nodiscard]] core::Result<void> run();
    /// Ends a run early: releases its lock, forgets the bound values.
    void reset();

    /// Columns of the present row, from 0. A value of another type is converted as SQLite does (NULL: 0 or empty).
    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] double real(int column) const;
    [[nodiscard]] std::string text(int column) const;
    /// Valid until the next step() or reset().
    [[nodiscard]] std::span<const std::byte> blob(int column) const;

  private:
    friend class Database;
    struct Finalizer {
        void operator()(sqlite3_stmt* statement) const;
    };
    Statement(std::shared_ptr<const Connection> connection, sqlite3_stmt* statement);
    Statement& bind_integer(std::int64_t value);
    Statement& note(int code);

    std::shared_ptr<const Connection> connection_;  // outlives statement_
    std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
    int next_parameter_ = 1;
    int bind_failure_ = 0;
};

}  // namespace db
