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
constexpr const char* kFormat = "croquis-garment";

constexpr std::array<std::pair<Kind, const char*>, 11> kSteps{{{Kind::Line, "line"},
                                                               {Kind::Region, "region"},
                                                               {Kind::Cut, "cut"},
                                                               {Kind::Hole, "hole"},
                                                               {Kind::Remove, "remove"},
                                                               {Kind::Corner, "corner"},
                                                               {Kind::Alpha, "alpha"},
                                                               {Kind::Move, "move"},
                                                               {Kind::Weld, "weld"},
                                                               {Kind::Layer, "layer"},
                                                               {Kind::Associate, "associate"}}};
constexpr std::array<std::pair<ToolKind, const char*>, 5> kTools{{{ToolKind::Body, "body"},
                                                                  {ToolKind::PlaneXY, "plane_xy"},
                                                                  {ToolKind::PlaneXZ, "plane_xz"},
                                                                  {ToolKind::PlaneYZ, "plane_yz"},
                                                                  {ToolKind::Temporary, "temporary"}}};
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

DrawingView view_from(const Json& json) {
    Result<DrawingView> view = json.is_string()   ? named_view(json.get<std::string>())
                               : json.is_object() ? perspective_view(place_at(json, "eye"), place_at(json, "target"))
                                                  : unexpected(ErrorCode::BadFormat, "\"view\" is missing");
    if (!view) throw Fault(view.error().message);
    return *view;
}

Json view_to(const DrawingView& view) {
    if (view.eye_distance > 0.0) {
        const Vec3 eye = view.centre + view.toward * view.eye_distance;
        return {{"eye", {eye.x, eye.y, eye.z}}, {"target", {view.centre.x, view.centre.y, view.centre.z}}};
    }
    for (const char* name : kViews)
        if (const DrawingView known = *named_view(name); known.toward == view.toward) return name;
    return "front";
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
    if (has_stroke(step.kind)) json["stroke"] = stroke_to(step.stroke);
    return json;
}

BodyMeasures body_from(const Json& document) {
    const Json& json = document.contains("body") ? document["body"] : throw Fault("\"body\" is missing");
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

Design design_from(const Json& document) {
    Design design;
    design.name = text(document, "name");
    design.body = body_from(document);
    design.mirror = flag(document, "mirror", true);
    design.network.edge_cm = number(document, "edge_cm", design.network.edge_cm);
    if (design.network.edge_cm < 0.3 || design.network.edge_cm > 20.0)
        throw Fault("\"edge_cm\" is not between 0.3 and 20");
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
    if (document["version"].get<int>() > kDesignVersion)
        return unexpected(ErrorCode::NewerVersion,
                          "The design was saved by a newer Croquis: update this one, or save the design as version " +
                              std::to_string(kDesignVersion) + ".");
    try {
        return design_from(document);
    } catch (const Fault& fault) {
        return bad(fault.what());
    }
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
                        {"clearance_cm", design.fitting.clearance_cm},
                        {"fairing", design.fitting.fairing == Fairing::Particles ? "particles" : "optimised"}};
    std::string text = document.dump(1, ' ');
    text.resize(text.size() - 2);  // the closing bracket: the steps come before it, a line each
    text += ",\n \"steps\": [";
    for (std::size_t i = 0; i < design.steps.size(); ++i)
        text += (i == 0 ? "\n  " : ",\n  ") + step_to(design.steps[i]).dump();
    return text + "\n ]\n}\n";
}

}  // namespace core
