#include "input/sources/usb_strings.hpp"

#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace input {

core::Result<std::vector<std::uint8_t>> read_usb_string(const std::string& usb_node, std::uint8_t index) {
    constexpr std::uint8_t kDeviceToHost = 0x80, kGetDescriptor = 6, kStringType = 3;
    constexpr std::uint16_t kEnglish = 0x0409;
    constexpr std::uint32_t kWait_ms = 300;
    const int fd = open(usb_node.c_str(), O_RDWR | O_CLOEXEC);
    if (fd < 0) {
        return core::unexpected(core::ErrorCode::FileUnreadable,
                                std::string("the tablet's strings cannot be asked (") + std::strerror(errno) + ")",
                                usb_node);
    }
    std::array<std::uint8_t, 255> answer{};
    usbdevfs_ctrltransfer request{};
    request.bRequestType = kDeviceToHost;
    request.bRequest = kGetDescriptor;
    request.wValue = static_cast<std::uint16_t>(kStringType << 8U | index);
    request.wIndex = kEnglish;
    request.wLength = static_cast<std::uint16_t>(answer.size());
    request.timeout = kWait_ms;
    request.data = answer.data();
    const int length = ioctl(fd, USBDEVFS_CONTROL, &request);
    close(fd);
    if (length < 2 || length > static_cast<int>(answer.size())) {
        return core::unexpected(core::ErrorCode::BadFormat, "the tablet has no string " + std::to_string(index),
                                usb_node);
    }
    return std::vector<std::uint8_t>(answer.begin(), answer.begin() + length);
}

}  // namespace input
