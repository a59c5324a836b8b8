#include "core/exchange/file_bytes.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/exchange/list_file.hpp"
#include "core/exchange/sketch_reader.hpp"
#include "support/temporary_folder.hpp"

namespace {

core::Error fault_of(const std::string& path) {
    const auto bytes = core::read_file_bytes(path);
    REQUIRE_FALSE(bytes);
    CHECK(bytes.error().where == path);
    return bytes.error();
}

}  // namespace

TEST_CASE("a file is read whole, up to a limit", "[file_bytes]") {
    const support::TemporaryFolder folder;
    const std::string text("a\0b\r\n", 5), path = folder.write("a", text);
    CHECK(*core::read_file_bytes(path) == text);
    CHECK(*core::read_file_bytes(path, 5) == text);
    CHECK(core::read_file_bytes(path, 4).error().code == core::ErrorCode::FileUnreadable);
}

TEST_CASE("a pipe is not waited for, and a device not read", "[file_bytes]") {
    const support::TemporaryFolder folder;
    const std::string pipe = folder.path("pipe.png");
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    CHECK(fault_of(pipe).message == "this is a device or a pipe; name an ordinary file");
    CHECK(fault_of("/dev/zero").code == core::ErrorCode::FileUnreadable);
    for (const std::string& path : {pipe, pipe + ":0", std::string("/dev/zero"), std::string("/dev/zero:9")}) {
        INFO(path);
        CHECK(core::read_sketch(path).error().message == "this is a device or a pipe; name an ordinary file");
    }
    CHECK(core::read_list_file(pipe).error().code == core::ErrorCode::FileUnreadable);
}

TEST_CASE("what cannot be read says why", "[file_bytes]") {
    const support::TemporaryFolder folder;
    CHECK(fault_of(folder.path("none")).code == core::ErrorCode::FileMissing);
    CHECK(fault_of(folder.path("")).message == "this is a folder; name a file in it");
    std::filesystem::create_symlink("loop", folder.path("loop"));
    CHECK(fault_of(folder.path("loop")).code == core::ErrorCode::FileUnreadable);
    if (geteuid() == 0) return;  // root may read everything
    const std::string closed = folder.write("closed.png", "hello");
    std::filesystem::permissions(closed, std::filesystem::perms::none);
    CHECK(core::read_sketch(closed).error().message == "the file cannot be opened; check its permissions");
}
