// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/reading_options.h"

#include <string>
#include <utility>

#include "app/cli/choice_options.h"
#include "core/toile/pipeline.h"

namespace toile::app {
namespace {

constexpr int kMaxLayers = 1000;

/// What files are, and what is done with them before they are divided.
void addPreparing(CLI::App& command, Preparation& preparing) {
    addChoice(command, "--as", preparing.as, kFileKindWords,
              "What the files are, if that is not seen rightly (docs/input.md)");
    addChoice(command, "--surface", preparing.surface, kShellSurfaceWords,
              "Which surface of a thick shell is the sheet")
        ->default_str("outer");
    command
        .add_option("--layer", preparing.onlyLayer,
                    "Which of several layers of cloth is taken, from the outermost, 1; 0: all")
        ->type_name("N")
        ->check(within(0, kMaxLayers));
    ScanSteps& scan = preparing.scan;
    command.add_flag_callback(
        "--keep-debris", [&scan] { scan.dropDebris = false; },
        "Of a scan: keep fragments that are no part of the garment");
    const auto addLength = [&](const char* option, double& length, const char* help) {
        command.add_option(option, length, help)
            ->type_name("MM")
            ->check(within(0.0, kMaxPreparedLength));
    };
    addLength("--close-holes", scan.largestHole,
              "Of a scan: close holes up to this perimeter; 0: none");
    addLength("--smooth", scan.smoothing, "Of a scan: smooth noise up to this height; 0: none");
    addLength("--remesh", scan.edgeLength,
              "Of a scan: make its triangles anew, with edges of this length; 0: not");
    addLength("--weld-within", preparing.weldDistance,
              "Of a soup: join vertices up to this distance; 0: a thousandth of an edge");
    command.add_flag("--complete-half", preparing.isHalf,
                     "The files hold half a garment: add its mirror image");
    command.add_flag("--turn-over", preparing.isTurned,
                     "Turn all faces over: the garment is inside out");
    command.parse_complete_callback([&command, &preparing] {
        static constexpr std::pair<const char*, FileKind> kGoesWith[] = {
            {"--keep-debris", FileKind::Scan}, {"--close-holes", FileKind::Scan},
            {"--smooth", FileKind::Scan},      {"--remesh", FileKind::Scan},
            {"--weld-within", FileKind::Soup}, {"--surface", FileKind::Shell},
            {"--layer", FileKind::Layers}};
        for (const auto& [option, kind] : kGoesWith) {
            const bool isRecognised = kind == FileKind::Shell || kind == FileKind::Layers;
            const bool fits = preparing.as == kind || (isRecognised && !preparing.as);
            if (command.count(option) > 0 && !fits) {
                throw CLI::ValidationError(
                    option, "goes with --as " + std::string(wordOf(kFileKindWords, kind)));
            }
        }
    });
}

}  // namespace

void addReading(CLI::App& command, Arguments& arguments) {
    LoadOptions& load = arguments.load;
    addChoice(command, "--split", load.split,
              {"auto", "components", "objects", "groups", "materials", "uv", "seams"},
              parseSplitMode, "By what files are divided into pieces")
        ->default_str(std::string(name(load.split)));
    command
        .add_option_function<std::string>(
            "--unit", [&load](const std::string& text) { load.unit = parseFileUnit(text); },
            "Unit of the input's coordinates; or what one is: 12.5mm")
        ->type_name("mm|cm|dm|m|in|LENGTH")
        ->check([](const std::string& text) {
            return parseFileUnit(text)
                       ? std::string()
                       : text + " is no unit: mm, cm, dm, m, in, or a length such as 25.4mm";
        });
    addChoice(command, "--up", load.up, {"y", "z"}, parseUpAxis,
              "Axis of the input that points up");
    command
        .add_option(
            "--seams", arguments.seams,
            "Cut and join the garment along the lines of this file, and take the ease of its "
            "seams from it (docs/seams.md)")
        ->type_name("FILE.json");
    command.add_flag("--auto-cut", load.autoCut, "Cut open whatever cannot lie flat as it is");
    addChoice(command, "--cut-style", load.cutStyle, kCutStyleWords,
              "Where automatic cuts run: as tailors cut, or the shortest ways that open a piece")
        ->default_str("auto");
    command
        .add_option_function<double>(
            "--enough", [&load](double percent) { load.enoughStrain = percent / 100; },
            "Strain at which no further cut is worth its length: of what tailors would cut as much "
            "is cut as that needs [their usual seams]")
        ->type_name("PERCENT")
        ->check(within(0.1, 100.0));
    command.add_flag("--swap-front", load.isFrontSwapped,
                     "Take the guessed front of tailors' cuts for the back");
    command.add_flag("--weld", load.weld, "Join vertices that lie on each other");
    addPreparing(command, load.preparing);
    command.add_flag("--close-slits", load.closeSlits,
                     "Sew shut the slits inside pieces, as texture maps have them");
    command.add_flag("--strict", load.strict,
                     "Refuse a file in which anything has to be left out or repaired");
}

}  // namespace toile::app
