#include "firmware_like_app/collection/model_files.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/exchange/mesh_reader.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fs = std::filesystem;

TEST_CASE("folders are searched, files taken as named, each path once", "[model_files]") {
    const support::TemporaryFolder folder;
    const std::string b = folder.write("b.off", "x"), c = folder.write("sub/deep/c.STL", "x");
    const std::string odd = folder.write("odd.dat", "x");
    (void)folder.write("notes.txt", "x");
    fs::create_directory_symlink(folder.path("sub"), folder.path("again"));
    const app::ModelFiles all = app::find_model_files({folder.path(""), folder.path("./sub/../b.off"), odd});
    CHECK(all.files == std::vector<std::string>{b, odd, c});
    CHECK(all.unreadable.empty());
    CHECK(app::find_model_files({folder.path("sub"), folder.path("sub")}).unreadable.empty());
}

TEST_CASE("what cannot be searched is named and the rest goes on", "[model_files]") {
    const support::TemporaryFolder folder;
    const std::string good = folder.write("good.off", "x");
    fs::create_directories(folder.path("empty/inside"));
    const app::ModelFiles all = app::find_model_files({folder.path("gone"), good, folder.path("empty")});
    CHECK(all.files == std::vector<std::string>{good});
    REQUIRE(all.unreadable.size() == 2);
    CHECK(all.unreadable[0].file == folder.path("empty"));
    CHECK_THAT(all.unreadable[0].why, Catch::Contains("there is no 3D model in it"));
    CHECK_THAT(all.unreadable[1].why, Catch::Contains("there is no such file or folder"));
}

TEST_CASE("content is known by its bytes", "[model_files]") {
    const support::TemporaryFolder folder;
    const auto content = [&](const std::string& bytes) { return *app::content_of(folder.write("f.off", bytes)); };
    const app::FileContent once = content("OFF 1"), other = content("OFF 2"), again = content("OFF 1");
    CHECK(once.hash == again.hash);
    CHECK(once.size == 5);
    CHECK(once.hash != other.hash);
}

TEST_CASE("a file that is too large is refused before it is read", "[model_files]") {
    const support::TemporaryFolder folder;
    const std::string large = folder.write("large.stl", "x");
    fs::resize_file(large, 3ULL << 30);  // a hole, no disk space
    const auto refused = app::content_of(large);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, Catch::Contains("larger than the 512 MiB"));
    CHECK_FALSE(app::content_of(folder.path("gone.off")));
}
