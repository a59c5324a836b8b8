#include "core/mannequin/part_set.hpp"

#include <array>
#include <utility>

namespace core {

PartSet mirrored_parts(PartSet parts) {
    constexpr std::array<std::pair<BodyPart, BodyPart>, 2> kPairs{
        {{BodyPart::ArmLeft, BodyPart::ArmRight}, {BodyPart::LegLeft, BodyPart::LegRight}}};
    PartSet out = parts;
    for (const auto& [left, right] : kPairs) {
        out &= ~(part_bit(left) | part_bit(right));
        if ((parts & part_bit(left)) != 0) out |= part_bit(right);
        if ((parts & part_bit(right)) != 0) out |= part_bit(left);
    }
    return out;
}

std::vector<std::string> names_of_parts(PartSet parts) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < kBodyPartCount; ++k)
        if ((parts & part_bit(static_cast<BodyPart>(k))) != 0)
            names.emplace_back(body_part_name(static_cast<BodyPart>(k)));
    return names;
}

Result<BodyPart> part_named(std::string_view name) {
    std::string all;
    for (std::size_t k = 0; k < kBodyPartCount; ++k) {
        const auto part = static_cast<BodyPart>(k);
        if (name == body_part_name(part)) return part;
        all += (k == 0 ? "" : ", ") + std::string(body_part_name(part));
    }
    return unexpected(ErrorCode::BadArgument,
                      "There is no body part \"" + std::string(name) + "\"; there are " + all + ".");
}

}  // namespace core
