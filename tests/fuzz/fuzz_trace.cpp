// Any text as a trace. What is read is written, and comes back the same. So that more than checksums is tried, every
// line also gets the right one.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "input/formats/text_lines.hpp"
#include "input/trace/decode_trace.hpp"

namespace {

void try_trace(std::string_view text) {
    const auto trace = input::parse_trace(text);
    if (!trace) return;
    const std::string written = input::trace_text(*trace);
    const auto again = input::parse_trace(written);
    if (!again || again->fault_count != 0 || again->records != trace->records) std::abort();
    (void)input::decode_trace(*trace);
    (void)trace->damage();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try_trace(text);
    std::string mended = input::trace_header();
    input::TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        line = line.substr(0, line.find(" *"));
        mended += std::string(line) + input::checksum_text(line) + "\n";
    }
    try_trace(mended);
    return 0;
}
