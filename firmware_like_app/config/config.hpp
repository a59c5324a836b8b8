#pragma once
// The station's settings: one TOML file, every option with a default, refused with line and key where it is wrong.
//
//     core::Result<app::Config> config = app::read_config("/etc/croquis/croquis.toml");
//
// The same names work on the command line, `--set visitors.language=de`, and win over the file.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace app {

/// Everything that can be set. The table of options in config.cpp says what each means, and its bounds.
struct Config {
    struct {
        std::string database;  ///< empty: none
        std::string models;    ///< folder that is read at the start
        std::string add_from;  ///< folder in which the operator starts to look for models
        std::int64_t search_threads = 0;
    } collection;
    struct {
        std::string language = "en";
        std::string hand = "right";
        std::string languages_folder;
        bool attract = true;
        bool garment = true;
        bool shadow = true;
        std::string part_colours = "soft";
        std::string attract_drawings;  ///< folder; empty: those of the program
    } visitors;
    struct {
        double ask_s = 60, ask_garment_s = 180, countdown_s = 20, empty_s = 30, still_pen_s = 600;
    } idle;
    struct {
        std::string designs;    ///< file of designs; empty: none are kept
        std::string export_to;  ///< folder; empty: USB sticks
        std::string bodies;     ///< folder of bodies of the studio's own; empty: none are offered
        std::string fabrics;    ///< folder of pictures of fabrics; empty: only the built-in ones
        std::int64_t bin_days = 30;
    } garment;
    struct {
        bool expected = false;
        std::string turn = "none";
        std::string pressure = "normal";
        std::vector<double> area;   ///< left, top, right, bottom; empty: all
        std::vector<double> align;  ///< six numbers, see input::CalibrationOptions::align; empty: as it is
    } tablet;
    struct {
        std::string pin = "000000";
        std::string place;
        std::string report_folder;
    } station;
    struct {
        std::string size;
        bool windowed = false;
        bool escape_exits = true;
    } screen;
    struct {
        std::string folder;
    } record;
};

/// The default file: every option with its default and a comment.
[[nodiscard]] std::string default_config_text();

/// FileMissing, FileUnreadable; BadFormat with "line N" and the key: a syntax error, a name that is not known (with the
/// one that is meant, where one is near), a value of another type or out of its bounds.
[[nodiscard]] core::Result<Config> read_config(const std::string& path);
/// `where` stands in errors.
[[nodiscard]] core::Result<Config> parse_config(std::string_view text, const std::string& where);
/// "idle.ask_s=90" into the config; text needs no quotes. BadArgument with the key.
[[nodiscard]] core::Result<void> set_option(Config& config, const std::string& assignment);
/// Writes these values into the file and leaves all else in it as it is: comments, order, other options. A file that is
/// not there is made of the default one. WriteFailed; errors of read_config.
[[nodiscard]] core::Result<void> save_options(const std::string& path,
                                              const std::vector<std::pair<std::string, std::string>>& options);

}  // namespace app
