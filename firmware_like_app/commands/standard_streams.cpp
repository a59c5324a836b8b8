#include "firmware_like_app/commands/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

namespace app {

void open_closed_streams() {
    // In this order each takes the lowest free number, its own. Output opened for reading makes every write fail.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) != -1) continue;
        [[maybe_unused]] const int opened = open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
    }
}

std::optional<std::string> unwritten_output() {
    errno = 0;
    std::cout.flush();
    const bool flushed = std::fflush(stdout) == 0;
    if (flushed && std::ferror(stdout) == 0 && std::cout.good()) return std::nullopt;
    const std::string why = errno != 0 ? std::string(" (") + std::strerror(errno) + ")" : std::string();
    return "the results could not be written" + why + "; send them to a place that has room";
}

}  // namespace app
