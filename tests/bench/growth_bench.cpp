// How query and build times grow with the collection. Variants of the models of a real index, their outlines stretched
// and bent a little, fill indexes of 1, 4, 16 and 64 times its size:
//
//     growth_bench INDEX FOLDER [BASE [QUERIES [JOBS]]]
//
// BASE models of INDEX are taken (200), QUERIES variants are searched for (5). Prints a table and draws it as
// FOLDER/growth.png, in processor time of all threads, which is nearly the same whoever else uses the machine; real
// time stands beside it where a visitor waits. "linear" is what the smallest collection would take times the factor.
// Memory: all models of the largest collection are held as a search holds them.

#include <cairo/cairo.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/parts/rounding.hpp"
#include "firmware_like_app/collection/collection.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"

namespace {

constexpr std::array kFactors{1, 4, 16, 64};

[[noreturn]] void give_up(const core::Error& error) {
    std::fprintf(stderr, "growth_bench: %s\n", error.sentence().c_str());
    std::exit(1);
}
template <typename T>
T value(core::Result<T> result) {
    if (!result) give_up(result.error());
    return std::move(*result);
}

/// A gentle bend and stretch of the plane, another for each number.
class Warp {
  public:
    explicit Warp(std::uint64_t number) : random_(number) {
        stretch_ = real(0.85, 1.18);
        turn_ = real(-0.2, 0.2);
        bend_ = real(-0.05, 0.05);
        phase_ = real(0.0, 2.0 * std::numbers::pi);
    }
    [[nodiscard]] core::Point operator()(core::Point p) const {
        const double x = p.x * stretch_ + bend_ * std::sin(4.0 * p.y + phase_);
        const double y = p.y / stretch_ + bend_ * std::sin(4.0 * p.x - phase_);
        return {x * std::cos(turn_) - y * std::sin(turn_), x * std::sin(turn_) + y * std::cos(turn_)};
    }

  private:
    double real(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1.0p-53);
    }
    std::mt19937_64 random_;
    double stretch_ = 1.0, turn_ = 0.0, bend_ = 0.0, phase_ = 0.0;
};

core::ShapeDescriptor warped(const core::ShapeDescriptor& shape, const Warp& warp) {
    core::ShapeDescriptor out = shape;
    for (core::Point& p : out.samples) p = warp(p);
    return core::measure_again(out) ? core::rounded(out).value_or(shape) : shape;
}

db::ModelRecord variant(const db::ModelRecord& model, std::size_t number) {
    db::ModelRecord out = model;
    out.source_path += "#" + std::to_string(number);
    const Warp warp(number);
    for (db::ModelView& view : out.views) {
        view.descriptor = warped(view.descriptor, warp);
        view.outline = view.descriptor.samples;
        if (const auto contour = core::describe_contour(view.outline)) view.contour = *contour;
    }
    return out;
}

std::vector<db::ModelRecord> base_models(const std::string& database, std::size_t count) {
    const db::TwoViewIndex index = value(db::TwoViewIndex::open(database, db::OpenMode::ReadOnly));
    std::vector<db::ModelRecord> models;
    const std::vector<db::ModelEntry> entries = value(index.list());
    count = std::min(count, entries.size());
    for (std::size_t i = 0; i < count; ++i) models.push_back(value(index.load(entries[i * entries.size() / count].id)));
    return models;
}

struct Row {
    std::size_t models = 0;
    // Processor time of all threads, but for the last two:
    double insert_ms = 0.0;  ///< of one model, over the whole build
    double last_ms = 0.0;    ///< of one model, over the last quarter
    double load_ms = 0.0;
    double query_ms = 0.0;        ///< median
    double most_ms = 0.0;         ///< slowest query
    double query_real_ms = 0.0;   ///< median
    double insert_real_ms = 0.0;  ///< of one model, over the whole build
    double bytes = 0.0;           ///< of the file, a model
    double memory = 0.0;          ///< of the loaded collection, bytes a model
};

double resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    double size = 0.0, resident = 0.0;
    statm >> size >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// Processor time of this process so far.
double cpu_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Adds the variants in batches, as a build does.
void build(const std::vector<db::ModelRecord>& base, std::size_t total, const std::string& database, Row& row) {
    constexpr std::size_t kBatch = 16;
    db::TwoViewIndex index = value(db::TwoViewIndex::open(database, db::OpenMode::Create, {.parameters = "growth"}));
    double spent_ms = 0.0, spent_before_ms = 0.0, spent_real_ms = 0.0;
    for (std::size_t first = 0; first < total; first += kBatch) {
        std::vector<db::ModelRecord> batch;
        for (std::size_t i = first; i < std::min(first + kBatch, total); ++i) {
            batch.push_back(variant(base[i % base.size()], i));
        }
        if (first < total - total / 4) spent_before_ms = spent_ms;
        const app::Stopwatch watch;
        const double before = cpu_ms();
        (void)value(index.add_all(batch));
        spent_ms += cpu_ms() - before;
        spent_real_ms += watch.ms();
    }
    row.models = total;
    row.insert_ms = spent_ms / static_cast<double>(total);
    row.insert_real_ms = spent_real_ms / static_cast<double>(total);
    row.last_ms = (spent_ms - spent_before_ms) / (static_cast<double>(total) / 4.0);
    row.bytes = static_cast<double>(value(index.info()).bytes) / static_cast<double>(total);
}

void search(const std::string& database, const std::vector<core::ComparableShape>& queries, int jobs, Row& row) {
    const double before = resident_bytes(), loading = cpu_ms();
    const app::Collection collection = value(app::Collection::load(database));
    row.load_ms = cpu_ms() - loading;
    row.memory = (resident_bytes() - before) / static_cast<double>(row.models);
    std::vector<double> times, cpu_times;
    for (const core::ComparableShape& query : queries) {
        const app::Stopwatch one;
        const double cpu_before = cpu_ms();
        constexpr std::size_t kCards = 10;
        if (collection.nearest({&query, 1}, kCards, jobs).size() != std::min(kCards, row.models))
            give_up({core::ErrorCode::Internal, "a model is missing", ""});
        times.push_back(one.ms());
        cpu_times.push_back(cpu_ms() - cpu_before);
    }
    std::sort(times.begin(), times.end());
    std::sort(cpu_times.begin(), cpu_times.end());
    row.query_ms = cpu_times[cpu_times.size() / 2];
    row.most_ms = cpu_times.back();
    row.query_real_ms = times[times.size() / 2];
}

void print(const std::vector<Row>& rows) {
    std::printf(
        "factor  models   add        the last   load       query      slowest    linear     add        query      "
        "file       memory\n"
        "                 ms/model   quarter    ms         ms         ms         ms         real ms    real ms    "
        "kB/model   kB/model\n");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& r = rows[i];
        std::printf("%5dx %7zu   %-10.2f %-10.2f %-10.0f %-10.1f %-10.1f %-10.1f %-10.2f %-10.1f %-10.1f %-10.0f\n",
                    kFactors[i], r.models, r.insert_ms, r.last_ms, r.load_ms, r.query_ms, r.most_ms,
                    rows[0].query_ms * kFactors[i], r.insert_real_ms, r.query_real_ms, r.bytes / 1000.0,
                    r.memory / 1000.0);
    }
}

/// Both axes in powers of ten; a straight line at 45 degrees is linear growth.
class Plot {
  public:
    Plot() : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 760, 520)), cr_(cairo_create(surface_)) {
        cairo_set_source_rgb(cr_, 1, 1, 1);
        cairo_paint(cr_);
        cairo_select_font_face(cr_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(cr_, 14);
    }
    ~Plot() {
        cairo_destroy(cr_);
        cairo_surface_destroy(surface_);
    }
    Plot(const Plot&) = delete;
    Plot& operator=(const Plot&) = delete;

    void range(double x_low, double x_high, double y_low, double y_high) {
        x_low_ = std::log10(x_low), x_high_ = std::log10(x_high);
        y_low_ = std::log10(y_low), y_high_ = std::log10(y_high);
    }
    void grid(const std::vector<Row>& rows) {
        cairo_set_line_width(cr_, 1);
        for (double power = std::floor(y_low_); power <= y_high_; ++power) {
            for (const double step : {1.0, 2.0, 5.0}) {
                const double ms = step * std::pow(10, power);
                if (std::log10(ms) < y_low_ || std::log10(ms) > y_high_) continue;
                line({kLeft, y(ms)}, {kWidth - kRight, y(ms)}, step == 1.0 ? 0.7 : 0.88);
                char label[32];
                std::snprintf(label, sizeof label, "%g", ms);
                text(label, kLeft - 8, y(ms) + 5, true);
            }
        }
        for (const auto& row : rows) {
            const double at = x(static_cast<double>(row.models));
            line({at, kTop}, {at, kHeight - kBottom}, 0.85);
            text(std::to_string(row.models), at + 16, kHeight - kBottom + 20, true);
        }
        text("models", (kLeft + kWidth - kRight) / 2, kHeight - 12, false);
        text("milliseconds of processor time; dashed: linear growth", 12, 24, false);
    }
    void curve(const std::vector<Row>& rows, const std::function<double(const Row&)>& of, const char* label,
               std::array<double, 3> colour) {
        cairo_set_source_rgb(cr_, colour[0], colour[1], colour[2]);
        cairo_set_line_width(cr_, 2.5);
        cairo_new_path(cr_);
        for (const Row& r : rows) cairo_line_to(cr_, x(static_cast<double>(r.models)), y(of(r)));
        cairo_stroke(cr_);
        for (const Row& r : rows) {
            cairo_arc(cr_, x(static_cast<double>(r.models)), y(of(r)), 4, 0, 2 * std::numbers::pi);
            cairo_fill(cr_);
        }
        double label_y = y(of(rows.back())) + 5;
        while (std::any_of(labels_y_.begin(), labels_y_.end(), [&](double l) { return std::abs(l - label_y) < 17; })) {
            label_y += 3;
        }
        labels_y_.push_back(label_y);
        cairo_move_to(cr_, kWidth - kRight + 8, label_y);
        cairo_show_text(cr_, label);
        // Linear growth from the smallest collection on.
        const std::array<double, 2> dashes{4, 5};
        cairo_set_dash(cr_, dashes.data(), 2, 0);
        cairo_set_line_width(cr_, 1);
        const double factor = static_cast<double>(rows.back().models) / static_cast<double>(rows.front().models);
        cairo_move_to(cr_, x(static_cast<double>(rows.front().models)), y(of(rows.front())));
        cairo_line_to(cr_, x(static_cast<double>(rows.back().models)), y(of(rows.front()) * factor));
        cairo_stroke(cr_);
        cairo_set_dash(cr_, nullptr, 0, 0);
    }
    [[nodiscard]] bool write(const std::string& path) const {
        return cairo_surface_write_to_png(surface_, path.c_str()) == CAIRO_STATUS_SUCCESS;
    }

  private:
    static constexpr double kWidth = 760, kHeight = 520, kLeft = 80, kRight = 130, kTop = 40, kBottom = 60;

    [[nodiscard]] double x(double value) const {
        return kLeft + (std::log10(value) - x_low_) / (x_high_ - x_low_) * (kWidth - kLeft - kRight);
    }
    [[nodiscard]] double y(double value) const {
        return kHeight - kBottom - (std::log10(value) - y_low_) / (y_high_ - y_low_) * (kHeight - kTop - kBottom);
    }
    void line(core::Point from, core::Point to, double grey) {
        cairo_set_source_rgb(cr_, grey, grey, grey);
        cairo_move_to(cr_, from.x, from.y);
        cairo_line_to(cr_, to.x, to.y);
        cairo_stroke(cr_);
    }
    void text(const std::string& words, double at_x, double at_y, bool to_the_left) {
        cairo_text_extents_t extents;
        cairo_text_extents(cr_, words.c_str(), &extents);
        cairo_set_source_rgb(cr_, 0.2, 0.2, 0.2);
        cairo_move_to(cr_, to_the_left ? at_x - extents.width : at_x, at_y);
        cairo_show_text(cr_, words.c_str());
    }

    cairo_surface_t* surface_;
    cairo_t* cr_;
    double x_low_ = 0, x_high_ = 1, y_low_ = 0, y_high_ = 1;
    std::vector<double> labels_y_;
};

bool draw(const std::vector<Row>& rows, const std::string& path) {
    double low = 1e9, high = 0.0;
    const auto total_build = [](const Row& r) { return r.insert_ms * static_cast<double>(r.models); };
    for (const Row& r : rows) {
        low = std::min({low, r.query_ms, r.load_ms, total_build(r)});
        high = std::max({high, r.query_ms, r.load_ms, total_build(r), rows[0].query_ms * kFactors.back()});
    }
    Plot plot;
    plot.range(static_cast<double>(rows.front().models), static_cast<double>(rows.back().models), low * 0.7,
               high * 1.4);
    plot.grid(rows);
    plot.curve(rows, total_build, "adding all", {0.2, 0.5, 0.3});
    plot.curve(rows, [](const Row& r) { return r.load_ms; }, "loading", {0.75, 0.45, 0.1});
    plot.curve(rows, [](const Row& r) { return r.query_ms; }, "one query", {0.15, 0.3, 0.7});
    return plot.write(path);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "growth_bench INDEX FOLDER [BASE [QUERIES [JOBS]]]\n");
        return 2;
    }
    const auto number = [&](int at, int otherwise) { return argc > at ? std::max(1, std::atoi(argv[at])) : otherwise; };
    const std::string folder = argv[2];
    std::filesystem::create_directories(folder);
    const std::vector<db::ModelRecord> base = base_models(argv[1], static_cast<std::size_t>(number(3, 200)));
    if (base.empty()) give_up({core::ErrorCode::BadArgument, "there is no model in it; name another index", argv[1]});
    std::vector<core::ComparableShape> queries;
    for (int q = 0; q < number(4, 5); ++q) {
        const db::ModelRecord drawn =
            variant(base[static_cast<std::size_t>(q) * 7 % base.size()], 1000000u + static_cast<unsigned>(q));
        queries.push_back(core::comparable(drawn.views[0].descriptor, drawn.views[0].contour));
    }
    std::vector<Row> rows;
    for (const int factor : kFactors) {
        const std::string database = folder + "/growth" + std::to_string(factor) + ".db";
        for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(database + end);
        Row row;
        build(base, base.size() * static_cast<std::size_t>(factor), database, row);
        search(database, queries, number(5, core::core_count()), row);
        rows.push_back(row);
        std::filesystem::remove(database);
    }
    print(rows);
    if (!draw(rows, folder + "/growth.png"))
        give_up({core::ErrorCode::WriteFailed, "the plot cannot be written", folder});
    return 0;
}
