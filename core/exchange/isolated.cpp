#include "core/exchange/isolated.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <exception>
#include <fstream>
#include <new>

namespace core {
namespace {

constexpr int kDone = 0, kFailed = 10, kNoMemory = 11;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

void limit(decltype(RLIMIT_CPU) what, rlim_t most) {
    const rlimit bounds{most, most};
    setrlimit(what, &bounds);
}

/// Ends this process after so much processor time. The timer is fine, the limit cannot be switched off by a reader.
void limit_processor_time(double seconds) {
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(seconds);
    timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - std::floor(seconds)) * 1e6);
    setitimer(ITIMER_PROF, &timer, nullptr);
    limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(seconds)) + 1);
}

/// Writable memory that this process has; 0 where the system does not tell.
[[maybe_unused]] std::size_t writable_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::size_t pages = 0;
    for (int field = 0; field < 6; ++field) statm >> pages;  // the sixth is data and stack
    return statm ? pages * static_cast<std::size_t>(sysconf(_SC_PAGE_SIZE)) : 0;
}

bool write_all(int pipe_end, const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t written = write(pipe_end, bytes.data() + at, bytes.size() - at);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        at += static_cast<std::size_t>(written);
    }
    return true;
}

[[noreturn]] void run_in_child(const std::function<std::string()>& work, const IsolationLimits& limits, int pipe_end,
                               pid_t parent) {
    // A crash should end quietly, whatever handlers the program has set.
    for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGPROF}) std::signal(crash, SIG_DFL);
    // Ctrl-C reaches both processes, and this one has nothing to save. Nor should it live on when the other is killed.
    for (const int end : {SIGINT, SIGTERM, SIGHUP}) std::signal(end, SIG_DFL);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(kFailed);
    limit(RLIMIT_CORE, 0);
    limit_processor_time(limits.processor_seconds);
    // A sanitizer's shadow memory is terabytes of address space, which such a limit would forbid.
    if constexpr (!kSanitized) limit(RLIMIT_DATA, writable_bytes() + limits.memory_bytes);
    int status = kFailed;
    try {
        const std::string answer = work();
        if (answer.size() <= limits.most_answer_bytes && write_all(pipe_end, answer)) status = kDone;
    } catch (const std::bad_alloc&) {
        status = kNoMemory;
    } catch (...) {  // every other fault of a third-party reader is the same to us
        status = kFailed;
    }
    _exit(status);
}

std::string read_all(int pipe_end) {
    std::string bytes;
    std::array<char, 65536> block{};
    for (;;) {
        const ssize_t got = read(pipe_end, block.data(), block.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return bytes;
        bytes.append(block.data(), static_cast<std::size_t>(got));
    }
}

}  // namespace

Result<std::string> run_isolated(const std::function<std::string()>& work, const IsolationLimits& limits) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        return unexpected(ErrorCode::Internal, "the system has no pipe to spare; close other programs");
    }
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        run_in_child(work, limits, ends[1], parent);
    }
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        return unexpected(ErrorCode::Internal, "the system has no process to spare; close other programs");
    }
    std::string answer = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == kDone) return answer;
    if (WIFEXITED(status) && WEXITSTATUS(status) == kNoMemory) {
        return unexpected(ErrorCode::BadMesh, "the model needs more memory than it may have; simplify it first");
    }
    const bool ended_by_hand = WIFSIGNALED(status) && (WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM ||
                                                       WTERMSIG(status) == SIGHUP);
    if (ended_by_hand) return unexpected(ErrorCode::Cancelled, "reading the model was interrupted; try again");
    if (WIFSIGNALED(status) &&
        (WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
        return unexpected(ErrorCode::BadFormat, "the model cannot be read in reasonable time; export it again");
    }
    return unexpected(ErrorCode::BadFormat, "the model cannot be read, it is damaged; export it again");
}

}  // namespace core
