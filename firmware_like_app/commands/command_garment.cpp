// croquis garment: fill makes the quads of one region of cloth, build a whole garment, wardrobe writes worked designs.

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "core/exchange/design_file.hpp"
#include "core/exchange/file_bytes.hpp"
#include "core/exchange/glb_writer.hpp"
#include "core/exchange/obj_writer.hpp"
#include "core/exchange/region_reader.hpp"
#include "core/garment/drape.hpp"
#include "core/garment/region.hpp"
#include "core/garment/subdivision.hpp"
#include "core/garment/texture.hpp"
#include "core/garment/wardrobe.hpp"
#include "core/mannequin/mannequin.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "firmware_like_app/commands/command_designs.hpp"
#include "firmware_like_app/commands/command_pattern.hpp"
#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/garment_form.hpp"
#include "firmware_like_app/commands/print_json.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;

struct FillOptions {
    std::string region, out;
    double alpha = core::kCoonsAlpha;
    bool json = false;
};

struct FillTimes {
    double topology_ms = 0.0, solve_ms = 0.0;
};

void print_fill(const core::FilledRegion& filled, const FillTimes& times, bool as_json) {
    const core::QuadDiscCounts& counts = filled.topology.counts;
    if (!as_json) {
        std::printf("%zu vertices, %zu quads, irregular: %d inside, %d on the boundary; alpha %g; %.2f + %.2f ms\n",
                    filled.mesh.vertices.size(), filled.mesh.quads.size(), counts.irregular_interior,
                    counts.irregular_boundary, filled.alpha, times.topology_ms, times.solve_ms);
        return;
    }
    ordered_json valences = ordered_json::object();
    for (std::size_t valence = 3; valence < counts.interior_by_valence.size(); ++valence)
        valences[std::to_string(valence)] = counts.interior_by_valence[valence];
    const ordered_json out{{"vertices", filled.mesh.vertices.size()},
                           {"quads", filled.mesh.quads.size()},
                           {"irregular_interior", counts.irregular_interior},
                           {"irregular_boundary", counts.irregular_boundary},
                           {"valences", valences},
                           {"alpha", filled.alpha},
                           {"ms", {{"topology", times.topology_ms}, {"solve", times.solve_ms}}}};
    print_json(out);
}

core::Result<core::FilledRegion> fill(const FillOptions& options, FillTimes& times) {
    const core::Result<core::RegionOutline> outline = core::read_region(options.region);
    if (!outline) return core::unexpected(outline.error());
    const auto blame = [&](const core::Error& error) {
        return core::unexpected(error.code, error.message, options.region);
    };
    const core::Result<std::vector<core::Vec3>> ring = core::outline_ring(*outline);
    if (!ring) return blame(ring.error());
    const Stopwatch topology_watch;
    core::Result<core::RegionTopology> topology = core::outline_topology(*outline);
    if (!topology) return blame(topology.error());
    times.topology_ms = topology_watch.ms();
    const Stopwatch solve_watch;
    core::FilledRegion filled = core::fill_ring(std::move(*topology), *ring, options.alpha);
    times.solve_ms = solve_watch.ms();
    return filled;
}

void run_fill(const FillOptions& options, CommandState& state) {
    if (const auto named = check_ending(options.out, {"obj"}); !named) return fail_call(state, named.error());
    FillTimes times;
    const core::Result<core::FilledRegion> filled = fill(options, times);
    if (!filled) return fail(state, filled.error());
    if (const auto written = core::write_obj_file(options.out, filled->mesh); !written)
        return fail(state, written.error());
    if (filled->alpha != options.alpha) {
        std::fprintf(
            stderr,
            "croquis: %s: alpha %g was used in place of %g, with which the cloth folds over itself, swings far "
            "out of its outline or is not determined\n",
            options.region.c_str(), filled->alpha, options.alpha);
    }
    print_fill(*filled, times, options.json);
}

struct BuildOptions {
    std::string design, out, body;
    int smooth = 0;
    double drape_s = 0.0;
    bool json = false;
};

/// Finer layers, off the body and off each other again.
core::Result<void> smooth_layers(core::Garment& garment, const core::Design& design, const core::DressForm& form,
                                 int levels) {
    core::Result<core::Obstacle> obstacle = core::Obstacle::of_body(form);
    if (!obstacle) return core::unexpected(obstacle.error());
    core::FittingOptions options = design.fitting;
    options.rounds = 2;
    for (core::FinishedLayer& layer : garment.layers) {
        core::Result<core::Cloth> finer = core::subdivided(layer.fitted, levels);
        if (!finer) return core::unexpected(finer.error());
        layer.fitted = std::move(*finer);
        const double before = layer.report.deepest_before_cm;
        layer.report = core::fit_cloth(layer.fitted, *obstacle, options);
        layer.report.deepest_before_cm = before;
        obstacle->add_layer(layer.fitted.mesh);
    }
    return {};
}

/// Hangs all layers together for some seconds.
core::Result<void> drape_layers(core::Garment& garment, const core::DressForm& form, double seconds) {
    const core::Result<core::Obstacle> obstacle = core::Obstacle::of_body(form);
    if (!obstacle) return core::unexpected(obstacle.error());
    core::Drape drape(core::joined_layers(garment.layers), *obstacle, {}, core::banded(garment.layers, *obstacle));
    for (int step = 0; step < static_cast<int>(60.0 * seconds); ++step) drape.step();
    core::put_places(drape.places(), garment.layers);
    return {};
}

constexpr std::array<core::Rgb, 6> kCloth{
    {{86, 112, 156}, {168, 84, 78}, {110, 138, 96}, {180, 150, 90}, {128, 100, 140}, {90, 140, 140}}};

core::Result<void> write_garment(const core::Garment& garment, const std::string& path) {
    if (core::lower_extension(path) == "glb") {
        std::vector<core::GlbMesh> meshes;
        for (std::size_t i = 0; i < garment.layers.size(); ++i)
            for (const core::ClothPiece& piece : garment.layers[i].fitted.pieces)
                meshes.push_back({piece.name, &garment.layers[i].fitted.mesh, piece.first, piece.count,
                                  kCloth[i % kCloth.size()], true, &garment.layers[i].fitted.texture});
        return core::write_glb_file(path, meshes);
    }
    core::QuadMesh all;
    std::vector<core::QuadGroup> groups;
    std::vector<core::QuadTexture> texture;
    for (const core::FinishedLayer& layer : garment.layers) {
        const auto shift = static_cast<std::uint32_t>(all.vertices.size());
        for (const core::ClothPiece& piece : layer.fitted.pieces)
            groups.push_back({piece.name, all.quads.size() + piece.first, piece.count});
        all.vertices.insert(all.vertices.end(), layer.fitted.mesh.vertices.begin(), layer.fitted.mesh.vertices.end());
        texture.insert(texture.end(), layer.fitted.texture.begin(), layer.fitted.texture.end());
        for (const core::Quad& q : layer.fitted.mesh.quads)
            all.quads.push_back({q[0] + shift, q[1] + shift, q[2] + shift, q[3] + shift});
    }
    return core::write_obj_file(path, all, groups, texture);
}

ordered_json to_json(const core::FinishedLayer& layer, const core::TextureReport& texture) {
    ordered_json pieces = ordered_json::array();
    for (const core::ClothPiece& piece : layer.fitted.pieces)
        pieces.push_back({{"name", piece.name},
                          {"quads", piece.count},
                          {"irregular_interior", piece.counts.irregular_interior},
                          {"irregular_boundary", piece.counts.irregular_boundary},
                          {"alpha", piece.alpha}});
    return {{"pieces", pieces},
            {"vertices", layer.fitted.mesh.vertices.size()},
            {"quads", layer.fitted.mesh.quads.size()},
            {"penetration_cm", {{"drawn", layer.report.deepest_before_cm}, {"fitted", layer.report.deepest_after_cm}}},
            {"closest_cm", layer.report.closest_cm},
            {"self_crossings", {{"before", layer.report.self_crossings_before}, {"left", layer.report.self_crossings}}},
            {"strain", {{"mean", layer.report.mean_stretch}, {"largest", layer.report.largest_stretch}}},
            {"texture_strain", {{"mean", texture.mean_strain}, {"largest", texture.largest_strain}}}};
}

void print_garment(const core::Garment& garment, const std::vector<core::TextureReport>& texture, double ms,
                   bool as_json) {
    if (as_json) {
        ordered_json layers = ordered_json::array(), faults = ordered_json::array();
        for (std::size_t i = 0; i < garment.layers.size(); ++i)
            layers.push_back(to_json(garment.layers[i], texture[i]));
        for (const core::DesignFault& fault : garment.faults)
            faults.push_back({{"step", fault.step}, {"why", fault.sentence}});
        print_json(ordered_json{{"layers", layers}, {"faults", faults}, {"ms", ms}});
        return;
    }
    for (const core::FinishedLayer& layer : garment.layers)
        std::printf(
            "%zu pieces, %zu quads; up to %.2f cm inside as drawn, %.2f cm after fitting; strain %.1f %% on average\n",
            layer.fitted.pieces.size(), layer.fitted.mesh.quads.size(), layer.report.deepest_before_cm,
            layer.report.deepest_after_cm, 100.0 * layer.report.mean_stretch);
}

void run_build(const BuildOptions& options, CommandState& state) {
    if (const auto named = check_ending(options.out, {"obj", "glb"}); !named) return fail_call(state, named.error());
    const core::Result<core::Design> design = core::read_design(options.design);
    if (!design) return fail(state, design.error());
    const core::Result<core::DressForm> form = form_for(*design, options.body);
    if (!form) return fail(state, form.error());
    const Stopwatch watch;
    core::Result<core::Garment> garment = core::make_garment(*design, *form);
    if (!garment) return fail(state, garment.error());
    std::vector<core::TextureReport> texture;
    for (core::FinishedLayer& layer : garment->layers) texture.push_back(core::lay_texture(layer.fitted));
    if (options.smooth > 0)
        if (const auto done = smooth_layers(*garment, *design, *form, options.smooth); !done)
            return fail(state, done.error());
    if (options.drape_s > 0.0)
        if (const auto done = drape_layers(*garment, *form, options.drape_s); !done) return fail(state, done.error());
    const double ms = watch.ms();
    if (const auto written = write_garment(*garment, options.out); !written) return fail(state, written.error());
    print_garment(*garment, texture, ms, options.json);
    for (std::size_t i = 0; i < garment->layers.size(); ++i)
        if (const std::string warning = core::fitting_warning(garment->layers[i].report); !warning.empty())
            std::fprintf(stderr, "croquis: %s: warning: layer %zu: %s\n", options.design.c_str(), i + 1,
                         warning.c_str());
    for (const core::DesignFault& fault : garment->faults)
        fail(state, {core::ErrorCode::BadFormat,
                     fault.step > 0 ? "step " + std::to_string(fault.step) + ": " + fault.sentence : fault.sentence,
                     options.design});
}

struct WardrobeOptions {
    std::string out, size = "38";
};

void run_wardrobe(const WardrobeOptions& options, CommandState& state) {
    const core::Result<core::BodyMeasures> measures = core::measures_of_size(options.size);
    if (!measures) return fail(state, measures.error());
    const core::Result<core::Mannequin> body = core::make_mannequin(*measures);
    if (!body) return fail(state, body.error());
    std::error_code failed;
    std::filesystem::create_directories(options.out, failed);
    for (const std::string& name : core::wardrobe_names()) {
        const std::filesystem::path path = std::filesystem::path(options.out) / (name + ".json");
        std::ofstream file(path, std::ios::binary | std::ios::trunc);
        const core::Design design = core::recorded(*core::wardrobe_design(name, *body), core::dress_form(*body));
        if (!(file << core::design_text(design)).flush())
            return fail(state, {core::ErrorCode::WriteFailed, "The design cannot be written; check the folder.",
                                path.string()});
        std::printf("%s\n", path.c_str());
    }
}

void add_build_command(Command garment, CommandState& state) {
    auto options = std::make_shared<BuildOptions>();
    Command command = garment.command("build", "The whole garment of a saved design");
    command.option("DESIGN", options->design, "design file").required();
    command.option("--out", options->out, "F.obj or F.glb to write").required();
    command.option("--body", options->body, "a closed mesh to dress in place of the design's mannequin");
    command.option("--smooth", options->smooth, "levels of Catmull-Clark subdivision").range(0, 3);
    command.option("--drape", options->drape_s, "seconds that the garment hangs under gravity before it is written")
        .range(0.0, 60.0);
    command.flag("--json", options->json, "one JSON object on standard output");
    command.runs([options, &state] { run_build(*options, state); });
}

void add_wardrobe_command(Command garment, CommandState& state) {
    auto options = std::make_shared<WardrobeOptions>();
    Command command = garment.command("wardrobe", "Writes the worked designs as design files");
    command.option("--out", options->out, "folder to write to").required();
    command.option("--size", options->size, "the mannequin they are drawn on").show_default();
    command.runs([options, &state] { run_wardrobe(*options, state); });
}

}  // namespace

void add_garment_commands(Command cli, CommandState& state) {
    Command garment = cli.group("garment", "Cloth from outlines");
    auto options = std::make_shared<FillOptions>();
    Command command = garment.command("fill", "Quad mesh of one region");
    command.option("REGION", options->region, "JSON: {\"sides\": [[[x, y, z], ...], ...]}, sides in order").required();
    command.option("--out", options->out, "the OBJ file to write").required();
    command
        .option("--alpha", options->alpha,
                "-0.25: the boundary's shape reaches far in (discrete Coons); 0: flat (harmonic)")
        .range(-0.25, 0.0)
        .show_default();
    command.flag("--json", options->json, "one JSON object on standard output");
    command.runs([options, &state] { run_fill(*options, state); });
    add_build_command(garment, state);
    add_wardrobe_command(garment, state);
    add_pattern_command(garment, state);
    add_designs_command(garment, state);
}

}  // namespace app
