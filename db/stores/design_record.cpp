#include "db/stores/design_record.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

#include "core/exchange/design_file.hpp"

namespace db {
namespace {

using Kind = JournalEntry::Kind;
using Steps = std::vector<core::DesignStep>;

/// Where the act number `place` begins, the end where there are no more.
std::size_t start_of_act(const Steps& steps, std::size_t place) {
    std::size_t acts = 0;
    for (std::size_t i = 0; i < steps.size(); ++i)
        if ((i == 0 || !steps[i].with_last) && acts++ == place) return i;
    return steps.size();
}

void go_to(DesignState& state, std::size_t place) {
    Steps all = std::move(state.design.steps);
    std::move(state.undone.begin(), state.undone.end(), std::back_inserter(all));
    const auto cut = all.begin() + static_cast<std::ptrdiff_t>(start_of_act(all, place));
    state.undone.assign(std::move_iterator(cut), std::move_iterator(all.end()));
    all.erase(cut, all.end());
    state.design.steps = std::move(all);
}

}  // namespace

JournalEntry JournalEntry::of(core::JournalEvent event) {
    const bool steps = event.kind == core::JournalEvent::Kind::Steps;
    return {.kind = steps ? Kind::Steps : Kind::Place, .steps = std::move(event.steps), .place = event.place};
}

std::size_t count_acts(const Steps& steps) {
    std::size_t acts = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) acts += i == 0 || !steps[i].with_last ? 1 : 0;
    return acts;
}

void apply(const JournalEntry& entry, DesignState& state) {
    switch (entry.kind) {
        case Kind::Steps:
            state.undone.clear();
            state.design.steps.insert(state.design.steps.end(), entry.steps.begin(), entry.steps.end());
            break;
        case Kind::Place:
            go_to(state, entry.place);
            break;
        case Kind::Rename:
            state.design.name = entry.name;
            break;
    }
}

std::string steps_text(const Steps& steps) {
    std::string lines;
    for (const core::DesignStep& step : steps) lines += core::step_text(step) + '\n';
    return lines;
}

core::Result<Steps> parse_steps(std::string_view lines) {
    Steps steps;
    for (std::size_t at = 0; at < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', at), lines.size());
        core::Result<core::DesignStep> step = core::parse_step(lines.substr(at, end - at));
        if (!step) return core::unexpected(step.error());
        steps.push_back(std::move(*step));
        at = end + 1;
    }
    return steps;
}

std::string payload_text(const JournalEntry& entry) {
    switch (entry.kind) {
        case Kind::Steps:
            return steps_text(entry.steps);
        case Kind::Place:
            return std::to_string(entry.place);
        case Kind::Rename:
            return entry.name;
    }
    return {};
}

core::Result<JournalEntry> parse_entry(std::int64_t kind, const std::string& payload) {
    if (kind < 0 || kind > static_cast<std::int64_t>(Kind::Rename))
        return core::unexpected(core::ErrorCode::Damaged, "there is no entry of kind " + std::to_string(kind));
    JournalEntry entry{.kind = static_cast<Kind>(kind)};
    if (entry.kind == Kind::Steps) {
        core::Result<Steps> steps = parse_steps(payload);
        if (!steps) return core::unexpected(steps.error());
        entry.steps = std::move(*steps);
    } else if (entry.kind == Kind::Place) {
        const char* end = payload.data() + payload.size();
        const auto [stop, failed] = std::from_chars(payload.data(), end, entry.place);
        if (failed != std::errc() || stop != end)
            return core::unexpected(core::ErrorCode::BadFormat, "\"" + payload + "\" is no place in a history");
    } else {
        entry.name = payload;
    }
    return entry;
}

}  // namespace db
