#include "core/exchange/xml_text.hpp"

#include <cstddef>
#include <string>

namespace core {
namespace {

constexpr std::size_t kMaxTextBytes = std::size_t{64} << 20;
constexpr int kMaxDepth = 200;

}  // namespace

Result<void> parse_xml(std::string_view text, pugi::xml_document& document) {
    if (text.size() > kMaxTextBytes) {
        return unexpected(ErrorCode::BadFormat, "the text is longer than 64 MB; give a smaller drawing");
    }
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed || !document.document_element()) {
        return unexpected(ErrorCode::BadFormat, "the text is no well-formed XML (" + std::string(parsed.description()) +
                                                    " at byte " + std::to_string(parsed.offset) + "); save it again");
    }
    // Walked without recursion, as the parser itself does it; only our own readers recurse.
    int depth = 0;
    for (pugi::xml_node node = document.first_child(); node;) {
        if (depth > kMaxDepth) {
            return unexpected(ErrorCode::BadFormat, "the XML nests deeper than 200 elements; save it flatter");
        }
        if (node.first_child()) {
            node = node.first_child();
            ++depth;
            continue;
        }
        while (node && !node.next_sibling()) {
            node = node.parent();
            --depth;
        }
        if (node) node = node.next_sibling();
    }
    return {};
}

std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

}  // namespace core
