// A designer's hand that draws the worked designs through the Garment screen, stroke by stroke, and leaves what its pen
// did as traces.
//
//     designer_hand OUT           OUT/garment-NAME/{input.trace, design.json} for dress, outfit and jacket; prints how
//                                 far each lies from the engine's worked design
//     designer_hand check FOLDER  plays FOLDER/garment-*/input.trace; fails where another design than design.json comes
//
// The screen has no plane but through what a stroke starts at, and a pen cannot change its view in the middle of a
// line: where a worked design does, the hand goes on with a new line at the end of the last.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/exchange/design_file.hpp"
#include "core/garment/wardrobe.hpp"
#include "tests/support/cloth_distance.hpp"
#include "tests/support/garment_hand.hpp"

namespace {

using Kind = core::DesignStep::Kind;
using Tool = core::DrawingTool::Kind;
using T = ui::GarmentTool;
using V = ui::GarmentView;
constexpr ui::SizePx kSize{1920, 1080};

V view_of(const core::DrawingView& view) {
    if (view.toward.y > 0.5) return V::Top;
    if (view.toward.z > 0.5) return V::Front;
    if (view.toward.z < -0.5) return V::Back;
    return V::Side;
}

/// Parts of a stroke that go on in one view with one tool as one; parts of a single point only where they are needed.
std::vector<core::StrokePart> strokes_of(const core::SketchStroke& stroke, const core::Obstacle& body) {
    std::vector<core::StrokePart> out;
    std::optional<core::Vec3> before;  // where a part of one point lies: the next begins there
    for (std::size_t k = 0; k < stroke.size(); ++k) {
        core::StrokePart part = stroke[k];
        core::StrokeLifter lifter(body);
        lifter.begin_part(part.view, part.tool);
        for (const core::Point at : part.points) (void)lifter.add(at);
        if (lifter.line().empty()) continue;
        if (part.points.size() == 1 && stroke.size() > 1) {
            if (out.empty())
                before = lifter.line().front();
            else
                out.back().points.push_back(out.back().view.project(lifter.line().front()));
            continue;
        }
        if (before) part.points.insert(part.points.begin(), part.view.project(*before));
        before.reset();
        const bool goes_on = !out.empty() && out.back().view.toward == part.view.toward &&
                             out.back().tool.kind == part.tool.kind && out.back().tool.offset == part.tool.offset;
        if (goes_on) {
            out.back().points.insert(out.back().points.end(), part.points.begin() + 1, part.points.end());
        } else {
            if (!out.empty()) {  // the next begins where the last ended
                core::StrokeLifter last(body);
                last.begin_part(out.back().view, out.back().tool);
                for (const core::Point at : out.back().points) (void)last.add(at);
                if (!last.line().empty())
                    part.points.insert(part.points.begin(), part.view.project(last.line().back()));
            }
            out.push_back(std::move(part));
        }
    }
    return out;
}

void draw_step(test::GarmentHand& hand, test::KioskStand& kiosk, const core::DesignStep& step) {
    if (step.kind == Kind::Layer) {
        hand.press(ui::GarmentAction::AddLayer);
        return;
    }
    if (step.kind != Kind::Line && step.kind != Kind::Cut && step.kind != Kind::Hole) return;
    const core::Obstacle& body = kiosk.garment->desk().state().obstacle();
    for (const core::StrokePart& part : strokes_of(step.stroke, body)) {
        const bool on_body = part.tool.kind == Tool::Body;
        hand.view(view_of(part.view));
        hand.tool(step.kind == Kind::Cut    ? T::Cut
                  : step.kind == Kind::Hole ? T::Hole
                  : on_body                 ? T::OnBody
                                            : T::OnPlane);
        if (on_body && step.kind == Kind::Line) hand.offset(part.tool.offset);
        const std::size_t acts = kiosk.garment->desk().history().size();
        hand.draw(part.points);
        if (kiosk.garment->desk().history().size() == acts)
            std::printf("  %s: nothing came of a stroke: %s\n", step.name.c_str(),
                        kiosk.garment->state(kiosk.now_us).problem.c_str());
    }
}

/// Lines that lie in the plane of the front come first in each layer: what is drawn on the body then ends on them.
std::vector<core::DesignStep> in_drawing_order(std::vector<core::DesignStep> steps) {
    const auto layer_end = [&](auto from) {
        return std::find_if(from, steps.end(), [](const core::DesignStep& s) { return s.kind == Kind::Layer; });
    };
    const auto in_plane = [](const core::DesignStep& step) {
        return step.kind == Kind::Line &&
               std::all_of(step.stroke.begin(), step.stroke.end(),
                           [](const core::StrokePart& part) { return part.tool.kind == Tool::PlaneXY; });
    };
    for (auto first = steps.begin(); first != steps.end();) {
        const auto end = layer_end(first);
        std::stable_partition(first, end, in_plane);
        first = end == steps.end() ? end : end + 1;
    }
    return steps;
}

int draw(const std::string& name, const std::filesystem::path& out) {
    const std::filesystem::path folder = out / ("garment-" + name);
    std::filesystem::create_directories(folder);
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    const core::Design design = *core::wardrobe_design(name, body);
    const core::DressForm form = core::dress_form(body);
    core::Design drawn;
    {
        test::KioskStand kiosk(kSize, {}, {}, folder);
        test::GarmentHand hand(kiosk);
        hand.enter();
        for (const core::DesignStep& step : in_drawing_order(design.steps)) draw_step(hand, kiosk, step);
        drawn = kiosk.garment->design();
        kiosk.garment->wipe(0, ui::Hand::Right);  // the trace is closed
    }
    std::filesystem::rename(folder / "garment-0001.trace", folder / "input.trace");
    std::ofstream(folder / "design.json") << core::design_text(drawn);
    const core::Result<core::Garment> engine = core::make_garment(design, form), own = core::make_garment(drawn, form);
    if (!engine || !own || engine->layers.size() != own->layers.size()) {
        std::printf("%s: %zu layers, not as the engine's\n", name.c_str(), own ? own->layers.size() : 0);
        return 1;
    }
    for (std::size_t k = 0; k < own->layers.size(); ++k) {
        const core::Cloth &a = own->layers[k].fitted, &b = engine->layers[k].fitted;
        const support::ClothDistance apart = support::distance_between(a.mesh, b.mesh);
        std::printf(
            "%s, layer %zu: %zu pieces of %zu, %zu quads of %zu; surfaces %.2f cm apart at half of the places, "
            "%.2f at 95 %%, %.2f at most\n",
            name.c_str(), k + 1, a.pieces.size(), b.pieces.size(), a.mesh.quads.size(), b.mesh.quads.size(),
            apart.median, apart.most_of, apart.largest);
    }
    return 0;
}

/// Whether a trace gives the design that is kept beside it.
bool plays(const std::filesystem::path& folder) {
    const core::Result<input::Trace> trace = input::read_trace((folder / "input.trace").string());
    if (!trace) {
        std::printf("%s\n", trace.error().sentence().c_str());
        return false;
    }
    const core::Result<app::GarmentReplay> replay = app::garment_replay(*trace, folder.filename().string());
    const core::Result<core::Design> kept = core::read_design((folder / "design.json").string());
    if (!replay || !kept) {
        std::printf("%s\n", (replay ? kept.error() : replay.error()).sentence().c_str());
        return false;
    }
    test::KioskStand kiosk(replay->start.screen);
    test::play(kiosk, *replay);
    const bool same = core::design_text(kiosk.garment->design()) == core::design_text(*kept);
    std::printf("%s: %zu events, %zu steps: %s\n", folder.filename().c_str(), replay->events.size(), kept->steps.size(),
                same ? "the same design" : "another design");
    return same;
}

int check(const std::filesystem::path& all) {
    int played = 0, failed = 0;
    for (const auto& entry : std::filesystem::directory_iterator(all)) {
        if (entry.path().filename().string().rfind("garment-", 0) != 0) continue;
        ++played;
        failed += plays(entry.path()) ? 0 : 1;
    }
    return played > 0 && failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::string(argv[1]) == "check") return check(argv[2]);
    if (argc != 2) {
        std::fprintf(stderr, "usage: designer_hand OUT | check FOLDER\n");
        return 2;
    }
    int failed = 0;
    for (const char* name : {"dress", "outfit", "jacket"}) failed += draw(name, argv[1]);
    return failed == 0 ? 0 : 1;
}
