#pragma once
// The pictures on the cards: painted once for each model, view and colouring, a few at a time, kept while shown.

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "firmware_like_app/kiosk/search_worker.hpp"
#include "ui/draw/model_painter.hpp"
#include "ui/draw/painter.hpp"
#include "ui/screens/card_rail.hpp"
#include "ui/screens/find_layout.hpp"

namespace app {

/// "lamp_desk_2" reads "Lamp desk 2".
[[nodiscard]] std::string readable_name(std::string name);

class CardPictures {
  public:
    [[nodiscard]] static core::Result<CardPictures> create();

    /// Takes an answer to make cards of; the one before must be finished (see busy()).
    void start(std::shared_ptr<const PreparedAnswer> answer, const ui::FontSet& fonts, const ui::FindLayout& layout);
    /// Paints up to `count` pictures that are still missing.
    void paint(int count, ui::Painter& painter);
    [[nodiscard]] bool busy() const { return answer_ != nullptr; }
    /// The cards, once all their pictures are there; empties itself.
    [[nodiscard]] std::optional<std::vector<ui::CardFace>> take_finished();
    /// Forgets the pictures that the rail no longer shows.
    void keep_only_shown(const ui::CardRail& rail, ui::Painter& painter);
    /// Forgets everything: the screen's size changed.
    void reset(ui::Painter& painter);
    /// Pictures painted since the start; for measuring.
    [[nodiscard]] int painted() const { return painted_; }

  private:
    explicit CardPictures(ui::ModelPainter painter) : painter_(std::move(painter)) {}
    struct Missing {
        ui::PictureId id;
        std::size_t card;
        ui::ModelPictureOptions options;
    };
    ui::ModelPainter painter_;
    std::map<std::uint64_t, ui::PictureId> ids_;  // by what the picture shows
    std::map<ui::PictureId, ui::Texture> textures_;
    std::shared_ptr<const PreparedAnswer> answer_;
    std::vector<ui::CardFace> faces_;
    std::deque<Missing> missing_;
    int next_id_ = 1000;
    int painted_ = 0;
};

}  // namespace app
