#include "core/exchange/stroke_list_reader.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/exchange/drawing_builder.hpp"
#include "core/exchange/file_bytes.hpp"

namespace core {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxTextBytes = std::size_t{16} << 20;

Unexpected bad(std::string why) {
    return unexpected(ErrorCode::BadFormat, std::move(why));
}

bool is_point(const Json& point) {
    if (!point.is_array() || point.size() < 2 || point.size() > 4) return false;
    for (std::size_t i = 0; i < point.size(); ++i) {
        if (!point[i].is_number() && !(i >= 2 && point[i].is_null())) return false;
    }
    return true;
}

std::optional<double> value_at(const Json& point, std::size_t i, double factor) {
    if (i >= point.size() || point[i].is_null()) return std::nullopt;
    return point[i].get<double>() * factor;
}

}  // namespace

Result<Drawing> parse_stroke_list(std::string_view text) {
    if (text.size() > kMaxTextBytes) return bad("the stroke list is longer than 16 MB; give a smaller drawing");
    const Json document = Json::parse(text, nullptr, false);
    if (document.is_discarded()) return bad("the text is no JSON; check it for a missing bracket or comma");
    if (!document.is_object() || !document.contains("strokes") || !document["strokes"].is_array()) {
        return bad("the JSON has no \"strokes\" list; give {\"strokes\": [{\"points\": [[x, y], …]}, …]}");
    }
    DrawingBuilder builder;
    for (const Json& stroke : document["strokes"]) {
        if (!stroke.is_object() || !stroke.contains("points") || !stroke["points"].is_array()) {
            return bad("a stroke has no \"points\" list; give {\"points\": [[x, y], …]}");
        }
        builder.begin_stroke();
        for (const Json& point : stroke["points"]) {
            if (!is_point(point)) return bad("a point is not [x, y], [x, y, t_ms] or [x, y, t_ms, pressure]");
            if (!builder.add(point[0].get<double>(), point[1].get<double>(), value_at(point, 2, 1000.0),
                             value_at(point, 3, 1.0))) {
                break;
            }
        }
    }
    return std::move(builder).finish();
}

Result<Drawing> read_stroke_list(const std::string& path) {
    const Result<std::string> text = read_file_bytes(path);
    if (!text) return unexpected(text.error());
    Result<Drawing> drawing = parse_stroke_list(*text);
    if (!drawing) return unexpected(drawing.error().code, drawing.error().message, path);
    return drawing;
}

}  // namespace core
