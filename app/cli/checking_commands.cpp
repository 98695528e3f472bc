// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that tell how good a garment or its pattern is. Includes CLI11 as `arguments.cpp` does;
// both are compiled together.
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/choice_options.h"
#include "app/cli/commands.h"
#include "app/cli/flattening_options.h"
#include "app/cli/picture_options.h"
#include "app/cli/reading_options.h"
#include "core/garment/fabric.h"
#include "core/toile/improve.h"

namespace toile::app {
namespace {

constexpr double kMicro = 1e-6;
constexpr double kMinScale = 0.5, kMaxScale = 2;
constexpr int kMaxRounds = 100;
constexpr Word<SewnPattern> kTypedSewnWords[] = {{SewnPattern::Designer, "uv"},
                                                 {SewnPattern::Own, "none"}};

/// Notes that it was typed, with what goes with it. @param take  `ProveArguments::stated`
void notesTyped(ProveArguments& prove, CLI::Option* option,
                void (*take)(const ProofPlan& typed, ProofPlan& plan)) {
    option->each([&prove, take](const std::string&) { prove.stated.push_back(take); });
}

/// @param field  of ProofSettings
template <auto field>
void notesSetting(ProveArguments& prove, CLI::Option* option) {
    notesTyped(prove, option, [](const ProofPlan& typed, ProofPlan& plan) {
        plan.settings.*field = typed.settings.*field;
    });
}

/// @param field  of StatedStiffness
template <auto field>
void notesStiffness(ProveArguments& prove, CLI::Option* option) {
    notesTyped(prove, option, [](const ProofPlan& typed, ProofPlan& plan) {
        plan.settings.stiffness.*field = typed.settings.stiffness.*field;
    });
}

CLI::Option* addUnit(CLI::App& command, const char* option, std::optional<FileUnit>& unit,
                     const char* help) {
    return command
        .add_option_function<std::string>(
            option, [&unit](const std::string& text) { unit = parseFileUnit(text); }, help)
        ->type_name("mm|cm|dm|m|in|LENGTH")
        ->check([](const std::string& text) {
            return parseFileUnit(text)
                       ? std::string()
                       : text + " is no unit: mm, cm, dm, m, in, or a length such as 25.4mm";
        });
}

/// Adds the file of a pattern that stands in the garment's own place: where another can, it
/// excludes this. @param what  becomes of it @param otherwise  what holds where it is left out
CLI::Option* addPatternFile(CLI::App& command, Arguments& arguments, const std::string& what,
                            const std::string& otherwise = {}) {
    return command
        .add_option("--pattern", arguments.pattern,
                    what + ": .dxf, .svg or GarmentCode's .specification.json" + otherwise)
        ->type_name("FILE");
}

void addSewnPattern(CLI::App& command, Arguments& arguments) {
    ProveArguments& prove = arguments.prove;
    CLI::Option* pattern = addPatternFile(command, arguments, "Sew this pattern",
                                          " [the garment's own, as ASTM DXF, read back]");
    addUnit(command, "--pattern-unit", prove.patternUnit, "Unit of its coordinates")
        ->needs(pattern);
    CLI::Option* reference =
        addChoice(command, "--reference", prove.typed.sewn, kTypedSewnWords,
                  "Sew the designer's own panels, which the garment carries as its UV map; none: "
                  "its own pattern, whatever a project says")
            ->excludes(pattern);
    notesTyped(prove, reference,
               [](const ProofPlan& typed, ProofPlan& plan) { plan.sewn = typed.sewn; });
    command
        .add_option("--scale", prove.scale,
                    "Sew the pattern this many times as large as it is: 0.97 as cloth that shrinks "
                    "by 3 %")
        ->type_name("FACTOR")
        ->check(within(kMinScale, kMaxScale))
        ->capture_default_str();
    CLI::Option* body =
        command
            .add_option("--body", prove.typed.body,
                        "A mesh file of what the cloth is worn on, in the garment's space; none: "
                        "the design's own surface [what a project says, else none]")
            ->type_name("FILE|none");
    notesTyped(prove, body, [](const ProofPlan& typed, ProofPlan& plan) {
        plan.body = typed.body == kNoBody ? std::filesystem::path() : typed.body;
        plan.bodyUnit = typed.bodyUnit;
    });
    addUnit(command, "--body-unit", prove.typed.bodyUnit,
            "Unit of the body's coordinates [what its file states, else as the garment's]")
        ->needs(body);
    notesSetting<&ProofSettings::edge>(
        prove, command
                   .add_option("--edge", prove.typed.settings.edge,
                               "Length of the cloth's triangles [what a project says, else as the "
                               "garment's own]")
                   ->type_name("MM")
                   ->check(within(kMinProofEdge, kMaxProofEdge)));
}

void addStiffness(CLI::App& command, ProveArguments& prove) {
    StatedStiffness& stated = prove.typed.settings.stiffness;
    CLI::Option* stretch =
        command
            .add_option_function<std::vector<double>>(
                "--stretch",
                [&stated](const std::vector<double>& typed) {
                    stated.warp = typed.front();
                    stated.weft = typed.back();
                },
                "How the cloth resists being stretched along warp and weft, N/m [what a project "
                "says, else as its fabric]")
            ->type_name("WARP[,WEFT]")
            ->delimiter(',')
            ->expected(1, 2)
            ->allow_extra_args(false)
            ->check(within(kMinStretch, kMaxStretch));
    notesStiffness<&StatedStiffness::warp>(prove, stretch);
    notesStiffness<&StatedStiffness::weft>(prove, stretch);
    const auto add = [&command](const char* option, std::optional<double>& value, double unit,
                                const char* type, double least, double most, const char* help) {
        return command
            .add_option_function<double>(
                option, [&value, unit](double typed) { value = unit * typed; }, help)
            ->type_name(type)
            ->check(within(least, most));
    };
    notesStiffness<&StatedStiffness::shear>(
        prove, add("--shear", stated.shear, 1, "N/M", kMinShear, kMaxShear,
                   "How it resists being sheared, N/m"));
    notesStiffness<&StatedStiffness::bending>(
        prove, add("--bend", stated.bending, kMicro, "UNM", 0, kMaxBending / kMicro,
                   "How it resists being bent, in millionths of a newton metre"));
    notesStiffness<&StatedStiffness::weight>(
        prove, add("--weight", stated.weight, 1, "GSM", 0, kMaxClothWeight,
                   "What it weighs, g/m2: counts with --gravity"));
}

/// A flag that takes back what a project says. @param field  of ProofSettings
template <auto field>
CLI::Option* addTakingBack(CLI::App& command, ProveArguments& prove, const std::string& option,
                           CLI::Option* flag) {
    CLI::Option* none = command.add_flag_function(
        option, [&prove](std::int64_t) { prove.typed.settings.*field = false; },
        "Not so, whatever a project says");
    notesSetting<field>(prove, none->excludes(flag));
    return none;
}

/// Adds whether cloth keeps off itself, and how far. @param needed  asked for with it; may be null
void addSelfContact(CLI::App& command, Arguments& arguments, CLI::Option* needed = nullptr) {
    ProveArguments& prove = arguments.prove;
    ProofSettings& settings = prove.typed.settings;
    CLI::Option* touches = command.add_flag("--self-contact", settings.touchesItself,
                                            "Cloth keeps off itself [cloth goes through cloth]");
    notesSetting<&ProofSettings::touchesItself>(prove, touches);
    CLI::Option* none =
        addTakingBack<&ProofSettings::touchesItself>(command, prove, "--no-self-contact", touches);
    notesSetting<&ProofSettings::thickness>(
        prove,
        command.add_option("--cloth-thickness", settings.thickness, "How far it keeps off itself")
            ->type_name("MM")
            ->check(within(kMinThickness, kMaxThickness))
            ->capture_default_str()
            ->needs(touches));
    if (needed != nullptr) {
        touches->needs(needed);
        none->needs(needed);
    }
}

/// Adds what `toile prove` is told of pattern, body and cloth to a command.
void addSewing(CLI::App& command, Arguments& arguments) {
    addSewnPattern(command, arguments);
    ProveArguments& prove = arguments.prove;
    ProofSettings& settings = prove.typed.settings;
    addStiffness(command, prove);
    notesSetting<&ProofSettings::pressure>(
        prove, command
                   .add_option("--pressure", settings.pressure,
                               "Pressure on the cloth towards the design or the body; below 0: "
                               "outwards, as of a cushion's filling")
                   ->type_name("PA")
                   ->check(within(-kMaxPressure, kMaxPressure))
                   ->capture_default_str());
    CLI::Option* gravity =
        command.add_flag("--gravity", settings.hasGravity, "Let the cloth's weight pull down");
    notesSetting<&ProofSettings::hasGravity>(prove, gravity);
    addTakingBack<&ProofSettings::hasGravity>(command, prove, "--no-gravity", gravity);
    addSelfContact(command, arguments);
    notesSetting<&ProofSettings::threads>(
        prove,
        command
            .add_option("--threads", settings.threads, "To work with; the result is the same [all]")
            ->type_name("N")
            ->check(within(1, kMaxThreads)));
}

/// Adds what becomes of a proof. Precondition: the options of sewing are there.
void addProveOutput(CLI::App& command, Arguments& arguments) {
    command
        .add_option("--sewn", arguments.prove.sewn,
                    "The picture's garment on its way from as designed, 0, to as sewn, 1")
        ->type_name("SHARE")
        ->check(within(0.0, 1.0))
        ->capture_default_str();
    CLI::Option* improve = command.add_flag(
        "--prove-improve", [&arguments](std::int64_t) { arguments.prove.rounds = kImproveRounds; },
        "Improve the pattern, round by round: as cloth that hangs by its weight sags, and comes to "
        "lie where it was designed");
    improve->excludes("--pattern")->excludes("--reference")->excludes("--scale");
    command
        .add_option_function<int>(
            "--rounds", [&arguments](int rounds) { arguments.prove.rounds = rounds; },
            "At most so many [" + std::to_string(kImproveRounds) + "]")
        ->type_name("N")
        ->check(within(1, kMaxRounds))
        ->needs(improve);
    command
        .add_option("--report", arguments.prove.report, "Write the proof as JSON (docs/prove.md)")
        ->type_name("FILE.json")
        ->check(jsonName());
    command.add_flag("--json", arguments.json, "Print as JSON");
}

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
