#pragma once
// The makers of the starter collection, by theme. Each appends its models, class by class.

#include <string>
#include <utility>
#include <vector>

#include "core/starter/starter_collection.hpp"

namespace core::starter {

using Models = std::vector<StarterModel>;

inline void add_model(Models& models, std::string class_name, std::string name, TriangleMesh mesh) {
    models.push_back({std::move(name), std::move(class_name), std::move(mesh)});
}

void add_accessories(Models& models);
void add_aircraft(Models& models);
void add_buildings(Models& models);
void add_clothes(Models& models);
void add_dogs_and_cats(Models& models);
void add_ducks_and_flamingos(Models& models);
void add_farm_animals(Models& models);
void add_fish(Models& models);
void add_furniture(Models& models);
void add_horses_and_elephants(Models& models);
void add_household(Models& models);
void add_insects(Models& models);
void add_instruments(Models& models);
void add_keepsakes(Models& models);
void add_plants(Models& models);
void add_rabbits(Models& models);
void add_road_vehicles(Models& models);
void add_sailboats_and_balloons(Models& models);
void add_shore_animals(Models& models);
void add_tableware(Models& models);
void add_tools(Models& models);
void add_tractors(Models& models);

}  // namespace core::starter
