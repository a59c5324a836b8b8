#include "db/codec/descriptor_codec.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/parts/rounding.hpp"
#include "db/codec/compact_descriptor.hpp"
#include "db/codec/points_codec.hpp"

namespace db {

namespace {

using core::Part;
using core::ShapeDescriptor;

constexpr std::uint8_t kFull = 1, kCompact = 2;                                           // layouts
constexpr std::size_t kPartBytes = 5 + 4 * (core::kFeatureCount + core::kSignatureSize);  // at least
constexpr int kAnyInteger = std::numeric_limits<int>::max();

// Layout 1 holds this many floats a part. Other counts in core are another layout, with a reader of its own.
static_assert(core::kFeatureCount == 9 && core::kSignatureSize == 12);

/// The same rules before writing and after reading. Null when the descriptor is sound.
const char* fault_of_part(const Part& part, int terminals, int samples) {
    if (part.first_terminal < 0 || part.first_terminal >= terminals) return "a part starts at no terminal";
    if (part.terminal_count < 1 || part.terminal_count > terminals) return "a part groups too many terminals";
    if (part.start_sample < 0 || part.start_sample >= samples) return "a part starts at no sample";
    if (part.end_sample < 0 || part.end_sample >= samples) return "a part ends at no sample";
    return nullptr;
}

/// The whole shape may have no terminals, and its arc may end where it starts.
const char* fault_of_whole(const Part& whole, int terminals, int samples) {
    const bool sound = whole.first_terminal >= 0 && whole.first_terminal <= terminals && whole.terminal_count >= 0 &&
                       whole.terminal_count <= std::max(terminals, 1) && whole.start_sample >= 0 &&
                       whole.start_sample <= samples && whole.end_sample >= 0 && whole.end_sample <= samples;
    return sound ? nullptr : "the whole shape names terminals or samples that are not there";
}

bool is_finite(const Part& part) {
    const auto finite = [](float f) { return std::isfinite(f); };
    return std::all_of(part.features.begin(), part.features.end(), finite) &&
           std::all_of(part.signature.begin(), part.signature.end(), finite);
}

const char* fault_of(const ShapeDescriptor& descriptor) {
    const auto samples = static_cast<int>(descriptor.samples.size());
    const int terminals = descriptor.terminal_count;
    if (terminals < 0 || static_cast<std::size_t>(terminals) > descriptor.parts.size()) {
        return "it has fewer parts than terminals";
    }
    for (const Part& part : descriptor.parts) {
        if (const char* fault = fault_of_part(part, terminals, samples); fault != nullptr) return fault;
        if (!is_finite(part)) return "a feature is not finite";
    }
    int last = -1;
    for (const int stop : descriptor.stop_points) {
        if (stop <= last || stop >= terminals) return "its stop points are not in order";
        last = stop;
    }
    if (!is_finite(descriptor.whole) || !std::isfinite(descriptor.skeletal_length)) return "a feature is not finite";
    return fault_of_whole(descriptor.whole, terminals, samples);
}

void write_part(ByteWriter& out, const Part& part) {
    out.varint(static_cast<std::uint64_t>(part.first_terminal));
    out.varint(static_cast<std::uint64_t>(part.terminal_count));
    out.varint(static_cast<std::uint64_t>(part.start_sample));
    out.varint(static_cast<std::uint64_t>(part.end_sample));
    out.u8(part.salient ? 1 : 0);
    for (const float f : part.features) out.f32(f);
    for (const float f : part.signature) out.f32(f);
}

Part read_part_1(ByteReader& in) {
    Part part;
    part.first_terminal = in.integer(kAnyInteger);
    part.terminal_count = in.integer(kAnyInteger);
    part.start_sample = in.integer(kAnyInteger);
    part.end_sample = in.integer(kAnyInteger);
    const std::uint8_t salient = in.u8();
    if (salient > 1) in.fail("a yes or no in it is neither");
    part.salient = salient == 1;
    for (float& f : part.features) f = in.f32();
    for (float& f : part.signature) f = in.f32();
    return part;
}

ShapeDescriptor read_1(ByteReader& in) {
    ShapeDescriptor descriptor;
    descriptor.samples = read_points(in);
    descriptor.terminal_count = in.integer(kAnyInteger);
    descriptor.parts.resize(in.count(kPartBytes));
    for (Part& part : descriptor.parts) part = read_part_1(in);
    descriptor.stop_points.resize(in.count(1));
    for (int& stop : descriptor.stop_points) stop = in.integer(kAnyInteger);
    descriptor.whole = read_part_1(in);
    descriptor.skeletal_length = in.f64();
    return descriptor;
}

core::Result<void> write_1(ByteWriter& out, const ShapeDescriptor& descriptor) {
    if (core::Result<void> done = write_points(out, descriptor.samples); !done) return done;
    out.varint(static_cast<std::uint64_t>(descriptor.terminal_count));
    out.varint(descriptor.parts.size());
    for (const Part& part : descriptor.parts) write_part(out, part);
    out.varint(descriptor.stop_points.size());
    for (const int stop : descriptor.stop_points) out.varint(static_cast<std::uint64_t>(stop));
    write_part(out, descriptor.whole);
    out.f64(descriptor.skeletal_length);
    return {};
}

ShapeDescriptor read_layout(ByteReader& in, std::uint8_t layout) {
    ShapeDescriptor descriptor;
    if (layout == kFull) descriptor = read_1(in);
    if (layout == kCompact) descriptor = read_compact(in);
    if (!in.failed()) {
        if (const char* fault = fault_of(descriptor); fault != nullptr) in.fail(fault);
    }
    return descriptor;
}

/// Appends the layout's number and then the descriptor, compact where it can be.
core::Result<void> write_layout(ByteWriter& out, const ShapeDescriptor& descriptor) {
    if (const char* fault = fault_of(descriptor); fault != nullptr) {
        return core::unexpected(core::ErrorCode::BadArgument, std::string("the descriptor is not sound: ") + fault);
    }
    const std::optional<ShapeDescriptor> rounded =
        fits_compact(descriptor) ? core::rounded(descriptor) : std::optional<ShapeDescriptor>();
    out.u8(rounded ? kCompact : kFull);
    if (!rounded) return write_1(out, descriptor);
    write_compact(out, *rounded);
    return {};
}

}  // namespace

core::Result<Blob> encode_descriptor(const ShapeDescriptor& descriptor) {
    ByteWriter out(BlobKind::Descriptor);
    if (const core::Result<void> done = write_layout(out, descriptor); !done) return core::unexpected(done.error());
    return out.take();
}

core::Result<ShapeDescriptor> decode_descriptor(BlobView blob) {
    ByteReader in(blob);
    const std::uint8_t layout = in.header(BlobKind::Descriptor, kCompact);
    ShapeDescriptor descriptor = read_layout(in, layout);
    if (const core::Result<void> done = in.finish(); !done) return core::unexpected(done.error());
    return descriptor;
}

}  // namespace db
