#include "core/exchange/design_file.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/exchange/file_bytes.hpp"

namespace core {
namespace {

using Json = nlohmann::ordered_json;
using Kind = DesignStep::Kind;
using ToolKind = DrawingTool::Kind;

constexpr std::size_t kMaxTextBytes = std::size_t{64} << 20;
constexpr auto kReplace = Json::error_handler_t::replace;  // names may come from anywhere: what is no UTF-8
constexpr double kFarthest_cm = 2000.0;  // of a drawn point: whatever lies beyond was never drawn on a figure
constexpr const char* kFormat = "croquis-garment";

constexpr std::array<std::pair<Kind, const char*>, 26> kSteps{
    {{Kind::Line, "line"},       {Kind::Region, "region"},       {Kind::Cut, "cut"},
     {Kind::Hole, "hole"},       {Kind::Remove, "remove"},       {Kind::Corner, "corner"},
     {Kind::Alpha, "alpha"},     {Kind::Move, "move"},           {Kind::Weld, "weld"},
     {Kind::Layer, "layer"},     {Kind::Associate, "associate"}, {Kind::Erase, "erase"},
     {Kind::Join, "join"},       {Kind::Meet, "meet"},           {Kind::Smooth, "smooth"},
     {Kind::Bump, "bump"},       {Kind::Rename, "rename"},       {Kind::Material, "material"},
     {Kind::Mirror, "mirror"},   {Kind::Work, "work"},           {Kind::Order, "order"},
     {Kind::Show, "show"},       {Kind::Body, "body"},           {Kind::Place, "place"},
     {Kind::Unplace, "unplace"}, {Kind::Edges, "edges"}}};
constexpr std::array<std::pair<ToolKind, const char*>, 6> kTools{{{ToolKind::Body, "body"},
                                                                  {ToolKind::PlaneXY, "plane_xy"},
                                                                  {ToolKind::PlaneXZ, "plane_xz"},
                                                                  {ToolKind::PlaneYZ, "plane_yz"},
                                                                  {ToolKind::Temporary, "temporary"},
                                                                  {ToolKind::Piece, "piece"}}};
constexpr std::array<const char*, 5> kViews{"front", "back", "left", "right", "top"};

/// Thrown within this file only: what is wrong, as the rest of a sentence.
struct Fault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

double number(const Json& json, const char* what) {
    if (!json.is_number() || !std::isfinite(json.get<double>())) throw Fault(std::string(what) + " is no number");
    return json.get<double>();
}
double number(const Json& object, const char* key, double otherwise) {
    return object.contains(key) ? number(object[key], key) : otherwise;
}
std::string text(const Json& object, const char* key) {
    if (!object.contains(key) || !object[key].is_string())
        throw Fault(std::string("\"") + key + "\" is missing or no text");
    return object[key].get<std::string>();
}
bool flag(const Json& object, const char* key, bool otherwise) {
    if (!object.contains(key)) return otherwise;
    if (!object[key].is_boolean()) throw Fault(std::string("\"") + key + "\" is neither true nor false");
    return object[key].get<bool>();
}
Vec3 place(const Json& json, const char* what) {
    if (!json.is_array() || json.size() != 3) throw Fault(std::string(what) + " is not [x, y, z]");
    return {number(json[0], what), number(json[1], what), number(json[2], what)};
}
Vec3 place_at(const Json& object, const char* key) {
    if (!object.contains(key)) throw Fault(std::string("\"") + key + "\" is missing");
    return place(object[key], key);
}

template <typename Value, std::size_t n>
Value from_name(const std::array<std::pair<Value, const char*>, n>& names, const std::string& name, const char* what) {
    for (const auto& [value, known] : names)
        if (name == known) return value;
    throw Fault(std::string("there is no ") + what + " \"" + name + "\"");
}
template <typename Value, std::size_t n>
const char* to_name(const std::array<std::pair<Value, const char*>, n>& names, Value value) {
    for (const auto& [known, name] : names)
        if (known == value) return name;
    return "";
}

/// A parallel view from any side: since version 3.
DrawingView parallel_view(const Json& json) {
    DrawingView view;
    view.right = place_at(json, "right");
    view.up = place_at(json, "up");
    view.toward = cross(view.right, view.up);
    const auto is_unit = [](Vec3 v) { return std::abs(length(v) - 1.0) < 1e-6; };
    if (!is_unit(view.right) || !is_unit(view.up) || std::abs(dot(view.right, view.up)) > 1e-6)
        throw Fault("\"right\" and \"up\" of a view are no unit vectors across each other");
    return view;
}

DrawingView view_from(const Json& json) {
    if (json.is_object() && json.contains("right")) return parallel_view(json);
    Result<DrawingView> view = json.is_string()   ? named_view(json.get<std::string>())
                               : json.is_object() ? perspective_view(place_at(json, "eye"), place_at(json, "target"))
                                                  : unexpected(ErrorCode::BadFormat, "\"view\" is missing");
    if (!view) throw Fault(view.error().message);
    return *view;
}

Json view_to(const DrawingView& view) {
    const auto places = [](Vec3 p) { return Json{p.x, p.y, p.z}; };
    if (view.eye_distance > 0.0)
        return {{"eye", places(view.centre + view.toward * view.eye_distance)}, {"target", places(view.centre)}};
    for (const char* name : kViews)
        if (const DrawingView known = *named_view(name); known.toward == view.toward && known.up == view.up)
            return name;
    return {{"right", places(view.right)}, {"up", places(view.up)}};
}

SketchStroke stroke_from(const Json& step) {
    if (!step.contains("stroke") || !step["stroke"].is_array()) throw Fault("\"stroke\" is missing or no list");
    SketchStroke stroke;
    for (const Json& json : step["stroke"]) {
        if (!json.is_object() || !json.contains("points") || !json["points"].is_array())
            throw Fault("a part of the stroke has no \"points\"");
        StrokePart part;
        part.view = view_from(json.contains("view") ? json["view"] : Json());
        part.tool = {from_name(kTools, text(json, "tool"), "tool"), number(json, "offset", 0.0)};
        for (const Json& p : json["points"]) {
            if (!p.is_array() || p.size() != 2) throw Fault("a point of the stroke is not [right, up]");
            part.points.push_back({number(p[0], "a point"), number(p[1], "a point")});
            if (std::hypot(part.points.back().x, part.points.back().y) > kFarthest_cm)
                throw Fault("a point lies more than 20 m from the figure");
        }
        stroke.push_back(std::move(part));
    }
    return stroke;
}

Json stroke_to(const SketchStroke& stroke) {
    Json list = Json::array();
    for (const StrokePart& part : stroke) {
        Json points = Json::array();
        for (const Point p : part.points) points.push_back({p.x, p.y});
        list.push_back({{"view", view_to(part.view)},
                        {"tool", to_name(kTools, part.tool.kind)},
                        {"offset", part.tool.offset},
                        {"points", std::move(points)}});
    }
    return list;
}

bool has_stroke(Kind kind) {
    return kind == Kind::Line || kind == Kind::Cut || kind == Kind::Hole;
}
bool has_ends(Kind kind) {
    return kind == Kind::Line || kind == Kind::Cut;
}
bool has_name(Kind kind) {
    return has_stroke(kind) || kind == Kind::Region;
}
bool names_region(Kind kind) {
    return kind == Kind::Cut || kind == Kind::Hole || kind == Kind::Remove || kind == Kind::Corner ||
           kind == Kind::Alpha || kind == Kind::Associate;
}

PartSet parts_from(const Json& list) {
    if (!list.is_array()) throw Fault("\"parts\" is no list");
    PartSet parts = 0;
    for (const Json& name : list) {
        if (!name.is_string()) throw Fault("a part's name is no text");
        const Result<BodyPart> part = part_named(name.get<std::string>());
        if (!part) throw Fault(part.error().message);
        parts |= part_bit(*part);
    }
    return parts;
}

BodyMeasures body_from(const Json& holder) {
    const Json& json = holder.contains("body") ? holder["body"] : throw Fault("\"body\" is missing");
    if (!json.is_object()) throw Fault("\"body\" is no object");
    Result<BodyMeasures> measures = measures_of_size(text(json, "size"));
    if (!measures) throw Fault(measures.error().message);
    if (json.contains("measures")) {
        if (!json["measures"].is_object()) throw Fault("\"measures\" is no object");
        for (const auto& [name, cm] : json["measures"].items())
            if (const auto set = set_measure(*measures, name, number(cm, "a measure")); !set)
                throw Fault(set.error().message);
    }
    return *measures;
}

/// Every measure that differs from the size it is nearest to by figure.
Json body_to(const BodyMeasures& measures) {
    const std::string size = measures.figure == Figure::Man ? "m" : "38";
    const BodyMeasures known = *measures_of_size(size);
    Json json{{"size", size}};
    for (std::size_t k = 0; k < kMeasureCount; ++k)
        if (measures.cm[k] != known.cm[k]) json["measures"][std::string(measure_names()[k])] = measures.cm[k];
    return json;
}

bool along_line(Kind kind) {
    return kind == Kind::Erase || kind == Kind::Join || kind == Kind::Smooth || kind == Kind::Bump;
}
bool of_layer(const DesignStep& step) {
    return step.kind == Kind::Work || step.kind == Kind::Show || (step.kind == Kind::Rename && step.region.empty());
}

int layer_number(const Json& json, const char* what) {
    const double value = number(json, what);
    if (value != std::floor(value) || value < 0.0 || value > 10000.0)
        throw Fault(std::string(what) + " is no number of a layer");
    return static_cast<int>(value);
}

PlacedObject object_from(const Json& json) {
    PlacedObject object{text(json, "name"), text(json, "model"), place_at(json, "at"), number(json, "scale", 1.0), {}};
    if (json.contains("turn")) object.turn = place(json["turn"], "turn");
    return object;
}

double edge_from(const Json& json) {
    const double cm = number(json, "edge_cm", 0.0);
    if (cm < kLeastEdge_cm || cm > kMostEdge_cm) throw Fault("\"edge_cm\" is not between 0.3 and 20");
    return cm;
}

/// What came with versions 3 and 4.
void of_later_versions(const Json& json, DesignStep& step) {
    if (has_ends(step.kind) && json.contains("starts_to")) step.starts_to = place_at(json, "starts_to");
    if (has_ends(step.kind) && json.contains("ends_to")) step.ends_to = place_at(json, "ends_to");
    if (step.kind == Kind::Region && json.contains("replaces")) step.region = text(json, "replaces");
    if (along_line(step.kind)) step.lines = {text(json, "line")};
    if (step.kind == Kind::Join) step.at = place_at(json, "at");
    if (step.kind == Kind::Meet) step.lines = {text(json, "line"), text(json, "other")};
    if (step.kind == Kind::Meet || step.kind == Kind::Smooth || step.kind == Kind::Bump) {
        step.at = place_at(json, "at");
        step.to = place_at(json, "to");
    }
    if (step.kind == Kind::Bump) {
        step.radius = number(json, "wave", 0.0);
        step.depth = number(json, "depth", 0.0);
    }
    if (step.kind == Kind::Rename && json.contains("region")) step.region = text(json, "region");
    if (step.kind == Kind::Rename || step.kind == Kind::Unplace) step.name = text(json, "name");
    if (of_layer(step)) step.layer = layer_number(json.contains("layer") ? json["layer"] : Json(), "\"layer\"");
    if (step.kind == Kind::Mirror || step.kind == Kind::Show) step.on = flag(json, "on", true);
    if (step.kind == Kind::Material) {
        step.region = text(json, "region");
        if (json.contains("colour")) step.material.colour = text(json, "colour");
        if (json.contains("fabric")) step.material.fabric = text(json, "fabric");
    }
    if (step.kind == Kind::Order) {
        if (!json.contains("layers") || !json["layers"].is_array()) throw Fault("\"layers\" is missing or no list");
        for (const Json& layer : json["layers"]) step.order.push_back(layer_number(layer, "\"layers\""));
    }
    if (step.kind == Kind::Body && json.contains("file"))
        step.name = text(json, "file");
    else if (step.kind == Kind::Body)
        step.body = body_from(json);
    if (step.kind == Kind::Place) step.object = object_from(json);
    if (step.kind == Kind::Edges) step.radius = edge_from(json);  // since version 4
}

void of_later_versions(const DesignStep& step, Json& json) {
    const auto places = [](Vec3 p) { return Json{p.x, p.y, p.z}; };
    if (has_ends(step.kind) && step.starts_to) json["starts_to"] = places(*step.starts_to);
    if (has_ends(step.kind) && step.ends_to) json["ends_to"] = places(*step.ends_to);
    if (step.kind == Kind::Region && !step.region.empty()) json["replaces"] = step.region;
    if (along_line(step.kind)) json["line"] = step.lines.empty() ? std::string() : step.lines.front();
    if (step.kind == Kind::Join) json["at"] = places(step.at);
    if (step.kind == Kind::Meet) json["line"] = step.lines.front();
    if (step.kind == Kind::Meet) json["other"] = step.lines.back();
    if (step.kind == Kind::Meet || step.kind == Kind::Smooth || step.kind == Kind::Bump) {
        json["at"] = places(step.at);
        json["to"] = places(step.to);
    }
    if (step.kind == Kind::Bump) {
        json["wave"] = step.radius;
        json["depth"] = step.depth;
    }
    if ((step.kind == Kind::Rename && !step.region.empty()) || step.kind == Kind::Material)
        json["region"] = step.region;
    if (step.kind == Kind::Rename || step.kind == Kind::Unplace) json["name"] = step.name;
    if (of_layer(step)) json["layer"] = step.layer;
    if (step.kind == Kind::Mirror || step.kind == Kind::Show) json["on"] = step.on;
    if (step.kind == Kind::Material && !step.material.colour.empty()) json["colour"] = step.material.colour;
    if (step.kind == Kind::Material && !step.material.fabric.empty()) json["fabric"] = step.material.fabric;
    if (step.kind == Kind::Order) json["layers"] = step.order;
    if (step.kind == Kind::Body && step.body)
        json["body"] = body_to(*step.body);
    else if (step.kind == Kind::Body)
        json["file"] = step.name;
    if (step.kind == Kind::Place) {
        json["name"] = step.object.name;
        json["model"] = step.object.model;
        json["at"] = places(step.object.at);
        json["scale"] = step.object.scale;
        json["turn"] = places(step.object.turn);
    }
    if (step.kind == Kind::Edges) json["edge_cm"] = step.radius;
}

DesignStep step_from(const Json& json) {
    if (!json.is_object()) throw Fault("it is no object");
    DesignStep step;
    step.kind = from_name(kSteps, text(json, "do"), "step");
    if (has_name(step.kind)) step.name = text(json, "name");
    if (names_region(step.kind)) step.region = text(json, "region");
    if (has_stroke(step.kind)) step.stroke = stroke_from(json);
    if (step.kind == Kind::Region) {
        if (!json.contains("lines") || !json["lines"].is_array()) throw Fault("\"lines\" is missing or no list");
        for (const Json& line : json["lines"]) {
            if (!line.is_string()) throw Fault("a line's name is no text");
            step.lines.push_back(line.get<std::string>());
        }
    }
    if (step.kind == Kind::Region || step.kind == Kind::Alpha) step.alpha = number(json, "alpha", kCoonsAlpha);
    if (step.kind == Kind::Corner || step.kind == Kind::Move || step.kind == Kind::Weld) step.at = place_at(json, "at");
    if (step.kind == Kind::Move || step.kind == Kind::Weld) step.to = place_at(json, "to");
    if (step.kind == Kind::Move) step.radius = number(json, "radius", 0.0);
    if (step.kind == Kind::Region && json.contains("parts")) step.parts = parts_from(json["parts"]);
    if (step.kind == Kind::Associate) {
        if (!json.contains("parts")) throw Fault("\"parts\" is missing");
        step.parts = parts_from(json["parts"]);
    }
    if (has_ends(step.kind) && json.contains("starts_at")) step.starts_at = text(json, "starts_at");
    if (has_ends(step.kind) && json.contains("ends_at")) step.ends_at = text(json, "ends_at");
    if (step.kind == Kind::Corner) step.on = flag(json, "on", true);
    step.with_last = flag(json, "with_last", false);
    of_later_versions(json, step);
    return step;
}

Json step_to(const DesignStep& step) {
    Json json{{"do", to_name(kSteps, step.kind)}};
    if (has_name(step.kind)) json["name"] = step.name;
    if (names_region(step.kind)) json["region"] = step.region;
    if (step.kind == Kind::Region) json["lines"] = step.lines;
    if (step.kind == Kind::Region || step.kind == Kind::Alpha) json["alpha"] = step.alpha;
    if (step.kind == Kind::Associate || (step.kind == Kind::Region && step.parts != 0))
        json["parts"] = names_of_parts(step.parts);
    if (has_ends(step.kind) && !step.starts_at.empty()) json["starts_at"] = step.starts_at;
    if (has_ends(step.kind) && !step.ends_at.empty()) json["ends_at"] = step.ends_at;
    if (step.kind == Kind::Corner || step.kind == Kind::Move || step.kind == Kind::Weld)
        json["at"] = {step.at.x, step.at.y, step.at.z};
    if (step.kind == Kind::Move || step.kind == Kind::Weld) json["to"] = {step.to.x, step.to.y, step.to.z};
    if (step.kind == Kind::Move) json["radius"] = step.radius;
    if (step.kind == Kind::Corner) json["on"] = step.on;
    of_later_versions(step, json);
    if (step.with_last) json["with_last"] = true;
    if (has_stroke(step.kind)) json["stroke"] = stroke_to(step.stroke);
    return json;
}

Design design_from(const Json& document) {
    Design design;
    design.name = text(document, "name");
    design.body = body_from(document);
    design.mirror = flag(document, "mirror", true);
    if (document.contains("edge_cm")) design.network.edge_cm = edge_from(document);
    design.network.snap_cm = number(document, "snap_cm", design.network.snap_cm);
    if (design.network.snap_cm < 0.1 || design.network.snap_cm > 10.0)
        throw Fault("\"snap_cm\" is not between 0.1 and 10");
    design.fitting.clearance_cm = number(document, "clearance_cm", design.fitting.clearance_cm);
    if (design.fitting.clearance_cm < 0.0 || design.fitting.clearance_cm > 5.0)
        throw Fault("\"clearance_cm\" is not between 0 and 5");
    const std::string fairing = document.contains("fairing") ? text(document, "fairing") : "optimised";
    if (fairing != "optimised" && fairing != "particles") throw Fault("\"fairing\" is neither optimised nor particles");
    design.fitting.fairing = fairing == "particles" ? Fairing::Particles : Fairing::Optimised;
    if (!document.contains("steps") || !document["steps"].is_array()) throw Fault("\"steps\" is missing or no list");
    for (const Json& step : document["steps"]) {
        try {
            design.steps.push_back(step_from(step));
        } catch (const Fault& fault) {
            throw Fault("step " + std::to_string(design.steps.size() + 1) + ": " + fault.what());
        }
    }
    return design;
}

std::string line_of(const Json& json) {
    return json.dump(-1, ' ', false, kReplace);
}

}  // namespace

Result<Design> parse_design(std::string_view text_of_file) {
    const auto bad = [](std::string why) {
        if (!why.empty() && why.back() == '.') why.pop_back();
        return unexpected(ErrorCode::BadFormat, "The design cannot be read: " + why + ".");
    };
    if (text_of_file.size() > kMaxTextBytes) return bad("it is longer than 64 MB");
    const Json document = Json::parse(text_of_file, nullptr, false);
    if (document.is_discarded()) return bad("it is no JSON, or it ends early");
    if (!document.is_object() || !document.contains("format") || document["format"] != kFormat)
        return bad(std::string("its \"format\" is not \"") + kFormat + "\"");
    if (!document.contains("version") || !document["version"].is_number_integer()) return bad("it has no \"version\"");
    const auto version = document["version"].get<std::int64_t>();
    if (version < 1) return bad("its \"version\" is below 1");
    if (version > kDesignVersion)
        return unexpected(ErrorCode::NewerVersion,
                          "The design was saved by a newer Croquis: update this one, or save the design as version " +
                              std::to_string(kDesignVersion) + ".");
    try {
        return design_from(document);
    } catch (const Fault& fault) {
        return bad(fault.what());
    }
}

Result<DesignStep> parse_step(std::string_view text_of_step) {
    const Json json = text_of_step.size() > kMaxTextBytes ? Json(Json::value_t::discarded)
                                                          : Json::parse(text_of_step, nullptr, false);
    if (json.is_discarded()) return unexpected(ErrorCode::BadFormat, "The step cannot be read: it is no JSON.");
    try {
        return step_from(json);
    } catch (const Fault& fault) {
        return unexpected(ErrorCode::BadFormat, std::string("The step cannot be read: ") + fault.what() + ".");
    }
}

std::string step_text(const DesignStep& step) {
    return line_of(step_to(step));
}

Result<Design> read_design(const std::string& path) {
    const Result<std::string> bytes = read_file_bytes(path);
    if (!bytes) return unexpected(bytes.error());
    Result<Design> design = parse_design(*bytes);
    if (!design) return unexpected(design.error().code, design.error().message, path);
    return design;
}

std::string design_text(const Design& design) {
    const Json document{{"format", kFormat},
                        {"version", kDesignVersion},
                        {"name", design.name},
                        {"body", body_to(design.body)},
                        {"mirror", design.mirror},
                        {"edge_cm", design.network.edge_cm},
                        {"snap_cm", design.network.snap_cm},
                        {"clearance_cm", design.fitting.clearance_cm},
                        {"fairing", design.fitting.fairing == Fairing::Particles ? "particles" : "optimised"}};
    std::string text = document.dump(1, ' ', false, kReplace);
    text.resize(text.size() - 2);  // the closing bracket: the steps come before it, a line each
    text += ",\n \"steps\": [";
    for (std::size_t i = 0; i < design.steps.size(); ++i)
        text += (i == 0 ? "\n  " : ",\n  ") + line_of(step_to(design.steps[i]));
    return text + "\n ]\n}\n";
}

}  // namespace core
