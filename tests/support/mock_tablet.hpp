#pragma once
// Tablets that are not there: nodes under umockdev that hidapi, the evdev source and libinput open like real ones.
// Programs with these run under umockdev-wrapper.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace support {

struct MockEvent {
    std::uint16_t type = 0, code = 0;
    std::int32_t value = 0;
};

class MockTablets {
  public:
    MockTablets();
    ~MockTablets();
    MockTablets(const MockTablets&) = delete;
    MockTablets& operator=(const MockTablets&) = delete;

    /// A HID tablet with this descriptor at /dev/hidrawN. `announce` sends the uevent that a plug sends.
    /// `kernel_pen`: a driver makes a pen with pressure of it, too.
    void plug_hid(int number, const std::vector<std::uint8_t>& descriptor, bool announce, bool kernel_pen = false);
    /// A pen's event node at /dev/input/eventN: 44800 by 29600 steps of 200 a mm, pressure to 8191, tilt -64 … 63 of 57
    /// a radian, rotation, distance, pen and eraser, three buttons, serial numbers. `down_at` >= 0: the pen touches
    /// already, at this x.
    void plug_evdev(int number, bool announce, int down_at = -1);
    void unplug_hid(int number);
    void unplug_evdev(int number);

    void report(int number, std::span<const std::uint8_t> bytes);
    /// A frame: the events and a SYN_REPORT, with this time.
    void frame(int number, const std::vector<MockEvent>& events, std::int64_t time_us);

    [[nodiscard]] static std::string evdev_node(int number) { return "/dev/input/event" + std::to_string(number); }
    [[nodiscard]] static bool running_mocked();  ///< under umockdev-wrapper

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace support
