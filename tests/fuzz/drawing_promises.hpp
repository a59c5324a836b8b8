#pragma once
// What every reader of drawings promises, whatever the file says.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/base/result.hpp"
#include "core/stroke/stroke.hpp"
#include "input/trace/decode_trace.hpp"

namespace fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Aborts where a drawing breaks a promise, or does not survive as a trace.
inline void hold_to_promises(const core::Result<core::Drawing>& drawing) {
    if (!drawing) return;
    if (drawing->empty()) std::abort();
    std::int64_t last_us = 0;
    for (const core::Stroke& stroke : drawing->strokes) {
        if (stroke.samples.empty()) std::abort();
        for (const core::PenSample& s : stroke.samples) {
            if (!std::isfinite(s.x) || !std::isfinite(s.y) || s.time_us < last_us) std::abort();
            if (!(s.pressure >= 0.0 && s.pressure <= 1.0)) std::abort();
            last_us = s.time_us;
        }
    }
    const auto again = input::parse_trace(input::trace_text(input::trace_of_drawing(*drawing)));
    if (!again || again->fault_count != 0) std::abort();
}

}  // namespace fuzz
