#include "firmware_like_app/kiosk/drawing_recorder.hpp"

#include <array>
#include <cstdio>
#include <fstream>

#include "input/trace/decode_trace.hpp"

namespace app {

std::filesystem::path next_free(const std::filesystem::path& folder, const std::string& name) {
    const auto path_of = [&](int number) {
        std::array<char, 24> end{};
        std::snprintf(end.data(), end.size(), "-%04d.trace", number);
        return folder / (name + end.data());
    };
    const auto is_taken = [&](int number) {
        std::error_code ignored;
        return std::filesystem::exists(path_of(number), ignored);
    };
    int taken = 0, free = 1;
    while (is_taken(free)) {
        taken = free;
        free *= 2;
    }
    while (free - taken > 1) {
        const int middle = taken + (free - taken) / 2;
        (is_taken(middle) ? taken : free) = middle;
    }
    return path_of(free);
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
