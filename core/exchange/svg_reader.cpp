#include "core/exchange/svg_reader.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <pugixml.hpp>
#include <utility>
#include <vector>

#include "core/exchange/drawing_builder.hpp"
#include "core/exchange/file_bytes.hpp"
#include "core/exchange/svg_path.hpp"
#include "core/exchange/xml_text.hpp"

namespace core {
namespace {

Unexpected bad(std::string why) {
    return unexpected(ErrorCode::BadFormat, std::move(why));
}

bool is_not_drawn(const pugi::xml_node& node) {
    static constexpr std::array<std::string_view, 9> kDefinitions{"defs",   "clipPath", "mask",     "marker", "pattern",
                                                                  "symbol", "title",    "metadata", "style"};
    if (std::find(kDefinitions.begin(), kDefinitions.end(), local_name(node)) != kDefinitions.end()) return true;
    const std::string_view style = node.attribute("style").value();
    return std::string_view(node.attribute("display").value()) == "none" ||
           style.find("display:none") != std::string_view::npos ||
           style.find("display: none") != std::string_view::npos;
}

/// The chains of one basic shape in its own coordinates; empty for an element that is no shape. Nothing when damaged.
std::optional<std::vector<Polyline>> outlines_of(const pugi::xml_node& node) {
    const std::string_view name = local_name(node);
    bool good = true;
    const auto value = [&](const char* attribute) {
        const std::optional<double> length = parse_svg_length(node.attribute(attribute).value());
        good = good && length.has_value();
        return length.value_or(0.0);
    };
    std::vector<Polyline> chains;
    if (name == "path") return parse_svg_path(node.attribute("d").value());
    if (name == "polyline" || name == "polygon") {
        std::optional<Polyline> points = parse_svg_points(node.attribute("points").value());
        if (!points) return std::nullopt;
        if (name == "polygon" && !points->empty()) points->push_back(points->front());
        chains.push_back(std::move(*points));
    } else if (name == "line") {
        chains.push_back({{value("x1"), value("y1")}, {value("x2"), value("y2")}});
    } else if (name == "rect") {
        const double x = value("x"), y = value("y"), w = value("width"), h = value("height");
        if (w > 0.0 && h > 0.0) chains.push_back({{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}, {x, y}});
    } else if (name == "circle") {
        const double r = value("r");
        if (r > 0.0) chains.push_back(ellipse_chain({value("cx"), value("cy")}, r, r));
    } else if (name == "ellipse") {
        const double rx = value("rx"), ry = value("ry");
        if (rx > 0.0 && ry > 0.0) chains.push_back(ellipse_chain({value("cx"), value("cy")}, rx, ry));
    }
    if (!good) return std::nullopt;
    return chains;
}

/// Adds what `node` and its children draw. The depth is bounded by parse_xml. Gives a reason to stop, or null.
const char* add_drawn(const pugi::xml_node& node, const Affine& outer, DrawingBuilder& builder) {
    if (node.type() != pugi::node_element || is_not_drawn(node)) return nullptr;
    const std::optional<Affine> own = parse_svg_transform(node.attribute("transform").value());
    if (!own) return "a transform is damaged; save the drawing again as plain SVG";
    const Affine placement = outer.after(*own);
    const std::optional<std::vector<Polyline>> chains = outlines_of(node);
    if (!chains) return "a path or shape is damaged or too long; save the drawing again as plain SVG";
    for (const Polyline& chain : *chains) {
        builder.begin_stroke();
        for (const Point p : chain) {
            const Point q = placement(p);
            if (!builder.add(q.x, q.y)) return nullptr;  // finish() tells why
        }
    }
    for (const pugi::xml_node& child : node.children()) {
        if (const char* reason = add_drawn(child, placement, builder)) return reason;
    }
    return nullptr;
}

}  // namespace

Result<Drawing> parse_svg(std::string_view text) {
    pugi::xml_document document;
    if (const Result<void> parsed = parse_xml(text, document); !parsed) return unexpected(parsed.error());
    const pugi::xml_node root = document.document_element();
    if (local_name(root) != "svg") return bad("the XML is no SVG; its first element is not <svg>");
    DrawingBuilder builder;
    if (const char* reason = add_drawn(root, {}, builder)) return bad(reason);
    return std::move(builder).finish();
}

Result<Drawing> read_svg(const std::string& path) {
    const Result<std::string> text = read_file_bytes(path);
    if (!text) return unexpected(text.error());
    Result<Drawing> drawing = parse_svg(*text);
    if (!drawing) return unexpected(drawing.error().code, drawing.error().message, path);
    return drawing;
}

}  // namespace core
