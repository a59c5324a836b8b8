#include "firmware_like_app/kiosk/drawing_recorder.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <string>

namespace app {
namespace {

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3f", value);
    return text.data();
}

template <typename Get>
std::string list_of(const core::Stroke& stroke, Get get) {
    std::string out = "[";
    for (const core::PenSample& s : stroke.samples) out += (out.size() > 1 ? "," : "") + number(get(s));
    return out + "]";
}

std::string line_of(const core::Drawing& drawing) {
    std::string strokes;
    for (const core::Stroke& stroke : drawing.strokes) {
        strokes += std::string(strokes.empty() ? "" : ",") + "[" +
                   list_of(stroke, [](const core::PenSample& s) { return s.x; }) + "," +
                   list_of(stroke, [](const core::PenSample& s) { return s.y; }) + "," +
                   list_of(stroke, [](const core::PenSample& s) { return static_cast<double>(s.time_us) / 1000; }) +
                   "]";
    }
    return "{\"word\":\"\",\"drawing\":[" + strokes + "]}\n";
}

}  // namespace

core::Result<void> DrawingRecorder::keep(const core::Drawing& drawing) {
    if (folder_.empty() || drawing.empty()) return {};
    std::filesystem::path path;
    std::error_code ignored;
    do {
        std::array<char, 40> name{};
        std::snprintf(name.data(), name.size(), "drawing-%04d.ndjson", next_++);
        path = folder_ / name.data();
    } while (std::filesystem::exists(path, ignored));
    std::ofstream file(path, std::ios::binary);
    file << line_of(drawing);
    file.close();
    if (file) return {};
    return core::unexpected(core::ErrorCode::WriteFailed, "the drawing cannot be kept; check that the folder has room",
                            path.string());
}

}  // namespace app
