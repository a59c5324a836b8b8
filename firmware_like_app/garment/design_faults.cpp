#include "firmware_like_app/garment/design_faults.hpp"

#include <filesystem>

namespace app {
namespace {

const char* words_key(core::ErrorCode code) {
    switch (code) {
        case core::ErrorCode::NewerVersion:
            return "designs_newer";
        case core::ErrorCode::NotAnIndex:
        case core::ErrorCode::UnknownFormat:
            return "designs_other_file";
        case core::ErrorCode::Damaged:
        case core::ErrorCode::BadFormat:
            return "designs_damaged";
        case core::ErrorCode::WriteFailed:
            return "designs_not_written";
        case core::ErrorCode::FileMissing:
        case core::ErrorCode::FileUnreadable:
        case core::ErrorCode::DatabaseFailed:
            return "designs_not_read";
        default:
            return nullptr;
    }
}

}  // namespace

std::string design_fault_words(const core::Error& error, const ui::Strings& words) {
    const char* key = words_key(error.code);
    if (key == nullptr) return error.sentence();
    const std::string file = std::filesystem::path(error.where).filename().string();
    return (file.empty() ? "" : file + ": ") + words[key];
}

}  // namespace app
