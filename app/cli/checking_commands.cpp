// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that tell how good a garment or its pattern is. Includes CLI11 as `arguments.cpp` does;
// both are compiled together.
#include "app/cli/choice_options.h"
#include "app/cli/commands.h"
#include "app/cli/flattening_options.h"
#include "app/cli/picture_options.h"
#include "app/cli/prove_options.h"
#include "app/cli/reading_options.h"
#include "core/garment/fabric.h"

namespace toile::app {
namespace {

constexpr Word<bool> kFailOnWords[] = {{false, "fault"}, {true, "doubt"}};

}  // namespace

CLI::App& addCommand(CLI::App& app, Arguments& arguments, Arguments::Command command,
                     const std::string& word, const std::string& help) {
    CLI::App& added = *app.add_subcommand(word, help);
    added.callback([&arguments, command] { arguments.command = command; });
    added
        .add_option(
            "INPUT", arguments.inputs,
            "Garment mesh: .obj, .off, .ply, .stl, .usda, .glb, .gltf, .fbx, .dae or .3mf; a "
            ".zip with one of the first five; or a project: .toile")
        ->required()
        ->type_name("FILE...");
    return added;
}

void addFailOn(CLI::App& command, Arguments& arguments) {
    addChoice(command, "--fail-on", arguments.failOnDoubt, kFailOnWords,
              "doubt: exit status 1 also where the pattern is in doubt (docs/ready-to-cut.md)")
        ->default_str("fault");
}

void addFabric(CLI::App& command, Arguments& arguments, const std::string& help) {
    std::vector<std::string> fabrics;
    for (const Fabric& fabric : fabricPresets()) {
        fabrics.push_back(fabric.id);
    }
    addChoice(command, "--fabric", arguments.fabric, fabrics, fabricPreset, help);
}

void addCompare(CLI::App& app, TypedOptions& typed, Arguments& arguments) {
    CLI::App& compare = addCommand(app, arguments, Arguments::Command::Compare, "compare",
                                   "Flatten a garment by several methods and compare them");
    const std::vector<std::string> names = methodNames();
    compare.add_option("--methods", typed.methods, "Methods to compare; all where none is named")
        ->type_name(CLI::detail::join(names, ","))
        ->delimiter(',')
        ->check(oneOf(names))
        ->allow_extra_args(false);  // so that inputs may follow
    addMethodOptions(compare, arguments.stated, false);
    addReading(compare, arguments);
    compare.add_flag("--per-piece", arguments.perPiece, "Print a table for each piece too");
    CLI::Option* proving =
        compare.add_flag("--prove", arguments.isProving,
                         "Sew each pattern back together and say how far from the design it sits");
    addSelfContact(compare, arguments, proving);
    CLI::Option* pattern =
        addPatternFile(compare, arguments, "Compare with the pieces of this pattern instead");
    pattern->excludes(proving);
    compare
        .add_option("-o,--output", arguments.outputs,
                    "With --pattern: a picture of each pair, .svg")
        ->type_name("FILE.svg")
        ->needs(pattern)
        ->allow_extra_args(false);  // so that inputs may follow
    CLI::Option* json = compare.add_flag("--json", arguments.json, "Print as JSON");
    compare.add_flag("--markdown", arguments.markdown, "Print tables as Markdown")->excludes(json);
}

void addCheck(CLI::App& app, Arguments& arguments) {
    CLI::App& check = addCommand(app, arguments, Arguments::Command::Check, "check",
                                 "Flatten a garment and tell whether it is ready to cut");
    addFabric(check, arguments,
              std::string("What the garment is cut from; ") + fabricPresets().front().id +
                  ", and its strain no fault, where neither this nor a project says so");
    addMethodOptions(check, arguments.stated);
    addLineOptions(check, arguments.stated);
    addPatternOptions(check, arguments.stated);
    addReading(check, arguments);
    addFailOn(check, arguments);
    CLI::Option* proving = check.add_flag(
        "--prove", arguments.isProving,
        "Sew the pattern back together first: a doubt where it sits far from the design");
    addSelfContact(check, arguments, proving);
    check.add_flag("--json", arguments.json, "Print as JSON");
}

void addWalk(CLI::App& app, Arguments& arguments) {
    CLI::App& walk = addCommand(app, arguments, Arguments::Command::Walk, "walk",
                                "Flatten a garment and walk its seams from notch to notch: the "
                                "lengths of both sides, and the kinks at the ends");
    walk.footer(
        "\nExit status 1 where the lengths of two sides differ by more than a millionth of a\n"
        "millimetre from the ease that is meant, or a piece failed.");
    addMethodOptions(walk, arguments.stated);
    addLineOptions(walk, arguments.stated);
    addPatternOptions(walk, arguments.stated);
    addReading(walk, arguments);
    walk.add_flag("--json", arguments.json, "Print as JSON");
}

void addProve(CLI::App& app, TypedOptions& typed, Arguments& arguments) {
    CLI::App& command =
        addCommand(app, arguments, Arguments::Command::Prove, "prove",
                   "Sew the pattern of a garment back together and measure how far from the "
                   "design it comes to rest (docs/prove.md)");
    areAbout(kInputFiles, command, typed.groups);
    command.footer(
        "\nExit status 1 where the pattern has a fault that is seen before it is sewn, such as a\n"
        "mirrored piece or a seam whose sides do not fit, or a piece failed. Ctrl-C ends it.");
    command
        .add_option("-o,--output", arguments.outputs,
                    "Picture of the sewn garment to write, .png; with --prove-improve also the "
                    "pattern, in any other format of flatten")
        ->type_name("FILE")
        ->allow_extra_args(false);  // so that inputs may follow
    areAbout(kOutputFiles, command, typed.groups);
    addPicture(command, typed, arguments, "What the picture has painted on the cloth [gap]");
    areAbout(kForTerminal, command, typed.groups);
    addSewing(command, arguments);
    addFabric(command, arguments,
              "What the garment is cut from, which says how it resists [what the project says, "
              "else a sheet that is alike in all directions]");
    areAbout(kSewing, command, typed.groups);
    addProveOutput(command, arguments);
    areAbout(kForTerminal, command, typed.groups);
    addMethodOptions(command, arguments.stated);
    addLineOptions(command, arguments.stated);
    addPatternOptions(command, arguments.stated, false);
    areAbout(kFlattening, command, typed.groups);
    addReading(command, arguments);
    areAbout(kReading, command, typed.groups);
}

void addInfo(CLI::App& app, TypedOptions& typed, Arguments& arguments) {
    CLI::App& info = addCommand(app, arguments, Arguments::Command::Info, "info",
                                "Tell what a garment file holds");
    areAbout(kInputFiles, info, typed.groups);
    addReading(info, arguments);
    areAbout(kReading, info, typed.groups);
    CLI::Option* json = info.add_flag("--json", arguments.json, "Print as JSON");
    info.add_flag("--advice", arguments.advice,
                  "Say which cuts would take most strain away, and what they leave")
        ->excludes(json);
}

}  // namespace toile::app
