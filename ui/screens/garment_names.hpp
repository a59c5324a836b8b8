#pragma once
// Names that pieces and lines were given by themselves, in the visitor's language; names that people gave stay.

#include <string>

#include "ui/screens/strings.hpp"

namespace ui {

/// "sleeve back 2", or "sleeve_back 2" as in a file, is the second back sleeve; a name with any other word in it is
/// somebody's own.
[[nodiscard]] std::string shown_name(const Strings& words, std::string name);

}  // namespace ui
