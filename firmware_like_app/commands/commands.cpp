#include "firmware_like_app/commands/commands.hpp"

#include <algorithm>
#include <cstdio>

#include "core/exchange/file_bytes.hpp"

namespace app {

void fail(CommandState& state, const core::Error& error) {
    std::fprintf(stderr, "croquis: %s\n", error.sentence().c_str());
    state.exit_code = 1;
}

void fail_call(CommandState& state, const core::Error& error) {
    fail(state, error);
    state.exit_code = 2;
}

core::Result<void> check_ending(const std::string& path, const std::vector<std::string>& endings) {
    const std::string ending = core::lower_extension(path);
    if (std::find(endings.begin(), endings.end(), ending) != endings.end()) return {};
    std::string choice;
    for (std::size_t k = 0; k < endings.size(); ++k) {
        if (k > 0) choice += k + 1 == endings.size() ? " or " : ", ";
        choice += "." + endings[k];
    }
    return core::unexpected(core::ErrorCode::BadArgument, "the name has to end in " + choice, path);
}

}  // namespace app
