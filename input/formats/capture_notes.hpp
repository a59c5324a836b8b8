#pragma once
// What the readers of recordings share in saying what is wrong.

#include <string>

#include "input/formats/capture.hpp"

namespace input {

/// Notes a line that is passed over; after 32 no more.
inline void note_line(Capture& capture, std::size_t line, const char* what) {
    if (capture.notes.size() < 32) capture.notes.push_back("line " + std::to_string(line) + ": " + what);
}

inline core::Unexpected bad_line(std::size_t line, const char* what) {
    return core::unexpected(core::ErrorCode::BadFormat, what, "line " + std::to_string(line));
}

}  // namespace input
