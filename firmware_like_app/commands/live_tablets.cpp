#include "firmware_like_app/commands/live_tablets.hpp"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <thread>

#include "input/sources/libinput_source.hpp"
#include "input/sources/tablet_hub.hpp"

namespace app {
namespace {

constexpr auto kPause = std::chrono::milliseconds(4);

std::atomic<bool>& interrupted() {
    static std::atomic<bool> flag{false};
    return flag;
}
extern "C" void on_tablet_interrupt(int) {
    interrupted() = true;
}

}  // namespace

core::Result<std::unique_ptr<input::PenSource>> open_tablets(const std::string& by, input::DeviceNumbers& numbers) {
    std::unique_ptr<input::PenSource> source;
    if (by == "auto") source = std::make_unique<input::TabletHub>(input::TabletHubOptions{.numbers = &numbers});
    if (by == "hidraw") source = std::make_unique<input::HidSource>(input::HidSourceOptions{.numbers = &numbers});
    if (by == "evdev") source = std::make_unique<input::EvdevSource>(input::EvdevSourceOptions{.numbers = &numbers});
    if (by == "libinput") {
        source = std::make_unique<input::LibinputSource>(input::LibinputSourceOptions{.numbers = &numbers});
    }
    if (source) return source;
    return core::unexpected(core::ErrorCode::BadArgument, "--by takes auto, hidraw, evdev or libinput");
}

void watch_tablets(input::PenSource& source, std::optional<double> seconds,
                   const std::function<bool(const std::vector<input::SourceEvent>&)>& each) {
    interrupted() = false;
    const auto before_int = std::signal(SIGINT, on_tablet_interrupt);
    const auto before_term = std::signal(SIGTERM, on_tablet_interrupt);
    const auto start = std::chrono::steady_clock::now();
    const auto over = [&] {
        const std::chrono::duration<double> since = std::chrono::steady_clock::now() - start;
        return interrupted() || (seconds && since.count() >= *seconds);
    };
    std::vector<input::SourceEvent> events;
    bool go_on = true;
    do {
        events.clear();
        source.drain(events);
        for (const std::string& problem : source.take_problems())
            std::fprintf(stderr, "croquis: %s\n", problem.c_str());
        go_on = each(events);
        std::this_thread::sleep_for(kPause);
    } while (go_on && !over());
    std::signal(SIGINT, before_int);
    std::signal(SIGTERM, before_term);
}

}  // namespace app
