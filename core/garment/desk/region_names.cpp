#include "core/garment/desk/region_names.hpp"

#include <algorithm>
#include <cmath>

#include "core/garment/desk/pick.hpp"

namespace core {
namespace {

constexpr double kSideways = 0.85;  // share of the normal along x from which a piece is a side

PartSet bits(std::initializer_list<BodyPart> parts) {
    PartSet out = 0;
    for (const BodyPart part : parts) out |= part_bit(part);
    return out;
}

bool within(PartSet parts, PartSet of) {
    return parts != 0 && (parts & ~of) == 0;
}

}  // namespace

std::string free_region_name(const Network& network, const std::string& base) {
    std::string name = base;
    for (int k = 2; network.find_region(name) != nullptr; ++k) name = base + " " + std::to_string(k);
    return name;
}

std::string free_line_name(const Network& network, const std::string& base) {
    for (std::size_t k = network.lines().size() + 1;; ++k) {
        std::string name = base + " " + std::to_string(k);
        const bool taken = std::any_of(network.lines().begin(), network.lines().end(),
                                       [&](const NetworkLine& line) { return line.name == name; });
        if (!taken) return name;
    }
}

std::string name_for_region(const Network& network, const std::vector<LineUse>& ring, const Obstacle& body) {
    const SpaceLine border = resampled(ring_line(network, ring), 48);
    Vec3 normal, away;
    for (std::size_t i = 0; i + 1 < border.size(); ++i) {
        normal = normal + cross(border[i], border[i + 1]);
        away = away + body.sample(border[i]).gradient;
    }
    normal = normalised(normal);
    if (dot(normal, away) < 0.0) normal = normal * -1.0;
    const PartSet parts = body.parts().empty() ? 0 : body.parts().parts_under(border);
    std::string base;
    if (within(parts, bits({BodyPart::ArmLeft, BodyPart::ArmRight})))
        base = "sleeve";
    else if (within(parts, bits({BodyPart::LegLeft, BodyPart::LegRight})))
        base = "leg";
    else if (within(parts, bits({BodyPart::Neck, BodyPart::Head})))
        base = "collar";
    if (!base.empty()) return free_region_name(network, normal.z < 0.0 && base != "collar" ? base + " back" : base);
    if (std::abs(normal.x) > kSideways)
        base = "side";
    else if (std::abs(normal.z) < 0.2)
        base = "piece";
    else
        base = normal.z > 0.0 ? "front" : "back";
    return free_region_name(network, base);
}

}  // namespace core
