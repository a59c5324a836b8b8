#include "ui/screens/garment_screen.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "ui/screens/garment_parts.hpp"

namespace {

struct Screen {
    ui::FontSet fonts = *ui::FontSet::load();
    std::vector<ui::Strings> languages = *ui::Strings::load_all();
    ui::GarmentScreen garment{fonts, languages};
};

ui::GarmentState dressed() {
    ui::GarmentState state;
    state.empty = false;
    state.can_undo = state.folds_on = true;
    for (const char* name : {"Jacket", "Dress", "Body"}) {
        ui::LayerRow row;
        row.name = name;
        row.body = row.name == "Body";
        state.rows.push_back(row);
    }
    state.rows[0].selected = state.rows[0].can_down = true;
    return state;
}

std::vector<std::string> texts(const ui::DrawList& list) {
    std::vector<std::string> out;
    for (const ui::DrawCommand& command : list.commands) {
        if (const auto* text = std::get_if<ui::TextCommand>(&command)) out.push_back(text->text);
    }
    return out;
}

bool has(const std::vector<std::string>& all, const std::string& text) {
    return std::find(all.begin(), all.end(), text) != all.end();
}

/// A sentence that may go over several lines.
bool begins(const std::vector<std::string>& all, const std::string& sentence) {
    return std::any_of(all.begin(), all.end(),
                       [&](const std::string& line) { return line.size() > 8 && sentence.rfind(line, 0) == 0; });
}

bool offers(const std::vector<ui::BoardTouch::Target>& targets, ui::GarmentAction action, std::size_t index = 0) {
    return std::any_of(targets.begin(), targets.end(), [&](const ui::BoardTouch::Target& t) {
        return t.control == ui::Control::Garment && t.item == ui::garment_item(action, index);
    });
}

}  // namespace

TEST_CASE("Garment has words for everything in every language", "[garment screen]") {
    const Screen s;
    const std::vector<std::string> keys = s.languages[0].keys();
    for (const ui::Strings& language : s.languages) CHECK(language.keys() == keys);
    ui::GarmentState state = dressed();
    for (std::size_t l = 0; l < s.languages.size(); ++l) {
        for (const ui::SizePx size : {ui::SizePx{1920, 1080}, ui::SizePx{1080, 1920}}) {
            state.language = l;
            const ui::GarmentLayout layout = ui::garment_layout(size, ui::Hand::Right);
            for (std::size_t page = 0; page < ui::kGarmentPages; ++page) {
                state.page = page;
                for (const std::string& word : texts(s.garment.draw(state, layout))) {
                    CHECK(std::find(keys.begin(), keys.end(), word) == keys.end());  // a key stands for a missing word
                }
            }
        }
    }
}

TEST_CASE("every tool is on a page, and each page has Undo", "[garment screen]") {
    const Screen s;
    const ui::GarmentLayout layout = ui::garment_layout({1280, 800}, ui::Hand::Right);
    std::set<std::size_t> found;
    ui::GarmentState state = dressed();
    for (std::size_t page = 0; page < ui::kGarmentPages; ++page) {
        state.page = page;
        const auto targets = s.garment.targets(state, layout);
        for (std::size_t tool = 0; tool <= static_cast<std::size_t>(ui::GarmentTool::Measure); ++tool) {
            if (offers(targets, ui::GarmentAction::Tool, tool)) found.insert(tool);
        }
        CHECK(
            std::any_of(targets.begin(), targets.end(), [](const auto& t) { return t.control == ui::Control::Undo; }));
        CHECK_FALSE(
            std::any_of(targets.begin(), targets.end(), [](const auto& t) { return t.control == ui::Control::Redo; }));
    }
    CHECK(found.size() == static_cast<std::size_t>(ui::GarmentTool::Measure) + 1);
}

TEST_CASE("what Garment cannot do takes no touch", "[garment screen]") {
    const Screen s;
    const ui::GarmentLayout layout = ui::garment_layout({1920, 1080}, ui::Hand::Left);
    ui::GarmentState state = dressed();
    auto targets = s.garment.targets(state, layout);
    CHECK(offers(targets, ui::GarmentAction::Folds));
    CHECK(offers(targets, ui::GarmentAction::RowDown, 0));
    CHECK_FALSE(offers(targets, ui::GarmentAction::RowUp, 0));
    CHECK_FALSE(offers(targets, ui::GarmentAction::Swatch, 2));  // the body is of no fabric
    state.folds_on = false;
    state.page = 2;
    targets = s.garment.targets(state, layout);
    CHECK_FALSE(offers(targets, ui::GarmentAction::Folds));
    CHECK_FALSE(offers(targets, ui::GarmentAction::Designs));
    state.designs_kept = true;
    CHECK(offers(s.garment.targets(state, layout), ui::GarmentAction::Designs));
    state.drawer = ui::GarmentDrawer::Export;
    state.empty = true;
    CHECK_FALSE(offers(s.garment.targets(state, layout), ui::GarmentAction::ExportAs, 0));
}

TEST_CASE("the sheet says where lines lie", "[garment screen]") {
    const Screen s;
    const ui::GarmentLayout layout = ui::garment_layout({1920, 1080}, ui::Hand::Right);
    ui::GarmentState state = dressed();
    state.tool = ui::GarmentTool::OnBody;
    CHECK(has(texts(s.garment.draw(state, layout)), "Lines lie on the body, 1.2 cm off"));
    state.tool = ui::GarmentTool::OnPlane;
    CHECK(has(texts(s.garment.draw(state, layout)), "Lines lie on the Front plane"));
    state.view = ui::GarmentView::Solid;
    CHECK(has(texts(s.garment.draw(state, layout)), "Drag beside the figure to turn"));
    state.problem = "Off.";
    CHECK(has(texts(s.garment.draw(state, layout)), "Off."));
}

TEST_CASE("a slider's ends are within reach, its list scrolls by what does not fit", "[garment screen]") {
    const ui::Rect slider{100, 0, 400, 64};
    CHECK(ui::slider_share(slider, 90, 1) == 0);
    CHECK(ui::slider_share(slider, 300, 1) == Approx(0.5));
    CHECK(ui::slider_share(slider, 600, 1) == 1);
    const ui::GarmentLayout layout = ui::garment_layout({1920, 1080}, ui::Hand::Right);
    ui::GarmentState state = dressed();
    CHECK(ui::GarmentScreen::most_scroll_px(state, layout) == 0);
    state.rows.resize(5, state.rows[1]);
    CHECK(ui::GarmentScreen::most_scroll_px(state, layout) == 2 * layout.row_pitch);
}

TEST_CASE("Drape is offered where there is cloth, and says what it does", "[garment screen]") {
    const Screen s;
    const ui::GarmentLayout layout = ui::garment_layout({1920, 1080}, ui::Hand::Right);
    ui::GarmentState state = dressed();
    state.page = 2;
    CHECK_FALSE(offers(s.garment.targets(state, layout), ui::GarmentAction::Drape));
    state.can_hang = true;
    CHECK(offers(s.garment.targets(state, layout), ui::GarmentAction::Drape));
    state.hanging = true;
    CHECK(begins(texts(s.garment.draw(state, layout)), s.languages[0]["hangs_flat"]));
    state.view = ui::GarmentView::Solid;
    CHECK(begins(texts(s.garment.draw(state, layout)), s.languages[0]["hangs_solid"]));
}

TEST_CASE("an object's row takes it off, and has neither eye nor swatch", "[garment screen]") {
    const Screen s;
    const ui::GarmentLayout layout = ui::garment_layout({1280, 800}, ui::Hand::Right);
    ui::GarmentState state = dressed();
    ui::LayerRow bag;
    bag.name = "Bag";
    bag.object = bag.selected = true;
    state.rows.insert(state.rows.begin(), bag);
    const auto targets = s.garment.targets(state, layout);
    CHECK(offers(targets, ui::GarmentAction::Unplace, 0));
    CHECK(offers(targets, ui::GarmentAction::Row, 0));
    CHECK_FALSE(offers(targets, ui::GarmentAction::Eye, 0));
    CHECK_FALSE(offers(targets, ui::GarmentAction::Swatch, 0));
    CHECK(offers(targets, ui::GarmentAction::Eye, 1));
    state.object = ui::ObjectHandles{{600, 300, 100, 80}, {700, 380}, {700, 300}, false, true};
    CHECK(begins(texts(s.garment.draw(state, layout)), s.languages[0]["object_hint"]));
}

TEST_CASE("the number pad has the drawer to itself; own bodies are a size more", "[garment screen]") {
    const Screen s;
    for (const ui::SizePx size : {ui::SizePx{1920, 1080}, ui::SizePx{1280, 800}, ui::SizePx{1080, 1920}}) {
        const ui::GarmentLayout layout = ui::garment_layout(size, ui::Hand::Right);
        ui::GarmentState state = dressed();
        state.drawer = ui::GarmentDrawer::Body;
        state.body.sizes = {"36", "38", "m"};
        for (ui::MeasureSlider& m : state.body.measures) m = {"waist", 74, 60, 120};
        auto targets = s.garment.targets(state, layout);
        CHECK(offers(targets, ui::GarmentAction::TypeMeasure, 6));
        CHECK_FALSE(offers(targets, ui::GarmentAction::OwnBody));
        state.body.own_bodies = true;
        CHECK(offers(s.garment.targets(state, layout), ui::GarmentAction::OwnBody));
        state.body.own_body = true;
        CHECK_FALSE(offers(s.garment.targets(state, layout), ui::GarmentAction::TypeMeasure, 6));
        state.body.own_body = false;
        state.body.typed = 1;
        state.body.number = {"74.0", true};
        targets = s.garment.targets(state, layout);
        CHECK_FALSE(offers(targets, ui::GarmentAction::Measure, 0));
        CHECK(offers(targets, ui::GarmentAction::PadDone));
        for (const ui::BoardTouch::Target& key : targets) {
            CHECK(key.rect.height >= 60);
            CHECK(key.rect.bottom() <= layout.board.bottom());
            CHECK(key.rect.right() <= layout.board.right());
        }
        CHECK(has(texts(s.garment.draw(state, layout)), "60.0 to 120.0 cm"));
        state.body.number.text.clear();
        CHECK_FALSE(offers(s.garment.targets(state, layout), ui::GarmentAction::PadDone));
    }
}
