#pragma once
// Everything on the screen around the modes: what is shown before, between and after visitors, and for the operator.
// Holds the state machine (Station), hands input to whatever is on, and draws it.

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "firmware_like_app/kiosk/attract_player.hpp"
#include "firmware_like_app/kiosk/detail_view.hpp"
#include "firmware_like_app/kiosk/find_mode.hpp"
#include "firmware_like_app/kiosk/garment_mode.hpp"
#include "firmware_like_app/kiosk/operator_desk.hpp"
#include "firmware_like_app/kiosk/pin_lock.hpp"
#include "firmware_like_app/kiosk/station.hpp"
#include "ui/screens/attract_screen.hpp"
#include "ui/screens/notice_screen.hpp"
#include "ui/screens/pin_screen.hpp"
#include "ui/screens/still_there_screen.hpp"

namespace app {

struct ShellOptions {
    StationTimes times;
    CollectionState collection = CollectionState::Ready;
    std::size_t language = 0;  ///< of every new visitor
    ui::Hand hand = ui::Hand::Right;
    bool attract = true;               ///< false: home is the empty sheet
    std::string attract_folder = {};   ///< see attract_drawings()
    std::string pin = "000000";        ///< of the station page
    OperatorDesk::Setup station = {};  ///< what the station page shows and changes
    GarmentMode* garment = nullptr;    ///< the other mode; null: there is none. It must outlive the shell.
    bool garment_offered = true;       ///< to visitors, by the operator
    bool every_frame_seen = true;      ///< false: pictures are made on request, and searches are waited for
};

/// How far the reading of the collection is.
struct CollectionProgress {
    std::int64_t done = 0, total = 0;
    std::optional<int> minutes_left = {};
};

class Shell {
  public:
    /// `searcher` is for the attract picture and may be null. All references must outlive the shell.
    [[nodiscard]] static core::Result<std::unique_ptr<Shell>> create(const ui::FontSet& fonts,
                                                                     const std::vector<ui::Strings>& languages,
                                                                     FindMode& find, Searcher* searcher,
                                                                     const ShellOptions& options, ui::SizePx screen,
                                                                     std::int64_t now_us);

    void resize(ui::SizePx screen, std::int64_t now_us);
    void pointer(const ui::WindowEvent& event);
    void cancel_pointer(std::int64_t now_us);
    /// A pen hovers. The first time wakes the attract picture.
    void pen_near(bool moved, std::int64_t now_us);
    /// Once a frame.
    void update(std::int64_t now_us);
    int update_ink();
    /// See FindMode::use_spare_time.
    void use_spare_time();
    [[nodiscard]] bool changed(std::int64_t now_us) const;
    /// `kept`: what is bound still holds the frame that was drawn last, so that only changes need be drawn.
    void draw(std::int64_t now_us, bool flip, bool kept = false);

    void set_collection(CollectionState state, const CollectionProgress& progress, std::int64_t now_us);
    void set_tablet(bool there, std::int64_t now_us);
    void expect_tablet(std::int64_t now_us);
    /// `code`: why no input can come, for whoever is called; empty when some can.
    void set_no_input(const std::string& code, std::int64_t now_us);
    /// The operator's wishes for the program as a whole.
    [[nodiscard]] bool exit_wanted() const { return exit_wanted_; }
    [[nodiscard]] bool restart_wanted() const { return restart_wanted_; }
    void set_facts(StationFacts facts) { desk_.set_facts(std::move(facts)); }
    [[nodiscard]] ui::StationPage station_page(std::int64_t now_us) const {
        return desk_.build(desk_.state(mode().language(), now_us), screen_);
    }
    /// To the sheet at once, as replays need it.
    void open_sheet(std::int64_t now_us);

    /// To Garment at once, or back.
    void open_garment(bool garment, std::int64_t now_us);
    [[nodiscard]] bool in_garment() const { return in_garment_; }
    /// Where touches may be a palm.
    [[nodiscard]] ui::Rect sheet() const {
        return in_garment_ ? options_.garment->layout().sheet : find_.layout().sheet;
    }

    [[nodiscard]] const Station& station() const { return station_; }
    [[nodiscard]] DetailView& detail() { return detail_; }

  private:
    Shell(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, FindMode& find,
          const ShellOptions& options, ui::SizePx screen, ui::Painter painter, std::unique_ptr<AttractPlayer> attract,
          DetailView detail, std::int64_t now_us);

    /// The one in use.
    [[nodiscard]] Mode& mode() const;
    [[nodiscard]] bool garment_offered() const { return options_.garment != nullptr && options_.garment_offered; }
    void follow_mode_wishes(std::int64_t now_us);
    void go_on(std::int64_t now_us);
    void entered(std::int64_t now_us);
    void note_board();
    void cancel_touches(std::int64_t now_us);
    void enter_digit(char digit, std::int64_t now_us);
    void take_wishes(std::int64_t now_us);
    void take_settings(const Config& config);
    void wear(std::int64_t now_us);
    void open_detail(const FindMode::OpenedCard& card, std::int64_t now_us);
    void press(const ui::WindowEvent& event);
    void release(const ui::WindowEvent& event);
    void act(const ui::Intent& intent, std::int64_t now_us);
    void watch_corner(const ui::WindowEvent& event);
    void draw_own(ui::DrawList list, bool flip, bool kept);
    void draw_mode(std::int64_t now_us, bool flip, bool kept, const ui::DrawList& over = {});
    void draw_still_there(const ui::StillThereState& state, std::int64_t now_us, bool flip, bool kept);
    [[nodiscard]] bool mode_has_input() const;
    [[nodiscard]] bool mode_zooms() const;
    [[nodiscard]] ui::Rect corner() const;
    [[nodiscard]] ui::Notice notice() const;
    [[nodiscard]] std::vector<ui::BoardTouch::Target> targets(std::int64_t now_us) const;
    [[nodiscard]] ui::AttractState attract_state(std::int64_t now_us) const;
    [[nodiscard]] ui::NoticeState notice_state() const;
    [[nodiscard]] ui::PinState pin_state(std::int64_t now_us) const;
    [[nodiscard]] ui::StillThereState still_there_state(std::int64_t now_us) const;

    /// What the last frame of a scene showed, but for the modes, which know for themselves.
    using SceneState = std::variant<std::monostate, ui::AttractState, ui::NoticeState, ui::StillThereState,
                                    ui::DetailState, ui::PinState, ui::StationState>;
    struct Shown {
        Scene scene;
        ui::SizePx screen;
        ui::Hand hand;
        SceneState state;
        friend bool operator==(const Shown&, const Shown&) = default;
    };
    [[nodiscard]] Shown shown_at(std::int64_t now_us) const;

    const std::vector<ui::Strings>& languages_;
    FindMode& find_;
    ShellOptions options_;
    ui::SizePx screen_;
    Station station_;
    ui::Painter painter_;
    std::unique_ptr<AttractPlayer> attract_;
    DetailView detail_;
    ui::AttractScreen attract_screen_;
    ui::NoticeScreen notice_screen_;
    ui::StillThereScreen still_screen_;
    ui::PinScreen pin_screen_;
    PinLock pin_lock_;
    OperatorDesk desk_;
    bool exit_wanted_ = false, restart_wanted_ = false;

    ui::BoardTouch touch_;
    bool in_garment_ = false;
    bool swallow_ = false;  // until the tip lifts, nothing more of it counts
    bool tip_down_ = false;
    std::optional<std::int64_t> corner_since_us_;
    Scene scene_ = Scene::Notice;  // that was entered last
    std::uint64_t wipes_ = 0;
    CollectionProgress progress_;
    std::string no_input_code_;
    std::optional<Shown> shown_;
    enum class Drawn { Nothing, Own, Find } drawn_ = Drawn::Nothing;  // whose painter knows what the last frame holds
};

}  // namespace app
