#pragma once
// Some of the recorded drawings of a folder, for tools that measure on them.

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace support {

/// `count` lines of the .ndjson files of a folder as FILE:LINE, chosen by the seed; all where there are fewer.
inline std::vector<std::string> chosen_drawings(const std::filesystem::path& folder, std::size_t count, unsigned seed) {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".ndjson") continue;
        std::ifstream in(entry.path());
        std::string line;
        for (int n = 0; std::getline(in, line); ++n) all.push_back(entry.path().string() + ":" + std::to_string(n));
    }
    std::sort(all.begin(), all.end());
    std::shuffle(all.begin(), all.end(), std::mt19937(seed));
    all.resize(std::min(all.size(), count));
    return all;
}

}  // namespace support
