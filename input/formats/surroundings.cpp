#include "input/formats/surroundings.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "core/exchange/file_bytes.hpp"
#include "input/devices/uclogic_strings.hpp"
#include "input/formats/text_lines.hpp"

namespace input {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = std::size_t{1} << 20U;
constexpr int kFoldersUp = 3;
constexpr std::uint16_t kLinuxHubs = 0x1d6b;

std::string text_of(const fs::path& path) {
    core::Result<std::string> text = core::read_file_bytes(path.string(), kMaxBytes);
    return text ? std::move(*text) : std::string();
}

std::vector<fs::path> files_of(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failure;
    for (fs::directory_iterator it(folder, failure), end; !failure && it != end && files.size() < 2000;
         it.increment(failure)) {
        if (it->is_regular_file(failure)) files.push_back(it->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The four hexadecimal digits after `key`; 0 without.
std::uint16_t hex_after(std::string_view line, std::string_view key) {
    const std::size_t at = line.find(key);
    if (at == std::string_view::npos) return 0;
    std::string_view rest = line.substr(at + key.size());
    rest = rest.substr(std::min(rest.find_first_not_of(" \t\":"), rest.size()));
    return number_of_text<std::uint16_t>(rest.substr(0, 4), 16).value_or(0);
}

/// lsusb lists whole machines, too: of several devices the first that a data file claims counts, else the only one.
void read_lsusb(std::string_view text, Surroundings& out) {
    std::vector<DeviceIdentity> listed;
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        const std::size_t id = line.find(": ID ");
        if (id != std::string_view::npos && line.size() >= id + 14) {
            DeviceIdentity device;
            device.vendor = hex_after(line.substr(id), ": ID ");
            device.product = number_of_text<std::uint16_t>(line.substr(id + 10, 4), 16).value_or(0);
            if (device.vendor != kLinuxHubs) listed.push_back(device);
        }
        std::string_view words = line;
        if (listed.size() != 1 || take_word(words) != "iProduct") continue;
        const std::string_view number = take_word(words);
        const std::string_view name = trimmed(words);
        if (!number.empty() && name != "(error)") listed.front().name = name.substr(0, 200);
    }
    const auto claimed = std::find_if(listed.begin(), listed.end(), [](const DeviceIdentity& d) {
        return find_device_file(d, device_files()) != nullptr;
    });
    if (out.device.known()) return;
    if (claimed != listed.end()) {
        out.device = *claimed;
    } else if (listed.size() == 1) {
        out.device = listed.front();
    }
}

void read_index(std::string_view text, Surroundings& out) {
    if (out.device.known()) return;
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        if (line.starts_with("VID:")) out.device.vendor = hex_after(line, "VID:");
        if (line.starts_with("PID:")) out.device.product = hex_after(line, "PID:");
    }
}

void read_strings(std::string_view text, Surroundings& out) {
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        std::string_view rest = line;
        if (take_word(rest) != "S") continue;
        const auto index = number_of_text<std::uint8_t>(take_word(rest), 16);
        std::vector<std::uint8_t> bytes;
        if (!index || !append_hex_bytes(rest, bytes, 255) || bytes.empty()) continue;
        out.strings.try_emplace(*index, std::move(bytes));
    }
}

void add_descriptor(int interface, std::vector<std::uint8_t> bytes, Surroundings& out) {
    const bool there = std::any_of(out.descriptors.begin(), out.descriptors.end(),
                                   [&](const CapturedDescriptor& d) { return d.interface == interface; });
    if (!there && !bytes.empty()) out.descriptors.push_back({interface, std::move(bytes)});
}

void read_descriptors(const fs::path& path, Surroundings& out) {
    const std::string text = text_of(path);
    if (text.find(":DESCRIPTOR") != std::string::npos) {
        const core::Result<Capture> dump = parse_usbhid_dump(text);
        if (!dump) return;
        for (const CapturedDescriptor& d : dump->descriptors) add_descriptor(d.interface, d.bytes, out);
        return;
    }
    std::vector<std::uint8_t> bytes;
    TextLines lines(text);
    for (std::string_view line; lines.next(line);) {
        if (!append_hex_bytes(line, bytes, kMaxDescriptorBytes)) return;
    }
    const std::string stem = path.stem().string();
    const bool digit = !stem.empty() && stem.back() >= '0' && stem.back() <= '9';
    add_descriptor(digit ? stem.back() - '0' : 0, std::move(bytes), out);
}

void read_folder(const fs::path& folder, Surroundings& out) {
    for (const fs::path& file : files_of(folder)) {
        const std::string name = file.filename().string();
        if (name == "index.md") read_index(text_of(file), out);
        if (!name.ends_with(".txt")) continue;
        if (name.starts_with("hid_report_descriptors")) {
            read_descriptors(file, out);
        } else if (name.starts_with("descriptor") || name.starts_with("lsusb")) {
            read_lsusb(text_of(file), out);
        } else if (name.find("probe") != std::string::npos) {
            read_strings(text_of(file), out);
        }
    }
    for (const fs::path& file : files_of(folder / "rd")) {
        const std::string name = file.filename().string();
        if (name.ends_with(".txt") && (name.starts_with("original") || name.starts_with("hid_report"))) {
            read_descriptors(file, out);
        }
    }
}

void read_evemu_description(const fs::path& path, Surroundings& out) {
    const std::string name = path.filename().string();
    const std::string stem = name.substr(0, name.find('.'));
    out.names.push_back(stem);
    if (stem.ends_with(" Pen")) out.names.push_back(stem.substr(0, stem.size() - 4));
    for (const char* ending : {".desc", " Pen.desc"}) {
        const std::string text = text_of(path.parent_path() / (stem + ending));
        if (text.empty()) continue;
        const core::Result<Capture> description = parse_evemu(text);
        if (!description || !description->has_evdev_description) continue;
        out.evdev = description->evdev;
        out.device = description->device;
        return;
    }
}

}  // namespace

Surroundings find_surroundings(const std::string& path) {
    Surroundings out;
    std::error_code failure;
    const fs::path file = fs::absolute(path, failure);
    if (failure) return out;
    read_evemu_description(file, out);
    fs::path folder = file.parent_path();
    for (int up = 0; up < kFoldersUp && !folder.empty(); ++up, folder = folder.parent_path()) {
        out.names.push_back(folder.filename().string());
        read_folder(folder, out);
        if (!out.descriptors.empty() || (out.device.known() && up > 0)) break;
    }
    const auto firmware = out.strings.find(201);
    if (firmware != out.strings.end()) out.device.firmware = text_of_string(firmware->second);
    return out;
}

}  // namespace input
