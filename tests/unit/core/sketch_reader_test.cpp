#include "core/exchange/sketch_reader.hpp"

#include <catch2/catch.hpp>

#include "support/image_bytes.hpp"
#include "support/temporary_folder.hpp"

TEST_CASE("what a file holds decides how it is read, not its name", "[sketch_reader]") {
    const support::TemporaryFolder folder;
    const auto drawn = [&](const std::string& name, const std::string& text) {
        const auto sketch = core::read_sketch(folder.write(name, text));
        return sketch && sketch->drawing && !sketch->image && sketch->drawing->strokes[0].samples[0].x == 1.0;
    };
    CHECK(drawn("a.txt", "<?xml version=\"1.0\"?>\n<svg><path d=\"M1 2L3 4\"/></svg>"));
    CHECK(drawn("b.png", "\xEF\xBB\xBF<ink><trace>1 2, 3 4</trace></ink>"));
    CHECK(drawn("c", "{\"drawing\":[[[1,2],[3,4]]]}"));
    CHECK(drawn("d.svg", "\n{\n\"strokes\": [{\"points\": [[1,2]]}]}"));

    const auto picture = core::read_sketch(folder.write("e.svg", support::make_png(core::GrayImage(3, 2, 9))));
    REQUIRE(picture);
    REQUIRE(picture->image);
    CHECK_FALSE(picture->drawing);
    CHECK(picture->image->width == 3);
}

TEST_CASE("a line of a Quick-Draw file is chosen by its number", "[sketch_reader]") {
    const support::TemporaryFolder folder;
    const std::string path = folder.write("two.ndjson", "{\"drawing\":[[[1],[1]]]}\n{\"drawing\":[[[5],[5]]]}\n");
    CHECK(core::read_sketch(path + ":1")->drawing->strokes[0].samples[0].x == 5.0);
    CHECK(core::read_sketch(path + ":2").error().code == core::ErrorCode::BadArgument);
}

TEST_CASE("where the content leaves a doubt the extension decides whose error is given", "[sketch_reader]") {
    const support::TemporaryFolder folder;
    CHECK(core::read_sketch(folder.write("a.png", "hello")).error().message ==
          "this is no PNG, BMP or JPEG picture; give one of these");
    CHECK(core::read_sketch(folder.write("b.ndjson", "hello")).error().message ==
          "the line is no JSON object; give a line of a Quick, Draw! file");
    const auto unknown = core::read_sketch(folder.write("c.doc", "hello"));
    CHECK(unknown.error().code == core::ErrorCode::UnknownFormat);
    CHECK(unknown.error().where == folder.path("c.doc"));
    CHECK(core::read_sketch(folder.write("empty", "")).error().code == core::ErrorCode::UnknownFormat);
    CHECK(core::read_sketch(folder.path("nothing.svg")).error().code == core::ErrorCode::FileMissing);
    CHECK(core::read_sketch(folder.path("")).error().code == core::ErrorCode::FileUnreadable);
}
