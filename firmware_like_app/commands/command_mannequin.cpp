// croquis mannequin: a body from measures.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "core/exchange/obj_writer.hpp"
#include "core/mannequin/mannequin.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/print_json.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;

struct MannequinOptions {
    std::string size = "38", out;
    std::vector<std::string> measures;  // NAME=CM
    bool json = false;
};

core::Result<core::BodyMeasures> asked_measures(const MannequinOptions& options) {
    core::Result<core::BodyMeasures> measures = core::measures_of_size(options.size);
    if (!measures) return measures;
    for (const std::string& text : options.measures) {
        const std::size_t equals = text.find('=');
        char* end = nullptr;
        const double cm = equals == std::string::npos ? 0.0 : std::strtod(text.c_str() + equals + 1, &end);
        if (equals == std::string::npos || end == text.c_str() + equals + 1 || *end != '\0')
            return core::unexpected(core::ErrorCode::BadArgument,
                                    "The measure \"" + text + "\" is not NAME=CM, as in waist=72.5.");
        const auto set = core::set_measure(*measures, text.substr(0, equals), cm);
        if (!set) return core::unexpected(set.error());
    }
    return measures;
}

/// The mesh with its quads in the order of their parts, and the groups.
std::vector<core::QuadGroup> group_parts(const core::Mannequin& body, core::QuadMesh& mesh) {
    mesh.vertices = body.mesh.vertices;
    std::vector<core::QuadGroup> groups;
    for (std::size_t part = 0; part < core::kBodyPartCount; ++part) {
        core::QuadGroup group{core::body_part_name(static_cast<core::BodyPart>(part)), mesh.quads.size(), 0};
        for (std::size_t q = 0; q < body.mesh.quads.size(); ++q)
            if (body.part_of_quad[q] == static_cast<core::BodyPart>(part)) mesh.quads.push_back(body.mesh.quads[q]);
        group.count = mesh.quads.size() - group.first;
        if (group.count > 0) groups.push_back(group);
    }
    return groups;
}

ordered_json to_json(const std::vector<core::ReachedMeasure>& measures) {
    ordered_json list = ordered_json::array();
    for (const core::ReachedMeasure& m : measures)
        list.push_back({{"name", m.name},
                        {"asked_cm", m.asked_cm},
                        {"reached_cm", m.reached_cm},
                        {"at", {m.plane.origin.x, m.plane.origin.y, m.plane.origin.z}}});
    return list;
}

void print(const core::Mannequin& body, double ms, bool as_json) {
    if (as_json) {
        ordered_json landmarks = ordered_json::object();
        for (const core::Landmark& l : body.landmarks) landmarks[l.name] = {l.place.x, l.place.y, l.place.z};
        const ordered_json out{{"girths", to_json(body.girths)},
                               {"heights", to_json(body.heights)},
                               {"landmarks", landmarks},
                               {"vertices", body.mesh.vertices.size()},
                               {"faces", body.mesh.quads.size()},
                               {"closed", body.closed},
                               {"ms", ms}};
        print_json(out);
        return;
    }
    const auto row = [](const char* kind, const core::ReachedMeasure& m) {
        std::printf("%-7s %-11s asked %6.1f cm, reached %7.2f cm\n", kind, m.name.c_str(), m.asked_cm, m.reached_cm);
    };
    for (const core::ReachedMeasure& m : body.girths) row("girth", m);
    for (const core::ReachedMeasure& m : body.heights) row("height", m);
    std::printf("%zu vertices, %zu quads, %s, %.0f ms\n", body.mesh.vertices.size(), body.mesh.quads.size(),
                body.closed ? "closed" : "not closed", ms);
}

void run(const MannequinOptions& options, CommandState& state) {
    if (const auto named = check_ending(options.out, {"obj"}); !named) return fail_call(state, named.error());
    const core::Result<core::BodyMeasures> measures = asked_measures(options);
    if (!measures) return fail(state, measures.error());
    const Stopwatch watch;
    const core::Result<core::Mannequin> body = core::make_mannequin(*measures);
    if (!body) return fail(state, body.error());
    const double ms = watch.ms();
    core::QuadMesh mesh;
    const std::vector<core::QuadGroup> groups = group_parts(*body, mesh);
    if (const auto written = core::write_obj_file(options.out, mesh, groups); !written)
        return fail(state, written.error());
    print(*body, ms, options.json);
}

}  // namespace

void add_mannequin_command(Command cli, CommandState& state) {
    auto options = std::make_shared<MannequinOptions>();
    Command command = cli.command("mannequin", "A body from measurements");
    command.option("--size", options->size, "36 to 44: a woman's EU size; m: a man's").show_default();
    command.option("--measure", options->measures, "NAME=CM, replaces one measure of the size; may be repeated")
        .repeated();
    command.option("--out", options->out, "the OBJ file to write; a group for each part of the body").required();
    command.flag("--json", options->json, "one JSON object on standard output");
    command.runs([options, &state] { run(*options, state); });
}

}  // namespace app
