#pragma once
// The descriptor as an index keeps it. Features and signatures of all parts follow from the samples and from where the
// parts start and end, so only those need be stored, the samples rounded to a grid; the rest is measured again from the
// rounded samples. A search that compares stored with fresh descriptors and wants the very same numbers for the same
// outline rounds the fresh one too:
//
//     core::ShapeDescriptor shape = core::rounded(described).value_or(described);

#include <optional>

#include "core/parts/descriptor.hpp"
#include "core/skeleton/sampling.hpp"
#include "core/skeleton/shape_parameters.hpp"

namespace core {

/// Whether all parts and `whole` carry, bit for bit, what measure_part gives for the samples and their arcs. False for
/// a descriptor without area or with a part that names no sample. About 2 us a part.
[[nodiscard]] bool is_measured(const ShapeDescriptor& shape, const ShapeParameters& parameters = {});

/// Gives every part, and `whole`, the features and signature that its arc has. Counts and salience stay. The samples
/// enclose an area and the arcs name samples. Returns whether every number is finite. About 2 us a part.
bool measure_again(ShapeDescriptor& shape, const ShapeParameters& parameters = {});

/// The descriptor with its samples on the grid, its skeletal length in single precision and its parts measured again;
/// rounding that a second time changes nothing. Nothing for a descriptor that is not measured (is_measured) and for one
/// that encloses no area once it is rounded.
[[nodiscard]] std::optional<ShapeDescriptor> rounded(const ShapeDescriptor& shape,
                                                     const ShapeParameters& parameters = {});

}  // namespace core
