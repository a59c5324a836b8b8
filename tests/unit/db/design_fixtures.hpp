#pragma once
// Designs for the tests of their store: small ones, the same for the same number.

#include <string>
#include <vector>

#include "core/exchange/design_file.hpp"
#include "core/mannequin/body_measures.hpp"
#include "db/stores/design_record.hpp"

namespace fixture {

inline core::DesignStep line_step(int n) {
    core::DesignStep step;
    step.kind = core::DesignStep::Kind::Line;
    step.name = "line " + std::to_string(n);
    core::StrokePart part;
    part.view = *core::named_view(n % 2 == 0 ? "front" : "back");
    for (int k = 0; k < 12; ++k) part.points.push_back({0.1 * n + k / 3.0, 90.0 + 0.7 * k});
    step.stroke = {part};
    return step;
}

inline core::Design small_design(const std::string& name, int lines) {
    core::Design design;
    design.name = name;
    design.body = *core::measures_of_size("40");
    for (int n = 0; n < lines; ++n) design.steps.push_back(line_step(n));
    return design;
}

inline db::JournalEntry step_entry(int n) {
    return {.kind = db::JournalEntry::Kind::Steps, .steps = {line_step(n)}};
}

/// Entry number n of a drawing with a mind of its own, on a design of one act: mostly acts of one or two steps, now and
/// then back by two, forward by one, another name.
inline db::JournalEntry drawn_entry(int n) {
    using Kind = db::JournalEntry::Kind;
    if (n % 17 == 16) return {.kind = Kind::Rename, .name = "design " + std::to_string(n)};
    if (n % 7 == 5) return {.kind = Kind::Place, .place = static_cast<std::size_t>(n / 2)};
    if (n % 7 == 6 && n % 3 != 0) return {.kind = Kind::Place, .place = static_cast<std::size_t>(n / 2 + 1)};
    db::JournalEntry entry = step_entry(n);
    if (n % 5 == 0) {
        entry.steps.push_back(line_step(n + 1000));
        entry.steps.back().with_last = true;
    }
    return entry;
}

/// The state as text: what two that are the same have in common.
inline std::string text_of(const db::DesignState& state) {
    std::string text = core::design_text(state.design);
    for (const core::DesignStep& step : state.undone) text += "undone: " + core::step_text(step) + "\n";
    return text;
}

}  // namespace fixture
