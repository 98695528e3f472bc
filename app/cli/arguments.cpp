// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CLI11: it takes seconds to compile.
#include "app/cli/arguments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <CLI/CLI.hpp>

#include "app/cli/command_line.h"
#include "core/base/version.h"
#include "core/pipeline/pipeline.h"

namespace toile {
namespace {

/// The strings CLI11 fills, before they become typed values.
struct Typed {
    std::vector<std::string> inputs, windowFiles, outputs, methods;
    std::string unit, up, split = "auto", seams, method{name(FlattenOptions{}.method)}, report,
                          screenshot, overlay = "checker", panel;
    std::string solver = "newton", quality = "standard", freeBoundary = "pinned",
                stretchOutline = "circle";
};

const std::map<std::string, Overlay> kOverlays = {{"none", Overlay::None},
                                                  {"checker", Overlay::Checker},
                                                  {"area", Overlay::Area},
                                                  {"angle", Overlay::Angle},
                                                  {"strain", Overlay::Strain}};

const std::map<std::string, Panel> kPanels = {
    {"pieces", Panel::Pieces}, {"seams", Panel::Seams}, {"messages", Panel::Messages}};

const std::map<std::string, Quality> kQualities = {
    {"draft", Quality::Draft}, {"standard", Quality::Standard}, {"fine", Quality::Fine}};

const std::map<std::string, FreeBoundary> kFreeBoundaries = {{"pinned", FreeBoundary::Pinned},
                                                             {"spectral", FreeBoundary::Spectral}};

const std::map<std::string, StretchOutline> kStretchOutlines = {
    {"circle", StretchOutline::Circle}, {"curvature", StretchOutline::Curvature}};

/// One of these words; the help lists them as the option's type already.
template <class Words>
CLI::Validator oneOf(const Words& words) {
    CLI::Validator member = CLI::IsMember(words);
    member.description("");
    return member;
}

CLI::Validator oneOf(std::initializer_list<std::string> words) {
    return oneOf(std::vector<std::string>(words));
}

/// How files are read, divided and cut: the commands and the window alike.
void addReading(CLI::App& command, Typed& typed, LoadOptions& load) {
    command.add_option("--split", typed.split, "By what files are divided into pieces")
        ->type_name("auto|components|objects|groups|materials|uv|seams")
        ->check(oneOf({"auto", "components", "objects", "groups", "materials", "uv", "seams"}))
        ->capture_default_str();
    command.add_option("--unit", typed.unit, "Unit of the input's coordinates")
        ->type_name("mm|cm|m|in")
        ->check(oneOf({"mm", "cm", "m", "in"}));
    command.add_option("--up", typed.up, "Axis of the input that points up")
        ->type_name("y|z")
        ->check(oneOf({"y", "z"}));
    command
        .add_option("--seams", typed.seams,
                    "Cut the garment along the lines of this file, and take the ease of its seams "
                    "from it (docs/seams.md)")
        ->type_name("FILE.json");
    command.add_flag("--auto-cut", load.autoCut, "Cut open whatever cannot lie flat as it is");
    command.add_flag("--weld", load.weld, "Join vertices that lie on each other");
    command.add_flag("--strict", load.strict,
                     "Refuse a file in which anything has to be left out or mended");
}

std::vector<std::string> methodNames() {
    std::vector<std::string> names;
    for (const MethodTraits& method : allMethods()) {
        names.emplace_back(method.name);
    }
    return names;
}

/// How a method goes about it, each option for the methods that have the choice: the commands and
/// the window alike.
void addMethodOptions(CLI::App& command, Typed& typed, FlattenOptions& options) {
    command
        .add_option("--boundary-solver", typed.solver,
                    "Solver of the boundary problem (wang2005, curvature, stretch)")
        ->type_name("newton|slcp")
        ->check(oneOf({"newton", "slcp"}))
        ->capture_default_str();
    command
        .add_option("--quality", typed.quality,
                    "How much time isometric takes for how little distortion")
        ->type_name("draft|standard|fine")
        ->check(oneOf(kQualities))
        ->capture_default_str();
    command
        .add_option("--free-boundary", typed.freeBoundary,
                    "How natural holds its outline: two vertices pinned, or none")
        ->type_name("pinned|spectral")
        ->check(oneOf(kFreeBoundaries))
        ->capture_default_str();
    command
        .add_option("--stretch-outline", typed.stretchOutline,
                    "Outline in which stretch works: a circle as published, or that of curvature")
        ->type_name("circle|curvature")
        ->check(oneOf(kStretchOutlines))
        ->capture_default_str();
    command
        .add_option("--authalic", options.authalic,
                    "From 0, keep angles, to 1, keep areas: the interior of wang2005 and curvature")
        ->type_name("MU")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
}

void addMethod(CLI::App& command, Typed& typed) {
    const std::vector<std::string> names = methodNames();
    command.add_option("--method", typed.method, "Flattening method")
        ->type_name(CLI::detail::join(names, "|"))
        ->check(oneOf(names))
        ->capture_default_str();
}

CLI::App* addFlatten(CLI::App& app, Typed& typed, Arguments& arguments) {
    CLI::App* flatten = app.add_subcommand("flatten", "Flatten every piece of a garment");
    flatten->add_option("INPUT", typed.inputs, "Garment mesh: .obj, .off, .ply or .stl")
        ->required()
        ->type_name("FILE...");
    flatten
        ->add_option("-o,--output", typed.outputs,
                     "File to write, by its ending: .svg, .dxf, .obj (input with the pattern as "
                     "its UV map) or .json (report). May be given several times")
        ->type_name("FILE")
        ->allow_extra_args(false);  // so that inputs may follow
    addMethod(*flatten, typed);
    addMethodOptions(*flatten, typed, arguments.options);
    addReading(*flatten, typed, arguments.load);
    flatten->add_flag("--ledger", arguments.ledger,
                      "Print every seam with the lengths of its two sides");
    flatten
        ->add_option("--report", typed.report, "Write the JSON report (the same as -o FILE.json)")
        ->type_name("FILE.json");
    return flatten;
}

CLI::App* addCompare(CLI::App& app, Typed& typed, Arguments& arguments) {
    CLI::App* compare =
        app.add_subcommand("compare", "Flatten a garment by several methods and compare them");
    compare->add_option("INPUT", typed.inputs, "Garment mesh: .obj, .off, .ply or .stl")
        ->required()
        ->type_name("FILE...");
    const std::vector<std::string> names = methodNames();
    compare->add_option("--methods", typed.methods, "Methods to compare; all where none is named")
        ->type_name(CLI::detail::join(names, ","))
        ->delimiter(',')
        ->check(oneOf(names))
        ->allow_extra_args(false);  // so that inputs may follow
    addMethodOptions(*compare, typed, arguments.options);
    addReading(*compare, typed, arguments.load);
    compare->add_flag("--per-piece", arguments.perPiece, "Print a table for each piece too");
    CLI::Option* json = compare->add_flag("--json", arguments.json, "Print as JSON");
    compare->add_flag("--markdown", arguments.markdown, "Print tables as Markdown")->excludes(json);
    return compare;
}

CLI::App* addInfo(CLI::App& app, Typed& typed, Arguments& arguments) {
    CLI::App* info = app.add_subcommand("info", "Tell what a garment file holds");
    info->add_option("INPUT", typed.inputs, "Garment mesh: .obj, .off, .ply or .stl")
        ->required()
        ->type_name("FILE...");
    addReading(*info, typed, arguments.load);
    info->add_flag("--json", arguments.json, "Print as JSON");
    return info;
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

Arguments message(std::string text, int status) {
    Arguments arguments;
    arguments.command = Arguments::Command::Message;
    arguments.message = std::move(text);
    arguments.status = status;
    return arguments;
}

/// One sentence, as every error.
Arguments wrongUsage(const std::string& what) {
    return message("toile: " + what + "; see toile --help.\n", kExitUsage);
}

/// A mistyped output must not cost the user the garment.
const std::filesystem::path* overwrittenInput(const Arguments& arguments) {
    std::vector<std::filesystem::path> inputs = arguments.inputs;
    if (!arguments.seams.empty()) {
        inputs.push_back(arguments.seams);
    }
    for (const auto& output : arguments.outputs) {
        for (const auto& input : inputs) {
            std::error_code ignored;
            if (std::filesystem::equivalent(input, output, ignored)) {
                return &output;
            }
        }
    }
    return nullptr;
}

/// CLI11's own wording for help, version and usage errors.
Arguments fromParseError(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(error, out, err) == 0) {
        return message(out.str(), kExitDone);
    }
    const std::string said = err.str();
    return wrongUsage(said.substr(0, said.find('\n')));
}

}  // namespace

Arguments parseArguments(int argc, const char* const* argv) {
    CLI::App app{
        "Toile: sewing patterns from 3D garments.\n"
        "Without a command it opens the window.\n"};
    app.name("toile");
    app.set_version_flag("--version", "toile " + std::string(version()));
    app.footer(
        "\nExit status: 0 all pieces done, 1 some piece failed (the rest is written),\n"
        "2 wrong usage, 3 a file cannot be read or written.");
    app.require_subcommand(0, 1);

    Typed typed;
    Arguments arguments;
    const CLI::App* flatten = addFlatten(app, typed, arguments);
    const CLI::App* compare = addCompare(app, typed, arguments);
    const CLI::App* info = addInfo(app, typed, arguments);
    // A window's files stand where a command could: `toile dress.obj`.
    app.add_option("FILE", typed.windowFiles, "Garment to open in the window")
        ->type_name("FILE...");
    app.add_option("--screenshot", typed.screenshot,
                   "Open the window, save a picture of it as PNG and end")
        ->type_name("FILE.png");
    app.add_option("--overlay", typed.overlay, "What the window paints on the cloth at first")
        ->type_name("none|checker|area|angle|strain")
        ->check(oneOf(kOverlays))
        ->capture_default_str();
    app.add_option("--panel", typed.panel, "The list that the window shows in front at first")
        ->type_name("pieces|seams|messages")
        ->check(oneOf(kPanels));
    addMethod(app, typed);
    addMethodOptions(app, typed, arguments.options);
    addReading(app, typed, arguments.load);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return fromParseError(app, error);
    }

    arguments.command = flatten->parsed()   ? Arguments::Command::Flatten
                        : compare->parsed() ? Arguments::Command::Compare
                        : info->parsed()    ? Arguments::Command::Info
                                            : Arguments::Command::Window;
    if (arguments.command != Arguments::Command::Window && !typed.windowFiles.empty()) {
        return wrongUsage("\"" + typed.windowFiles.front() + "\" stands before the command");
    }
    const auto& inputs =
        arguments.command == Arguments::Command::Window ? typed.windowFiles : typed.inputs;
    arguments.inputs.assign(inputs.begin(), inputs.end());
    arguments.outputs.assign(typed.outputs.begin(), typed.outputs.end());
    arguments.screenshot = typed.screenshot;
    arguments.overlay = kOverlays.at(typed.overlay);
    if (!typed.panel.empty()) {
        arguments.panel = kPanels.at(typed.panel);
    }
    arguments.load.unit = parseLengthUnit(typed.unit);
    arguments.load.up = parseUpAxis(typed.up);
    arguments.load.split = parseSplitMode(typed.split).value_or(SplitMode::Auto);
    arguments.seams = typed.seams;
    if (arguments.load.split == SplitMode::Seams && arguments.seams.empty()) {
        return wrongUsage("--split seams divides by the cuts of a file: give it with --seams");
    }
    arguments.options.method = parseMethod(typed.method).value_or(FlattenOptions{}.method);
    arguments.options.boundarySolver =
        parseBoundarySolver(typed.solver).value_or(BoundarySolver::Newton);
    if (std::isnan(arguments.options.authalic)) {  // which is neither below nor above a limit
        return wrongUsage("--authalic must be a number from 0 to 1");
    }
    arguments.options.quality = kQualities.at(typed.quality);
    arguments.options.freeBoundary = kFreeBoundaries.at(typed.freeBoundary);
    arguments.options.stretchOutline = kStretchOutlines.at(typed.stretchOutline);
    arguments.methods = methodsOf(typed);
    if (!typed.report.empty()) {
        if (!typed.report.ends_with(".json") && !typed.report.ends_with(".JSON")) {
            return wrongUsage("the report's name must end in .json, not \"" + typed.report + "\"");
        }
        arguments.outputs.emplace_back(typed.report);
    }
    for (const auto& output : arguments.outputs) {
        if (!canExport(output)) {
            return wrongUsage("\"" + output.string() +
                              "\" has an ending that Toile does not write; use .svg, .dxf, .obj or "
                              ".json");
        }
    }
    if (const auto* lost = overwrittenInput(arguments)) {
        return wrongUsage("\"" + lost->string() + "\" is an input and would be overwritten");
    }
    return arguments;
}

}  // namespace toile
