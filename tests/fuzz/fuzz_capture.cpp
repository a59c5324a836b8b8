// Any text as a recording of another program: whichever reader takes it, and then decoded.

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "input/formats/decode_capture.hpp"
#include "input/trace/decode_trace.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const auto read :
         {input::parse_capture, input::parse_hid_recorder, input::parse_usbhid_dump, input::parse_evemu,
          input::parse_libinput_record, input::parse_evdev_text, input::parse_hex_reports}) {
        const auto capture = read(text);
        if (!capture) continue;
        const input::DecodedCapture decoded = input::decode_capture(*capture, {});
        if (decoded.samples.empty() != decoded.why_none.has_value()) std::abort();
        const input::Trace trace = input::trace_of_capture(*capture, {});
        if (trace.samples() != decoded.samples) std::abort();
    }
    return 0;
}
