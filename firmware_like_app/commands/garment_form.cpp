#include "firmware_like_app/commands/garment_form.hpp"

#include <utility>

#include "core/exchange/mesh_reader.hpp"
#include "core/mannequin/mannequin.hpp"
#include "core/mannequin/own_body.hpp"

namespace app {

core::Result<core::DressForm> form_for(const core::Design& design, const std::string& path) {
    if (path.empty()) {
        const core::Result<core::Mannequin> body = core::make_mannequin(design.body);
        if (!body) return core::unexpected(body.error());
        return core::dress_form(*body);
    }
    const core::Result<core::TriangleMesh> mesh = core::read_mesh(path);
    if (!mesh) return core::unexpected(mesh.error());
    core::Result<core::TriangleMesh> stood = core::stand_body(*mesh);
    if (!stood) return core::unexpected(stood.error().code, stood.error().message, path);
    return core::dress_form(std::move(*stood));
}

}  // namespace app
