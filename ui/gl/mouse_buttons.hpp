#pragma once
// Which of a mouse's buttons counts: the first that goes down, until it goes up.

#include <cstdint>
#include <optional>
#include <utility>

namespace ui {

class MouseButtons {
  public:
    /// A button went down or up, numbered from 1, the left one. Whether that begins or ends what the mouse does.
    bool change(std::uint8_t button, bool down) {
        if (down && !held_) {
            held_ = button;
            return true;
        }
        if (down || held_ != button) return false;
        ended_ = std::exchange(held_, std::nullopt);
        return true;
    }
    /// The one that is held, or was until the change that was told last, is not the left one. A mouse that only moves
    /// holds none.
    [[nodiscard]] bool is_other() const { return held_.value_or(ended_.value_or(kLeft)) != kLeft; }
    /// What was told is done with: a button that went up is forgotten.
    void settle() { ended_.reset(); }
    /// All are up, wherever that was.
    void forget() { held_ = ended_ = std::nullopt; }

  private:
    static constexpr std::uint8_t kLeft = 1;
    std::optional<std::uint8_t> held_, ended_;
};

}  // namespace ui
