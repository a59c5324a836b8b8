// A designer's hand that draws the worked designs through the Garment screen, stroke by stroke, and leaves what its pen
// did as traces.
//
//     designer_hand OUT           OUT/garment-NAME/{input.trace, design.json} for dress, outfit and jacket; prints how
//                                 far each lies from the engine's worked design, and fails beyond 5 mm
//     designer_hand check FOLDER  plays FOLDER/garment-*/input.trace; fails where another design than design.json
//     comes,
//                                 and where that is not the engine's
//
// A line that changes its view or its plane goes on from its end, as a tap there lets it. A cut drawn off the body is a
// line across the piece, which parts it.
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

bool same_way(const core::StrokePart& a, const core::StrokePart& b) {
    return a.view.toward == b.view.toward && a.tool.kind == b.tool.kind && a.tool.offset == b.tool.offset;
}

/// The parts of a stroke; those that go on in one view with one tool as one.
std::vector<core::StrokePart> parts_of(const core::SketchStroke& stroke) {
    std::vector<core::StrokePart> out;
    for (const core::StrokePart& part : stroke) {
        const bool goes_on = !out.empty() && same_way(out.back(), part) && part.points.size() > 1;
        if (goes_on)
            out.back().points.insert(out.back().points.end(), part.points.begin(), part.points.end());
        else
            out.push_back(part);
    }
    return out;
}

/// A designer's hand with a worked design before it.
class Copyist {
  public:
    Copyist(test::GarmentHand& hand, test::KioskStand& kiosk) : hand_(hand), kiosk_(kiosk) {}

    void draw(const core::DesignStep& step) {
        if (step.kind == Kind::Layer) return hand_.press(ui::GarmentAction::AddLayer);
        if (step.kind != Kind::Line && step.kind != Kind::Cut && step.kind != Kind::Hole) return;
        const std::vector<core::StrokePart> parts = parts_of(step.stroke);
        const std::size_t acts = desk().history().size();
        for (std::size_t k = 0; k < parts.size(); ++k) {
            take_up(parts[k], step.kind == Kind::Hole);
            if (k == 0 && parts[k].points.size() == 1)
                begin_at(parts[k].points.front(), step.name);
            else if (parts[k].points.size() == 1)
                hand_.tap(parts[k].points.front());
            else
                hand_.draw_sampled(parts[k].points);
            if (k == 0 && parts.size() > 1 && parts[k].points.size() > 1) begin_at(parts[k].points.back(), step.name);
            hand_.zoom(1);
        }
        if (desk().goes_on()) kiosk_.tap(kiosk_.garment->layout().redo);  // Finish
        if (desk().history().size() == acts) tell(step.name, "nothing came of it");
    }

    /// On the page of the design as a whole.
    void choose_quads(double cm) {
        if (desk().network().options().edge_cm == cm) return;
        hand_.press(ui::GarmentAction::Page, 2);
        hand_.number(cm);
    }

  private:
    [[nodiscard]] core::GarmentDesk& desk() { return kiosk_.garment->desk(); }

    /// View, tool, number, and near to where there is much to see: as near as the part has room.
    void take_up(const core::StrokePart& part, bool hole) {
        hand_.view(view_of(part.view));
        const bool on_body = part.tool.kind == Tool::Body;
        hand_.tool(hole ? T::Hole : on_body ? T::OnBody : T::OnPlane);
        if (!hole) hand_.number(part.tool.offset);
        const auto [left, right] = std::minmax_element(part.points.begin(), part.points.end(),
                                                       [](core::Point a, core::Point b) { return a.x < b.x; });
        const auto [low, high] = std::minmax_element(part.points.begin(), part.points.end(),
                                                     [](core::Point a, core::Point b) { return a.y < b.y; });
        const core::Point middle = core::midpoint({left->x, low->y}, {right->x, high->y}), room = hand_.room_cm();
        const double wide = std::max((right->x - left->x) / room.x, (high->y - low->y) / room.y) / 2;
        for (const double times : {8.0, 4.0, 2.0}) {
            if (wide * times > 1) continue;
            hand_.zoom(times, middle);
            break;
        }
    }

    void begin_at(core::Point end, const std::string& name) {
        hand_.tap(end);
        if (!desk().goes_on()) tell(name, "no end to go on from");
    }

    void tell(const std::string& name, const char* what) {
        std::printf("  %s: %s: %s\n", name.c_str(), what, kiosk_.garment->state(kiosk_.now_us).problem.c_str());
    }

    test::GarmentHand& hand_;
    test::KioskStand& kiosk_;
};

constexpr double kMost_cm = 0.5;  // between the surfaces, at the worst place

/// Whether a drawn design is the engine's: as many pieces, and their surfaces less than 5 mm apart.
bool is_near(const std::string& name, const core::Design& drawn) {
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    const core::DressForm form = core::dress_form(body);
    const core::Result<core::Garment> engine = core::make_garment(*core::wardrobe_design(name, body), form),
                                      own = core::make_garment(drawn, form);
    if (!engine || !own || engine->layers.size() != own->layers.size()) {
        std::printf("%s: %zu layers, not as the engine's\n", name.c_str(), own ? own->layers.size() : 0);
        return false;
    }
    bool near = true;
    for (std::size_t k = 0; k < own->layers.size(); ++k) {
        const core::Cloth &a = own->layers[k].fitted, &b = engine->layers[k].fitted;
        const support::ClothDistance apart = support::distance_between(a.mesh, b.mesh);
        std::printf(
            "%s, layer %zu: %zu pieces of %zu, %zu quads of %zu; surfaces %.2f cm apart at half of the places, "
            "%.2f at 95 %%, %.2f at most\n",
            name.c_str(), k + 1, a.pieces.size(), b.pieces.size(), a.mesh.quads.size(), b.mesh.quads.size(),
            apart.median, apart.most_of, apart.largest);
        near = near && a.pieces.size() == b.pieces.size() && a.mesh.quads.size() == b.mesh.quads.size() &&
               apart.largest <= kMost_cm;
    }
    return near;
}

int draw(const std::string& name, const std::filesystem::path& out) {
    const std::filesystem::path folder = out / ("garment-" + name);
    std::filesystem::create_directories(folder);
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    const core::Design design = *core::wardrobe_design(name, body);
    core::Design drawn;
    {
        test::KioskStand kiosk(kSize, {}, {}, folder);
        test::GarmentHand hand(kiosk);
        hand.enter();
        Copyist copyist(hand, kiosk);
        copyist.choose_quads(design.network.edge_cm);
        for (const core::DesignStep& step : design.steps) copyist.draw(step);
        drawn = kiosk.garment->design();
        kiosk.garment->wipe(0, ui::Hand::Right);  // the trace is closed
    }
    std::filesystem::rename(folder / "garment-0001.trace", folder / "input.trace");
    std::ofstream(folder / "design.json") << core::design_text(drawn);
    return is_near(name, drawn) ? 0 : 1;
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
    constexpr std::size_t kPrefix = 8;  // "garment-"
    return is_near(folder.filename().string().substr(kPrefix), *kept) && same;
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
