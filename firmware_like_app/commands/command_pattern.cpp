#include "firmware_like_app/commands/command_pattern.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/exchange/design_file.hpp"
#include "core/exchange/pattern_files.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "firmware_like_app/commands/garment_form.hpp"
#include "firmware_like_app/commands/print_json.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;

struct PatternCommand {
    std::string design, out, body;
    core::PatternOptions pattern;
    bool json = false;
};

double worst_mismatch(const core::Pattern& pattern) {
    double worst = 0.0;
    for (const core::PatternSeam& seam : pattern.seams) worst = std::max(worst, seam.mismatch());
    return worst;
}

void print_pattern(const core::Pattern& pattern, const std::vector<std::string>& files, double ms, bool as_json) {
    if (as_json) {
        ordered_json pieces = ordered_json::array();
        for (const core::PatternPiece& piece : pattern.pieces)
            pieces.push_back(
                {{"name", piece.name},
                 {"copies", piece.copies},
                 {"on_fold", piece.on_fold},
                 {"strain",
                  {{"mean", piece.mean_strain}, {"high", piece.high_strain}, {"largest", piece.largest_strain}}}});
        ordered_json faults = ordered_json::array();
        for (const core::DesignFault& fault : pattern.faults) faults.push_back(fault.sentence);
        const ordered_json out{{"pieces", pieces},
                               {"seams", pattern.seams.size()},
                               {"largest_mismatch", worst_mismatch(pattern)},
                               {"files", files},
                               {"faults", faults},
                               {"ms", ms}};
        print_json(out);
        return;
    }
    for (const core::PatternPiece& piece : pattern.pieces)
        std::printf("%-20s cut %d%s; strain %.2f %% on average, %.1f %% exceeded by a hundredth of it%s\n",
                    piece.name.c_str(), piece.copies, piece.on_fold ? " on the fold" : "", 100.0 * piece.mean_strain,
                    100.0 * piece.high_strain, piece.high_strain > core::kDartStrain ? ": wants a dart" : "");
    std::printf("%zu seams, their sides alike within %.2f %%\n", pattern.seams.size(), 100.0 * worst_mismatch(pattern));
    for (const std::string& file : files) std::printf("%s\n", file.c_str());
}

void run_pattern(const PatternCommand& options, CommandState& state) {
    const core::Result<core::Design> design = core::read_design(options.design);
    if (!design) return fail(state, design.error());
    const core::Result<core::DressForm> form = form_for(*design, options.body);
    if (!form) return fail(state, form.error());
    const core::Result<core::Garment> garment = core::make_garment(*design, *form);
    if (!garment) return fail(state, garment.error());
    const Stopwatch watch;
    core::Result<core::Pattern> pattern = core::make_pattern(*design, *garment, options.pattern);
    if (!pattern) return fail(state, {pattern.error().code, pattern.error().message, options.design});
    const double ms = watch.ms();
    const core::Result<std::vector<std::string>> files = core::write_pattern_folder(options.out, *pattern);
    if (!files) return fail(state, files.error());
    pattern->faults.insert(pattern->faults.begin(), garment->faults.begin(), garment->faults.end());
    print_pattern(*pattern, *files, ms, options.json);
    for (const core::DesignFault& fault : pattern->faults)
        fail(state, {core::ErrorCode::BadFormat,
                     fault.step > 0 ? "step " + std::to_string(fault.step) + ": " + fault.sentence : fault.sentence,
                     options.design});
}

}  // namespace

void add_pattern_command(Command garment, CommandState& state) {
    auto options = std::make_shared<PatternCommand>();
    Command command = garment.command("pattern", "Flat pieces of a saved design: SVG, PDF, DXF, seams");
    command.option("DESIGN", options->design, "design file").required();
    command.option("--out", options->out, "folder to write to").required();
    command.option("--body", options->body, "a closed mesh to dress in place of the design's mannequin");
    command.option("--seam", options->pattern.seam_allowance_cm, "seam allowance in cm")
        .range(0.0, 10.0)
        .show_default();
    command.option("--hem", options->pattern.hem_allowance_cm, "hem allowance in cm").range(0.0, 10.0).show_default();
    command.flag("--json", options->json, "one JSON object on standard output");
    command.runs([options, &state] { run_pattern(*options, state); });
}

}  // namespace app
