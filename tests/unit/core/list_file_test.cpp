#include "core/exchange/list_file.hpp"

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

using core::LabelledFile;

TEST_CASE("our own lists have paths relative to the list", "[list_file]") {
    const support::TemporaryFolder folder;
    folder.write("shapes/a.png", "x");
    folder.write("shapes/b.ndjson", "x");
    const std::string path =
        folder.write("lists/l.txt", "../shapes/a.png\tgreat cat\r\n\n../shapes/b.ndjson:4\tdog\n../shapes/no.png\tdog");
    const auto list = core::read_list_file(path);
    REQUIRE(list);
    CHECK(list->files == std::vector<LabelledFile>{{folder.path("shapes/a.png"), "great cat"},
                                                   {folder.path("shapes/b.ndjson:4"), "dog"}});
    CHECK(list->missing == std::vector<LabelledFile>{{folder.path("shapes/no.png"), "dog"}});
}

TEST_CASE("numbers of a .cla stand for files named so, with or without m", "[list_file]") {
    const support::TemporaryFolder folder;
    const std::string path =
        folder.write("c.cla", "PSB 1\n3 6\n\ncat  0 3\n1\n2\n77\n\nempty\t0 0\t\n\ndog 0 3\n3\n4\n77\n");
    folder.write("m1.off", "x");
    folder.write("2.obj", "x");
    folder.write("m2.off", "x");
    folder.write("dog/3.png", "x");
    folder.write("cat/3.png", "x");
    folder.write("4.txt", "x");
    const auto list = core::read_list_file(path);
    REQUIRE(list);
    CHECK(list->files == std::vector<LabelledFile>{{folder.path("m1.off"), "cat"},
                                                   {folder.path("2.obj"), "cat"},
                                                   {folder.path("dog/3.png"), "dog"}});
    CHECK(list->missing == std::vector<LabelledFile>{{"77", "cat"}, {"4", "dog"}, {"77", "dog"}});
}

TEST_CASE("the files of a .cla may lie elsewhere", "[list_file]") {
    const support::TemporaryFolder folder;
    const std::string path = folder.write("c.cla", "PSB 1\n1 1\ncat 0 1\n1\n");
    folder.write("models/m1.off", "x");
    CHECK(core::read_list_file(path, folder.path("models"))->files.size() == 1);
    CHECK(core::read_list_file(path, folder.path("nowhere")).error().code == core::ErrorCode::FileMissing);
}

TEST_CASE("a class name that comes again below another parent keeps the parent", "[list_file]") {
    const support::TemporaryFolder folder;
    for (const char* file : {"1.off", "2.off", "3.off"}) folder.write(file, "x");
    const auto list =
        core::read_list_file(folder.write("c.cla", "PSB 1\n3 3\nleg chair 1\n1\nleg table 1\n2\nleg chair 1\n3\n"));
    REQUIRE(list);
    CHECK(list->files[0].class_name == "leg");
    CHECK(list->files[1].class_name == "table/leg");
    CHECK(list->files[2].class_name == "leg");
}

TEST_CASE("broken lists are refused with the line", "[list_file]") {
    const support::TemporaryFolder folder;
    const auto refusal = [&](const std::string& text) {
        const auto list = core::read_list_file(folder.write("l", text));
        REQUIRE_FALSE(list);
        return list.error().sentence();
    };
    const std::string line = ": this line is not \"path<TAB>class\"; separate the two by one tab";
    CHECK(refusal("a\tb\nno tab here\n") == folder.path("l:2") + line);
    CHECK(refusal("\tclass") == folder.path("l:1") + line);
    CHECK(refusal("path\t") == folder.path("l:1") + line);
    CHECK(refusal("PSB 1\nx y") ==
          folder.path("l:2") + ": a number of classes and of files is expected here; get the .cla file again");
    CHECK(refusal("PSB 1\n1 2\ncat 0 2\n1\n") ==
          folder.path("l:5") + ": a file number is expected here; get the .cla file again");
    CHECK_THAT(refusal("PSB 1\n2 1\ncat 0 1\n1\n"), Catch::Contains("class with its parent and count"));
    CHECK_THAT(refusal("PSB 1\n1 1\ncat 0 1\n1\n2\n"), Catch::Contains("end of the file"));
    CHECK_THAT(refusal("PSB 1\n1 9\ncat 0 1\n1\n"), Catch::Contains("total that agrees"));
    CHECK_THAT(refusal("PSB 1\n1 9\ncat 0 99999999999\n1\n"), Catch::Contains("file number"));
    CHECK(core::read_list_file(folder.path("none")).error().code == core::ErrorCode::FileMissing);
}
