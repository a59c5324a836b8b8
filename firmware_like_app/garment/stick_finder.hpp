#pragma once
// Where an export may go: USB sticks that are mounted, as the kernel tells it.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace app {

struct ExportPlace {
    std::filesystem::path path;  ///< where it is mounted, or a folder that is configured
    std::string name;            ///< for people: the last part of the path
    bool read_only = false;
    /// The device it lies on, so that a stick that was pulled out is not mistaken for the empty folder it was mounted
    /// at; 0: any.
    dev_t device = 0;
};

/// Where to look; other folders in tests.
struct StickSources {
    std::filesystem::path mounts = "/proc/self/mountinfo";
    std::filesystem::path sys = "/sys";
};

/// File systems on removable disks or on the USB, in the order they were mounted; none that the system itself runs from
/// (mounted at /, /boot, /usr, /var, /home). udisks mounts sticks for its users below /media or /run/media; whoever
/// mounted them, they are found here. Some milliseconds.
[[nodiscard]] std::vector<ExportPlace> find_sticks(const StickSources& sources = {});

/// A folder as a place; the device is the one it lies on now.
[[nodiscard]] ExportPlace folder_place(const std::filesystem::path& folder);

}  // namespace app
