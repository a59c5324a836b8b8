// The process that writes is killed; the index holds whole models only, and the build goes on from there.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "db/stores/two_view_index.hpp"
#include "db_fixtures.hpp"

using db::OpenMode;
using db::TwoViewIndex;
using fixture::TemporaryFolder;

namespace {

constexpr int kBatch = 3;
constexpr int kModels = 60;

/// What a build does: passes over what is there, adds the rest in batches.
void build(const std::filesystem::path& path, const std::vector<db::ModelRecord>& models) {
    core::Result<TwoViewIndex> index = TwoViewIndex::open(path, OpenMode::Create, {.parameters = "p"});
    if (!index) return;
    std::vector<db::ModelRecord> batch;
    for (const db::ModelRecord& model : models) {
        const core::Result<bool> known = index->is_unchanged(model.source_path, model.content_hash, model.file_size);
        if (!known) return;
        if (!*known) batch.push_back(model);
        if (batch.size() < kBatch && &model != &models.back()) continue;
        if (!index->add_all(batch)) return;
        batch.clear();
    }
}

std::vector<db::ModelRecord> models() {
    std::vector<db::ModelRecord> all;
    for (int n = 0; n < kModels; ++n) all.push_back(fixture::random_model(n));
    return all;
}

/// How long an undisturbed build takes, so that the kills fall into it.
std::int64_t build_us(const std::vector<db::ModelRecord>& all) {
    const TemporaryFolder folder;
    const auto start = std::chrono::steady_clock::now();
    build(folder / "a.db", all);
    return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - start).count();
}

void build_and_kill(const std::filesystem::path& path, const std::vector<db::ModelRecord>& all, std::int64_t after_us) {
    const pid_t child = fork();
    if (child == 0) {
        build(path, all);
        _exit(0);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(after_us));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
}

}  // namespace

TEST_CASE("killed at any moment, an index holds whole models only and the build goes on", "[crash]") {
    const std::vector<db::ModelRecord> all = models();
    const std::int64_t whole_us = build_us(all);
    fixture::Random random(99);
    int cut_short = 0;
    for (int round = 0; round < 10; ++round) {
        const TemporaryFolder folder;
        build_and_kill(folder / "a.db", all, fixture::whole(random, 0, static_cast<int>(whole_us)));
        if (std::filesystem::exists(folder / "a.db") && std::filesystem::file_size(folder / "a.db") > 0) {
            const core::Result<TwoViewIndex> index =
                TwoViewIndex::open(folder / "a.db", OpenMode::Create, {.parameters = "p"});
            if (!index) FAIL(index.error().sentence());
            CHECK(fixture::value(index->check()).empty());
            const std::size_t there = fixture::value(index->list()).size();
            CHECK(there % kBatch == 0);
            if (there < kModels) ++cut_short;
        }
        build(folder / "a.db", all);
        const TwoViewIndex index =
            fixture::value(TwoViewIndex::open(folder / "a.db", OpenMode::ReadOnly, {.parameters = "p"}));
        CHECK(fixture::value(index.check()).empty());
        const db::LoadedModels loaded = fixture::value(index.load_views());
        REQUIRE(loaded.models.size() == kModels);
        for (std::size_t i = 0; i < loaded.models.size(); ++i) {
            CHECK(loaded.models[i].id == static_cast<std::int64_t>(i) + 1);
            CHECK(loaded.models[i].name == all[i].name);
        }
    }
    CHECK(cut_short > 0);  // else nothing was tried
}
