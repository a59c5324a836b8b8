#include "core/exchange/region_reader.hpp"

#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/exchange/file_bytes.hpp"

namespace core {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxTextBytes = std::size_t{16} << 20;

Unexpected bad(std::string why) {
    return unexpected(ErrorCode::BadFormat, std::move(why));
}

/// null is how JSON writers put what is not a number: it is passed on as such, for outline_ring to name the place.
bool is_coordinate(const Json& value) {
    return value.is_number() || value.is_null();
}

double coordinate(const Json& value) {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

}  // namespace

Result<RegionOutline> parse_region(std::string_view text) {
    if (text.size() > kMaxTextBytes) return bad("The region is longer than 16 MB; give fewer points.");
    const Json document = Json::parse(text, nullptr, false);
    if (document.is_discarded())
        return bad("The text is no JSON, or it ends early; check it for a missing bracket or comma.");
    if (!document.is_object() || !document.contains("sides") || !document["sides"].is_array())
        return bad("The JSON has no \"sides\" list; give {\"sides\": [[[x, y, z], …], …]}.");
    RegionOutline outline;
    for (const Json& side : document["sides"]) {
        const std::string name = "Side " + std::to_string(outline.sides.size() + 1);
        if (!side.is_array()) return bad(name + " is no list of points; give [[x, y, z], …].");
        auto& points = outline.sides.emplace_back();
        for (const Json& p : side) {
            if (!p.is_array() || p.size() != 3 || !is_coordinate(p[0]) || !is_coordinate(p[1]) || !is_coordinate(p[2]))
                return bad(name + ", point " + std::to_string(points.size() + 1) + ", is not [x, y, z].");
            points.push_back({coordinate(p[0]), coordinate(p[1]), coordinate(p[2])});
        }
    }
    return outline;
}

Result<RegionOutline> read_region(const std::string& path) {
    const Result<std::string> text = read_file_bytes(path);
    if (!text) return unexpected(text.error());
    Result<RegionOutline> outline = parse_region(*text);
    if (!outline) return unexpected(outline.error().code, outline.error().message, path);
    return outline;
}

}  // namespace core
