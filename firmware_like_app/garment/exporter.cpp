#include "firmware_like_app/garment/exporter.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/exchange/design_file.hpp"
#include "core/exchange/png_writer.hpp"
#include "firmware_like_app/garment/turntable.hpp"

namespace app {
namespace {

using Stage = ExportState::Stage;
using Report = std::function<void(const ExportState&)>;

constexpr double kDressed = 0.35, kPictured = 0.7;  // shares of the work done by then

/// One export on its way: each step adds files, or ends it.
class Export {
  public:
    Export(const ExportJob& job, const Report& report, const std::stop_token& stop)
        : job_(job), report_(report), stop_(stop) {}

    ExportState run() {
        go_on(Stage::Dressing, 0.0);
        if (job_.place.path.empty())
            return fail({ExportFault::Kind::NoPlace,
                         {core::ErrorCode::FileMissing, "no USB stick was found; plug one in and export again", {}}});
        if (!has_region(job_.design)) return fail(nothing());
        const core::Result<DressedDesign> dressed = dress(job_.design, job_.bodies, job_.models, stop_);
        if (!dressed) return fail(dressed.error());
        state_.warnings = dressed->faults;
        if (!has_cloth(*dressed)) return fail(nothing());
        if (const core::Result<void> done = add_files(*dressed); !done) return fail(done.error());
        if (const core::Result<void> done = add_pictures(*dressed); !done) return fail(done.error());
        return write();
    }

  private:
    static ExportFault nothing() {
        return {ExportFault::Kind::Nothing,
                {core::ErrorCode::EmptyMesh, "there is no cloth yet; draw an outline first", {}}};
    }
    /// What needs no body to be made.
    static bool has_region(const core::Design& design) {
        return std::any_of(design.steps.begin(), design.steps.end(),
                           [](const core::DesignStep& step) { return step.kind == core::DesignStep::Kind::Region; });
    }
    static bool has_cloth(const DressedDesign& dressed) {
        for (const core::FinishedLayer& layer : dressed.garment.layers)
            if (!layer.fitted.mesh.quads.empty()) return true;
        return false;
    }

    core::Result<void> add_files(const DressedDesign& dressed) {
        const ExportPlan& plan = job_.plan;
        if (plan.design) files_.push_back({"design.json", core::design_text(job_.design)});
        if (plan.model) {
            core::Result<std::string> obj = garment_obj(dressed), glb = garment_glb(dressed);
            if (!obj) return core::unexpected(obj.error());
            if (!glb) return core::unexpected(glb.error());
            files_.push_back({"garment.obj", std::move(*obj)});
            files_.push_back({"garment.glb", std::move(*glb)});
        }
        if (!plan.print_pattern && !plan.cut_pattern) return {};
        core::Result<std::vector<NamedBytes>> pattern = pattern_files(dressed, plan);
        if (!pattern) {
            state_.warnings.push_back(pattern.error().sentence());
            return {};
        }
        for (NamedBytes& file : *pattern) files_.push_back(std::move(file));
        return {};
    }

    core::Result<void> add_pictures(const DressedDesign& dressed) {
        const int count = job_.plan.pictures;
        go_on(Stage::Pictures, kDressed);
        if (count <= 0) return {};
        core::Result<Turntable> table = Turntable::create(dressed);
        if (!table) {
            state_.warnings.push_back(table.error().sentence());
            return {};
        }
        const ui::SizePx size{job_.plan.picture_px * 3 / 4, job_.plan.picture_px};
        for (int k = 0; k < count; ++k) {
            if (stop_.stop_requested()) return core::unexpected(core::ErrorCode::Cancelled, "the export was stopped");
            const core::Result<std::vector<std::byte>> png = core::png_bytes(table->picture(k, count, size));
            if (!png) return core::unexpected(png.error());
            const std::string number = std::to_string(1001 + k).substr(k < 99 ? 2 : 1);
            files_.push_back(
                {"turn-" + number + ".png", std::string(reinterpret_cast<const char*>(png->data()), png->size())});
            go_on(Stage::Pictures, kDressed + (kPictured - kDressed) * (k + 1) / count);
        }
        return {};
    }

    ExportState write() {
        go_on(Stage::Writing, kPictured);
        FolderReport written = write_new_folder(
            job_.place, job_.design.name, files_,
            [this](double share) { go_on(Stage::Writing, kPictured + (1.0 - kPictured) * share); }, stop_);
        if (written.fault) return fail(std::move(*written.fault));
        state_.folder = written.folder;
        go_on(Stage::Saved, 1.0);
        return state_;
    }

    void go_on(Stage stage, double share) {
        state_.stage = stage;
        state_.share = share;
        if (report_) report_(state_);
    }

    ExportState fail(ExportFault fault) {
        state_.fault = std::move(fault);
        go_on(Stage::Failed, state_.share);
        return state_;
    }
    ExportState fail(const core::Error& error) {
        const bool stopped = error.code == core::ErrorCode::Cancelled;
        return fail(ExportFault{stopped ? ExportFault::Kind::Cancelled : ExportFault::Kind::Failed, error});
    }

    const ExportJob& job_;
    const Report& report_;
    const std::stop_token& stop_;
    ExportState state_;
    std::vector<NamedBytes> files_;
};

}  // namespace

ExportState run_export(const ExportJob& job, const Report& report, const std::stop_token& stop) {
    try {
        return Export(job, report, stop).run();
    } catch (const std::exception& error) {  // out of memory and the like
        ExportState failed;
        failed.stage = Stage::Failed;
        failed.fault = {ExportFault::Kind::Failed,
                        {core::ErrorCode::Internal, std::string("the export was given up (") + error.what() + ")", {}}};
        if (report) report(failed);
        return failed;
    }
}

bool Exporter::start(ExportJob job) {
    if (is_running()) return false;
    if (thread_.joinable()) thread_.join();
    state_ = {.stage = Stage::Dressing};  // no thread runs that could look
    forgotten_ = false;
    const auto keep = [this](const ExportState& state) {
        const std::lock_guard lock(mutex_);
        state_ = state;
    };
    thread_ =
        std::jthread([keep, job = std::move(job)](const std::stop_token& stop) { keep(run_export(job, keep, stop)); });
    return true;
}

ExportState Exporter::whole_state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

ExportState Exporter::state() const {
    const ExportState now = whole_state();
    if (!forgotten_) return now;
    return is_running() ? ExportState{.stage = now.stage, .share = now.share} : ExportState{};
}

bool Exporter::is_running() const {
    const Stage stage = whole_state().stage;
    return stage == Stage::Dressing || stage == Stage::Pictures || stage == Stage::Writing;
}

}  // namespace app
