// Kills `croquis index build` at random moments, again and again, and looks at what is left:
//
//     kill_builds CROQUIS FOLDER [KILLS [MODELS [SEED]]]
//
// Models are written to FOLDER, which is made anew, and built once without disturbance. Then builds are killed
// (SIGKILL) after a random time; after each kill `index check` must find whole models only, and the next build goes on.
// A build that gets to its end must give the same index as the undisturbed one, ids and every byte of every blob
// included. The last line says how many of the kills left a whole index. Exit code 0 when all did and all indexes were
// the same.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "db/stores/two_view_index.hpp"
#include "tests/support/block_models.hpp"
#include "tests/support/index_rows.hpp"

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;

/// Some through our own reader, some through assimp's in its process.
void write_models(const std::string& folder, int count) {
    fs::create_directories(folder);
    for (int n = 0; n < count; ++n) {
        const core::TriangleMesh mesh = support::block_model(n);
        const std::string stem = folder + "/m" + std::to_string(1000 + n);
        if (n % 4 != 0) {
            std::ofstream(stem + ".off") << support::off_text(mesh);
            continue;
        }
        std::ofstream obj(stem + ".obj");
        for (const core::Vec3& v : mesh.vertices) obj << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
        for (const auto& t : mesh.triangles) obj << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    }
}

/// How a run of the program ended.
struct End {
    bool killed = false;
    int code = 0;
};

/// Runs the program quietly; killed after `patience` if that is not negative.
End run(const std::vector<std::string>& words, microseconds patience = microseconds(-1)) {
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char*> arguments;
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(127);
        execv(arguments[0], arguments.data());
        _exit(127);
    }
    if (patience.count() >= 0) {
        std::this_thread::sleep_for(patience);
        kill(child, SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) return {false, WEXITSTATUS(status)};
    return {WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL, 1};
}

void run_to_the_end(const std::vector<std::string>& words) {
    if (const End end = run(words); end.killed || end.code != 0) {
        throw std::runtime_error("a build that was not killed ended with exit code " + std::to_string(end.code));
    }
}

class Rounds {
  public:
    Rounds(std::string croquis, std::string folder, std::uint64_t seed)
        : croquis_(std::move(croquis)), folder_(std::move(folder)), random_(seed) {}

    void build_undisturbed() {
        const Clock::time_point start = Clock::now();
        run_to_the_end(build(folder_ + "/whole.db"));
        whole_ = std::chrono::duration_cast<microseconds>(Clock::now() - start);
        expected_ = support::index_rows(folder_ + "/whole.db");
    }

    /// Kills until `kills` have hit. Gives the number of faults.
    int go(int kills) {
        const std::string database = folder_ + "/killed.db";
        while (hit_ < kills) {
            const auto patience =
                microseconds(static_cast<std::int64_t>(random_() % 1000000) * whole_.count() / 2000000);
            const End end = run(build(database), patience);
            if (!end.killed && end.code != 0) throw std::runtime_error("a build went wrong before it was killed");
            if (!end.killed) {
                finish(database);
                continue;
            }
            ++hit_;
            check(database);
        }
        run_to_the_end(build(database));
        finish(database);
        std::printf(
            "%d of %d kills left a whole index (%d before a model was in); %d builds gone on with to the end, %d "
            "of them with the index of an undisturbed one\n",
            hit_ - broken_, hit_, before_any_, finished_, finished_ - different_);
        return broken_ + different_;
    }

  private:
    [[nodiscard]] std::vector<std::string> build(const std::string& database) const {
        return {croquis_, "index", "build", folder_ + "/models", "--db", database};
    }

    void check(const std::string& database) {
        if (!fs::exists(database) || fs::file_size(database) == 0) {
            ++before_any_;
            return;
        }
        if (run({croquis_, "index", "check", "--db", database}).code != 0) {
            ++broken_;
            std::printf("after kill %d the check finds a fault\n", hit_);
            return;
        }
        const auto index = db::TwoViewIndex::open(database, db::OpenMode::ReadOnly);
        const auto models = index ? index->list() : core::unexpected(index.error());
        if (!models) throw std::runtime_error(models.error().sentence());
        if (models->empty()) ++before_any_;
    }

    void finish(const std::string& database) {
        ++finished_;
        if (support::index_rows(database) != expected_) {
            ++different_;
            std::printf("build %d gave another index\n", finished_);
        }
        for (const char* end : {"", "-wal", "-shm"}) fs::remove(database + end);
    }

    std::string croquis_, folder_;
    std::mt19937_64 random_;
    microseconds whole_{0};
    std::string expected_;
    int hit_ = 0, broken_ = 0, before_any_ = 0, finished_ = 0, different_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "kill_builds CROQUIS FOLDER [KILLS [MODELS [SEED]]]\n");
        return 2;
    }
    const auto number = [&](int at, int otherwise) { return argc > at ? std::atoi(argv[at]) : otherwise; };
    const std::string folder = fs::absolute(argv[2]);
    try {
        fs::remove_all(folder);
        write_models(folder + "/models", number(4, 100));
        Rounds rounds(fs::absolute(argv[1]), folder, static_cast<std::uint64_t>(number(5, 1)));
        rounds.build_undisturbed();
        return rounds.go(number(3, 50)) == 0 ? 0 : 1;
    } catch (const std::exception& error) {
        std::printf("%s\n", error.what());
        return 1;
    }
}
