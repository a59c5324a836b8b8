// What the same shape gives when it lies elsewhere, is traced from elsewhere, has the other polarity, is turned, scaled
// or mirrored: on figures made here, and on real silhouettes where they are.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "core/exchange/image_reader.hpp"
#include "core/match/match.hpp"
#include "core/parts/describe.hpp"
#include "core/silhouette/contour.hpp"
#include "support/picture_copies.hpp"
#include "support/raster.hpp"
#include "support/shapes.hpp"

using core::GrayImage;
using core::Polygon;
using core::ShapeDescriptor;

namespace {

struct Picture {
    std::string name;
    GrayImage white_on_black;  ///< with a margin
};

std::vector<Picture> figures() {
    std::vector<Picture> all;
    const std::vector<std::pair<const char*, Polygon>> outlines{
        {"horse", support::horse()},       {"centaur", support::centaur()},   {"horned", support::horned()},
        {"hand", support::hand()},         {"airplane", support::airplane()}, {"bug", support::bug()},
        {"star", support::star(5, 10, 4)}, {"cross", support::cross(9, 3)},   {"comb", support::comb(7, 6)},
        {"L", support::l_shape(9, 3)},     {"disc", support::disc(80, 5)},    {"coastline", support::coastline(7)}};
    for (const auto& [name, outline] : outlines) {
        all.push_back({name, support::as_gray(support::silhouette_of(outline, 150, 12), true)});
    }
    return all;
}

/// Every `every`-th file of a folder of real silhouettes, in the order of their names. None where it is not there,
/// which is said.
std::vector<Picture> silhouettes(const char* folder, std::size_t every) {
    const std::filesystem::path root = std::filesystem::path(CROQUIS_SHARED_DATA) / folder;
    if (!std::filesystem::exists(root)) {
        WARN("skipped: " + root.string() + " is not there");
        return {};
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(root)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Picture> all;
    for (std::size_t i = 0; i < files.size(); i += every) {
        const auto image = core::read_gray_image(files[i].string());
        if (!image) continue;
        const core::BinaryImage mask = core::object_mask(*image);
        all.push_back({files[i].filename().string(), support::moved(support::as_gray(mask, true), 20, 20)});
    }
    REQUIRE_FALSE(all.empty());
    return all;
}

Polygon outline_of(const GrayImage& image) {
    const auto outline = core::largest_contour(core::object_mask(image));
    REQUIRE(outline);
    return *outline;
}

ShapeDescriptor described(const Polygon& outline) {
    const auto descriptor = core::describe(outline);
    REQUIRE(descriptor);
    return *descriptor;
}

ShapeDescriptor described(const GrayImage& image) {
    return described(outline_of(image));
}

void check_other_starts(const Picture& picture, int starts) {
    const Polygon outline = outline_of(picture.white_on_black);
    const ShapeDescriptor original = described(outline);
    for (int k = 1; k <= starts; ++k) {
        const int first = static_cast<int>(outline.size()) * k / (starts + 1);
        INFO(picture.name << " from contour point " << first);
        CHECK(described(support::started_at(outline, first)) == original);
    }
}

void check_other_places(const Picture& picture, const std::vector<std::pair<int, int>>& places) {
    const ShapeDescriptor original = described(picture.white_on_black);
    for (const auto& [dx, dy] : places) {
        INFO(picture.name << " moved by " << dx << ", " << dy);
        CHECK(support::same_but_for_place(original, described(support::moved(picture.white_on_black, dx, dy))));
    }
}

void check_other_polarity(const Picture& picture) {
    INFO(picture.name);
    CHECK(described(support::inverted(picture.white_on_black)) == described(picture.white_on_black));
}

/// Copies that were turned, scaled and mirrored, and how many of them are nearest to their own original.
struct Nearness {
    int made = 0, nearest = 0;
    [[nodiscard]] double share() const { return 100.0 * nearest / made; }
};

class Originals {
  public:
    explicit Originals(const std::vector<Picture>& pictures) {
        for (const Picture& picture : pictures) shapes_.push_back(core::matchable(described(picture.white_on_black)));
    }
    void compare(std::size_t own, const std::string& name, const GrayImage& copy, Nearness& result) {
        const core::MatchableShape shape = core::matchable(described(copy));
        const double distance = matcher_.distance(shape, shapes_[own]);
        ++result.made;
        for (std::size_t i = 0; i < shapes_.size(); ++i) {
            if (i == own || matcher_.distance(shape, shapes_[i], distance) >= distance) continue;
            UNSCOPED_INFO(name << " is nearer to number " << i);
            return;
        }
        ++result.nearest;
    }

  private:
    std::vector<core::MatchableShape> shapes_;
    core::Matcher matcher_;
};

Nearness mirrored(const std::vector<Picture>& pictures, Originals& originals, std::size_t every) {
    Nearness result;
    for (std::size_t i = 0; i < pictures.size(); i += every) {
        originals.compare(i, pictures[i].name + ", mirrored", support::turned(pictures[i].white_on_black, 0, 1, true),
                          result);
    }
    return result;
}

Nearness turned(const std::vector<Picture>& pictures, Originals& originals, std::size_t every) {
    Nearness result;
    for (std::size_t i = 0; i < pictures.size(); i += every) {
        for (int k = 1; k <= 12; ++k) {
            const double degrees =
                360.0 * k / 12.0 - 11.0;  // 11 degrees short of every twelfth: no copy is the original
            originals.compare(i, pictures[i].name + ", turned by " + std::to_string(degrees),
                              support::turned(pictures[i].white_on_black, degrees, 1, false), result);
        }
    }
    return result;
}

Nearness scaled(const std::vector<Picture>& pictures, Originals& originals, std::size_t every) {
    Nearness result;
    for (std::size_t i = 0; i < pictures.size(); i += every) {
        for (const double scale : {0.5, 2.0, 4.0}) {
            originals.compare(i, pictures[i].name + ", scaled by " + std::to_string(scale),
                              support::turned(pictures[i].white_on_black, 0, scale, false), result);
        }
    }
    return result;
}

}  // namespace

TEST_CASE("another start of the trace: the same descriptor to the last bit", "[stability]") {
    for (const Picture& picture : figures()) check_other_starts(picture, 6);
}

TEST_CASE("another place: the same descriptor, its samples moved", "[stability]") {
    for (const Picture& picture : figures()) check_other_places(picture, {{0, 0}, {1, 0}, {0, 1}, {17, 5}, {40, 39}});
}

TEST_CASE("the other polarity: the same descriptor to the last bit", "[stability]") {
    for (const Picture& picture : figures()) check_other_polarity(picture);
}

TEST_CASE("real silhouettes: start, place and polarity change nothing", "[stability]") {
    for (const auto& [folder, every] :
         {std::pair{"kimia99", 11U}, std::pair{"kimia216", 12U}, std::pair{"mpeg7", 40U}}) {
        for (const Picture& picture : silhouettes(folder, every)) {
            check_other_starts(picture, 2);
            check_other_places(picture, {{17, 5}});
            check_other_polarity(picture);
        }
    }
}

TEST_CASE("mirrored, turned and scaled copies are nearest to their own original", "[stability]") {
    const std::vector<Picture> pictures = figures();
    Originals originals(pictures);
    SECTION("mirrored") {
        CHECK(mirrored(pictures, originals, 1).share() == 100.0);
    }
    SECTION("turned") {
        CHECK(turned(pictures, originals, 2).share() == 100.0);
    }
    SECTION("scaled") {
        CHECK(scaled(pictures, originals, 3).share() == 100.0);
    }
}

TEST_CASE("real silhouettes: copies are nearest to their own original among several of every class", "[stability]") {
    const std::vector<Picture> pictures = silhouettes("kimia216", 4);
    if (pictures.empty()) return;
    Originals originals(pictures);
    SECTION("mirrored") {
        CHECK(mirrored(pictures, originals, 3).share() == 100.0);
    }
    SECTION("turned") {
        CHECK(turned(pictures, originals, 9).share() >= 97.0);
    }
    SECTION("scaled") {
        CHECK(scaled(pictures, originals, 9).share() == 100.0);
    }
}
