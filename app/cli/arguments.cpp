// SPDX-License-Identifier: GPL-3.0-or-later
// All options of all commands, in the order in which their help lists them; so it is longer than
// most. CLI11 takes seconds to compile: only this and what is compiled with it include it.
#include "app/cli/arguments.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <sstream>

#include "app/cli/batch_options.h"
#include "app/cli/check_arguments.h"
#include "app/cli/choice_options.h"
#include "app/cli/command_line.h"
#include "app/cli/exit_status.h"
#include "app/cli/first_word.h"
#include "app/cli/marker_options.h"
#include "app/cli/option_groups.h"
#include "app/cli/prove_options.h"
#include "app/cli/reading_options.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/export/formats.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/fabric.h"
#include "core/pipeline/pipeline.h"

namespace toile::app {
namespace {

/// What becomes of it is known only when all is parsed.
struct Typed {
    std::vector<std::filesystem::path> windowFiles;
    std::vector<std::string> methods;
    std::string report, picture, size, look;
    std::map<std::string, std::string> exporting;  ///< by FormatOption::name
    OptionGroups groups;
};

constexpr Word<ViewsShown> kViewWords[] = {
    {ViewsShown::Garment, "garment"}, {ViewsShown::Pattern, "pattern"}, {ViewsShown::Both, "both"}};

constexpr Word<bool> kNotchesWords[] = {{true, "auto"}, {false, "none"}};
constexpr Word<bool> kFailOnWords[] = {{false, "fault"}, {true, "doubt"}};
constexpr Word<bool> kSwitchWords[] = {{true, "on"}, {false, "off"}};

constexpr Word<Panel> kPanelWords[] = {
    {Panel::Pieces, "pieces"},   {Panel::Seams, "seams"}, {Panel::ProblemList, "problems"},
    {Panel::History, "history"}, {Panel::Lines, "lines"}, {Panel::Symmetry, "symmetry"},
    {Panel::Proof, "proof"}};

std::vector<std::string> methodNames() {
    std::vector<std::string> names;
    for (const MethodTraits& method : allMethods()) {
        names.emplace_back(method.name);
    }
    return names;
}

/// A command, with the files that each of them takes.
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

/// From when on the exit status is that of a failure.
void addFailOn(CLI::App& command, Arguments& arguments) {
    addChoice(command, "--fail-on", arguments.failOnDoubt, kFailOnWords,
              "doubt: exit status 1 also where the pattern is in doubt (docs/ready-to-cut.md)")
        ->default_str("fault");
}

/// By which method, and how it goes about it, each option for the methods that have the choice: the
/// commands and the window alike.
void addMethodOptions(CLI::App& command, StatedOptions& stated, bool isOne = true) {
    const FlattenOptions usual;
    if (isOne) {
        addChoice(command, "--method", stated.method, methodNames(), parseMethod,
                  "Flattening method")
            ->default_str(std::string(name(usual.method)));
    }
    const auto add = [&command](const std::string& option, auto& value, const auto& words,
                                auto otherwise, const std::string& help) {
        addChoice(command, option, value, words, help)
            ->default_str(std::string(wordOf(words, otherwise)));
    };
    add("--boundary-solver", stated.boundarySolver, kBoundarySolverWords, usual.boundarySolver,
        "Solver of the boundary problem (wang2005, curvature, stretch)");
    add("--quality", stated.quality, kQualityWords, usual.quality,
        "How much time isometric takes for how little distortion");
    add("--free-boundary", stated.freeBoundary, kFreeBoundaryWords, usual.freeBoundary,
        "How natural holds its outline: two vertices pinned, or none");
    add("--stretch-outline", stated.stretchOutline, kStretchOutlineWords, usual.stretchOutline,
        "Outline in which stretch works: a circle as published, or that of curvature");
    command
        .add_option_function<double>(
            "--authalic", [&stated](double mu) { stated.authalic = mu; },
            "From 0, keep angles, to 1, keep areas: the interior of wang2005 and curvature")
        ->type_name("MU")
        ->check(within(0.0, 1.0))
        ->default_str("0");
}

std::optional<Mirror> parseMirror(std::string_view text) {
    return text == "auto"   ? std::optional(Mirror::Mean)
           : text == "none" ? std::optional(Mirror::None)
                            : std::nullopt;
}

/// How outlines are drawn.
void addLineOptions(CLI::App& command, StatedOptions& stated) {
    command
        .add_option_function<std::vector<double>>(
            "--fair",
            [&stated](const std::vector<double>& typed) {
                Fairing& fairing = stated.fairing.emplace();
                fairing.tolerance = typed.front();
                fairing.smoothing = typed.size() > 1 ? typed[1] : fairing.smoothing;
            },
            "Draw outlines as fair lines of the same length, at most so far from the exact ones, "
            "smoothed over LAMBDA [1,40]")
        ->type_name("[MM[,LAMBDA]]")
        ->delimiter(',')
        ->expected(1, 2)
        ->allow_extra_args(false);
    command.add_flag("--true", stated.trueSeams,
                     "True the lines at the ends of seams: kinks up to 10 degrees are taken out; "
                     "draws fair lines");
    addChoice(command, "--mirror", stated.mirror, {"auto", "none"}, parseMirror,
              "auto: pieces that mirror each other become equal, and those that are symmetric in "
              "themselves symmetric")
        ->default_str("none");
}

/// What is added to the outlines.
/// @param hasPreset  with `--pattern`; else that word is free for a file
void addPatternOptions(CLI::App& command, StatedOptions& stated, bool hasPreset = true) {
    const AllowanceWidths usual;
    const auto addWidth = [&command](const char* option, std::optional<double>& width,
                                     double otherwise, const std::string& help) {
        command
            .add_option_function<double>(
                option, [&width](double typed) { width = typed; }, help)
            ->type_name("MM")
            ->check(within(0.0, kMaxAllowance))
            ->default_str(shortest(otherwise));
    };
    addWidth("--allowance", stated.allowance, usual.seam,
             "Cut pieces this far outside their seam lines, and further along hems");
    addWidth("--hem", stated.hem, usual.hem, "The same along free edges");
    addChoice(command, "--notches", stated.notches, kNotchesWords,
              "auto: mark the places at which the two sides of a seam are laid on each other")
        ->default_str("none");
    if (hasPreset) {
        command.add_flag(
            "--pattern", stated.pattern,
            "A pattern to cut and sew: --fair --true --mirror auto --allowance 10 --hem 30 "
            "--notches auto --grain vertical, but for what a project or another option "
            "says");
    }
    addChoice(command, "--grain", stated.grain, kGrainRuleWords,
              "How the grain runs where a project does not say: as the garment hangs, as in the "
              "reference panels, or as the garment hangs and turned by 45 or 90 degrees where that "
              "strains the cloth much less [unset: no grain line is drawn]");
}

/// What stands on all labels.
void addLabelOptions(CLI::App& command, StatedOptions& stated) {
    const auto addText = [&command](const char* option, std::optional<std::string>& text,
                                    const std::string& help) {
        command
            .add_option_function<std::string>(
                option, [&text](const std::string& typed) { text = typed; }, help)
            ->type_name("TEXT");
    };
    addText("--size", stated.size, "The size that the labels of all pieces name [none]");
    addText("--date", stated.date, "The date that the labels of all pieces name [none]");
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

/// What can be chosen of the files to write.
void addExporting(CLI::App& command, Typed& typed) {
    for (const FormatOption& row : formatOptions()) {
        const std::string option = std::string("--") + row.name;
        const std::string otherwise = row.get(ExportOptions{});
        if (row.isSwitch) {
            command.add_flag_callback(
                option, [&typed, name = row.name] { typed.exporting[name] = "on"; }, row.help);
            continue;
        }
        const std::vector<std::string> words(row.words.begin(), row.words.end());
        CLI::Option* added = command.add_option_function<std::string>(
            option,
            [&typed, name = row.name](const std::string& value) { typed.exporting[name] = value; },
            row.help);
        added->type_name(words.empty() ? "NUMBER" : CLI::detail::join(words, "|"))
            ->default_str(otherwise);
        if (words.empty()) {
            added->check(within(row.least, row.most).description(""));
        } else {
            added->check(oneOf(words));
        }
    }
}

/// How a garment is flattened and written, for one garment and for many.
void addFlattening(CLI::App& command, Typed& typed, Arguments& arguments) {
    addMethodOptions(command, arguments.stated);
    addLineOptions(command, arguments.stated);
    addPatternOptions(command, arguments.stated);
    addLabelOptions(command, arguments.stated);
    command.add_flag("--half", arguments.stated.byHalf,
                     "Draw only half of what is symmetric, to be cut on the fold, and one of two "
                     "that mirror each other, to be cut as a pair; asks for --mirror auto");
    areAbout(kFlattening, command, typed.groups);
    addReading(command, arguments);
    areAbout(kReading, command, typed.groups);
    addExporting(command, typed);
    areAbout(kExporting, command, typed.groups);
}

void addFlatten(CLI::App& app, Typed& typed, Arguments& arguments) {
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
        ->check(within(0, kMostThreads))
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

void addBatch(CLI::App& app, Typed& typed, Arguments& arguments) {
    CLI::App& command = *app.add_subcommand(
        "batch", "Flatten a list of garments, each in a process of its own (docs/batch.md)");
    command.callback([&arguments] { arguments.command = Arguments::Command::Batch; });
    command.footer(
        "\nWhat is finished is skipped when the same list is run again. Exit status 1 where a\n"
        "garment failed (the rest is written); Ctrl-C or SIGTERM ends it, with nothing half done.");
    addBatchOptions(command, arguments.batch);
    addFlattening(command, typed, arguments);
}

void addCompare(CLI::App& app, Typed& typed, Arguments& arguments) {
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
        compare
            .add_option(
                "--pattern", arguments.pattern,
                "Compare with the pieces of this pattern instead: .dxf, .svg or GarmentCode's "
                ".specification.json")
            ->type_name("FILE")
            ->excludes(proving);
    compare
        .add_option("-o,--output", arguments.outputs,
                    "With --pattern: a picture of each pair, .svg")
        ->type_name("FILE.svg")
        ->needs(pattern)
        ->allow_extra_args(false);  // so that inputs may follow
    CLI::Option* json = compare.add_flag("--json", arguments.json, "Print as JSON");
    compare.add_flag("--markdown", arguments.markdown, "Print tables as Markdown")->excludes(json);
}

/// How a picture of both views shows them.
void addPicture(CLI::App& command, Typed& typed, Arguments& arguments, const std::string& overlay) {
    PictureArguments& picture = arguments.picture;
    addChoice(command, "--view", picture.views, kViewWords, "What to draw; both lie side by side")
        ->default_str("both");
    addChoice(command, "--overlay", arguments.overlay, kOverlayWords, overlay);
    command.add_option("--size", typed.size, "Width and height in pixels [1600x800]")
        ->type_name("WxH");
    command
        .add_option("--look", typed.look,
                    "From where the garment is seen, a side or degrees around and upwards")
        ->type_name("front|back|left|right|top|bottom|YAW,PITCH");
    command.add_flag("--dark", picture.dark, "On a dark ground");
}

void addRender(CLI::App& app, Typed& typed, Arguments& arguments) {
    CLI::App& render = addCommand(app, arguments, Arguments::Command::Render, "render",
                                  "Draw a garment and its pattern as the window shows them");
    render.add_option("-o,--output", typed.picture, "Picture to write")
        ->required()
        ->type_name("FILE.png");
    PictureArguments& picture = arguments.picture;
    addPicture(render, typed, arguments,
               "What is painted on the cloth [what the project says, else checker]");
    render
        .add_option("--morph", picture.morph,
                    "The garment on its way to the pattern: 0 as it is worn, 1 flat")
        ->type_name("SHARE")
        ->check(within(0.0, 1.0))
        ->capture_default_str();
    render.add_flag("--wireframe", picture.wireframe, "Draw the mesh's edges");
    render.add_flag("--xray", picture.xray, "Let cloth show what is behind it");
    addChoice(render, "--seams-shown", picture.seams, kSwitchWords,
              "Seam lines, each pair in one colour")
        ->default_str("on");
    addChoice(render, "--bar", picture.bar, kSwitchWords,
              "The colour bar below [on where the overlay is measured]");
    render
        .add_option("--thumbnail", picture.thumbnail,
                    "A square picture of the garment alone, so many pixels wide, for file "
                    "managers, made quickly; its name may end in anything")
        ->type_name("PIXELS")
        ->check(within(kMinPicture, kMaxPicture))
        ->excludes("--size", "--view", "--overlay", "--morph");
    addMethodOptions(render, arguments.stated);
    addLineOptions(render, arguments.stated);
    addPatternOptions(render, arguments.stated);
    addReading(render, arguments);
}

void addFabric(CLI::App& command, Arguments& arguments, const std::string& help) {
    std::vector<std::string> fabrics;
    for (const Fabric& fabric : fabricPresets()) {
        fabrics.push_back(fabric.id);
    }
    addChoice(command, "--fabric", arguments.fabric, fabrics, fabricPreset, help);
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

void addMarker(CLI::App& app, Typed& typed, Arguments& arguments) {
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
        ->check([](const std::string& name) {
            return name.ends_with(".json") || name.ends_with(".JSON")
                       ? std::string()
                       : "the report's name must end in .json, not \"" + name + "\"";
        });
    addMarkerOptions(command, arguments.marker);
    addFabric(command, arguments, "What the garment is cut from, which says how wide that is");
    addMethodOptions(command, arguments.stated);
    addLineOptions(command, arguments.stated);
    addPatternOptions(command, arguments.stated);
    addLabelOptions(command, arguments.stated);
    addReading(command, arguments);
    addExporting(command, typed);
}

void addProve(CLI::App& app, Typed& typed, Arguments& arguments) {
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

/// Of a proof: what is typed of a picture that is not asked for.
std::string wrongWithoutPicture(const CLI::App& app, const Arguments& arguments) {
    if (arguments.command != Arguments::Command::Prove ||
        std::ranges::any_of(arguments.outputs, isPicture)) {
        return {};
    }
    const CLI::App* prove = app.get_subcommand("prove");
    for (const char* option : {"--view", "--overlay", "--size", "--look", "--dark", "--sewn"}) {
        if (prove->count(option) > 0) {
            return std::string(option) + " is of a picture: ask for one with -o FILE.png";
        }
    }
    return {};
}

void addInfo(CLI::App& app, Typed& typed, Arguments& arguments) {
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

bool isNumber(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

/// As CLI11 takes them: last first. `--fair` may stand alone: what follows is its value only where
/// it begins as a number does.
std::vector<std::string> reversedWords(const std::vector<std::string>& typed) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        words.push_back(typed[i]);
        const std::string next = i + 1 < typed.size() ? typed[i + 1] : "";
        if (words.back() == "--fair" &&
            (next.empty() || !isNumber(next.substr(0, next.find(','))))) {
            words.emplace_back(shortest(Fairing{}.tolerance));
        }
    }
    std::ranges::reverse(words);
    return words;
}

/// Each once, in the order typed; all of them where none was.
std::vector<Method> methodsOf(const Typed& typed) {
    std::vector<Method> methods;
    for (const std::string& word : typed.methods.empty() ? methodNames() : typed.methods) {
        const auto method = parseMethod(word);
        if (method && std::ranges::find(methods, *method) == methods.end()) {
            methods.push_back(*method);
        }
    }
    return methods;
}

/// Rows as those of options, which the manual page reads too.
std::string exitStatusHelp() {
    constexpr std::size_t kColumn = 30;
    std::string text = "\nExit status:\n";
    for (const auto& [status, meaning] : exitMeanings()) {
        std::string row = std::string("  ") + status;
        row.resize(kColumn, ' ');
        text += row + meaning + '\n';
    }
    text.pop_back();
    return text;
}

Arguments message(std::string text, int status) {
    Arguments arguments;
    arguments.command = Arguments::Command::Message;
    arguments.message = std::move(text);
    arguments.status = status;
    return arguments;
}

std::vector<std::string> namesOfCommands(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

/// One sentence, as every error; it ends with where the command that was typed is explained.
Arguments wrongUsage(const CLI::App& app, const std::string& what) {
    const auto typed = app.get_subcommands();
    const std::string command = typed.empty() ? "" : typed.front()->get_name() + " ";
    return message("toile: " + what + "; see toile " + command + "--help.\n", kExitUsage);
}

/// "--split: At Most 1 required but received 2", as whoever typed it sees it.
std::string saidTwice(const std::string& said) {
    const std::size_t end = said.find(": At Most 1 required");
    return end == std::string::npos ? said
                                    : said.substr(0, end) + " is said more than once; say it once";
}

/// CLI11's own wording for help, version and most usage errors.
Arguments fromParseError(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(error, out, err) == 0) {
        return message(out.str(), kExitDone);
    }
    std::string said = err.str().substr(0, err.str().find('\n'));
    constexpr std::string_view kFlagWithValue = " was given a disallowed flag override";
    if (said.ends_with(kFlagWithValue)) {
        said = "--" + said.substr(0, said.size() - kFlagWithValue.size()) +
               " takes no value: it is said or left out";
    }
    return wrongUsage(app, saidTwice(said));
}

/// "--auto-cut=yes" would be read, and so would "--auto-cut=no" and "--auto-cut=7".
void refuseValuesOfFlags(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) {
        if (option->get_items_expected_max() == 0) {
            option->disable_flag_override();
        }
    }
    for (CLI::App* command : app.get_subcommands({})) {
        refuseValuesOfFlags(*command);
    }
}

}  // namespace

Arguments parseArguments(int argc, const char* const* argv, unsigned taken) {
    CLI::App app{
        "Toile: sewing patterns from 3D garments.\n"
        "Without a command it opens the window.\n"};
    app.name("toile");
    app.set_version_flag("--version", "toile " + std::string(version()));
    app.footer(exitStatusHelp());
    app.require_subcommand(0, 1);

    Typed typed;
    Arguments arguments;
    addFlatten(app, typed, arguments);
    addBatch(app, typed, arguments);
    addCompare(app, typed, arguments);
    addCheck(app, arguments);
    addWalk(app, arguments);
    addMarker(app, typed, arguments);
    addProve(app, typed, arguments);
    addInfo(app, typed, arguments);
    addRender(app, typed, arguments);
    addServe(app, arguments);
    // A window's files stand where a command could: `toile dress.obj`.
    app.add_option("FILE", typed.windowFiles, "Garment or project to open in the window")
        ->type_name("FILE...");
    app.add_option("--screenshot", arguments.screenshot,
                   "Open the window, save a picture of it as PNG and end")
        ->type_name("FILE.png");
    addChoice(app, "--overlay", arguments.overlay, kOverlayWords,
              "What the window paints on the cloth at first [what the project says, else checker]");
    addChoice(app, "--panel", arguments.panel, kPanelWords,
              "The list that the window shows in front at first");
    addMethodOptions(app, arguments.stated);
    addReading(app, arguments);
    refuseValuesOfFlags(app);
    const std::vector<std::string> words = wordsAfterProgram(argc, argv);
    if (const std::string wrong = unknownFirstWord(words, namesOfCommands(app)); !wrong.empty()) {
        return wrongUsage(app, wrong);
    }
    try {
        app.parse(reversedWords(words));
    } catch (const CLI::CallForHelp& help) {
        return taken == kEveryOption ? fromParseError(app, help)
                                     : wrongUsage(app, outOfPlace("--help", kForTerminal));
    } catch (const CLI::ParseError& error) {
        return fromParseError(app, error);
    }
    if (const std::string wrong = wordNotTaken(app, typed.groups, taken); !wrong.empty()) {
        return wrongUsage(app, wrong);
    }

    if (arguments.command == Arguments::Command::Window) {
        arguments.inputs = typed.windowFiles;
    } else if (!typed.windowFiles.empty()) {
        return wrongUsage(
            app, "\"" + typed.windowFiles.front().string() + "\" stands before the command");
    }
    if (arguments.command == Arguments::Command::Marker) {  // places of pieces, and no blocks
        arguments.exporting.dxf.profile = DxfProfile::Plain;
    }
    for (const FormatOption& row : formatOptions()) {
        const auto value = typed.exporting.find(row.name);
        if (value != typed.exporting.end() && !row.set(arguments.exporting, value->second)) {
            return wrongUsage(app, std::string("--") + row.name + " takes a number from " +
                                       shortest(row.least) + " to " + shortest(row.most));
        }
    }
    for (const std::string& wrong : {readPictureSize(typed.size, arguments.picture),
                                     readPictureLook(typed.look, arguments.picture)}) {
        if (!wrong.empty()) {
            return wrongUsage(app, wrong);
        }
    }
    if (const std::string wrong = wrongWithoutPicture(app, arguments); !wrong.empty()) {
        return wrongUsage(app, wrong);
    }
    arguments.options = arguments.stated.over(FlattenOptions{});
    arguments.lines = arguments.stated.over(LineSettings{});
    arguments.methods = methodsOf(typed);
    if (arguments.command == Arguments::Command::Batch) {
        arguments.batch.words = flattenWords(*app.get_subcommand("batch"));
    }
    for (const std::string& output : {typed.picture, typed.report}) {
        if (!output.empty()) {
            arguments.outputs.emplace_back(output);
        }
    }
    if (!typed.report.empty() && !typed.report.ends_with(".json") &&
        !typed.report.ends_with(".JSON")) {
        return wrongUsage(app, "the report's name must end in .json, not \"" + typed.report + "\"");
    }
    if (const std::string wrong = wrongIn(arguments); !wrong.empty()) {
        return wrongUsage(app, wrong);
    }
    return arguments;
}

}  // namespace toile::app
