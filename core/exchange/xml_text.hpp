#pragma once
// What the XML readers check before and share after parsing. Private to core/exchange: it shows a third-party type.

#include <pugixml.hpp>
#include <string_view>

#include "core/base/result.hpp"

namespace core {

/// Parses into `document`. BadFormat when the text is longer than 64 MB, nests deeper than 200 elements, is no XML or
/// has no element. Entities of a DOCTYPE are not expanded, so a document cannot blow up.
[[nodiscard]] Result<void> parse_xml(std::string_view text, pugi::xml_document& document);

/// An element's name without its namespace prefix.
[[nodiscard]] std::string_view local_name(const pugi::xml_node& node);

}  // namespace core
