#pragma once
// Which screen the kiosk shows, and when it changes by itself. No screen and no clock in here: times are arguments.
//
//     Notice ──button──> Work          Attract ──tip, pen near──> Work ──card──> Detail ──keep drawing──> Work
//     Work, Detail ──idle──> StillThere ──countdown, start over──> wipe, home   StillThere ──any tip──> back
//     visitor's screens ──corner──> Pin ──right PIN──> Operator ──close, idle──> wipe, home    Operator <──> Cleaning
//
// Home is a notice when something is missing, else Attract. A wipe is counted; whoever holds a visitor's things drops
// them when the count has changed.

#include <cstdint>

namespace app {

/// Microseconds.
struct StationTimes {
    std::int64_t ask = 60'000'000;            ///< without input, before "Still there?"
    std::int64_t ask_garment = 180'000'000;   ///< the same in Garment, where people think longer
    std::int64_t countdown = 20'000'000;      ///< of "Still there?"
    std::int64_t empty = 30'000'000;          ///< an empty sheet goes home without asking
    std::int64_t still_pen = 600'000'000;     ///< a pen that is near but does not move counts as present no longer
    std::int64_t pin = 20'000'000;            ///< the PIN page goes back
    std::int64_t station_page = 120'000'000;  ///< the operator's page closes
    std::int64_t cleaning = 30'000'000;       ///< without input: the screen is clean
};

enum class Scene { Notice, Attract, Work, Detail, StillThere, Pin, Operator, Cleaning };
enum class CollectionState { Ready, Building, Empty, Missing, Damaged, Stale };

class Station {
  public:
    /// Starts at home.
    Station(const StationTimes& times, CollectionState collection, std::int64_t now_us);

    [[nodiscard]] Scene scene() const { return scene_; }
    /// The scene that "Still there?" or the PIN page covers and goes back to; else scene().
    [[nodiscard]] Scene behind() const { return covers() ? behind_ : scene_; }
    [[nodiscard]] CollectionState collection() const { return collection_; }
    [[nodiscard]] bool tablet_is_missed() const { return tablet_expected_ && !tablet_; }
    /// Grows with every wipe.
    [[nodiscard]] std::uint64_t wipes() const { return wipes_; }
    /// How much of the countdown or of the cleaning time is left, in microseconds; 0 elsewhere.
    [[nodiscard]] std::int64_t left_us(std::int64_t now_us) const;
    [[nodiscard]] const StationTimes& times() const { return times_; }
    void set_times(const StationTimes& times) { times_ = times; }

    // Around the visitor.
    void set_collection(CollectionState state, std::int64_t now_us);
    /// A tablet that is expected, or was there once, is missed when it goes; missing it changes the screen at home
    /// only.
    void set_tablet(bool there, std::int64_t now_us);
    void expect_tablet(std::int64_t now_us);
    /// Whether anything at all can reach the program: where nothing can, home says so.
    void set_input(bool there, std::int64_t now_us);
    [[nodiscard]] bool input_is_there() const { return input_; }
    /// Whether something would be lost by a wipe.
    void set_has_work(bool has_work) { has_work_ = has_work; }
    /// Whether the mode in use is Garment.
    void set_garment(bool garment) { garment_ = garment; }
    /// Work that the operator's page must not be left for: an import, a test.
    void set_busy(bool busy) { busy_ = busy; }

    // The visitor.
    /// Any tip, drag, wheel or movement of a pen. Everything but hovering counts as this.
    void touched(std::int64_t now_us);
    /// A pen in range; without movement it counts for a limited time.
    void pen_near(bool moved, std::int64_t now_us);
    /// Attract to an empty sheet. False elsewhere.
    bool wake(std::int64_t now_us);
    /// The button of a notice.
    void leave_notice(std::int64_t now_us);
    void open_detail(std::int64_t now_us);
    void keep_drawing(std::int64_t now_us);  ///< from Detail, and the answer to "Still there?"
    void start_over(std::int64_t now_us);

    // The operator.
    /// From every visitor's screen, "Still there?" included.
    void open_pin(std::int64_t now_us);
    void leave_pin(std::int64_t now_us);
    void open_operator(std::int64_t now_us);
    void close_operator(std::int64_t now_us);
    void clean_screen(std::int64_t now_us);

    /// Lets time pass.
    void tick(std::int64_t now_us);

  private:
    [[nodiscard]] bool covers() const { return scene_ == Scene::StillThere || scene_ == Scene::Pin; }
    [[nodiscard]] bool at_home() const { return scene_ == Scene::Notice || scene_ == Scene::Attract; }
    [[nodiscard]] Scene home() const;
    void go(Scene scene, std::int64_t now_us);
    void wipe(std::int64_t now_us);

    StationTimes times_;
    CollectionState collection_;
    Scene scene_, behind_ = Scene::Attract;
    bool tablet_ = false, tablet_expected_ = false, input_ = true;
    bool has_work_ = false, garment_ = false, busy_ = false;
    bool visited_ = false;  // touched since the last wipe: a language may have been chosen
    std::uint64_t wipes_ = 0;
    std::int64_t entered_us_, present_us_, pen_moved_us_;
};

}  // namespace app
