// libwacom: names, sizes and buttons of tablets. It is only here.

extern "C" {  // the header of 2.6 leaves this out
#include <libwacom/libwacom.h>
}

#include <memory>
#include <mutex>

#include "input/sources/evdev_source.hpp"

namespace input {
namespace {

struct WacomFree {
    void operator()(WacomDeviceDatabase* db) const { libwacom_database_destroy(db); }
    void operator()(WacomDevice* d) const { libwacom_destroy(d); }
};

}  // namespace

std::optional<TabletFacts> tablet_facts(const DeviceIdentity& device) {
    constexpr double kInch_mm = 25.4;
    static std::mutex mutex;  // the database is read once, and is not made for several threads
    static const std::unique_ptr<WacomDeviceDatabase, WacomFree> database(libwacom_database_new());
    const std::lock_guard lock(mutex);
    if (!database) return std::nullopt;
    const std::unique_ptr<WacomDevice, WacomFree> found(
        libwacom_new_from_usbid(database.get(), device.vendor, device.product, nullptr));
    if (!found) return std::nullopt;
    TabletFacts facts;
    if (const char* name = libwacom_get_name(found.get())) facts.name = name;
    facts.width_mm = libwacom_get_width(found.get()) * kInch_mm;
    facts.height_mm = libwacom_get_height(found.get()) * kInch_mm;
    facts.buttons = libwacom_get_num_buttons(found.get());
    facts.on_screen = libwacom_get_integration_flags(found.get()) != WACOM_DEVICE_INTEGRATED_NONE;
    return facts;
}

}  // namespace input
