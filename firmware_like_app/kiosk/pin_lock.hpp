#pragma once
// The operator's PIN: digits in, open or not out, with a wait that grows with wrong tries.

#include <cstdint>
#include <string>

namespace app {

class PinLock {
  public:
    /// Four to eight digits.
    explicit PinLock(std::string pin) : pin_(std::move(pin)) {}

    /// Another digit; ignored while it waits. The last one is the try: true when it opens the lock.
    bool enter(char digit, std::int64_t now_us);
    void erase();
    /// Forgets what was entered, not the wrong tries.
    void clear() { entered_.clear(); }

    [[nodiscard]] int length() const { return static_cast<int>(pin_.size()); }
    [[nodiscard]] int entered() const { return static_cast<int>(entered_.size()); }
    /// Whole seconds until it takes digits again: after three wrong tries 30, then 60, 120 … after each further one, an
    /// hour at most. 0: it takes them now. A right PIN forgets the wrong ones.
    [[nodiscard]] std::int64_t wait_s(std::int64_t now_us) const;
    /// Whether the last try was wrong and nothing was entered since.
    [[nodiscard]] bool was_wrong() const { return wrong_ > 0 && just_wrong_; }

  private:
    std::string pin_, entered_;
    int wrong_ = 0;
    bool just_wrong_ = false;
    std::int64_t free_us_ = 0;
};

}  // namespace app
