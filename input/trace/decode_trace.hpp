#pragma once
// The samples of a trace made anew from what the tablets sent. The same program makes the same samples; another one may
// know the tablet better.

#include <cstddef>
#include <vector>

#include "input/trace/trace.hpp"

namespace input {

struct DecodedTrace {
    std::vector<PenSample> samples;
    std::size_t differing = 0;  ///< samples that differ from those that were recorded
};

/// Reports and frames through today's decoders, in the order of the trace. Of a device without raw records the recorded
/// samples are taken. Linear time.
[[nodiscard]] DecodedTrace decode_trace(const Trace& trace);

/// A recording of another program as a trace: one device, its reports or frames, and the samples made of them.
struct Capture;
struct Surroundings;
[[nodiscard]] Trace trace_of_capture(const Capture& capture, const Surroundings& around);

/// A drawing as a trace: a device without axes beyond what drawings have, samples only. Coordinates are scaled to 0 … 1
/// of the drawing's extent, the longer side; millimetres are the drawing's own units.
[[nodiscard]] Trace trace_of_drawing(const core::Drawing& drawing);

/// The whole trace as text.
[[nodiscard]] std::string trace_text(const Trace& trace);

}  // namespace input
