#include "firmware_like_app/config/options.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {
namespace {

using Text = std::function<std::string&(Config&)>;
using Switch = std::function<bool&(Config&)>;
using Number = std::function<double&(Config&)>;
using Whole = std::function<std::int64_t&(Config&)>;
using Numbers = std::function<std::vector<double>&(Config&)>;

std::string check_pin(const Config& config) {
    const std::string& pin = config.station.pin;
    const bool digits = std::all_of(pin.begin(), pin.end(), [](char c) { return c >= '0' && c <= '9'; });
    return digits && pin.size() >= 4 && pin.size() <= 8 ? "" : "it must be four to eight digits";
}

std::string check_area(const Config& config) {
    const std::vector<double>& a = config.tablet.area;
    if (a.empty()) return "";
    const bool inside = std::all_of(a.begin(), a.end(), [](double v) { return v >= -0.5 && v <= 1.5; });
    if (a.size() == 4 && inside && a[0] < a[2] && a[1] < a[3]) return "";
    return "it must be four shares, left, top, right, bottom, with left < right and top < bottom, such as [0, 0, 1, 1]";
}

std::string check_align(const Config& config) {
    const std::vector<double>& a = config.tablet.align;
    if (a.empty()) return "";
    const bool small = std::all_of(a.begin(), a.end(), [](double v) { return std::abs(v) <= 2; });
    if (a.size() == 6 && small && std::abs(a[0] * a[4] - a[1] * a[3]) >= 0.1) return "";
    return "it must be six numbers, none beyond 2, such as [1, 0, 0, 0, 1, 0]; align pen and screen on the station "
           "page";
}

std::string check_size(const Config& config) {
    if (config.screen.size.empty()) return "";
    int width = 0, height = 0;
    char rest = 0;
    const bool whole = std::sscanf(config.screen.size.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
    const bool good = whole && width >= 320 && height >= 240 && width <= 8192 && height <= 8192;
    return good ? "" : "it must be WIDTHxHEIGHT from 320x240 to 8192x8192";
}

std::vector<Option> make_options() {
    std::vector<Option> o;
    o.push_back(Option{"collection", "database", "The index to search, one file.",
                       Text([](Config& c) -> std::string& { return c.collection.database; })});
    o.push_back(Option{"collection", "models",
                       "A folder of models: what is new or changed in it is read at the start, while visitors draw.",
                       Text([](Config& c) -> std::string& { return c.collection.models; })});
    o.push_back(Option{"collection", "add_from",
                       "Where the operator starts to look for models to add.\nEmpty: /media, where USB sticks appear.",
                       Text([](Config& c) -> std::string& { return c.collection.add_from; })});
    o.push_back(Option{
        "collection", "search_threads", "Threads that search; 0: one for each core.",
        Whole([](Config& c) -> std::int64_t& {
            return c.collection.search_threads;
        })}.within(0, 64));

    o.push_back(Option{"visitors", "language", "Language at the start of every visit: the code of a language file.",
                       Text([](Config& c) -> std::string& { return c.visitors.language; })});
    o.push_back(Option{
        "visitors", "hand", "Drawing hand at the start of every visit: \"right\" or \"left\".",
        Text([](Config& c) -> std::string& {
            return c.visitors.hand;
        })}.one_of({"right", "left"}));
    o.push_back(Option{"visitors", "languages_folder", "A folder with further language files, NAME.json.",
                       Text([](Config& c) -> std::string& { return c.visitors.languages_folder; })});
    o.push_back(Option{"visitors", "attract",
                       "Drawings that draw themselves while nobody is there; false: an empty sheet waits.",
                       Switch([](Config& c) -> bool& { return c.visitors.attract; })});
    o.push_back(Option{"visitors", "garment", "Whether visitors can draw garments on a figure.",
                       Switch([](Config& c) -> bool& { return c.visitors.garment; })});
    o.push_back(Option{"visitors", "shadow", "The best match lies under the drawing as a faint shadow.",
                       Switch([](Config& c) -> bool& { return c.visitors.shadow; })});
    o.push_back(Option{
        "visitors", "part_colours",
        "Colours of matched parts: \"soft\", or \"strong\" for screens and projectors that show soft ones pale.",
        Text([](Config& c) -> std::string& {
            return c.visitors.part_colours;
        })}.one_of({"soft", "strong"}));
    o.push_back(Option{"visitors", "attract_drawings",
                       "A folder of drawings that draw themselves in place of those that come with Croquis, such as "
                       "traces\nof record.folder. Everybody sees them: take those whose makers agreed.",
                       Text([](Config& c) -> std::string& { return c.visitors.attract_drawings; })});

    o.push_back(Option{
        "idle", "ask_s", "Without input, before \"Still there?\" is asked.", Number([](Config& c) -> double& {
            return c.idle.ask_s;
        })}.within(10, 3600));
    o.push_back(Option{
        "idle", "ask_garment_s", "The same while a garment is drawn.", Number([](Config& c) -> double& {
            return c.idle.ask_garment_s;
        })}.within(10, 3600));
    o.push_back(Option{
        "idle", "countdown_s", "How long the question counts down before it wipes.", Number([](Config& c) -> double& {
            return c.idle.countdown_s;
        })}.within(5, 120));
    o.push_back(Option{
        "idle", "empty_s", "An empty sheet goes back to the start without asking.", Number([](Config& c) -> double& {
            return c.idle.empty_s;
        })}.within(5, 3600));
    o.push_back(Option{
        "idle", "still_pen_s", "A pen that lies on the tablet without moving counts as a visitor this long.",
        Number([](Config& c) -> double& {
            return c.idle.still_pen_s;
        })}.within(10, 7200));

    o.push_back(Option{"garment", "designs",
                       "The file in which garments are kept while they are drawn. Empty: they go with the visitor.",
                       Text([](Config& c) -> std::string& { return c.garment.designs; })});
    o.push_back(Option{"garment", "export_to", "The folder that garments are exported to. Empty: the USB stick.",
                       Text([](Config& c) -> std::string& { return c.garment.export_to; })});
    o.push_back(Option{"garment", "bodies",
                       "A folder of bodies as closed meshes, OBJ and others, to draw on in place of the mannequin.\n"
                       "Empty: none.",
                       Text([](Config& c) -> std::string& { return c.garment.bodies; })});
    o.push_back(Option{"garment", "fabrics",
                       "A folder of PNG pictures, the first ten of which are offered as fabrics, each 10 cm wide.\n"
                       "Empty: none.",
                       Text([](Config& c) -> std::string& { return c.garment.fabrics; })});
    o.push_back(Option{
        "garment", "bin_days", "How many days a deleted design can still be taken out of the bin.",
        Whole([](Config& c) -> std::int64_t& {
            return c.garment.bin_days;
        })}.within(0, 3650));

    o.push_back(Option{"tablet", "expected",
                       "Say on the screen when no tablet is there. One that was there once is always expected.",
                       Switch([](Config& c) -> bool& { return c.tablet.expected; })});
    o.push_back(Option{
        "tablet", "turn",
        "How the tablet lies against the screen: \"none\", \"right\", \"half\", \"left\" (quarter turns).",
        Text([](Config& c) -> std::string& {
            return c.tablet.turn;
        })}.one_of({"none", "right", "half", "left"}));
    o.push_back(Option{
        "tablet", "pressure", "Pressure curve: \"soft\" for light hands, \"normal\", \"firm\".",
        Text([](Config& c) -> std::string& {
            return c.tablet.pressure;
        })}.one_of({"soft", "normal", "firm"}));
    o.push_back(Option{
        "tablet", "area",
        "The part of the tablet that is the screen: left, top, right, bottom, as shares.\nEmpty: as much of it as has "
        "the screen's shape.",
        Numbers([](Config& c) -> std::vector<double>& {
            return c.tablet.area;
        })}.checked_by(check_area));
    o.push_back(Option{
        "tablet", "align",
        "What \"Align pen and screen\" on the station page found: six numbers, x' = a x + b y + c and\ny' = d x + e y "
        "+ f "
        "in shares of the screen. Empty: the pen is where the tablet says.",
        Numbers([](Config& c) -> std::vector<double>& {
            return c.tablet.align;
        })}.checked_by(check_align));

    o.push_back(Option{
        "station", "pin",
        "Opens the station page: hold the board's top corner for three seconds. Four to eight digits. Change it.",
        Text([](Config& c) -> std::string& {
            return c.station.pin;
        })}.checked_by(check_pin));
    o.push_back(Option{"station", "place", "Where the station stands; shown on the station page and in reports.",
                       Text([](Config& c) -> std::string& { return c.station.place; })});
    o.push_back(Option{"station", "report_folder",
                       "Where \"Save report\" writes. Empty: beside this file, else the home folder.",
                       Text([](Config& c) -> std::string& { return c.station.report_folder; })});

    o.push_back(Option{
        "screen", "size", "WIDTHxHEIGHT. Empty: the whole screen.", Text([](Config& c) -> std::string& {
            return c.screen.size;
        })}.checked_by(check_size));
    o.push_back(Option{"screen", "windowed", "A framed window instead of the full screen.",
                       Switch([](Config& c) -> bool& { return c.screen.windowed; })});
    o.push_back(Option{"screen", "escape_exits", "Whether the Escape key ends the program.",
                       Switch([](Config& c) -> bool& { return c.screen.escape_exits; })});

    o.push_back(Option{"record", "folder", "Keep what visitors draw, in this folder. Empty: nothing is kept.",
                       Text([](Config& c) -> std::string& { return c.record.folder; })});
    return o;
}

}  // namespace

const std::vector<Option>& all_options() {
    static const std::vector<Option> options = make_options();
    return options;
}

std::string section_comment(const std::string& section) {
    if (section == "collection") return "What is searched.";
    if (section == "visitors") return "What visitors meet.";
    if (section == "idle") return "When a visit is over; seconds.";
    if (section == "tablet") return "Pen and tablet.";
    if (section == "station") return "For the operator.";
    if (section == "screen") return "The window.";
    return "Drawings that are kept.";
}

}  // namespace app
