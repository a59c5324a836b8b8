// Any bytes as a report descriptor, and as a report of its pens. The first two bytes say where the one ends.

#include <cstdint>
#include <cstdlib>
#include <span>

#include "input/parse/pen_decoder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) return 0;
    const std::span<const std::uint8_t> all(data + 2, size - 2);
    const std::size_t split = std::min<std::size_t>(static_cast<std::size_t>(data[0] | data[1] << 8), all.size());
    const auto descriptor = input::parse_report_descriptor(all.first(split));
    if (!descriptor) return 0;
    if (descriptor->fields.size() > input::kMaxHidFields) std::abort();
    for (const input::HidField& f : descriptor->fields) {
        (void)input::steps_per_unit(f);
        (void)input::field_value(all.subspan(split), f);
        if (f.logical_min > f.logical_max) std::abort();
    }
    std::vector<input::PenLayout> pens = input::find_pens(*descriptor);
    if (pens.empty()) return 0;
    const auto decoder = input::make_layout_decoder(std::move(pens), "fuzz");
    input::PenReport report;
    const input::PenAxes* axes = nullptr;
    if (!decoder->decode(all.subspan(split), report, axes)) return 0;
    const input::PenSample s = to_sample(report, *axes, 0, 1);
    if (s.tip && !s.in_range) std::abort();
    for (const auto& share : {s.x, s.y, s.pressure}) {
        if (share && !(*share >= 0.0 && *share <= 1.0)) std::abort();
    }
    return 0;
}
