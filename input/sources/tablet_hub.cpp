#include "input/sources/tablet_hub.hpp"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <filesystem>

#include "core/exchange/file_bytes.hpp"
#include "input/formats/text_lines.hpp"

namespace input {
namespace {

/// Whether a bit is set in a mask as sysfs writes it: words of 64 bits in hexadecimal, the lowest last.
bool has_bit(const std::string& path, unsigned bit) {
    const core::Result<std::string> text = core::read_file_bytes(path, 4096);
    if (!text) return false;
    std::vector<std::string_view> words;
    std::string_view rest = *text;
    while (!rest.empty() && (rest.back() == '\n' || rest.back() == ' ')) rest.remove_suffix(1);
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) words.push_back(word);
    const std::size_t index = bit / 64;
    if (index >= words.size()) return false;
    const auto word = number_of_text<std::uint64_t>(words[words.size() - 1 - index], 16);
    return word && ((*word >> (bit % 64)) & 1U) != 0;
}

/// The HID interfaces of the tablet that a node is of.
std::vector<std::string> hid_paths_of(const UdevNode& node) {
    std::vector<std::string> paths;
    if (!node.hid_path.empty()) paths.push_back(node.hid_path);
    if (node.usb_path.empty()) return paths;
    for (const UdevNode& other : udev_nodes("hidraw")) {
        const bool known = std::find(paths.begin(), paths.end(), other.hid_path) != paths.end();
        if (other.usb_path == node.usb_path && !known) paths.push_back(other.hid_path);
    }
    return paths;
}

bool interface_has_pen(const std::string& hid_path) {
    std::error_code failure;
    for (std::filesystem::directory_iterator it(hid_path + "/input", failure), end; !failure && it != end;
         it.increment(failure)) {
        const std::string capabilities = it->path().string() + "/capabilities/";
        const bool stylus = has_bit(capabilities + "key", BTN_TOOL_PEN) || has_bit(capabilities + "key", BTN_STYLUS);
        if (stylus && has_bit(capabilities + "abs", ABS_PRESSURE)) return true;
    }
    return false;
}

}  // namespace

bool kernel_knows_pen(const UdevNode& node) {
    const std::vector<std::string> paths = hid_paths_of(node);
    return std::any_of(paths.begin(), paths.end(), interface_has_pen);
}

TabletHub::TabletHub(const TabletHubOptions& options)
    : clock_(options.clock),
      events_({.clock = options.clock,
               .numbers = options.numbers,
               .wanted = [](const UdevNode& node) { return node.hid_path.empty() || kernel_knows_pen(node); },
               .hot_plug = options.hot_plug,
               .grab = options.grab}),
      reports_({.clock = options.clock,
                .numbers = options.numbers,
                .wanted = [](const UdevNode& node) { return !kernel_knows_pen(node); },
                .hot_plug = options.hot_plug,
                .grab_siblings = options.grab}) {}

void TabletHub::drain(std::vector<SourceEvent>& out) {
    const std::size_t start = out.size();
    events_.drain(out);
    reports_.drain(out);
    for (std::size_t i = start; i < out.size(); ++i) {
        const bool attached = out[i].kind == SourceEventKind::Attached;
        sleep_.see(out[i], attached ? device(out[i].device) : TraceDevice{});
    }
    sleep_.append_asleep(clock_(), out);
    std::stable_sort(out.begin() + static_cast<std::ptrdiff_t>(start), out.end(),
                     [](const SourceEvent& a, const SourceEvent& b) { return a.time_ns < b.time_ns; });
}

TraceDevice TabletHub::device(std::uint32_t number) const {
    TraceDevice d = events_.device(number);
    return d.number == number ? d : reports_.device(number);
}

std::uint64_t TabletHub::lost() const {
    return events_.lost() + reports_.lost();
}

std::vector<std::string> TabletHub::take_problems() {
    std::vector<std::string> problems = events_.take_problems();
    for (std::string& p : reports_.take_problems()) problems.push_back(std::move(p));
    return problems;
}

}  // namespace input
