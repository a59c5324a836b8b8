#include "firmware_like_app/garment/safe_folder.hpp"

#include <sys/mount.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <set>

#include "tests/support/temporary_folder.hpp"

namespace fs = std::filesystem;
using app::NamedBytes;
using Kind = app::ExportFault::Kind;

namespace {

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
    return names;
}

const std::vector<NamedBytes> kFiles{{"garment.obj", "v 0 0 0\n"}, {"turn-01.png", std::string(300000, 'p')}};

/// 64 kB that are mounted for the length of a test; only root may.
class SmallDisk {
  public:
    explicit SmallDisk(const fs::path& at) : at_(at) {
        fs::create_directories(at);
        mounted_ = mount("croquis-test", at.c_str(), "tmpfs", 0, "size=64k") == 0;
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    ~SmallDisk() { pull(); }
    void pull() {
        if (mounted_) umount2(at_.c_str(), MNT_DETACH);
        mounted_ = false;
    }
    [[nodiscard]] bool is_there() const { return mounted_; }

  private:
    fs::path at_;
    bool mounted_ = false;
};

}  // namespace

TEST_CASE("an export never lies over another one", "[safe_folder]") {
    const support::TemporaryFolder folder;
    const app::ExportPlace place = app::folder_place(folder.path(""));
    std::vector<double> shares;
    for (const char* expected : {"Dress", "Dress-2", "Dress-3"}) {
        const app::FolderReport report =
            app::write_new_folder(place, "Dress", kFiles, [&](double share) { shares.push_back(share); });
        REQUIRE_FALSE(report.fault);
        CHECK(report.folder == fs::path(folder.path("")) / expected);
        CHECK(names_in(report.folder) == std::set<std::string>{"garment.obj", "turn-01.png"});
        CHECK(read(report.folder / "turn-01.png") == kFiles[1].bytes);
    }
    CHECK(shares.size() >= 6);
    CHECK(shares.back() == 1.0);
    CHECK(names_in(place.path) == std::set<std::string>{"Dress", "Dress-2", "Dress-3"});
    std::ofstream(fs::path(folder.path("")) / "Skirt") << "a file of somebody's";
    CHECK(app::write_new_folder(place, "Skirt", kFiles).folder.filename() == "Skirt-2");
    CHECK(read(fs::path(folder.path("")) / "Skirt") == "a file of somebody's");
}

TEST_CASE("names that a stick cannot take are changed", "[safe_folder]") {
    CHECK(app::safe_name("Robe d’été") == "Robe d’été");
    CHECK(app::safe_name("a/b\\c:d*?\"<>|e\n") == "a_b_c_d______e_");
    CHECK(app::safe_name("..") == "design");
    CHECK(app::safe_name("../../etc") == "_.._etc");
    CHECK(app::safe_name("") == "design");
    CHECK(app::safe_name(" Dress. ") == "Dress");
    std::string umlauts;
    for (int i = 0; i < 50; ++i) umlauts += "ä";
    CHECK(app::safe_name(umlauts).size() == 60);
    CHECK(app::safe_name("a" + umlauts).size() == 59);
}

TEST_CASE("an export that is stopped leaves nothing", "[safe_folder]") {
    const support::TemporaryFolder folder;
    std::stop_source stop;
    const app::FolderReport report = app::write_new_folder(
        app::folder_place(folder.path("")), "Dress", kFiles, [&](double) { stop.request_stop(); }, stop.get_token());
    REQUIRE(report.fault);
    CHECK(report.fault->kind == Kind::Cancelled);
    CHECK(names_in(folder.path("")).empty());
}

TEST_CASE("what a pulled stick kept goes with the next export", "[safe_folder]") {
    const support::TemporaryFolder folder;
    const std::string alive = ".croquis-unfinished-" + std::to_string(getppid());  // of a program that still writes it
    fs::create_directories(folder.path(".croquis-unfinished-999999999/below"));
    fs::create_directories(folder.path(".croquis-unfinished-" + std::to_string(getpid())));
    fs::create_directories(folder.path(".croquis-unfinished-x"));
    fs::create_directories(folder.path(alive));
    CHECK_FALSE(app::write_new_folder(app::folder_place(folder.path("")), "Dress", kFiles).fault);
    CHECK(names_in(folder.path("")) == std::set<std::string>{"Dress", alive});
}

TEST_CASE("a place that is not there, another disk than it was, one that may only be read", "[safe_folder]") {
    const support::TemporaryFolder folder;
    CHECK(app::write_new_folder(app::folder_place(folder.path("none")), "A", kFiles).fault->kind == Kind::NoPlace);
    CHECK(app::write_new_folder({folder.path("none"), "", false, 5}, "A", kFiles).fault->kind == Kind::Gone);
    app::ExportPlace place = app::folder_place(folder.path(""));
    place.device += 1;  // the stick was pulled out: its folder is one of the system's disk
    CHECK(app::write_new_folder(place, "A", kFiles).fault->kind == Kind::Gone);
    place = app::folder_place(folder.path(""));
    place.read_only = true;
    const app::FolderReport report = app::write_new_folder(place, "A", kFiles);
    CHECK(report.fault->kind == Kind::ReadOnly);
    CHECK(report.fault->error.sentence().find(folder.path("")) != std::string::npos);
    CHECK(names_in(folder.path("")).empty());
}

TEST_CASE("a full stick says so and keeps nothing", "[safe_folder]") {
    const support::TemporaryFolder folder;
    const fs::path at = folder.path("stick");
    SmallDisk disk(at);
    if (!disk.is_there()) {
        WARN("skipped: only root may mount a small disk");
        return;
    }
    const app::ExportPlace place = app::folder_place(at);
    const std::vector<NamedBytes> little{{"a.obj", std::string(8000, 'a')}};
    REQUIRE_FALSE(app::write_new_folder(place, "Dress", little).fault);
    SECTION("seen before anything is written") {
        const app::FolderReport report = app::write_new_folder(place, "Dress", kFiles);
        REQUIRE(report.fault);
        CHECK(report.fault->kind == Kind::Full);
        CHECK(report.fault->error.message.find("free") != std::string::npos);
    }
    SECTION("seen while it is written, because somebody else fills it") {
        const std::vector<NamedBytes> two{{"a.obj", std::string(9000, 'a')}, {"b.obj", std::string(30000, 'b')}};
        const app::FolderReport report = app::write_new_folder(place, "Dress", two, [&](double share) {
            if (share < 0.5) std::ofstream(at / "other") << std::string(60000, 'x');
        });
        REQUIRE(report.fault);
        CHECK(report.fault->kind == Kind::Full);
        fs::remove(at / "other");
    }
    SECTION("pulled out in the middle") {
        const app::FolderReport report = app::write_new_folder(place, "Dress", little, [&](double) { disk.pull(); });
        REQUIRE(report.fault);
        CHECK(report.fault->kind == Kind::Gone);
        CHECK(names_in(at).empty());  // nothing on the system's own disk
        return;
    }
    CHECK(names_in(at) == std::set<std::string>{"Dress"});
}
