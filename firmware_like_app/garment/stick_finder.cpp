#include "firmware_like_app/garment/stick_finder.hpp"

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

namespace app {
namespace {

namespace fs = std::filesystem;

/// A line of mountinfo (proc(5)): id, parent, major:minor, root, mount point, options, optional fields, "-", type, …
struct Mount {
    unsigned major_number = 0, minor_number = 0;
    std::string point;
    bool read_only = false;
};

/// The kernel writes space, tab, newline and backslash as "\040" and so on.
std::string unescaped(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto octal = [&](std::size_t k) { return text[i + k] >= '0' && text[i + k] <= '7'; };
        if (text[i] == '\\' && i + 3 < text.size() && octal(1) && octal(2) && octal(3)) {
            out += static_cast<char>((text[i + 1] - '0') * 64 + (text[i + 2] - '0') * 8 + (text[i + 3] - '0'));
            i += 3;
        } else {
            out += text[i];
        }
    }
    return out;
}

std::optional<Mount> mount_of(const std::string& line) {
    std::istringstream in(line);
    std::string id, parent, device, root, point, options;
    if (!(in >> id >> parent >> device >> root >> point >> options) || root != "/") return std::nullopt;
    Mount mount;
    char colon = 0;
    std::istringstream numbers(device);
    if (!(numbers >> mount.major_number >> colon >> mount.minor_number) || colon != ':') return std::nullopt;
    mount.point = unescaped(point);
    mount.read_only = ("," + options + ",").find(",ro,") != std::string::npos;
    return mount;
}

bool is_of_the_system(const std::string& point) {
    if (point == "/") return true;
    constexpr std::array<std::string_view, 4> kFolders{"/boot", "/usr", "/var", "/home"};
    return std::any_of(kFolders.begin(), kFolders.end(), [&](std::string_view folder) {
        return point == folder || point.starts_with(std::string(folder) + "/");
    });
}

bool says_removable(const fs::path& disk) {
    std::ifstream in(disk / "removable");
    int flag = 0;
    return in >> flag && flag == 1;
}

/// The disk of a partition has the file "removable" in the folder above; a disk on the USB has it in its path.
bool can_be_pulled(const Mount& mount, const fs::path& sys) {
    std::error_code failed;
    const fs::path device = fs::canonical(
        sys / "dev/block" / (std::to_string(mount.major_number) + ":" + std::to_string(mount.minor_number)), failed);
    if (failed) return false;
    return device.string().find("/usb") != std::string::npos || says_removable(device) ||
           says_removable(device.parent_path());
}

}  // namespace

std::vector<ExportPlace> find_sticks(const StickSources& sources) {
    std::vector<ExportPlace> places;
    std::ifstream mounts(sources.mounts);
    for (std::string line; std::getline(mounts, line);) {
        const std::optional<Mount> mount = mount_of(line);
        if (!mount || is_of_the_system(mount->point) || !can_be_pulled(*mount, sources.sys)) continue;
        const fs::path path(mount->point);
        places.push_back(
            {path, path.filename().string(), mount->read_only, makedev(mount->major_number, mount->minor_number)});
    }
    return places;
}

ExportPlace folder_place(const fs::path& folder) {
    struct stat info {};
    const bool there = stat(folder.c_str(), &info) == 0;
    return {folder, folder.filename().string(), false, there ? info.st_dev : 0};
}

}  // namespace app
