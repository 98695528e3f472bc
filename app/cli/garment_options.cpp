// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/garment_options.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/flatten/base/flat_piece.h"
#include "core/formats/formats.h"

namespace toile::app {
namespace {

constexpr int kMaxLayers = 1000;
constexpr Range kPreparedLengths{0, kMaxPreparedLength};
constexpr double kPercent = 100;

constexpr Word<bool> kNotchesWords[] = {{true, "auto"}, {false, "none"}};
constexpr Word<Mirror> kTypedMirrorWords[] = {
    {Mirror::Close, "auto"}, {Mirror::Mean, "equal"}, {Mirror::None, "none"}};

void describeKinds(OptionArchive& at, Preparation& preparing) {
    at.section("Kind of input", kReading);
    at.choice("--as", preparing.as, kFileKindWords, "Kind of the input (docs/input.md)")
        .by("detected");
    at.choice("--surface", preparing.surface, kShellSurfaceWords,
              "Surface of a thick shell that becomes the sheet");
    at.number("--layer", "N", preparing.onlyLayer, {0, kMaxLayers},
              "Layer of cloth to use, counted from outside; 0 uses all");
    ScanSteps& scan = preparing.scan;
    at.flag("--keep-debris", scan.dropDebris, false,
            "Scan: keep fragments that are not part of the garment");
    at.number("--close-holes", "MM", scan.largestHole, kPreparedLengths,
              "Scan: close holes up to this perimeter; 0 closes none");
    at.number("--smooth", "MM", scan.smoothing, kPreparedLengths,
              "Scan: smooth noise up to this height; 0 disables it");
    at.number("--remesh", "MM", scan.edgeLength, kPreparedLengths,
              "Scan: remesh to this edge length; 0 disables it");
    at.number("--weld-within", "MM", preparing.weldDistance, kPreparedLengths,
              "Soup: join vertices up to this distance; 0 uses a thousandth of an edge");
}

void describeCutting(OptionArchive& at, Arguments& arguments) {
    LoadOptions& load = arguments.load;
    at.section("Cutting open", kReading);
    at.text("--seams", "FILE.json", arguments.seams,
            "File with cuts, joins and ease of seams (docs/seams.md)");
    at.flag("--auto-cut", load.autoCut, "Cut open what cannot lie flat");
    at.choice("--cut-style", load.cutStyle, kCutStyleWords,
              "Style of automatic cuts: as tailors cut, or the shortest ones");
    at.numberOf<double>("--max-strain", "PERCENT", {0.1, 100},
                        "Stop cutting when the strain is below this percentage",
                        [&load](double percent) { load.enoughStrain = percent / kPercent; })
        .formerly("--enough")
        .by("the usual seams of tailors");
    at.flag("--swap-front", load.isFrontSwapped, "Swap the detected front and back");
}

/// @return as `Option::read`
std::string readEdgeAllowances(const Words& typed, LineSettings& lines) {
    constexpr Range kWidths{0, kMaxAllowance};
    AllowanceWidths& widths = lines.allowance ? *lines.allowance : lines.allowance.emplace();
    for (const std::string& one : typed) {
        const Words parts = partsOf(one, '=');
        const auto kind = parseWord(kEdgeKindWords, parts.front());
        if (!kind || parts.size() != 2) {
            return one + " is not KIND=MM; KIND is " + wordList(kEdgeKindWords);
        }
        const auto width = parseNumber<double>(parts.back());
        if (!width || !(*width >= kWidths.least && *width <= kWidths.most)) {
            return outOfRange(parts.back(), kWidths, false);
        }
        (*kind == EdgeKind::Hem ? widths.hem
                                : widths.edges[static_cast<std::size_t>(*kind)].emplace()) = *width;
    }
    return {};
}

}  // namespace

Words methodNames() {
    Words names;
    for (const MethodTraits& method : allMethods()) {
        names.emplace_back(method.name);
    }
    return names;
}

Option& describeUnit(OptionArchive& at, const char* names, std::optional<FileUnit>& unit,
                     const char* help) {
    return at.add(names, "mm|cm|dm|m|in|LENGTH", help, [&unit](const Words& typed) {
        unit = parseFileUnit(typed.front());
        return unit ? std::string()
                    : typed.front() +
                          " is not a unit; use mm, cm, dm, m, in, or a length such as 25.4mm";
    });
}

ReadNumbers readNumbers(const std::string& typed, std::span<const Range> ranges,
                        std::span<double> numbers) {
    const Words parts = partsOf(typed, ',');
    if (parts.size() > numbers.size()) {
        return {0, "needs at most " + counted(static_cast<long long>(numbers.size()), "number") +
                       ", not \"" + typed + '"'};
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const auto number = parseNumber<double>(parts[k]);
        if (!number || !(*number >= ranges[k].least && *number <= ranges[k].most)) {
            return {0, outOfRange(parts[k], ranges[k], false)};
        }
        numbers[k] = *number;
    }
    return {parts.size(), {}};
}

void describeReading(OptionArchive& at, Arguments& arguments) {
    LoadOptions& load = arguments.load;
    at.section("Reading", kReading);
    describeUnit(at, "--unit", load.unit,
                 "Unit of the input's coordinates, or its length such as 12.5mm")
        .by("detected");
    at.choice("--up", load.up, {"y", "z"}, parseUpAxis, "Axis of the input that points up")
        .by("detected");
    at.choice("--split", load.split,
              {"auto", "components", "objects", "groups", "materials", "uv", "seams"},
              parseSplitMode, "What divides the input into pieces")
        .by(std::string(name(load.split)));
    at.flag("--weld", load.weld, "Join vertices at the same position");
    at.flag("--close-slits", load.closeSlits,
            "Close slits inside pieces, such as those of texture maps");
    at.flag("--turn-over", load.preparing.isTurned,
            "Turn all faces over, for a garment that is inside out");
    at.flag("--complete-half", load.preparing.isHalf,
            "Add the mirror image, for a file with half a garment");
    at.flag("--strict", load.strict, "Refuse a file that has to be repaired");
    describeKinds(at, load.preparing);
    describeCutting(at, arguments);
}

void describeMethod(OptionArchive& at, FlattenOptions& options, bool isOne) {
    at.section("Flattening", kFlattening);
    if (isOne) {
        at.choice("--method", options.method, methodNames(), parseMethod,
                  "Flattening method (docs/methods.md)")
            .by(std::string(name(options.method)));
    }
    at.choice("--boundary-solver", options.boundarySolver, kBoundarySolverWords,
              "Solver of the boundary problem, for wang2005, curvature and stretch");
    at.choice("--quality", options.quality, kQualityWords,
              "Quality of isometric: more time for less distortion");
    at.choice("--free-boundary", options.freeBoundary, kFreeBoundaryWords,
              "Constraint of natural: two pinned vertices, or none");
    at.choice("--stretch-outline", options.stretchOutline, kStretchOutlineWords,
              "Outline for stretch: a circle as published, or that of curvature");
    at.number("--authalic", "MU", options.authalic, {0, 1},
              "Interior of wang2005 and curvature: 0 keeps angles, 1 keeps areas");
}

void describeLines(OptionArchive& at, LineSettings& lines, bool hasPreset) {
    at.section("Pattern", kFlattening);
    if (hasPreset) {
        at.add("--pattern", "",
               "Pattern to cut and sew: --fair --true --mirror auto --allowance 10 --hem 30 "
               "--notches auto --grain vertical. The project and other options take precedence",
               [&lines](const Words&) -> std::string {
                   lines = withPattern(std::move(lines));
                   return {};
               });
    }
    at.add("--fair", "[MM[,LAMBDA]]",
           "Draw smooth outlines of the same length, within MM of the exact ones. LAMBDA is the "
           "smoothing length in mm. Without MM, wrinkled garments use up to 8 mm",
           [&lines](const Words& typed) -> std::string {
               Fairing fairing;
               if (typed.front() != kFairAlone) {
                   constexpr std::array kRanges{Range{kMinFairTolerance, kMaxFairTolerance},
                                                Range{kMinSmoothing, kMaxSmoothing}};
                   std::array numbers{fairing.tolerance, fairing.smoothing};
                   const ReadNumbers read = readNumbers(typed.front(), kRanges, numbers);
                   if (read.count == 0) {
                       return read.fault;
                   }
                   fairing = {numbers[0], numbers[1], true};
               }
               lines.fairing = fairing;
               return {};
           })
        .by("1,40");
    at.add("--true", "",
           "True the lines at seam ends: remove kinks up to 10 degrees. Draws fair lines",
           [&lines](const Words&) -> std::string {
               lines.fairing = lines.fairing.value_or(Fairing{});
               lines.trueBelow = kProposedTrueing;
               return {};
           });
    at.choice("--mirror", lines.mirror, kTypedMirrorWords,
              "Make mirrored pieces equal, and symmetric pieces symmetric. auto: only pieces "
              "whose seams differ from their mirror images by at most 2 mm or 1 %");
    const auto width = [&](const char* names, double AllowanceWidths::*which, const char* help) {
        return at.numberOf<double>(
            names, "MM", {0, kMaxAllowance}, help, [&lines, which](double typed) {
                lines.allowance = lines.allowance.value_or(AllowanceWidths{});
                *lines.allowance.*which = typed;
            });
    };
    width("--allowance", &AllowanceWidths::seam, "Seam allowance; also sets a hem of 30 mm");
    width("--hem", &AllowanceWidths::hem,
          "Allowance along hems; also sets a seam allowance of 10 mm");
    at.add("--edge-allowance", "KIND=MM",
           "Allowance along free edges of a kind; repeat it for several. KIND is " +
               wordList(kEdgeKindWords),
           [&lines](const Words& typed) { return readEdgeAllowances(typed, lines); })
        .isRepeated = true;
    at.add("--notches", "auto|none", "Notches where the two sides of a seam meet",
           [&lines](const Words& typed) -> std::string {
               const auto wanted = parseWord(kNotchesWords, typed.front());
               if (!wanted) {
                   return notAmong(typed.front(), {"auto", "none"});
               }
               if (*wanted) {
                   lines.notches = lines.notches.value_or(NotchRules{});
                   lines.notches->automatic = true;
               } else {
                   lines.notches.reset();
               }
               return {};
           })
        .by("none");
    at.choice("--grain", lines.grain, kGrainRuleWords,
              "Grain of pieces without one: as the garment hangs, as in the reference panels, or "
              "turned by 45 or 90 degrees for less strain")
        .by("no grain line");
}

void describeLabels(OptionArchive& at, LineSettings& lines) {
    at.text("--size", "TEXT", lines.label.size, "Size on all labels").by("none");
    at.text("--date", "TEXT", lines.label.date, "Date on all labels").by("none");
}

void describeExporting(OptionArchive& at, ExportOptions& options) {
    at.section("File formats", kExporting);
    for (const FormatOption& row : formatOptions()) {
        const std::string names = std::string("--") + row.name;
        if (row.isSwitch) {
            at.add(names.c_str(), "", row.help, [&options, &row](const Words&) {
                return row.set(options, "on") ? "" : "cannot be set";
            });
            continue;
        }
        const Words words(row.words.begin(), row.words.end());
        Option& added = at.add(names.c_str(), words.empty() ? "NUMBER" : joined(words, '|'),
                               row.help, [&options, &row, words](const Words& typed) {
                                   return row.set(options, typed.front()) ? std::string()
                                          : words.empty() ? outOfRange(typed.front(),
                                                                       {row.least, row.most}, false)
                                                          : notAmong(typed.front(), words);
                               });
        added.by(row.get(options));
        if (words.empty()) {
            added.range = Range{row.least, row.most};
        }
    }
}

void describeHalf(OptionArchive& at, Arguments& arguments) {
    at.add("--half", "",
           "Draw symmetric pieces by half, on the fold, and one piece of each mirrored pair. "
           "Implies --mirror auto",
           [&arguments](const Words&) -> std::string {
               arguments.byHalf = true;
               Mirror& mirror = arguments.lines.mirror;
               mirror = mirror == Mirror::None && !arguments.isTyped("--mirror") ? Mirror::Close
                                                                                 : mirror;
               return {};
           });
}

void describeFlattening(OptionArchive& at, Arguments& arguments) {
    describeLines(at, arguments.lines);
    describeHalf(at, arguments);
    describeLabels(at, arguments.lines);
    describeMethod(at, arguments.options);
    describeReading(at, arguments);
    describeExporting(at, arguments.exporting);
}

}  // namespace toile::app
