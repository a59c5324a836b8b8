#include <cctype>
#include <fstream>
#include <system_error>

#include "core/exchange/ply_writer.hpp"
#include "core/starter/starter_collection.hpp"

namespace core {
namespace {

/// "school bus", "Old school bus" -> "school-bus-old-school-bus.ply"
std::string file_name(const StarterModel& model) {
    std::string name;
    for (const char c : model.class_name + " " + model.name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte))
            name.push_back(static_cast<char>(std::tolower(byte)));
        else if (c != '\'' && name.back() != '-')
            name.push_back('-');
    }
    return name + ".ply";
}

}  // namespace

Result<void> write_starter_collection(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        return unexpected(ErrorCode::WriteFailed,
                          "the folder for the starter collection cannot be made (" + failure.message() +
                              "); name a place where this user may write",
                          folder.string());
    std::string list;
    for (const StarterModel& model : starter_collection()) {
        const std::string name = file_name(model);
        if (Result<void> written = write_ply_file(folder / name, model.mesh); !written) return written;
        list += name + "\t" + model.class_name + "\n";
    }
    std::ofstream out(folder / "starter.list", std::ios::binary | std::ios::trunc);
    if (!(out << list) || !out.flush())
        return unexpected(ErrorCode::WriteFailed, "The list of the starter collection could not be written.",
                          (folder / "starter.list").string());
    return {};
}

}  // namespace core
