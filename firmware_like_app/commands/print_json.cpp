#include "firmware_like_app/commands/print_json.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace app {

void print_json(const nlohmann::ordered_json& object, int indent) {
    std::printf("%s\n", object.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

}  // namespace app
