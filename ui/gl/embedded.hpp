#pragma once
// Text files that are built into the program: the shaders and the strings of every language.

#include <string_view>
#include <vector>

namespace ui {

struct EmbeddedFile {
    std::string_view name;  ///< file name without folder, "ink.vert"
    std::string_view content;
};

/// The GLSL ES files of ui/shaders.
[[nodiscard]] const std::vector<EmbeddedFile>& shader_files();
/// The files of ui/screens/strings, one per language.
[[nodiscard]] const std::vector<EmbeddedFile>& string_files();

/// The files of ui/screens/attract, drawings as Quick-Draw lines.
[[nodiscard]] const std::vector<EmbeddedFile>& attract_files();

}  // namespace ui
