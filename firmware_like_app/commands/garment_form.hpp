#pragma once
// What a design is worn on, for the commands that build it.

#include <string>

#include "core/base/result.hpp"
#include "core/garment/design.hpp"
#include "core/mannequin/dress_form.hpp"

namespace app {

/// The design's own mannequin, or, where `path` is not empty, a mesh of the user's, stood up. Errors name the file.
[[nodiscard]] core::Result<core::DressForm> form_for(const core::Design& design, const std::string& path);

}  // namespace app
