#pragma once
// Work that has to wait when the pen's thread wants a core.

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace app {

/// Lowers the priority of the calling thread and of those that it starts from now on. On two cores that are both busy
/// searching, the thread that draws ink then still gets its core at once.
inline void yield_to_the_pen() {
    constexpr int kNicer = 5;  // than the rest of the program
    const auto self = static_cast<id_t>(syscall(SYS_gettid));
    (void)setpriority(PRIO_PROCESS, self, getpriority(PRIO_PROCESS, self) + kNicer);
}

}  // namespace app
