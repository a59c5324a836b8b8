#pragma once
// Names that pieces of cloth get by themselves: what a tailor would call them, as far as the body tells.

#include <string>

#include "core/garment/network.hpp"

namespace core {

/// "front", "back", "side", "sleeve", "sleeve back", "leg", "leg back", "collar", or where no direction tells "piece";
/// with a number where the name is taken: "front 2".
[[nodiscard]] std::string name_for_region(const Network& network, const std::vector<LineUse>& ring,
                                          const Obstacle& body);

/// `base`, or "base 2", "base 3", … : the first that no region has.
[[nodiscard]] std::string free_region_name(const Network& network, const std::string& base);

/// "line 1", "line 2", … : the first after all lines that there ever were.
[[nodiscard]] std::string free_line_name(const Network& network, const std::string& base = "line");

}  // namespace core
