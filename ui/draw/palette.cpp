#include "ui/draw/palette.hpp"

#include <atomic>

namespace ui::palette {
namespace {

constexpr Colour kWhite = Colour::hex(0xFFFFFF);
constexpr PartColours kSoft{
    {Colour::hex(0x75C4F1), Colour::hex(0x8E872C), Colour::hex(0x7B77CF), Colour::hex(0xC6908A), Colour::hex(0x734541),
     Colour::hex(0x127C7D), Colour::hex(0x334A81), Colour::hex(0x9DCD36)},
    {kInk, kInk, kInk, kInk, kWhite, kWhite, kWhite, kInk}};
constexpr PartColours kStrong{
    {Colour::hex(0x30A1ED), Colour::hex(0x8F851B), Colour::hex(0x8C02F4), Colour::hex(0xEC789C), Colour::hex(0x5E0027),
     Colour::hex(0x087D59), Colour::hex(0x253A86), Colour::hex(0x89CD00)},
    {kInk, kInk, kWhite, kInk, kWhite, kWhite, kWhite, kInk}};

std::atomic<PartPalette> chosen{PartPalette::Soft};

}  // namespace

const PartColours& part_colours(PartPalette palette) {
    return palette == PartPalette::Strong ? kStrong : kSoft;
}

void choose_parts(PartPalette palette) {
    chosen = palette;
}

PartPalette chosen_parts() {
    return chosen;
}

}  // namespace ui::palette
