#pragma once
// Objects that the figure wears or carries: their meshes, which one is chosen, and the handles by which it is moved,
// scaled and turned in the view that is large.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/design.hpp"
#include "firmware_like_app/garment/dressed_design.hpp"
#include "ui/draw/figure_camera.hpp"
#include "ui/screens/garment_screen.hpp"

namespace app {

class GarmentObjects {
  public:
    enum class Grip { None, Move, Scale, Turn };

    /// Where models that are not known yet are looked up; may be empty.
    explicit GarmentObjects(ModelSource source) : source_(std::move(source)) {}

    /// A model that need not be looked up.
    void keep(const std::string& model, std::shared_ptr<const core::TriangleMesh> mesh);
    /// What belongs to a visitor: what is chosen and held, and the models.
    void forget();

    /// Their meshes in place, the held one as it is held; null where a model is not found. Looks models up, some
    /// milliseconds each the first time.
    [[nodiscard]] std::vector<std::shared_ptr<const core::TriangleMesh>> shown(
        const std::vector<core::PlacedObject>& objects);
    /// Why the last one was not found, a sentence; empty when all were.
    [[nodiscard]] const std::string& problem() const { return problem_; }

    void choose(const std::string& name) { chosen_ = name; }
    [[nodiscard]] const std::string& chosen() const { return chosen_; }

    /// Of the chosen one; nothing when none is, or it is not found. The frame goes `margin_px` around it, and no
    /// farther than `reach`, so that its corners can be touched wherever the object is.
    [[nodiscard]] std::optional<ui::ObjectHandles> handles(const std::vector<core::PlacedObject>& objects,
                                                           const ui::FigureCamera& camera, double margin_px,
                                                           const ui::Rect& reach);
    /// The foremost object whose box on the screen holds this place; empty: none.
    [[nodiscard]] std::string at(core::Point px, const std::vector<core::PlacedObject>& objects,
                                 const ui::FigureCamera& camera);

    /// What a tip at this place takes hold of: the turning handle, the scaling one, or the box between.
    [[nodiscard]] static Grip grip_at(const ui::ObjectHandles& handles, core::Point px, double reach_px);
    void hold(Grip grip, core::Point px, const std::vector<core::PlacedObject>& objects,
              const ui::FigureCamera& camera);
    [[nodiscard]] bool held() const { return grip_ != Grip::None; }
    /// Along the view's plane; by the distance from its middle; about the view's axis.
    void drag(core::Point px);
    /// As it is now, to be kept; nothing where nothing was held or nothing changed.
    [[nodiscard]] std::optional<core::PlacedObject> let_go();

  private:
    struct Model {
        std::shared_ptr<const core::TriangleMesh> mesh;  // null: it was looked for in vain
        core::Vec3 half;                                 // of its box
        std::string problem;
    };
    const Model& model_of(const std::string& name);
    [[nodiscard]] const core::PlacedObject* now(const std::vector<core::PlacedObject>& objects,
                                                const std::string& name) const;
    [[nodiscard]] std::optional<ui::Rect> box_px(const core::PlacedObject& object, const ui::FigureCamera& camera);

    ModelSource source_;
    std::map<std::string, Model> models_;
    std::map<std::string, std::pair<core::PlacedObject, std::shared_ptr<const core::TriangleMesh>>> in_place_;
    std::string problem_, chosen_;
    Grip grip_ = Grip::None;
    core::PlacedObject start_, dragged_;
    core::Point from_px_;
    ui::FigureCamera camera_;
};

}  // namespace app
