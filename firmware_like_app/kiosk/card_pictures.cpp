#include "firmware_like_app/kiosk/card_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "core/base/checksum.hpp"
#include "ui/screens/card_text.hpp"

namespace app {
namespace {

template <typename T>
std::uint64_t mix(std::uint64_t hash, const T& value) {
    return core::fnv1a64(std::as_bytes(std::span<const T, 1>(&value, 1)), hash);
}

/// Identity of a picture: the model, from where, with which part colours where, how large and where in the picture.
std::uint64_t identity(const FoundModel& model, const ui::CardModel& card, const ui::ModelPictureOptions& options) {
    std::uint64_t hash = mix(0xcbf29ce484222325ULL, model.id);
    hash = mix(hash, model.mesh.get());
    for (const core::Vec3& v : {model.camera.direction, model.camera.up}) {
        for (const double d : {v.x, v.y, v.z}) hash = mix(hash, d);
    }
    hash = mix(hash, model.mirrored ? 1 : 0);
    hash = mix(hash, options.size.width);
    hash = mix(hash, options.size.height);
    hash = mix(hash, options.lean);
    hash = mix(hash, options.headroom);
    return core::fnv1a64(std::as_bytes(std::span(card.part_map.pixels)), hash);
}

std::vector<int> tags_of(const FoundModel& model) {
    std::set<int> colours;
    for (const FoundPart& part : model.parts) {
        if (part.colour >= 0 && part.colour < ui::palette::kPartCount) colours.insert(part.colour);
    }
    return {colours.begin(), colours.end()};
}

}  // namespace

std::string readable_name(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

core::Result<CardPictures> CardPictures::create() {
    core::Result<ui::ModelPainter> painter = ui::ModelPainter::create();
    if (!painter) return core::unexpected(painter.error());
    painter->warm_up();
    return CardPictures(std::move(*painter));
}

void CardPictures::start(std::shared_ptr<const PreparedAnswer> answer, const ui::FontSet& fonts,
                         const ui::FindLayout& layout) {
    answer_ = std::move(answer);
    faces_.clear();
    missing_.clear();
    const std::vector<FoundModel>& best = answer_->answer.best;
    for (std::size_t i = 0; i < std::min({best.size(), ui::kCardCount, answer_->cards.size()}); ++i) {
        ui::CardFace face;
        face.model = best[i].id;
        face.name = readable_name(best[i].name);
        face.caption = readable_name(best[i].class_name);
        if (face.caption == face.name) face.caption.clear();
        face.tags = tags_of(best[i]);
        if (answer_->cards[i] != nullptr) {
            ui::CardPlace place = ui::place_on_card(fonts, layout, i, face.name, face.caption, *answer_->cards[i]);
            face.lines = std::move(place.name);
            const std::uint64_t key = identity(best[i], *answer_->cards[i], place.picture);
            const auto [entry, is_new] = ids_.emplace(key, ui::PictureId{next_id_});
            face.picture = entry->second;
            if (is_new) {
                ++next_id_;
                missing_.push_back({face.picture, i, place.picture});
            }
        }
        faces_.push_back(std::move(face));
    }
}

void CardPictures::paint(int count, ui::Painter& painter) {
    for (; count > 0 && !missing_.empty(); --count) {
        const Missing next = missing_.front();
        missing_.pop_front();
        const auto [entry, is_new] =
            textures_.emplace(next.id, painter_.paint(*answer_->cards[next.card], next.options));
        painter.set_picture(next.id, &entry->second);
        ++painted_;
    }
}

std::optional<std::vector<ui::CardFace>> CardPictures::take_finished() {
    if (!answer_ || !missing_.empty()) return std::nullopt;
    answer_.reset();
    return std::move(faces_);
}

void CardPictures::keep_only_shown(const ui::CardRail& rail, ui::Painter& painter) {
    if (busy()) return;
    for (auto it = textures_.begin(); it != textures_.end();) {
        if (rail.shows(it->first)) {
            ++it;
            continue;
        }
        painter.set_picture(it->first, nullptr);
        it = textures_.erase(it);
    }
    std::erase_if(ids_, [this](const auto& entry) { return textures_.count(entry.second) == 0; });
}

void CardPictures::reset(ui::Painter& painter) {
    for (const auto& [id, texture] : textures_) painter.set_picture(id, nullptr);
    textures_.clear();
    ids_.clear();
    answer_.reset();
    missing_.clear();
}

}  // namespace app
