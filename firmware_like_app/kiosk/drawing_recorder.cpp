#include "firmware_like_app/kiosk/drawing_recorder.hpp"

#include <array>
#include <cstdio>
#include <fstream>

#include "input/trace/decode_trace.hpp"

namespace app {

std::filesystem::path next_free(const std::filesystem::path& folder, const std::string& name) {
    std::error_code ignored;
    for (int n = 1;; ++n) {
        std::array<char, 24> end{};
        std::snprintf(end.data(), end.size(), "-%04d.trace", n);
        std::filesystem::path path = folder / (name + end.data());
        if (!std::filesystem::exists(path, ignored)) return path;
    }
}

core::Result<void> DrawingRecorder::keep(const core::Drawing& drawing) {
    if (folder_.empty() || drawing.empty()) return {};
    const std::filesystem::path path = next_free(folder_, "drawing");
    std::ofstream file(path, std::ios::binary);
    file << input::trace_text(input::trace_of_drawing(drawing));
    file.close();
    if (file) return {};
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return core::unexpected(core::ErrorCode::WriteFailed, "the drawing cannot be kept; check that the folder has room",
                            path.string());
}

}  // namespace app
