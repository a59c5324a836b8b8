#pragma once
// Worked designs with quads as fine as a measurement asks for.

#include <cmath>
#include <cstddef>

#include "core/garment/drape.hpp"
#include "core/garment/wardrobe.hpp"

namespace support {

/// The design with quads so fine that the garment has about so many vertices. It must build without a fault.
inline core::Garment garment_of(core::Design design, const core::Mannequin& body, std::size_t vertices) {
    const core::DressForm form = core::dress_form(body);
    core::Garment garment = *core::make_garment(design, form);
    for (int k = 0; k < 3; ++k) {
        const double ratio = std::sqrt(static_cast<double>(core::joined_layers(garment.layers).vertices.size()) /
                                       static_cast<double>(vertices));
        if (std::abs(ratio - 1.0) < 0.03) break;
        design.network.edge_cm *= ratio;
        garment = *core::make_garment(design, form);
    }
    return garment;
}

}  // namespace support
