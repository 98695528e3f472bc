// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that make something of a garment. Includes CLI11 as `arguments.cpp` does; both are
// compiled together.
#include <CLI/CLI.hpp>

#include "app/cli/batch_options.h"
#include "app/cli/choice_options.h"
#include "app/cli/commands.h"
#include "app/cli/flattening_options.h"
#include "app/cli/marker_arguments.h"
#include "app/cli/picture_options.h"
#include "app/cli/reading_options.h"
#include "core/base/units.h"
#include "core/formats/formats.h"
#include "core/garment/fabric.h"

namespace toile::app {
namespace {

constexpr double kMaxApart = 1000;  // mm
constexpr int kMaxGarments = 1000;

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
            ->check(within(0.0, kMaxApart))
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
                    ->check(within(1, kMaxGarments))
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

/// Adds what `toile marker` is told of cloth and search to a command.
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
        ->check(within(1, kMaxThreads));
    command
        .add_option("--minutes-per-metre", marker.minutesPerMetre,
                    "Say how long the seams take to sew")
        ->type_name("MINUTES")
        ->check(within(0.0, 1000.0));
}

/// ".svg (SVG drawing), .dxf (DXF pattern) ...", of this build.
std::string formatList() {
    std::string list;
    for (const Format& format : formats()) {
        list += list.empty() ? "" : ", ";
        list += std::string(format.endings.front()) + " (" + format.name + ")";
        list += format.write ? "" : " (not built)";
    }
    return list;
}

}  // namespace

void addFlatten(CLI::App& app, TypedOptions& typed, Arguments& arguments) {
    CLI::App& flatten = addCommand(app, arguments, Arguments::Command::Flatten, "flatten",
                                   "Flatten every piece of a garment");
    areAbout(kInputFiles, flatten, typed.groups);
    flatten
        .add_option(
            "-o,--output", arguments.outputs,
            "File to write, by its ending: " + formatList() + ". May be given several times")
        ->type_name("FILE")
        ->allow_extra_args(false);  // so that inputs may follow
    areAbout(kOutputFiles, flatten, typed.groups);
    addFlattening(flatten, typed, arguments);
    flatten
        .add_option("--threads", arguments.threads,
                    "To work with, 0: all there are; the result is the same")
        ->type_name("N")
        ->check(within(0, kMaxThreads))
        ->capture_default_str();
    areAbout(kThreads, flatten, typed.groups);
    flatten
        .add_option("--report", typed.report, "Write the JSON report (the same as -o FILE.json)")
        ->type_name("FILE.json");
    areAbout(kOutputFiles, flatten, typed.groups);
    addFailOn(flatten, arguments);
    flatten.add_flag("--ledger", arguments.ledger,
                     "Print every seam with the lengths of its two sides");
}

void addBatch(CLI::App& app, TypedOptions& typed, Arguments& arguments) {
    CLI::App& command = *app.add_subcommand(
        "batch", "Flatten a list of garments, each in a process of its own (docs/batch.md)");
    command.callback([&arguments] { arguments.command = Arguments::Command::Batch; });
    command.footer(
        "\nWhat is finished is skipped when the same list is run again. Exit status 1 where a\n"
        "garment failed (the rest is written); Ctrl-C or SIGTERM ends it, with nothing half done.");
    addBatchOptions(command, arguments.batch);
    addFlattening(command, typed, arguments);
}

void addMarker(CLI::App& app, TypedOptions& typed, Arguments& arguments) {
    CLI::App& command =
        addCommand(app, arguments, Arguments::Command::Marker, "marker",
                   "Lay the pieces of a garment on cloth as densely as time allows, or shapes of "
                   "the nesting problem, .json (docs/marker.md)");
    command.footer(
        "\nAfter so many rounds the marker is the same everywhere; a time says after which round\n"
        "it ends, and so does Ctrl-C. Exit status 1 where a piece failed or is too large.");
    command
        .add_option("-o,--output", arguments.outputs,
                    "Marker to write, by its ending: .svg, .dxf, .pdf, .plt or .png; of several "
                    "materials a file each, named after it. May be given several times")
        ->type_name("FILE")
        ->allow_extra_args(false);  // so that inputs may follow
    command
        .add_option("--report", arguments.marker.report,
                    "Write use, length and places of copies as JSON")
        ->type_name("FILE.json")
        ->check(jsonName());
    addMarkerOptions(command, arguments.marker);
    addFabric(command, arguments, "What the garment is cut from, which says how wide that is");
    addMethodOptions(command, arguments.stated);
    addLineOptions(command, arguments.stated);
    addPatternOptions(command, arguments.stated);
    addLabelOptions(command, arguments.stated);
    addReading(command, arguments);
    addExporting(command, typed);
}

void addRender(CLI::App& app, TypedOptions& typed, Arguments& arguments) {
    CLI::App& render = addCommand(app, arguments, Arguments::Command::Render, "render",
                                  "Draw a garment and its pattern as the window shows them");
    render.add_option("-o,--output", typed.picture, "Picture to write")
        ->required()
        ->type_name("FILE.png");
    addPicture(render, typed, arguments,
               "What is painted on the cloth [what the project says, else checker]");
    addRenderedPicture(render, arguments.picture);
    addMethodOptions(render, arguments.stated);
    addLineOptions(render, arguments.stated);
    addPatternOptions(render, arguments.stated);
    addReading(render, arguments);
}

void addServe(CLI::App& app, Arguments& arguments) {
    CLI::App& command = *app.add_subcommand(
        "serve",
        "Answer requests of another program: a line of JSON each on the standard input, answers "
        "on the standard output (docs/serve.md)");
    command.callback([&arguments] { arguments.command = Arguments::Command::Serve; });
    command.footer(
        "\nEnds with the request \"quit\" or the end of the input. Exit status 0 whatever was\n"
        "answered, 3 where answers could not be written.");
}

}  // namespace toile::app
