#include "firmware_like_app/kiosk/detail_model.hpp"

namespace app {

PreparedDetail prepare_detail(const DetailJob& job) {
    PreparedDetail out;
    out.ticket = job.ticket;
    out.lifted = ui::lift_parts(*job.surface, job.camera, job.parts);
    out.contacts = ui::find_ground_contacts(out.lifted.geometry, job.camera.up);
    return out;
}

}  // namespace app
