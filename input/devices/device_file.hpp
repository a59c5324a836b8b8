#pragma once
// What we know of tablets that do not describe themselves well: one data file a tablet or family, in this folder.
// README.md says what a file holds.
//
//     const input::DeviceFile* file = input::find_device_file(identity, input::device_files());

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "input/device_identity.hpp"
#include "input/parse/pen_layout.hpp"

namespace input {

/// From where a layout takes the ranges that it does not name itself.
/// SizeOfString100: ranges from the descriptor, and the string says only how large the area is. Without a description
/// of the report the ranges are the string's too.
enum class AxesFrom : std::uint8_t { Descriptor, String100, String200, SizeOfString100 };

struct FileLayout {
    PenLayout layout;  ///< its axes hold what the file says, no more
    AxesFrom axes_from = AxesFrom::Descriptor;
};

/// A device that a file claims. Empty texts and -1 mean any.
struct DeviceClaim {
    std::uint16_t vendor = 0, product = 0;
    int interface = -1;
    std::string firmware;  ///< string 201 begins with this
    friend bool operator==(const DeviceClaim&, const DeviceClaim&) = default;
};

/// What has to be done before the tablet sends the reports of this file.
struct WakeStep {
    enum class Kind : std::uint8_t { ReadString, SetFeature, WriteOutput } kind = Kind::ReadString;
    std::uint8_t string = 0;          ///< of ReadString
    std::vector<std::uint8_t> bytes;  ///< of the others, with the report id
    int interface = -1;               ///< where it goes; -1: the pen's own
};

struct DeviceFile {
    std::string file;  ///< "huion.json"
    std::string name;
    std::string why;     ///< what is odd about the tablet, in a sentence
    std::string parser;  ///< "descriptor", "fields", "wacom-intuos"
    std::vector<DeviceClaim> claims;
    std::vector<std::string> names;  ///< names under which recordings know it
    std::vector<FileLayout> layouts;
    std::vector<WakeStep> wake;
    PenAxes axes;                                  ///< of wacom-intuos; ranges for recordings without any
    std::optional<std::array<double, 2>> size_mm;  ///< of the active area
    bool fine = true;                              ///< of wacom-intuos
    std::optional<int> silence_ms;                 ///< the pen is gone after this time without a report
    int barrel_buttons = -1;                       ///< -1: not known
    bool eraser = false;
};

/// BadFormat naming the member that is wrong.
[[nodiscard]] core::Result<DeviceFile> parse_device_file(std::string_view json, std::string file);

/// The files of this folder, built into the program. Parsed once; a file that is wrong is a fault of the program, which
/// the lint test finds.
[[nodiscard]] std::span<const DeviceFile> device_files();

/// Name and text of each built-in file, as they are; for the lint.
struct EmbeddedFile {
    std::string_view name, text;
};
[[nodiscard]] std::span<const EmbeddedFile> embedded_device_files();

/// The file that claims the device. A claim with firmware or interface goes before one without; null when none does.
[[nodiscard]] const DeviceFile* find_device_file(const DeviceIdentity& device, std::span<const DeviceFile> files);
/// The file that knows this name of a recording; null when none does.
[[nodiscard]] const DeviceFile* find_device_file_by_name(std::string_view name, std::span<const DeviceFile> files);

/// "16", "16:8", "s64:8", "-s72:8", "!14", "16:16+64:8": offset and size in bits from the start of the report with its
/// id; "s" signed, "-" runs the other way, "!" a flag that says the opposite, "+" where the upper bits lie.
[[nodiscard]] std::optional<PenField> parse_field_spec(std::string_view text);

}  // namespace input
