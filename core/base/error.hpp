#pragma once
// What went wrong with data or resources, as a value: a code to branch on, a sentence for a person, and the place.

#include <string>
#include <utility>

namespace core {

/// Grouped by the stage that finds the fault.
enum class ErrorCode {
    // reading
    FileMissing,
    FileUnreadable,
    UnknownFormat,
    BadFormat,
    // shapes
    EmptyDrawing,
    TooSmall,
    BadOutline,
    EmptyMesh,
    BadMesh,
    // storage
    NotAnIndex,
    NewerVersion,
    Damaged,
    DatabaseFailed,
    // running
    WriteFailed,
    NoDisplay,
    Cancelled,
    BadArgument,
    Internal,
};

struct Error {
    ErrorCode code = ErrorCode::Internal;
    std::string message;  ///< one sentence: what is wrong and what to do, without the place
    std::string where;    ///< the file, record or element; may be empty

    /// "where: message", as commands print it.
    [[nodiscard]] std::string sentence() const { return where.empty() ? message : where + ": " + message; }
};

}  // namespace core
