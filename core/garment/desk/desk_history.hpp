#pragma once
// Undo and redo without limit: acts of the designer, each some steps of the design, and states kept on the way.

#include <map>
#include <string>
#include <vector>

#include "core/garment/design.hpp"

namespace core {

/// One act, for a list to choose from.
struct HistoryEntry {
    DesignStep::Kind kind = DesignStep::Kind::Line;  ///< of its first step
    std::string name;                                ///< of the line, piece, layer or object it was about
    std::size_t steps = 0;                           ///< of the design after it
};

/// What a journal must write to lose nothing; played again in order it gives the same history.
struct JournalEvent {
    enum class Kind {
        Steps,  ///< one act was done; what had been undone is forgotten
        Place   ///< undone or redone: the history stands after `place` acts
    };
    Kind kind = Kind::Steps;
    std::vector<DesignStep> steps;
    std::size_t place = 0;
};

/// The steps and the states between them. Of the last 48 acts every state is kept, of those before every eighth: going
/// back costs at most seven acts done again.
class DesignHistory {
  public:
    explicit DesignHistory(DesignRunner start);

    /// An act; the state after it is `after`. Acts that were undone are forgotten.
    void push(std::vector<DesignStep> steps, DesignRunner after);

    /// Stands after `place` acts, 0 … acts().
    void go_to(std::size_t place);

    [[nodiscard]] const DesignRunner& now() const { return now_; }
    [[nodiscard]] std::size_t place() const { return place_; }
    [[nodiscard]] std::size_t acts() const { return acts_.size(); }
    [[nodiscard]] const std::vector<DesignStep>& act(std::size_t k) const { return acts_[k]; }

    /// The steps of the acts up to the place, in order.
    [[nodiscard]] std::vector<DesignStep> steps() const;
    [[nodiscard]] std::vector<HistoryEntry> entries() const;

  private:
    void thin();
    std::vector<std::vector<DesignStep>> acts_;
    std::map<std::size_t, DesignRunner> kept_;  // by the number of acts before them
    DesignRunner now_;
    std::size_t place_ = 0;
};

}  // namespace core
