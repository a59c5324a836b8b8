#include "core/exchange/image_reader.hpp"

#include <catch2/catch.hpp>
#include <span>
#include <string>
#include <string_view>

#include "support/image_bytes.hpp"
#include "support/temporary_folder.hpp"

using namespace std::string_literals;

namespace {

core::Result<core::GrayImage> decode(const std::string& bytes) {
    return core::decode_gray_image(std::as_bytes(std::span(bytes)));
}

std::vector<int> grays(const std::string& bytes) {
    const auto image = decode(bytes);
    REQUIRE(image);
    return {image->pixels.begin(), image->pixels.end()};
}

std::string from_hex(std::string_view hex) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
        bytes.push_back(static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
    }
    return bytes;
}

// One row of two pixels, written blue, green, red: red, white.
const std::string kBmp = from_hex(
    "424d3e00000000000000360000002800000002000000010000000100180000000000080000000000"
    "00000000000000000000000000000000ffffffff0000");

}  // namespace

TEST_CASE("grey pictures of 1, 8 and 16 bits are read", "[image_reader]") {
    CHECK(grays(support::make_png(8, 1, 1, 0, "\xA5"s)) == std::vector<int>{255, 0, 255, 0, 0, 255, 0, 255});
    CHECK(grays(support::make_png(3, 1, 8, 0, "\x00\x80\xFF"s)) == std::vector<int>{0, 128, 255});
    CHECK(grays(support::make_png(2, 1, 16, 0, "\x12\x34\xFE\x00"s)) == std::vector<int>{0x12, 0xFE});
}

TEST_CASE("colour becomes luma, also through a palette", "[image_reader]") {
    CHECK(grays(support::make_png(3, 1, 8, 2, "\xFF\0\0\0\xFF\0\0\0\xFF"s)) == std::vector<int>{76, 150, 29});
    const std::string palette = support::png_chunk("PLTE", "\0\0\0\xFF\xFF\xFF\x0A\x0A\x0A"s);
    CHECK(grays(support::make_png(3, 1, 8, 3, "\2\1\0"s, palette)) == std::vector<int>{10, 255, 0});
}

TEST_CASE("what is transparent shows white paper", "[image_reader]") {
    CHECK(grays(support::make_png(3, 1, 8, 4, "\0\0\0\xFF\0\x80"s)) == std::vector<int>{255, 0, 127});
    CHECK(grays(support::make_png(1, 1, 8, 6, "\xFF\0\0\0"s)) == std::vector<int>{255});
}

TEST_CASE("BMP pictures are read", "[image_reader]") {
    CHECK(grays(kBmp) == std::vector<int>{76, 255});
    CHECK(grays(kBmp.substr(0, kBmp.size() - 2)) == std::vector<int>{76, 255});  // without the last row's filling
}

TEST_CASE("JPEG pictures are read", "[image_reader]") {
    const auto image = decode(
        from_hex("ffd8ffe000104a46494600010100000100010000ffdb004300100b0c0e0c0a100e0d0e1211101318281a181616183123251d2"
                 "83a333d3c39"
                 "33383740485c4e404457453738506d51575f626768673e4d71797064785c656763ffc0000b080008000801011100ffc400140"
                 "00100000000"
                 "000000000000000000000001ffc40014100100000000000000000000000000000000ffda0008010100003f001fffd9"));
    REQUIRE(image);
    CHECK(image->width == 8);
    CHECK(image->height == 8);
    CHECK(image->at(4, 4) == Approx(127).margin(3));
}

TEST_CASE("what is no picture, or a broken one, is refused with a sentence", "[image_reader]") {
    CHECK(decode("").error().code == core::ErrorCode::UnknownFormat);
    CHECK(decode("Dear reader").error().message == "this is no PNG, BMP or JPEG picture; give one of these");
    CHECK(decode("GIF89a").error().code == core::ErrorCode::UnknownFormat);

    const std::string whole = support::make_png(3, 1, 8, 0, "\x00\x80\xFF"s);
    for (std::size_t size = 4; size + 16 < whole.size(); ++size) {
        INFO(size);
        REQUIRE_FALSE(decode(whole.substr(0, size)));
    }
    CHECK(decode(whole.substr(0, 50)).error().message ==
          "the picture is damaged or of a kind that is not read; save it again as PNG");
    CHECK_FALSE(decode(support::make_png(0, 1, 8, 0, "")));
    CHECK_FALSE(decode(support::make_png(2'000'000'000, 2, 8, 0, "")));
    CHECK_FALSE(decode("BM"));
    for (std::size_t size = 2; size + 2 < kBmp.size(); ++size) {
        INFO(size);
        CHECK_FALSE(decode(kBmp.substr(0, size)));
    }
    CHECK_FALSE(decode("\xFF\xD8\xFF"));
}

TEST_CASE("a picture that claims to be huge is refused before it is decoded", "[image_reader]") {
    for (const auto& [width, height] : {std::pair{20'001, 1}, {1, 20'001}, {10'000, 10'000}}) {
        const auto image = decode(support::make_png(width, height, 8, 0, ""));
        REQUIRE_FALSE(image);
        CHECK(image.error().message ==
              "the picture has more than 48 million pixels or a side of more than 20000; reduce it");
    }
}

TEST_CASE("a JPEG whose code table is longer than any decoder's is refused", "[image_reader]") {
    const std::string table = "\xFF\xD8\xFF\xC4\x01\x22"s + "\0"s + std::string(15, '\x11') + "\x12"s;
    const auto image = decode(table + std::string(300, '\1'));
    REQUIRE_FALSE(image);
    CHECK(image.error().message == "the picture is damaged or of a kind that is not read; save it again as PNG");
}

TEST_CASE("errors of a file name it", "[image_reader]") {
    const support::TemporaryFolder folder;
    CHECK(core::read_gray_image(folder.path("none.png")).error().sentence() ==
          folder.path("none.png") + ": there is no such file; check the name");
    CHECK(core::read_gray_image(folder.path("")).error().code == core::ErrorCode::FileUnreadable);
    const std::string text = folder.write("text.png", "not a picture");
    CHECK(core::read_gray_image(text).error().where == text);
    const std::string good = folder.write("good.dat", support::make_png(3, 1, 8, 0, "\x00\x80\xFF"s));
    CHECK(core::read_gray_image(good)->width == 3);
}
