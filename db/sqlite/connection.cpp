#include "db/sqlite/connection.hpp"

#include <sqlite3.h>

#include <utility>

namespace db {

Connection::Connection(sqlite3* opened, std::string path, const DatabaseWords& called)
    : handle(opened), where(std::move(path)), words(called) {}

Connection::~Connection() {
    sqlite3_close_v2(handle);
}

core::Unexpected Connection::failure() const {
    return core::unexpected(describe_failure(sqlite3_extended_errcode(handle), sqlite3_errmsg(handle), where, words));
}

bool Connection::outside_transaction() const {
    return sqlite3_get_autocommit(handle) != 0;
}

core::Error describe_failure(int extended_code, const std::string& detail, const std::string& where,
                             const DatabaseWords& words) {
    using core::ErrorCode;
    switch (extended_code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return {ErrorCode::DatabaseFailed,
                    "another program is using it; wait until that has finished, then try again", where};
        case SQLITE_FULL:
            return {ErrorCode::WriteFailed,
                    "the disk is full; free some space and try again (what was stored before is still there)", where};
        case SQLITE_READONLY:
            return {ErrorCode::WriteFailed,
                    "it cannot be written; allow writing to the file and its folder, or choose another place", where};
        case SQLITE_PERM:
        case SQLITE_AUTH:
        case SQLITE_CANTOPEN:
            return {ErrorCode::FileUnreadable,
                    "it cannot be opened; check that the folder exists and that file and folder may be used", where};
        case SQLITE_NOTADB:
            return {ErrorCode::NotAnIndex,
                    "it is no Croquis " + std::string(words.thing) + " and was left as it is; name another file",
                    where};
        case SQLITE_CORRUPT:
            return {ErrorCode::Damaged, "it is damaged (" + detail + "); " + words.mend, where};
        case SQLITE_IOERR:
            return {ErrorCode::DatabaseFailed, "reading or writing failed (" + detail + "); check the disk", where};
        case SQLITE_NOMEM:
            return {ErrorCode::DatabaseFailed, "there is not enough memory; close other programs and try again", where};
        default:
            return {ErrorCode::DatabaseFailed, "the database refused (" + detail + "); " + words.mend, where};
    }
}

}  // namespace db
