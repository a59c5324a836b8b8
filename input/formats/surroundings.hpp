#pragma once
// A recording seldom says all that is needed to read it. What lies beside it often does: lsusb's words, report
// descriptors, string descriptors, an evemu description.
//
//     const input::Surroundings around = input::find_surroundings("dumps/pen_coords.txt");

#include <optional>
#include <string>
#include <vector>

#include "input/devices/make_decoder.hpp"
#include "input/formats/capture.hpp"

namespace input {

struct Surroundings {
    DeviceIdentity device;                        ///< vendor, product and name, where a file tells
    std::vector<CapturedDescriptor> descriptors;  ///< of the interfaces
    UsbStrings strings;
    std::optional<EvdevDescription> evdev;  ///< of an evemu description beside an evemu recording
    std::vector<std::string> names;         ///< under which a data file may know the recording: its stem, its folders
};

/// Looks in the folder of the file and in the two above it. Read are, where they are there: `*descriptor*.txt` and
/// `lsusb*.txt` (lsusb -v), `hid_report_descriptors*.txt` and `rd/original*.txt` (usbhid-dump, or plain bytes; the
/// digit in the name is the interface), `probe*.txt` (lines "S C8 13 03 …": string 0xC8), `index.md` (lines "VID:",
/// "PID:"), and for NAME.anything.events the files NAME.desc, "NAME Pen.desc". Files above 1 MB are passed over. Never
/// fails: what cannot be read is not there.
[[nodiscard]] Surroundings find_surroundings(const std::string& path);

}  // namespace input
