#include "core/starter/starter_collection.hpp"

#include "core/starter/models/models.hpp"

namespace core {

std::vector<StarterModel> starter_collection() {
    std::vector<StarterModel> models;
    starter::add_hoofed_animals(models);
    starter::add_dogs_and_cats(models);
    starter::add_farm_animals(models);
    starter::add_wild_animals(models);
    starter::add_birds(models);
    starter::add_fish_and_whales(models);
    starter::add_shore_animals(models);
    starter::add_insects(models);
    starter::add_aircraft(models);
    starter::add_furniture(models);
    starter::add_tableware(models);
    starter::add_instruments(models);
    starter::add_road_vehicles(models);
    starter::add_engines(models);
    starter::add_boats(models);
    starter::add_household(models);
    starter::add_tools(models);
    starter::add_plants(models);
    starter::add_buildings(models);
    return models;
}

}  // namespace core
