// SPDX-License-Identifier: GPL-3.0-or-later
// Includes CLI11 as `arguments.cpp` does; both are compiled together.
#include "app/cli/marker_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/choice_options.h"
#include "core/base/units.h"
#include "core/garment/fabric.h"

namespace toile::app {
namespace {

constexpr double kMostApart = 1000;  // mm
constexpr int kMostGarments = 1000;

/// Notes that this setting was typed. @param field  of MarkerSettings
template <auto field>
void notes(MarkerArguments& marker, CLI::Option* option) {
    option->each([&marker](const std::string&) {
        marker.stated.push_back([](const MarkerSettings& typed, MarkerSettings& settings) {
            settings.*field = typed.*field;
        });
    });
}

/// An option whose words a function of ours reads.
CLI::Option* addRead(CLI::App& command, const char* option, MarkerSettings& settings,
                     std::string (*read)(const std::string&, MarkerSettings&), const char* type,
                     const char* help) {
    return command
        .add_option_function<std::vector<std::string>>(
            option,
            [&settings, read](const std::vector<std::string>& typed) {
                for (const std::string& words : typed) {
                    if (std::string wrong = read(words, settings); !wrong.empty()) {
                        throw CLI::ValidationError(wrong);
                    }
                }
            },
            help)
        ->type_name(type)
        ->allow_extra_args(false);
}

void addCloth(CLI::App& command, MarkerArguments& marker) {
    MarkerSettings& settings = marker.settings;
    command.add_option("--width", settings.width, "Width of the cloth [as its fabric says]")
        ->type_name("MM")
        ->check(within(1.0, kMaxClothWidth));
    addRead(command, "--sheet", settings, readSheet, "ALONGxACROSS",
            "Lay on sheets of this size instead, in mm along the warp and across it");
    command
        .add_option("--hide", marker.hides,
                    "Lay on hides instead, in this order: .dxf or .svg with a closed outline, "
                    "holes, and zones on layers called \"grade 2\" and so on")
        ->type_name("FILE")
        ->allow_extra_args(false);
    const auto addLength = [&command](const char* option, double& length, const char* help) {
        return command.add_option(option, length, help)
            ->type_name("MM")
            ->check(within(0.0, kMostApart))
            ->capture_default_str();
    };
    notes<&MarkerSettings::gap>(marker,
                                addLength("--gap", settings.gap, "Between two copies at least"));
    notes<&MarkerSettings::border>(marker, addLength("--border", settings.border,
                                                     "Between copies and the edges of the cloth"));
    notes<&MarkerSettings::isFolded>(
        marker,
        command.add_flag("--folded", settings.isFolded,
                         "Fold the cloth lengthwise: what mirrors itself is laid by half on the "
                         "fold, and of two that mirror each other one"));
    notes<&MarkerSettings::garments>(
        marker, command.add_option("--garments", settings.garments, "How many garments are cut")
                    ->type_name("N")
                    ->check(within(1, kMostGarments))
                    ->capture_default_str());
    command
        .add_option("--material", marker.material,
                    "Lay only what is cut from this material; \"\": from the garment's own fabric")
        ->type_name("NAME");
}

void addRules(CLI::App& command, MarkerArguments& marker) {
    MarkerSettings& settings = marker.settings;
    CLI::Option* oneWay = command.add_flag_callback(
        "--one-way,--nap", [&settings] { settings.turns = TurnRule::OneWay; },
        "All pieces the same way up, on cloth with a nap [either way up]");
    CLI::Option* freely = command
                              .add_flag_callback(
                                  "--free-grain", [&settings] { settings.turns = TurnRule::Free; },
                                  "Turn pieces freely, on cloth without a grain")
                              ->excludes(oneWay);
    for (CLI::Option* option : {oneWay, freely}) {
        notes<&MarkerSettings::turns>(marker, option);
    }
    notes<&MarkerSettings::tolerance>(
        marker,
        command
            .add_option_function<double>(
                "--turn", [&settings](double degrees) { settings.tolerance = degrees * kDegree; },
                "Pieces may be turned by so much off the grain [0]")
            ->type_name("DEGREES")
            ->check(within(0.0, 180.0)));
    notes<&MarkerSettings::repeat>(
        marker,
        addRead(
            command, "--repeat", settings, readRepeat, "WARPxWEFT[@X,Y]",
            "Repeat of stripes or plaids along the warp and across it, 0: none, and where on the "
            "cloth one begins; kept along the seams of --match"));
    notes<&MarkerSettings::matched>(
        marker, command
                    .add_option("--match", settings.matched,
                                "A seam whose two sides meet at the same place of the repeat")
                    ->type_name("SEAM")
                    ->allow_extra_args(false));
    notes<&MarkerSettings::grades>(
        marker, addRead(command, "--grade", settings, readGrade, "PIECE=N",
                        "A piece that needs leather of grade N or better [any grade does]"));
}

}  // namespace

void addMarkerOptions(CLI::App& command, MarkerArguments& marker) {
    addCloth(command, marker);
    addRules(command, marker);
    command.add_option("--rounds", marker.rounds, "End after so many rounds")
        ->type_name("N")
        ->check(within(0, 1'000'000'000));
    command
        .add_option("--time", marker.seconds,
                    "End after so many seconds [5 where no rounds are given], for each material")
        ->type_name("S")
        ->check(within(0.0, 1e6));
    notes<&MarkerSettings::seed>(
        marker, command.add_option("--seed", marker.settings.seed, "Another seed, another nest")
                    ->type_name("N")
                    ->capture_default_str());
    command.add_option("--threads", marker.threads, "To work with; the nest is the same [all]")
        ->type_name("N")
        ->check(within(1, kMostThreads));
    command
        .add_option("--minutes-per-metre", marker.minutesPerMetre,
                    "Say how long the seams take to sew")
        ->type_name("MINUTES")
        ->check(within(0.0, 1000.0));
}

}  // namespace toile::app
