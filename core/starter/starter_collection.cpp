#include "core/starter/starter_collection.hpp"

#include "core/starter/models/models.hpp"

namespace core {

std::vector<StarterModel> starter_collection() {
    std::vector<StarterModel> models;
    starter::add_horses_and_elephants(models);
    starter::add_dogs_and_cats(models);
    starter::add_farm_animals(models);
    starter::add_rabbits(models);
    starter::add_ducks_and_flamingos(models);
    starter::add_fish(models);
    starter::add_shore_animals(models);
    starter::add_insects(models);
    starter::add_aircraft(models);
    starter::add_furniture(models);
    starter::add_tableware(models);
    starter::add_instruments(models);
    starter::add_road_vehicles(models);
    starter::add_tractors(models);
    starter::add_sailboats_and_balloons(models);
    starter::add_household(models);
    starter::add_clothes(models);
    starter::add_accessories(models);
    starter::add_keepsakes(models);
    starter::add_tools(models);
    starter::add_plants(models);
    starter::add_buildings(models);
    return models;
}

}  // namespace core
