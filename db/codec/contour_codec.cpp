#include "db/codec/contour_codec.hpp"

#include <cstdlib>

namespace db {

namespace {

using core::ContourDescriptor;

constexpr std::uint8_t kContourVersion = 1;

// Layout 1 holds these many numbers within these bounds.
static_assert(core::kFramePoints == 80 && core::kFrameChannels == 16);
static_assert(core::kGreatestHeight == 34 && core::kGreatestAhead == 51);
static_assert(core::kPolarRings == 12 && core::kPolarSectors == 32);

/// The same rules before writing and after reading. Null when the descriptor is sound.
const char* fault_of(const ContourDescriptor& descriptor) {
    for (std::size_t k = 0; k < core::kFrameChannels; ++k) {
        const int greatest = k < core::kFrameStretches ? core::kGreatestHeight : core::kGreatestAhead;
        for (const std::int8_t value : descriptor.frames[k]) {
            if (std::abs(static_cast<int>(value)) > greatest) return "a number of its frames is too large";
        }
    }
    if (!(descriptor.complexity >= 0.0F && descriptor.complexity <= 1.0F)) return "its complexity is not in 0 to 1";
    return nullptr;
}

ContourDescriptor read_1(ByteReader& in) {
    ContourDescriptor descriptor;
    descriptor.complexity = in.f32();
    for (auto& channel : descriptor.frames) {
        for (std::int8_t& value : channel) value = static_cast<std::int8_t>(in.u8());
    }
    for (auto& ring : descriptor.cover) {
        for (std::uint8_t& cell : ring) cell = in.u8();
    }
    return descriptor;
}

}  // namespace

core::Result<Blob> encode_contour(const ContourDescriptor& descriptor) {
    if (const char* fault = fault_of(descriptor); fault != nullptr) {
        return core::unexpected(core::ErrorCode::BadArgument,
                                std::string("the contour descriptor is not sound: ") + fault);
    }
    ByteWriter out(BlobKind::Contour, kContourVersion);
    out.f32(descriptor.complexity);
    for (const auto& channel : descriptor.frames) {
        for (const std::int8_t value : channel) out.u8(static_cast<std::uint8_t>(value));
    }
    for (const auto& ring : descriptor.cover) {
        for (const std::uint8_t cell : ring) out.u8(cell);
    }
    return out.take();
}

core::Result<ContourDescriptor> decode_contour(BlobView blob) {
    ByteReader in(blob);
    ContourDescriptor descriptor;
    switch (in.header(BlobKind::Contour, kContourVersion)) {
        case 1:
            descriptor = read_1(in);
            break;
        default:
            break;  // the reader has noted the fault
    }
    if (!in.failed()) {
        if (const char* fault = fault_of(descriptor); fault != nullptr) in.fail(fault);
    }
    if (const core::Result<void> done = in.finish(); !done) return core::unexpected(done.error());
    return descriptor;
}

}  // namespace db
