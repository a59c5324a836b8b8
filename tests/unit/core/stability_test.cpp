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

constexpr double kSize_px = 110;  ///< of the longer side of a figure

struct Figure {
    std::string name;
    Polygon outline;
};

Picture pictured(const Figure& figure, double size = kSize_px) {
    return {figure.name, support::as_gray(support::silhouette_of(figure.outline, size, 12), true)};
}

std::vector<Figure> figures() {
    return {{"horse", support::horse()},       {"centaur", support::centaur()},   {"horned", support::horned()},
            {"hand", support::hand()},         {"airplane", support::airplane()}, {"bug", support::bug()},
            {"star", support::star(5, 10, 4)}, {"cross", support::cross(9, 3)},   {"comb", support::comb(7, 6)},
            {"L", support::l_shape(9, 3)},     {"disc", support::disc(80, 5)},    {"coastline", support::coastline(7)}};
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

constexpr int kTurns = 12;
/// Eleven degrees short of every twelfth of a turn, so that no copy is the original.
double degrees_of(int turn) {
    return 360.0 * turn / kTurns - 11.0;
}

}  // namespace

TEST_CASE("another start of the trace: the same descriptor to the last bit", "[stability]") {
    for (const Figure& figure : figures()) check_other_starts(pictured(figure), 6);
}

TEST_CASE("another place: the same descriptor, its samples moved", "[stability]") {
    for (const Figure& figure : figures()) {
        check_other_places(pictured(figure), {{0, 0}, {1, 0}, {0, 1}, {17, 5}, {40, 39}});
    }
}

TEST_CASE("the other polarity: the same descriptor to the last bit", "[stability]") {
    for (const Figure& figure : figures()) check_other_polarity(pictured(figure));
}

TEST_CASE("real silhouettes: start, place and polarity change nothing", "[stability]") {
    for (const auto& [folder, every] :
         {std::pair{"kimia99", 11U}, std::pair{"kimia216", 24U}, std::pair{"mpeg7", 80U}}) {
        for (const Picture& picture : silhouettes(folder, every)) {
            check_other_starts(picture, 2);
            check_other_places(picture, {{17, 5}});
            check_other_polarity(picture);
        }
    }
}

TEST_CASE("a picture read from the other side or turned by a quarter has the same parts", "[stability]") {
    core::Matcher matcher;
    for (const Figure& figure : figures()) {
        const Picture picture = pictured(figure);
        const core::MatchableShape own = core::matchable(described(picture.white_on_black));
        const GrayImage& page = picture.white_on_black;
        GrayImage mirror(page.width, page.height), quarter(page.height, page.width);
        for (int y = 0; y < page.height; ++y) {
            for (int x = 0; x < page.width; ++x) {
                mirror.pixels[mirror.index(page.width - 1 - x, y)] = page.at(x, y);
                quarter.pixels[quarter.index(page.height - 1 - y, x)] = page.at(x, y);
            }
        }
        INFO(picture.name);
        // The ellipse of a cross is a circle, so nothing says where its samples begin. Other shapes are at 50 and more.
        const double most = picture.name == "cross" ? 3.0 : 1.0;
        CHECK(matcher.distance(own, core::matchable(described(mirror))) < most);
        CHECK(matcher.distance(own, core::matchable(described(quarter))) < most);
    }
}

TEST_CASE("mirrored, turned and scaled figures are nearest to their own original", "[stability]") {
    std::vector<Picture> pictures;
    for (const Figure& figure : figures()) pictures.push_back(pictured(figure));
    Originals originals(pictures);
    Nearness mirrored, turned, scaled;
    std::size_t own = 0;
    for (const auto& [name, outline] : figures()) {
        const Picture mirror = pictured({name + ", mirrored", support::mirrored(outline)});
        originals.compare(own, mirror.name, mirror.white_on_black, mirrored);
        for (int k = 1; k <= kTurns; ++k) {
            const Polygon copy = support::turned(outline, degrees_of(k) * std::numbers::pi / 180.0);
            const Picture picture = pictured({name + ", turned by " + std::to_string(degrees_of(k)), copy});
            originals.compare(own, picture.name, picture.white_on_black, turned);
        }
        for (const double scale : {0.5, 2.0, 4.0}) {
            const Picture picture =
                pictured({name + ", scaled by " + std::to_string(scale), outline}, kSize_px * scale);
            originals.compare(own, picture.name, picture.white_on_black, scaled);
        }
        ++own;
    }
    CHECK(mirrored.share() == 100.0);
    CHECK(turned.share() == 100.0);
    CHECK(scaled.share() == 100.0);
}

TEST_CASE("real silhouettes: copies are nearest to their own original among several of every class", "[stability]") {
    const std::vector<Picture> pictures = silhouettes("kimia216", 4);
    if (pictures.empty()) return;
    Originals originals(pictures);
    Nearness all;
    const auto compare = [&](std::size_t own, double degrees, double scale, bool mirrored) {
        const Picture& picture = pictures[own];
        originals.compare(own, picture.name, support::turned(picture.white_on_black, degrees, scale, mirrored), all);
    };
    SECTION("mirrored") {
        for (std::size_t i = 0; i < pictures.size(); i += 3) compare(i, 0, 1, true);
        CHECK(all.share() == 100.0);
    }
    SECTION("turned") {
        for (std::size_t i = 0; i < pictures.size(); i += 18) {
            for (int k = 1; k <= kTurns; ++k) compare(i, degrees_of(k), 1, false);
        }
        CHECK(all.share() >= 97.0);
    }
    SECTION("scaled") {
        for (std::size_t i = 0; i < pictures.size(); i += 18) {
            for (const double scale : {0.5, 2.0}) compare(i, 0, scale, false);
        }
        compare(1, 0, 4.0, false);
        CHECK(all.share() == 100.0);
    }
}
