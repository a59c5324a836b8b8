#pragma once
// What a station needs, looked at: what is fine, what is not, and what to do.

#include <cstdint>
#include <string>
#include <vector>

#include "firmware_like_app/config/config.hpp"

namespace app {

struct Check {
    std::string name;  ///< "fonts", "database" …
    bool good = true;
    std::string found;   ///< in a few words
    std::string advice;  ///< what to do; empty when it is good
};

/// Fonts, languages, database, disk, folders that are written to. Opens nothing that the running kiosk holds, so it may
/// run beside it. A second or two for a large database.
[[nodiscard]] std::vector<Check> check_station(const Config& config, const std::string& config_file);
/// Screen, OpenGL ES, tablets: only where no kiosk runs in this program. Half a second.
[[nodiscard]] std::vector<Check> check_machine();

/// What this user may do with the files and folders that the settings name, and with the graphics device where there
/// is one: one check, which names the first that is in the way. Tablets are in check_machine. Writes nothing.
[[nodiscard]] Check check_permissions(const Config& config, const std::string& config_file);

/// Resident memory of this program, in MB; 0 where the system does not tell.
[[nodiscard]] double resident_mb();
/// Free space of the disk that holds the path, in GB.
[[nodiscard]] double free_disk_gb(const std::string& path);
/// File handles that are open; 0 where the system does not tell.
[[nodiscard]] int open_handles();

}  // namespace app
