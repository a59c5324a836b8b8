#pragma once
// A design as it is kept: what it is, what may be done again, and what was done to it since, entry by entry.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/desk/desk_history.hpp"

namespace db {

/// One thing that was done to a design: an event of the desk (core/garment/desk/desk_history.hpp), or a new name.
struct JournalEntry {
    enum class Kind {
        Steps,   ///< an act was done, of one or more steps; what had been undone is forgotten
        Place,   ///< undone or done again: the design is what it was after `place` acts
        Rename,  ///< the design got another name
    };
    Kind kind = Kind::Steps;
    std::vector<core::DesignStep> steps = {};  ///< Steps
    std::size_t place = 0;                     ///< Place
    std::string name = {};                     ///< Rename

    [[nodiscard]] static JournalEntry of(core::JournalEvent event);
};

/// A design with the steps that were undone, the next one to be done again first.
struct DesignState {
    core::Design design;
    std::vector<core::DesignStep> undone;
};

/// How many acts the steps are: a step that is not `with_last` begins one.
[[nodiscard]] std::size_t count_acts(const std::vector<core::DesignStep>& steps);

/// Does to the state what the entry says. A place beyond the last act is the last one.
void apply(const JournalEntry& entry, DesignState& state);

/// Steps as the design file writes them, a line each, and back. ErrorCode::BadFormat with the step at fault.
[[nodiscard]] std::string steps_text(const std::vector<core::DesignStep>& steps);
[[nodiscard]] core::Result<std::vector<core::DesignStep>> parse_steps(std::string_view lines);

/// The entry's payload as the journal stores it.
[[nodiscard]] std::string payload_text(const JournalEntry& entry);
/// The reverse. ErrorCode::Damaged for a kind that does not exist; ErrorCode::BadFormat for a payload that is none.
[[nodiscard]] core::Result<JournalEntry> parse_entry(std::int64_t kind, const std::string& payload);

}  // namespace db
