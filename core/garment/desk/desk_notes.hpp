#pragma once
// Errors of the engine as notes to the designer.

#include "core/base/error.hpp"
#include "core/garment/desk/desk_tool.hpp"

namespace core {

/// With the key for the screen's strings that the error's sentence tells.
[[nodiscard]] inline DeskNote note_of(const Error& error, Vec3 place) {
    const auto says = [&](const char* words) { return error.message.find(words) != std::string::npos; };
    const char* key = says("too short") || says("fewer than two") || says("draw it longer") || says("draw along it") ||
                              says("draw farther")
                          ? "too_short"
                      : says("too far away")                 ? "off_body"
                      : says("edge-on")                      ? "plane_edge_on"
                      : says("starts and ends at one place") ? "not_across"
                      : says("There is no region")           ? "no_region"
                      : error.code == ErrorCode::BadOutline  ? "not_filled"
                                                             : "other";
    return {key, error.message, place, {}, 0.0};
}

/// A reply that did nothing but say why.
[[nodiscard]] inline DeskReply told(const char* key, const char* sentence, Vec3 place) {
    DeskReply reply;
    reply.notes.push_back({key, sentence, place, {}, 0.0});
    return reply;
}

}  // namespace core
