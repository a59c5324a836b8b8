#pragma once
// Sets of named body parts: what a piece of cloth lies over.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/mannequin/body_shape.hpp"

namespace core {

using PartSet = std::uint32_t;  ///< a bit for each BodyPart; none: not known

[[nodiscard]] constexpr PartSet part_bit(BodyPart part) {
    return PartSet{1} << static_cast<unsigned>(part);
}

/// Left arms and legs become right ones and the other way round.
[[nodiscard]] PartSet mirrored_parts(PartSet parts);

/// In the order of BodyPart.
[[nodiscard]] std::vector<std::string> names_of_parts(PartSet parts);

/// ErrorCode::BadArgument for a name that does not exist, with all that do.
[[nodiscard]] Result<BodyPart> part_named(std::string_view name);

}  // namespace core
