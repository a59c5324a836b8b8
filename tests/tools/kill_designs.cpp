// Kills a program that draws garments at random moments, again and again, and looks at what is left:
//
//     kill_designs FOLDER [KILLS [SEED]]
//
// A child process draws worked designs, act by act, undone and done again at times, into a file of designs in FOLDER
// (made anew) through the journal that the screen uses, and says after each act up to which number the journal has
// acknowledged. It is killed (SIGKILL) after a random time. Then every acknowledged act must be there, the design must
// be exactly what these acts make, and the file without a fault; the next child goes on from there. The last line says
// how many of the kills lost nothing. Exit code 0 when none did.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/exchange/design_file.hpp"
#include "core/garment/wardrobe.hpp"
#include "db/stores/design_journal.hpp"

namespace {

namespace fs = std::filesystem;
using db::JournalEntry;

constexpr int kWholeEach = 29;      // every so many numbers the whole design is kept
constexpr int kMostEntries = 1500;  // then a new design is begun

/// What is drawn: number n of the entries, the same for the same n.
class Drawing {
  public:
    Drawing() {
        const core::Result<core::Mannequin> body = core::make_mannequin(*core::measures_of_size("38"));
        if (!body) throw std::runtime_error(body.error().sentence());
        start_.name = "Dress";
        for (const std::string& name : core::wardrobe_names()) {
            const core::Result<core::Design> design = core::wardrobe_design(name, *body);
            if (!design) throw std::runtime_error(design.error().sentence());
            steps_.insert(steps_.end(), design->steps.begin(), design->steps.end());
            start_.body = design->body;
        }
    }

    [[nodiscard]] const core::Design& start() const { return start_; }
    [[nodiscard]] static bool keeps_whole(std::int64_t n) { return n % kWholeEach == kWholeEach - 1; }
    [[nodiscard]] JournalEntry entry(std::int64_t n) const {
        const auto place = static_cast<std::size_t>(n) / 2;
        if (n % 11 == 7) return {.kind = JournalEntry::Kind::Place, .place = place};
        if (n % 11 == 8 && n % 2 == 0) return {.kind = JournalEntry::Kind::Place, .place = place + 2};
        if (n % 53 == 0) return {.kind = JournalEntry::Kind::Rename, .name = "Dress " + std::to_string(n)};
        JournalEntry entry{.kind = JournalEntry::Kind::Steps,
                           .steps = {steps_[static_cast<std::size_t>(n) % steps_.size()]}};
        if (n % 4 == 0) {
            entry.steps.push_back(steps_[static_cast<std::size_t>(n + 1) % steps_.size()]);
            entry.steps.back().with_last = true;
        }
        return entry;
    }

    /// Does number n to the state.
    void take(std::int64_t n, db::DesignState& state) const {
        if (!keeps_whole(n)) db::apply(entry(n), state);
    }
    [[nodiscard]] std::string text_after(std::int64_t count) const {
        db::DesignState state{start_, {}};
        for (std::int64_t n = 0; n < count; ++n) take(n, state);
        return text_of(state);
    }
    [[nodiscard]] static std::string text_of(const db::DesignState& state) {
        return core::design_text(state.design) + db::steps_text(state.undone);
    }

  private:
    std::vector<core::DesignStep> steps_;
    core::Design start_;
};

/// The child: draws on from `opened` until it is killed, a few hundred acts a second.
[[noreturn]] void draw(const fs::path& path, const Drawing& drawing, db::OpenedDesign opened, int tell) {
    db::DesignJournal journal(path, opened.id, opened.sequence, {.compact_after = 60});
    for (std::int64_t n = opened.sequence; n < kMostEntries; ++n) {
        drawing.take(n, opened.state);
        if (Drawing::keeps_whole(n))
            journal.keep(opened.state);
        else if (!journal.append(drawing.entry(n)))
            _exit(1);
        std::this_thread::sleep_for(std::chrono::microseconds(n * 7919 % 4000));
        const std::int64_t sure = journal.acknowledged();
        if (write(tell, &sure, sizeof sure) != sizeof sure) _exit(1);
    }
    for (;;) pause();
}

template <typename T>
T value(core::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().sentence());
    return std::move(*result);
}

class Rounds {
  public:
    Rounds(fs::path path, std::uint64_t seed) : path_(std::move(path)), random_(seed) {
        db::DesignStore store = value(db::DesignStore::open(path_, db::OpenMode::Create));
        id_ = value(store.create(drawing_.start()));
    }

    /// Gives the number of kills that lost something.
    int go(int kills) {
        for (int k = 0; k < kills; ++k) {
            const std::int64_t sure = draw_and_kill();
            if (!is_whole(sure, k + 1)) ++faults_;
        }
        std::printf("%d of %d kills lost nothing; %lld acts were acknowledged, %lld more were there\n", kills - faults_,
                    kills, static_cast<long long>(acknowledged_), static_cast<long long>(beyond_));
        return faults_;
    }

  private:
    /// The number acknowledged last.
    std::int64_t draw_and_kill() {
        db::OpenedDesign opened = value(value(db::DesignStore::open(path_, db::OpenMode::ReadWrite)).load(id_));
        std::int64_t sure = before_ = opened.sequence;
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe could be made");
        const pid_t child = fork();
        if (child == 0) {
            close(ends[0]);
            draw(path_, drawing_, std::move(opened), ends[1]);
        }
        close(ends[1]);
        std::this_thread::sleep_for(std::chrono::microseconds(random_() % 200000));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        std::int64_t told = 0;
        while (read(ends[0], &told, sizeof told) == sizeof told) sure = told;
        close(ends[0]);
        return sure;
    }

    bool is_whole(std::int64_t sure, int kill) {
        db::DesignStore store = value(db::DesignStore::open(path_, db::OpenMode::ReadWrite));
        const db::OpenedDesign opened = value(store.load(id_));
        const bool there = opened.sequence >= sure && opened.faults.empty();
        const bool same = Drawing::text_of(opened.state) == drawing_.text_after(opened.sequence);
        const bool sound = value(store.check()).empty();
        acknowledged_ += sure - before_;
        beyond_ += opened.sequence - sure;
        if (!there || !same || !sound)
            std::printf("kill %d: acknowledged %lld, there %lld, design %s, file %s\n", kill,
                        static_cast<long long>(sure), static_cast<long long>(opened.sequence),
                        same ? "the same" : "another", sound ? "sound" : "damaged");
        if (opened.sequence >= kMostEntries) id_ = value(store.create(drawing_.start()));
        return there && same && sound;
    }

    fs::path path_;
    Drawing drawing_;
    std::mt19937_64 random_;
    std::int64_t id_ = 0, before_ = 0, acknowledged_ = 0, beyond_ = 0;
    int faults_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::fprintf(stderr, "kill_designs FOLDER [KILLS [SEED]]\n"), 2;
    const fs::path folder = fs::absolute(argv[1]);
    try {
        fs::remove_all(folder);
        fs::create_directories(folder);
        Rounds rounds(folder / "designs.db", static_cast<std::uint64_t>(argc > 3 ? std::atoi(argv[3]) : 1));
        return rounds.go(argc > 2 ? std::atoi(argv[2]) : 100) == 0 ? 0 : 1;
    } catch (const std::exception& error) {
        std::printf("%s\n", error.what());
        return 1;
    }
}
