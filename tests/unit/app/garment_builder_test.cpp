#include "firmware_like_app/kiosk/garment_builder.hpp"

#include <catch2/catch.hpp>
#include <new>

#include "core/garment/desk/garment_desk.hpp"
#include "core/garment/wardrobe.hpp"

namespace {

/// The desk of a worked design, and requests for it as it was after each of its last acts.
struct Work {
    core::GarmentDesk desk;
    std::vector<app::GarmentBuilder::Job> jobs;
};

Work work(const char* design, std::size_t acts) {
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    Work out{*core::GarmentDesk::open(*core::wardrobe_design(design, body), core::dress_form(body)), {}};
    const std::size_t all = out.desk.history().size();
    for (std::size_t place = all - acts + 1; place <= all; ++place) {
        (void)out.desk.go_to(place);
        if (auto request = out.desk.build_request()) out.jobs.push_back({std::move(*request), {0}});
    }
    return out;
}

}  // namespace

TEST_CASE("cloth made beside the pen is the cloth made at once, to the bit", "[garment builder]") {
    Work w = work("skirt_flat", 1);
    if (w.jobs.empty()) w.jobs.push_back({*w.desk.build_request(), {0}});
    app::GarmentBuilder at_once(false), beside(true);
    at_once.submit(w.jobs.back());
    beside.submit(w.jobs.back());
    beside.wait();
    CHECK_FALSE(beside.busy());
    const auto a = at_once.take(), b = beside.take();
    REQUIRE(a);
    REQUIRE(b);
    CHECK(a->result.complete);
    CHECK(a->result.number == b->result.number);
    REQUIRE(a->result.layers.size() == b->result.layers.size());
    for (std::size_t k = 0; k < a->result.layers.size(); ++k) {
        const core::Cloth &one = a->result.layers[k].cloth->fitted, &other = b->result.layers[k].cloth->fitted;
        CHECK(one.mesh.vertices == other.mesh.vertices);
        CHECK(one.mesh.quads == other.mesh.quads);
        REQUIRE(a->textured[k]);
        CHECK(a->textured[k]->texture == b->textured[k]->texture);
    }
    CHECK_FALSE(beside.take());
}

TEST_CASE("of many requests the newest is made last; what was forgotten never comes", "[garment builder]") {
    Work w = work("skirt_flat", 4);
    REQUIRE(w.jobs.size() >= 2);
    app::GarmentBuilder beside(true);
    for (const app::GarmentBuilder::Job& job : w.jobs) beside.submit(job);
    beside.wait();
    const auto newest = beside.take();
    REQUIRE(newest);
    CHECK(newest->result.number == w.jobs.back().request.number);
    beside.submit(w.jobs.front());
    beside.forget();
    beside.wait();
    CHECK_FALSE(beside.take());
}

TEST_CASE("cloth that there is no memory for does not come, and the builder goes on", "[garment builder]") {
    Work w = work("skirt_flat", 1);
    if (w.jobs.empty()) w.jobs.push_back({*w.desk.build_request(), {0}});
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    const core::DesignRunner greedy =
        *core::DesignRunner::start(w.desk.design(), core::dress_form(body),
                                   [](const std::string&) -> core::Result<core::DressForm> { throw std::bad_alloc(); });
    core::DesignStep worn;
    worn.kind = core::DesignStep::Kind::Body;
    worn.name = "mine.obj";
    app::GarmentBuilder beside(true);
    beside.submit({{greedy, 9, worn}, {}});
    beside.wait();
    CHECK_FALSE(beside.take());
    beside.submit(w.jobs.back());
    beside.wait();
    CHECK(beside.take());
}
