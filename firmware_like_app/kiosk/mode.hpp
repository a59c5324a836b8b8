#pragma once
// What a visitor works in: Find now, others beside it. The shell gives it input and frames while it is in use, and asks
// it to forget a visitor.

#include <cstddef>
#include <cstdint>

#include "ui/gl/window.hpp"
#include "ui/screens/find_layout.hpp"

namespace app {

class Mode {
  public:
    virtual ~Mode() = default;

    /// Another size of screen: what was made keeps its place.
    virtual void resize(ui::SizePx screen) = 0;
    /// A mouse or a finger.
    virtual void pointer(const ui::WindowEvent& event) = 0;
    /// The pointer is gone: a stroke ends where it is, a pressed control does nothing.
    virtual void cancel_pointer(std::int64_t now_us) = 0;
    /// Once a frame.
    virtual void update(std::int64_t now_us) = 0;
    /// Draws new samples into layers that stay, before a frame is bound. Returns the number of pieces drawn.
    virtual int update_ink() = 0;
    /// Whether the frame would differ from the one drawn last.
    [[nodiscard]] virtual bool changed(std::int64_t now_us) const = 0;
    /// The frame into whatever is bound; `flip` for windows.
    virtual void draw(std::int64_t now_us, bool flip) = 0;

    /// Whether a wipe would lose something, history included.
    [[nodiscard]] virtual bool has_work() const = 0;
    /// Forgets everything of the visitor, and starts with this language and hand. Nothing of it can come back.
    virtual void wipe(std::size_t language, ui::Hand hand) = 0;
    [[nodiscard]] virtual std::size_t language() const = 0;
    virtual void set_language(std::size_t language) = 0;
    [[nodiscard]] virtual ui::Hand hand() const = 0;
    virtual void set_hand(ui::Hand hand) = 0;
};

}  // namespace app
