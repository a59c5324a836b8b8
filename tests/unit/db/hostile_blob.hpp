#pragma once
// What every decoder must stand: a blob cut off anywhere, and a blob with any byte changed. Whatever still decodes must
// be a sound value, one that encodes and comes back the same.

#include <catch2/catch.hpp>

#include "db/codec/bytes.hpp"

namespace fixture {

template <typename T, typename Decode, typename Encode, typename Same>
void try_every_cut_and_flip(const db::Blob& blob, Decode decode, Encode encode, Same same) {
    for (std::size_t size = 0; size < blob.size(); ++size) {
        const core::Result<T> cut = decode(db::BlobView(blob).first(size));
        if (cut) FAIL("the first " << size << " of " << blob.size() << " bytes were taken for the whole");
        if (cut.error().code != core::ErrorCode::Damaged) FAIL("cut off, but: " << cut.error().sentence());
    }
    db::Blob longer = blob;
    longer.push_back(std::byte{0});
    CHECK_FALSE(decode(db::BlobView(longer)));
    for (std::size_t at = 0; at < blob.size(); ++at) {
        for (const int mask : {0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x80, 0xff}) {
            db::Blob flipped = blob;
            flipped[at] ^= static_cast<std::byte>(mask);
            const core::Result<T> decoded = decode(db::BlobView(flipped));
            if (!decoded) continue;
            const core::Result<db::Blob> again = encode(*decoded);
            if (!again)
                FAIL("byte " << at << " ^ " << mask << " gave what cannot be written: " << again.error().sentence());
            const core::Result<T> twice = decode(db::BlobView(*again));
            if (!twice || !same(*decoded, *twice)) FAIL("byte " << at << " ^ " << mask << " gave what does not last");
        }
    }
}

}  // namespace fixture
