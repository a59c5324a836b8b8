#include "firmware_like_app/garment/stick_finder.hpp"

#include <sys/sysmacros.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "tests/support/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace {

/// A made-up /sys and mountinfo.
struct Machine {
    support::TemporaryFolder folder;
    app::StickSources sources{folder.path("mountinfo"), folder.path("sys")};

    void add_disk(const std::string& path, const std::string& numbers, bool removable) {
        const fs::path disk = sources.sys / "devices" / path;
        fs::create_directories(disk);
        fs::create_directories(sources.sys / "dev/block");
        if (!fs::exists(disk.parent_path() / "removable")) std::ofstream(disk / "removable") << removable << '\n';
        fs::create_directory_symlink(disk, sources.sys / "dev/block" / numbers);
    }
    void mount(const std::string& numbers, const std::string& point, const std::string& options = "rw,nosuid",
               const std::string& root = "/") {
        std::ofstream(sources.mounts, std::ios::app)
            << "36 25 " << numbers << ' ' << root << ' ' << point << ' ' << options << " shared:1 - vfat /dev/x rw\n";
    }
};

}  // namespace

TEST_CASE("sticks are what is mounted and can be pulled out", "[stick_finder]") {
    Machine machine;
    machine.add_disk("pci0/nvme0/nvme0n1", "259:0", false);
    machine.add_disk("pci0/nvme0/nvme0n1/p2", "259:2", false);
    machine.add_disk("pci0/usb1/1-2/block/sdb", "8:16", true);
    machine.add_disk("pci0/usb1/1-2/block/sdb/sdb1", "8:17", true);
    machine.add_disk("pci0/usb2/2-1/block/sdc/sdc1", "8:33", false);  // a hard disk on the USB
    machine.add_disk("pci0/mmc/mmcblk0", "179:0", true);
    machine.add_disk("pci0/mmc/mmcblk0/p1", "179:1", true);
    machine.mount("0:22", "/proc");
    machine.mount("259:2", "/");
    machine.mount("259:0", "/srv/data");
    machine.mount("8:17", "/media/kiosk/MY\\040STICK");
    machine.mount("8:33", "/run/media/kiosk/Disk", "ro,nosuid");
    machine.mount("179:1", "/mnt");
    machine.mount("179:1", "/boot/firmware");
    machine.mount("8:17", "/somewhere", "rw", "/below");  // a part of it shown elsewhere
    std::ofstream(machine.sources.mounts, std::ios::app) << "half a line\n\n";

    const std::vector<app::ExportPlace> found = app::find_sticks(machine.sources);
    REQUIRE(found.size() == 3);
    CHECK(found[0].path == "/media/kiosk/MY STICK");
    CHECK(found[0].name == "MY STICK");
    CHECK_FALSE(found[0].read_only);
    CHECK(found[0].device == makedev(8, 17));
    CHECK(found[1].name == "Disk");
    CHECK(found[1].read_only);
    CHECK(found[2].path == "/mnt");
}

TEST_CASE("where nothing can be read there are no sticks", "[stick_finder]") {
    const support::TemporaryFolder folder;
    CHECK(app::find_sticks({folder.path("none"), folder.path("none")}).empty());
    CHECK(app::folder_place(folder.path("none")).device == 0);
    CHECK(app::folder_place(folder.path("")).device != 0);
}
