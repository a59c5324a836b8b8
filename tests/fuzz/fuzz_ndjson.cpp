// Any text as a drawing in Quick-Draw line.

#include "core/exchange/quickdraw_reader.hpp"
#include "drawing_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::hold_to_promises(core::parse_quickdraw_line(fuzz::text_of(data, size)));
    return 0;
}
