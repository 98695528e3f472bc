// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that make something of a garment. Includes CLI11 as `arguments.cpp` does; both are
// compiled together.
#include "app/cli/batch_options.h"
#include "app/cli/choice_options.h"
#include "app/cli/commands.h"
#include "app/cli/flattening_options.h"
#include "app/cli/marker_options.h"
#include "app/cli/picture_options.h"
#include "app/cli/reading_options.h"
#include "core/export/formats.h"

namespace toile::app {
namespace {

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
