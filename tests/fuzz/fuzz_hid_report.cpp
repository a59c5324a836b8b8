// Any bytes as a row of reports, each with its length in front, of every tablet that a data file knows. The first byte
// chooses the file.

#include <cstdint>
#include <cstdlib>
#include <span>

#include "input/devices/make_decoder.hpp"
#include "input/devices/uclogic_strings.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto files = input::device_files();
    if (size < 2 || files.empty()) return 0;
    std::span<const std::uint8_t> rest(data + 1, size - 1);
    (void)input::axes_of_string_200(rest);
    (void)input::axes_of_string_100(rest);
    (void)input::text_of_string(rest);
    input::UsbStrings strings;
    strings[100] = strings[200] = {rest.begin(),
                                   rest.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(rest.size(), 20))};
    const auto decoder = make_decoder(&files[data[0] % files.size()], std::nullopt, strings);
    if (!decoder) return 0;
    while (!rest.empty()) {
        const std::size_t length = std::min<std::size_t>(rest[0], rest.size() - 1);
        const auto bytes = rest.subspan(1, length);
        rest = rest.subspan(1 + length);
        input::PenReport report;
        const input::PenAxes* axes = nullptr;
        if (!decoder->decode(bytes, report, axes)) continue;
        const input::PenSample s = to_sample(report, *axes, 0, 1);
        if (s.tip && !s.in_range) std::abort();
        if (s.x && !(*s.x >= 0.0 && *s.x <= 1.0)) std::abort();
    }
    return 0;
}
