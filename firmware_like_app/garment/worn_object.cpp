#include "firmware_like_app/garment/worn_object.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "core/geometry/turn.hpp"
#include "firmware_like_app/garment/dressed_design.hpp"

namespace app {
namespace {

using core::Vec3;

enum class Spot { Head, Eyes, Neck, Hand, Wrist, Waist, Back, Foot };

struct Kind {
    std::string_view word;
    Spot spot;
    double size_cm;  // longest side
};

constexpr std::array<Kind, 35> kKinds{
    {{"hat", Spot::Head, 30},        {"cap", Spot::Head, 26},        {"helmet", Spot::Head, 30},
     {"crown", Spot::Head, 22},      {"beret", Spot::Head, 27},      {"hood", Spot::Head, 32},
     {"glasses", Spot::Eyes, 15},    {"eyeglasses", Spot::Eyes, 15}, {"spectacles", Spot::Eyes, 15},
     {"sunglasses", Spot::Eyes, 15}, {"goggles", Spot::Eyes, 18},    {"mask", Spot::Eyes, 20},
     {"necklace", Spot::Neck, 22},   {"tie", Spot::Neck, 45},        {"scarf", Spot::Neck, 40},
     {"collar", Spot::Neck, 20},     {"watch", Spot::Wrist, 8},      {"bracelet", Spot::Wrist, 8},
     {"glove", Spot::Wrist, 22},     {"belt", Spot::Waist, 40},      {"buckle", Spot::Waist, 8},
     {"backpack", Spot::Back, 45},   {"rucksack", Spot::Back, 45},   {"wing", Spot::Back, 90},
     {"shoe", Spot::Foot, 28},       {"boot", Spot::Foot, 32},       {"sneaker", Spot::Foot, 28},
     {"sandal", Spot::Foot, 27},     {"slipper", Spot::Foot, 27},    {"bag", Spot::Hand, 34},
     {"handbag", Spot::Hand, 34},    {"purse", Spot::Hand, 26},      {"suitcase", Spot::Hand, 55},
     {"briefcase", Spot::Hand, 42},  {"umbrella", Spot::Hand, 85}}};
constexpr Kind kOther{"", Spot::Hand, 34};

/// Lower case, cut where no letters are; plurals count as their singular.
std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
            words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!words.back().empty())
            words.emplace_back();
    }
    return words;
}

Kind kind_of(const FoundObject& found) {
    for (const std::string* text : {&found.class_name, &found.name})
        for (const std::string& word : words_of(*text))
            for (const Kind& kind : kKinds)
                if (word == kind.word || word == std::string(kind.word) + "s") return kind;
    return kOther;
}

struct Box {
    Vec3 low, high;
};
Box box_of(const std::vector<Vec3>& points) {
    Box box{points.empty() ? Vec3{} : points.front(), points.empty() ? Vec3{} : points.front()};
    for (const Vec3& p : points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
    return box;
}

/// The part of the body between two heights, |x| no more than `wide`.
Box slice(const core::DressForm& form, double low_y, double high_y, double wide) {
    std::vector<Vec3> inside;
    for (const Vec3& v : form.mesh.vertices)
        if (v.y >= low_y && v.y <= high_y && std::abs(v.x) <= wide) inside.push_back(v);
    if (inside.empty()) inside.push_back({0, (low_y + high_y) / 2, 0});
    return box_of(inside);
}

/// The landmark, or where it would be on an upright body, as shares of its height.
Vec3 place_of(const core::DressForm& form, const char* landmark, double height, Vec3 share) {
    if (const core::Landmark* found = core::find_landmark(form.landmarks, landmark)) return found->place;
    return share * height;
}

/// Where the middle of an object goes whose turned box has these half sides.
Vec3 middle_at(Spot spot, const core::DressForm& form, Vec3 half) {
    const double height = box_of(form.mesh.vertices).high.y;
    const Box head = slice(form, 0.9 * height, height, 0.1 * height);
    const Vec3 head_middle = (head.low + head.high) * 0.5;
    const Vec3 wrist = place_of(form, "wrist_left", height, {0.24, 0.5, 0.03});
    switch (spot) {
        case Spot::Head:  // down over the crown by a third of a hat
            return {0, height + half.y / 3, head_middle.z};
        case Spot::Eyes:
            return {0, 0.935 * height, slice(form, 0.92 * height, 0.95 * height, 0.05 * height).high.z};
        case Spot::Neck: {
            const double y = 0.82 * height;
            return {0, y - half.y / 2, slice(form, y - 0.02 * height, y + 0.01 * height, 0.04 * height).high.z};
        }
        case Spot::Wrist:
            return wrist;
        case Spot::Waist: {
            const double y = place_of(form, "waist_front", height, {0, 0.63, 0.08}).y;
            const Box waist = slice(form, y - 2, y + 2, 0.11 * height);
            return {0, y, (waist.low.z + waist.high.z) / 2};
        }
        case Spot::Back: {
            const Box trunk = slice(form, 0.6 * height, 0.8 * height, 0.08 * height);
            return {0, 0.72 * height, trunk.low.z - half.z};
        }
        case Spot::Foot: {
            const Vec3 ankle = place_of(form, "ankle_left", height, {0.06, 0.05, 0});
            return {std::min(ankle.x, 0.1 * height), half.y, ankle.z + half.z / 3};
        }
        case Spot::Hand:
            break;
    }
    // below the hand; what is taller stands on the floor
    return {wrist.x, std::max(wrist.y - 0.06 * height - half.y, half.y), wrist.z};
}

std::string free_name(const std::string& wished, const std::vector<core::PlacedObject>& taken) {
    std::set<std::string> names;
    for (const core::PlacedObject& object : taken) names.insert(object.name);
    const std::string name = wished.empty() ? "object" : wished;
    for (int n = 1;; ++n) {
        std::string numbered = n == 1 ? name : name + " " + std::to_string(n);
        if (names.count(numbered) == 0) return numbered;
    }
}

/// As the drawing saw it, from the front; a shoe from the side.
Vec3 turn_of(const core::Camera& camera, Spot spot) {
    // of the model's axes, what the drawing had right, up and towards itself; the turn takes these to x, y, z
    const Vec3 right = camera.right(), up = camera.up, toward = camera.direction;
    const Vec3 turn =
        core::turn_of_axes({right.x, up.x, toward.x}, {right.y, up.y, toward.y}, {right.z, up.z, toward.z});
    return spot == Spot::Foot ? core::turned_further(turn, {0, 1, 0}, std::numbers::pi / 2) : turn;
}

}  // namespace

double longest_side(const core::TriangleMesh& model) {
    const Box box = box_of(model.vertices);
    const Vec3 size = box.high - box.low;
    return std::max({size.x, size.y, size.z});
}

core::PlacedObject put_on(const FoundObject& found, const core::TriangleMesh& model, const core::DressForm& form,
                          const std::vector<core::PlacedObject>& taken) {
    const Kind kind = kind_of(found);
    core::PlacedObject object;
    object.name = free_name(found.name, taken);
    object.model = found.model;
    object.turn = turn_of(found.camera, kind.spot);
    const double side = longest_side(model);
    object.scale = side > 0 ? kind.size_cm / side : 1;
    const Box box = box_of(placed_mesh(object, model).vertices);
    object.at = middle_at(kind.spot, form, (box.high - box.low) * 0.5);
    return object;
}

}  // namespace app
