#include "firmware_like_app/kiosk/input_fault.hpp"

#include <unistd.h>

#include <filesystem>

namespace app {

std::string input_fault(const std::string& folder) {
    std::error_code error;
    bool any = false;
    for (auto it = std::filesystem::directory_iterator(folder, error);
         !error && it != std::filesystem::directory_iterator(); it.increment(error)) {
        if (it->path().filename().string().rfind("event", 0) != 0) continue;
        any = true;
        if (access(it->path().c_str(), R_OK) == 0) return {};
    }
    return any ? "I2" : "I1";
}

}  // namespace app
