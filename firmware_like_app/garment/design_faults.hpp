#pragma once
// What is wrong with the file of designs, in the visitor's language.

#include <string>

#include "core/base/error.hpp"
#include "ui/screens/strings.hpp"

namespace app {

/// One sentence with a way on, after the name of the file where there is one. A fault that has no words in the table of
/// strings is said as the library says it, in English.
[[nodiscard]] std::string design_fault_words(const core::Error& error, const ui::Strings& words);

}  // namespace app
