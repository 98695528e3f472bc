// SPDX-License-Identifier: GPL-3.0-or-later
// The commands, and options specific to one or two of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "app/cli/garment_options.h"
#include "core/base/text.h"
#include "core/formats/formats.h"
#include "core/garment/fabric.h"
#include "core/toile/improve.h"

namespace toile::app {
namespace {

using Command = Arguments::Command;

constexpr double kMaxApart = 1000;  // mm
constexpr int kMaxGarments = 1000;
constexpr double kMicro = 1e-6;
constexpr int kMaxImproveRounds = 100;
constexpr Range kAnyLength{0, kMaxApart};
constexpr Range kMatchShare{0, 1};

constexpr Word<Panel> kPanelWords[] = {
    {Panel::Pieces, "pieces"},   {Panel::Seams, "seams"}, {Panel::ProblemList, "problems"},
    {Panel::History, "history"}, {Panel::Lines, "lines"}, {Panel::Symmetry, "symmetry"},
    {Panel::Proof, "proof"}};
constexpr Word<ViewsShown> kViewWords[] = {
    {ViewsShown::Garment, "garment"}, {ViewsShown::Pattern, "pattern"}, {ViewsShown::Both, "both"}};
constexpr Word<bool> kOnOffWords[] = {{true, "on"}, {false, "off"}};
constexpr Word<bool> kFailOnWords[] = {{false, "fault"}, {true, "doubt"}};
constexpr Word<SewnPattern> kTypedSewnWords[] = {{SewnPattern::Designer, "uv"},
                                                 {SewnPattern::Own, "none"}};
constexpr Word<ViewDirection> kLooks[] = {{kFrontView, "front"}, {kBackView, "back"},
                                          {kLeftView, "left"},   {kRightView, "right"},
                                          {kTopView, "top"},     {kBottomView, "bottom"}};

void describeInputs(OptionArchive& at, Arguments& arguments) {
    at.section("Files", kInputFiles);
    at.texts("INPUT", "FILE...", arguments.inputs,
             "Garment mesh: .obj, .off, .ply, .stl, .usda, .glb, .gltf, .fbx, .dae or .3mf; a .zip "
             "with one of the first five; or a project: .toile")
        .required();
}

Option& describeReport(OptionArchive& at, std::filesystem::path& report, const char* help) {
    return at.add("--report", "FILE.json", help, [&report](const Words& typed) {
        report = typed.front();
        return typed.front().ends_with(".json") || typed.front().ends_with(".JSON")
                   ? std::string()
                   : "the report's name must end in .json, not \"" + typed.front() + '"';
    });
}

void describeFailOn(OptionArchive& at, Arguments& arguments) {
    at.choice("--fail-on", arguments.failOnDoubt, kFailOnWords,
              "Least severity with exit status 1 (docs/ready-to-cut.md)");
}

Option& describeFabric(OptionArchive& at, Arguments& arguments) {
    Words ids;
    for (const Fabric& fabric : fabricPresets()) {
        ids.push_back(fabric.id);
    }
    return at.choice("--fabric", arguments.fabric, ids, fabricPreset, "Fabric of the garment");
}

/// the option that self-contact depends on; may be null
void describeSelfContact(OptionArchive& at, ProofSettings& settings, const char* needed = nullptr) {
    Option& touches =
        at.flag("--self-contact", settings.touchesItself, "Keep layers of cloth apart");
    Option& none = at.flag("--no-self-contact", settings.touchesItself, false,
                           "Turn off the project's self-contact")
                       .excludes({"--self-contact"});
    at.number("--cloth-thickness", "MM", settings.thickness, {kMinThickness, kMaxThickness},
              "Distance between layers of cloth")
        .needs("--self-contact");
    if (needed != nullptr) {
        touches.needs(needed);
        none.needs(needed);
    }
}

std::string formatList() {
    std::string list;
    for (const Format& format : formats()) {
        list += list.empty() ? "" : ", ";
        list += std::string(format.endings.front()) + " (" + format.name + ")";
        list += format.write ? "" : " (not built)";
    }
    return list;
}

void describeWindow(OptionArchive& at, Arguments& arguments) {
    at.section("Window", kInputFiles);
    at.texts("FILE", "FILE...", arguments.inputs, "Garment or project to open in the window");
    at.section("Window", kForTerminal);
    at.text("--screenshot", "FILE.png", arguments.screenshot,
            "Open the window, save a picture of it and quit");
    at.choice("--overlay", arguments.overlay, kOverlayWords, "Overlay on the cloth")
        .by("the project's, else checker");
    at.choice("--panel", arguments.panel, kPanelWords, "Panel in front");
    describeMethod(at, arguments.options);
    describeReading(at, arguments);
}

void describeFlatten(OptionArchive& at, Arguments& arguments) {
    describeInputs(at, arguments);
    at.section("Files", kOutputFiles);
    at.texts("-o,--output", "FILE", arguments.outputs,
             "File to write, by its ending: " + formatList() + ". May be given several times");
    at.add("--report", "FILE.json", "JSON report to write, the same as -o FILE.json",
           [&arguments](const Words& typed) -> std::string {
               std::filesystem::path report;
               OptionArchive one;
               std::string fault = describeReport(one, report, "").read(typed);
               arguments.outputs.push_back(report);
               return fault;
           });
    describeFlattening(at, arguments);
    at.section("Run", kThreads);
    at.number("--threads", "N", arguments.threads, {0, kMaxThreads},
              "Number of threads; 0 uses all cores. Results do not depend on it");
    at.section("Run", kForTerminal);
    describeFailOn(at, arguments);
    at.flag("--ledger", arguments.ledger, "Print every seam with the lengths of its two sides");
}

void describeBatch(OptionArchive& at, Arguments& arguments) {
    BatchArguments& batch = arguments.batch;
    at.section("Batch", kForTerminal);
    at.text("LIST", "FILE", batch.list,
            "File with a garment per line: its path, then the words of its own options, separated "
            "by tabs; - is standard input")
        .required();
    at.text("-o,--output", "DIR", batch.folder, "Folder to write to; created if missing")
        .required();
    Words endings;
    for (const Format& format : formats()) {
        endings.emplace_back(format.endings.front() + 1);  // skip the dot
    }
    Option& written = at.add("--formats", joined(endings, ','), "Formats to write for each garment",
                             [&batch, endings](const Words& typed) -> std::string {
                                 batch.formats.clear();
                                 for (const std::string& list : typed) {
                                     for (const std::string& word : partsOf(list, ',')) {
                                         if (std::ranges::find(endings, word) == endings.end()) {
                                             return notAmong(word, endings);
                                         }
                                         batch.formats.push_back(word);
                                     }
                                 }
                                 return {};
                             });
    written.by("json,svg").isRepeated = true;
    at.number("--limit", "SECONDS", batch.limitSeconds, {0, 1e6},
              "Time limit per garment; 0 disables it");
    at.number("--memory", "MIB", batch.memoryMib, {0, 1 << 24},
              "Memory limit per garment; 0 disables it");
    at.number("--threads", "N", batch.threads, {1, kMaxThreads}, "Threads per garment");
    describeFlattening(at, arguments);
}

void describeCompare(OptionArchive& at, Arguments& arguments) {
    describeInputs(at, arguments);
    at.section("Comparison", kForTerminal);
    Option& methods = at.add(
        "--methods", joined(methodNames(), ','), "Methods to compare",
        [&arguments](const Words& typed) -> std::string {
            arguments.methods.clear();
            for (const std::string& list : typed) {
                for (const std::string& word : partsOf(list, ',')) {
                    const auto method = parseMethod(word);
                    if (!method) {
                        return notAmong(word, methodNames());
                    }
                    if (std::ranges::find(arguments.methods, *method) == arguments.methods.end()) {
                        arguments.methods.push_back(*method);
                    }
                }
            }
            return {};
        });
    methods.by("all").isRepeated = true;
    at.text("--pattern", "FILE", arguments.pattern,
            "Pattern file to compare with instead: .dxf, .svg or .specification.json")
        .excludes({"--prove"});
    at.texts("-o,--output", "FILE.svg", arguments.outputs, "Picture of each pair, .svg")
        .needs("--pattern");
    at.flag("--prove", arguments.isProving,
            "Sew each pattern back together and measure its distance from the design");
    describeSelfContact(at, arguments.prove.plan.settings, "--prove");
    at.flag("--per-piece", arguments.perPiece, "Print a table for each piece too");
    at.flag("--json", arguments.json, "Print JSON");
    at.flag("--markdown", arguments.markdown, "Print Markdown tables").excludes({"--json"});
    describeMethod(at, arguments.options, false);
    describeReading(at, arguments);
}

void describeCheck(OptionArchive& at, Arguments& arguments) {
    describeInputs(at, arguments);
    at.section("Check", kForTerminal);
    describeFabric(at, arguments)
        .by("the project's, else " + fabricPresets().front().id + ", whose strain is no fault");
    describeFailOn(at, arguments);
    at.flag("--prove", arguments.isProving,
            "Sew the pattern back together first: a doubt if it is far from the design");
    describeSelfContact(at, arguments.prove.plan.settings, "--prove");
    at.flag("--json", arguments.json, "Print JSON");
    describeLines(at, arguments.lines);
    describeHalf(at, arguments);
    describeMethod(at, arguments.options);
    describeReading(at, arguments);
}

void describeWalk(OptionArchive& at, Arguments& arguments) {
    describeInputs(at, arguments);
    at.section("Output", kForTerminal);
    at.flag("--json", arguments.json, "Print JSON");
    describeLines(at, arguments.lines);
    describeMethod(at, arguments.options);
    describeReading(at, arguments);
}

/// The numbers in "80x60@5,5", separated by these marks; empty if the format differs.
std::vector<double> numbersBetween(const std::string& typed, std::string_view marks) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= typed.size();) {
        const std::size_t end = numbers.size() < marks.size()
                                    ? typed.find(marks[numbers.size()], begin)
                                    : std::string::npos;
        const auto number = parseNumber<double>(
            std::string_view(typed).substr(begin, end == std::string::npos ? end : end - begin));
        if (!number) {
            return {};
        }
        numbers.push_back(*number);
        if (end == std::string::npos) {
            return numbers;
        }
        begin = end + 1;
    }
    return {};
}

std::string readSheet(const std::string& typed, MarkerSettings& settings) {
    const std::vector<double> sides = numbersBetween(typed, "x");
    const auto fits = [](double side) { return side >= 1 && side <= kMaxClothWidth; };
    if (sides.size() != 2 || !std::ranges::all_of(sides, fits)) {
        return "needs the sides along and across the warp, from 1 to " + shortest(kMaxClothWidth) +
               " mm, as in 305x610, not \"" + typed + "\"";
    }
    settings.sheet = Eigen::Vector2d(sides[0], sides[1]);
    return {};
}

std::string readRepeat(const std::string& typed, MarkerSettings& settings) {
    const std::vector<double> numbers = numbersBetween(typed, "x@,");
    const bool hasOrigin = numbers.size() == 4;
    const auto isTooLarge = [](double number) { return std::abs(number) > kMaxClothWidth; };
    if ((numbers.size() != 2 && !hasOrigin) || numbers[0] < 0 || numbers[1] < 0 ||
        std::ranges::any_of(numbers, isTooLarge)) {
        return "needs the repeat along and across the warp (0 for none), optionally with its "
               "start, "
               "as in 80x60 or 80x0@10,5, not \"" +
               typed + "\"";
    }
    settings.repeat.warp = numbers[0];
    settings.repeat.weft = numbers[1];
    if (hasOrigin) {
        settings.repeat.origin = {numbers[2], numbers[3]};
    }
    return {};
}

std::string readGrade(const std::string& typed, MarkerSettings& settings) {
    const std::size_t at = typed.rfind('=');
    const auto grade = at == std::string::npos || at == 0
                           ? std::nullopt
                           : parseNumber<int>(std::string_view(typed).substr(at + 1));
    if (grade.value_or(0) < 1) {
        return "needs a piece and its lowest allowed grade, as in front=2, not \"" + typed + "\"";
    }
    settings.grades[typed.substr(0, at)] = *grade;
    return {};
}

void describeCloth(OptionArchive& at, Arguments& arguments) {
    MarkerArguments& marker = arguments.marker;
    MarkerSettings& settings = marker.settings;
    at.section("Cloth", kForTerminal);
    at.number("--width", "MM", settings.width, {1, kMaxClothWidth}, "Width of the cloth")
        .by("the fabric's");
    at.add("--sheet", "ALONGxACROSS",
           "Size of sheets to use instead, in mm along and across the warp",
           [&settings](const Words& typed) { return readSheet(typed.front(), settings); });
    at.texts(
        "--hide", "FILE", marker.hides,
        "Hides to use instead, in this order. A .dxf or .svg file has a closed outline, holes, "
        "and zones on layers such as \"grade 2\"");
    at.flag("--folded", settings.isFolded,
            "Fold the cloth lengthwise: symmetric pieces are laid on the fold, and one of each "
            "mirrored pair");
    at.text("--material", "NAME", marker.material,
            "The only material to lay; \"\" is the garment's own fabric");
    describeFabric(at, arguments).by("the project's");
}

void describeRules(OptionArchive& at, Arguments& arguments) {
    MarkerSettings& settings = arguments.marker.settings;
    at.section("Layout", kForTerminal);
    at.number("--garments", "N", settings.garments, {1, kMaxGarments}, "Number of garments");
    at.number("--gap", "MM", settings.gap, kAnyLength, "Least distance between two pieces");
    at.number("--border", "MM", settings.border, kAnyLength,
              "Least distance from the edges of the cloth");
    at.flag("--one-way,--nap", settings.turns, TurnRule::OneWay,
            "Lay all pieces the same way up, for cloth with a nap");
    at.flag("--free-grain", settings.turns, TurnRule::Free,
            "Turn pieces freely, for cloth without a grain")
        .excludes({"--one-way"});
    at.numberOf<double>("--grain-tolerance", "DEGREES", {0, 180},
                        "Largest turn of pieces off the grain",
                        [&settings](double degrees) { settings.tolerance = degrees * kDegree; })
        .formerly("--turn")
        .by("0");
    at.add("--repeat", "WARPxWEFT[@X,Y]",
           "Repeat of stripes or plaids in mm along and across the warp, 0 for none, and the start "
           "of one. Used by --match",
           [&settings](const Words& typed) { return readRepeat(typed.front(), settings); });
    at.texts("--match", "SEAM", settings.matched, "Seam across which the repeat is matched");
    at.add("--grade", "PIECE=N", "Worst grade of leather for a piece",
           [&settings](const Words& typed) -> std::string {
               settings.grades.clear();
               for (const std::string& words : typed) {
                   if (std::string wrong = readGrade(words, settings); !wrong.empty()) {
                       return wrong;
                   }
               }
               return {};
           })
        .by("any")
        .isRepeated = true;
    at.number("--minutes-per-metre", "MINUTES", arguments.marker.minutesPerMetre, {0, 1000},
              "Sewing time per metre of seam, for an estimate");
}

void describeMarker(OptionArchive& at, Arguments& arguments) {
    MarkerArguments& marker = arguments.marker;
    describeInputs(at, arguments);
    at.section("Files", kForTerminal);
    at.texts("-o,--output", "FILE", arguments.outputs,
             "Marker to write: .svg, .dxf, .pdf, .plt or .png. Each of several materials has its "
             "own file. May be given several times");
    describeReport(at, arguments.report, "JSON report to write: use, length and positions");
    describeCloth(at, arguments);
    describeRules(at, arguments);
    at.section("Search", kForTerminal);
    at.number("--rounds", "N", marker.rounds, {0, 1'000'000'000}, "Number of rounds");
    at.number("--time", "S", marker.seconds, {0, 1e6}, "Time per material")
        .by("5 without --rounds");
    at.number("--seed", "N", marker.settings.seed, {0, 18'446'744'073'709'551'615.0},
              "Seed of the search: another seed gives another marker");
    at.numberOf<int>("--threads", "N", {1, kMaxThreads},
                     "Number of threads; results do not depend on it",
                     [&marker](int threads) { marker.threads = threads; })
        .by("all cores");
    describeLines(at, arguments.lines);
    describeLabels(at, arguments.lines);
    describeMethod(at, arguments.options);
    describeReading(at, arguments);
    describeExporting(at, arguments.exporting);
}

std::string readPictureSize(const std::string& typed, PictureArguments& picture) {
    const std::vector<double> sides = numbersBetween(typed, "x");
    const auto fits = [](double side) {
        return side >= kMinPicture && side <= kMaxPicture && side == std::floor(side);
    };
    if (sides.size() != 2 || !std::ranges::all_of(sides, fits)) {
        return "must be width and height in whole pixels, such as 1600x800, each from " +
               std::to_string(kMinPicture) + " to " + std::to_string(kMaxPicture);
    }
    picture.width = static_cast<int>(sides[0]);
    picture.height = static_cast<int>(sides[1]);
    return {};
}

std::string readPictureLook(const std::string& typed, PictureArguments& picture) {
    picture.direction = parseWord(kLooks, typed);
    if (!picture.direction) {
        const std::vector<double> degrees = numbersBetween(typed, ",");
        if (degrees.size() != 2 || std::abs(degrees[0]) > 360 || std::abs(degrees[1]) > 90) {
            return "must be a side, or two angles in degrees such as 30,10: around from the front "
                   "within 360, upwards within 90";
        }
        picture.direction = ViewDirection{degrees[0] * kDegree, degrees[1] * kDegree};
    }
    return {};
}

/// Options for a picture of both views.
void describePicture(OptionArchive& at, Arguments& arguments, const char* overlay) {
    PictureArguments& picture = arguments.picture;
    at.section("Picture", kForTerminal);
    at.choice("--view", picture.views, kViewWords, "Views to draw; both are side by side");
    at.choice("--overlay", arguments.overlay, kOverlayWords, "Overlay on the cloth").by(overlay);
    at.add("--size", "WxH", "Width and height in pixels", [&picture](const Words& typed) {
          return readPictureSize(typed.front(), picture);
      }).by("1600x800");
    at.add("--look", "front|back|left|right|top|bottom|YAW,PITCH",
           "Side to look from, or angles in degrees around and upwards",
           [&picture](const Words& typed) { return readPictureLook(typed.front(), picture); });
    at.flag("--dark", picture.dark, "Use a dark background");
}

void describeProve(OptionArchive& at, Arguments& arguments) {
    ProveArguments& prove = arguments.prove;
    ProofPlan& plan = prove.plan;
    ProofSettings& settings = plan.settings;
    StatedStiffness& stiffness = settings.stiffness;
    describeInputs(at, arguments);
    at.section("Files", kOutputFiles);
    at.texts("-o,--output", "FILE", arguments.outputs,
             "Picture of the sewn garment to write, .png. With --prove-improve also the pattern, "
             "in any other format of flatten");
    at.section("Files", kForTerminal);
    describeReport(at, arguments.report, "JSON file of the proof to write (docs/prove.md)");
    at.flag("--json", arguments.json, "Print JSON");
    at.section("Pattern and body", kSewing);
    at.text("--pattern", "FILE", arguments.pattern,
            "Pattern file to sew: .dxf, .svg or .specification.json")
        .by("the garment's own, as ASTM DXF");
    describeUnit(at, "--pattern-unit", prove.patternUnit, "Unit of the pattern file's coordinates")
        .needs("--pattern");
    at.choice("--reference", plan.sewn, kTypedSewnWords,
              "Sew the designer's panels in the UV map. none: the garment's own pattern")
        .by("the project's, else none")
        .excludes({"--pattern"});
    at.number("--scale", "FACTOR", prove.scale, {0.5, 2},
              "Scale of the sewn pattern: 0.97 if the cloth shrinks by 3 %");
    at.add("--body", "FILE|none",
           "Mesh of the body that wears the cloth, in the garment's space. none: the design's "
           "surface",
           [&plan](const Words& typed) -> std::string {
               plan.body = typed.front() == "none" ? "" : typed.front();
               plan.bodyUnit.reset();
               return {};
           })
        .by("the project's, else none");
    describeUnit(at, "--body-unit", plan.bodyUnit, "Unit of the body's coordinates")
        .by("detected, else the garment's")
        .needs("--body");
    at.section("Cloth", kSewing);
    describeFabric(at, arguments).by("the project's, else equal in all directions");
    at.numberOf<double>("--edge", "MM", {kMinProofEdge, kMaxProofEdge},
                        "Edge length of the cloth's triangles",
                        [&settings](double edge) { settings.edge = edge; })
        .by("the project's, else the garment's");
    at.add("--stretch", "WARP[,WEFT]", "Stiffness against stretching along warp and weft, N/m",
           [&stiffness](const Words& typed) {
               constexpr Range kStretch{kMinStretch, kMaxStretch};
               constexpr std::array kRanges{kStretch, kStretch};
               std::array<double, 2> numbers{};
               ReadNumbers read = readNumbers(typed.front(), kRanges, numbers);
               if (read.count > 0) {
                   stiffness.warp = numbers[0];
                   stiffness.weft = numbers[read.count - 1];
               }
               return std::move(read.fault);
           })
        .by("the project's, else the fabric's");
    at.number("--shear", "N/M", stiffness.shear, {kMinShear, kMaxShear},
              "Stiffness against shearing");
    at.numberOf<double>("--bend", "UNM", {0, kMaxBending / kMicro},
                        "Stiffness against bending in millionths of a newton metre",
                        [&stiffness](double typed) { stiffness.bending = kMicro * typed; });
    at.number("--weight", "GSM", stiffness.weight, {0, kMaxClothWeight},
              "Weight in g/m2, used with --gravity");
    at.section("Forces", kSewing);
    at.number("--pressure", "PA", settings.pressure, {-kMaxPressure, kMaxPressure},
              "Pressure towards the design or the body; negative values push outwards");
    at.flag("--gravity", settings.hasGravity, "Apply the cloth's weight");
    at.flag("--no-gravity", settings.hasGravity, false, "Turn off the project's gravity")
        .excludes({"--gravity"});
    describeSelfContact(at, settings);
    at.numberOf<int>("--threads", "N", {1, kMaxThreads},
                     "Number of threads; results do not depend on it",
                     [&settings](int threads) { settings.threads = threads; })
        .by("all cores");
    at.section("Improvement", kForTerminal);
    at.flag("--prove-improve", prove.rounds, kImproveRounds,
            "Improve the pattern in rounds until the hanging cloth matches the design")
        .excludes({"--pattern", "--reference", "--scale"});
    at.numberOf<int>("--rounds", "N", {1, kMaxImproveRounds}, "Largest number of rounds",
                     [&prove](int rounds) { prove.rounds = rounds; })
        .by(std::to_string(kImproveRounds))
        .needs("--prove-improve");
    describePicture(at, arguments, "gap");
    at.number("--sewn", "SHARE", prove.sewn, kMatchShare,
              "Garment between its design, 0, and as sewn, 1");
    describeLines(at, arguments.lines, false);
    describeMethod(at, arguments.options);
    describeReading(at, arguments);
}

void describeInfo(OptionArchive& at, Arguments& arguments) {
    describeInputs(at, arguments);
    at.section("Output", kForTerminal);
    at.flag("--json", arguments.json, "Print JSON");
    at.flag("--advice", arguments.advice, "Recommend cuts that reduce strain").excludes({"--json"});
    describeReading(at, arguments);
}

void describeRender(OptionArchive& at, Arguments& arguments) {
    PictureArguments& picture = arguments.picture;
    describeInputs(at, arguments);
    at.section("Files", kForTerminal);
    at.add("-o,--output", "FILE.png", "Picture to write",
           [&arguments](const Words& typed) -> std::string {
               arguments.outputs = {typed.front()};
               return {};
           })
        .required();
    describePicture(at, arguments, "the project's, else checker");
    at.number("--morph", "SHARE", picture.morph, kMatchShare, "Garment between 3D, 0, and flat, 1");
    at.flag("--wireframe", picture.wireframe, "Draw the mesh's edges");
    at.flag("--xray", picture.xray, "Make the cloth transparent");
    at.choice("--seams-shown", picture.seams, kOnOffWords, "Seam lines, each pair in one colour");
    at.choice("--bar", picture.bar, kOnOffWords, "Colour bar at the bottom")
        .by("on for measured overlays");
    at.numberOf<int>("--thumbnail", "PIXELS", {kMinPicture, kMaxPicture},
                     "Square picture of the garment for file managers, of any ending",
                     [&picture](int pixels) { picture.thumbnail = pixels; })
        .excludes({"--size", "--view", "--overlay", "--morph"});
    describeLines(at, arguments.lines);
    describeMethod(at, arguments.options);
    describeReading(at, arguments);
}

void describeServe(OptionArchive& /*at*/, Arguments& /*arguments*/) {}

constexpr CommandRow kCommandRows[] = {
    {Command::Window, "", "", "", "toile dress.obj --unit cm", describeWindow},
    {Command::Flatten, "flatten", "Flatten the pieces of a garment and write the pattern", "",
     "toile flatten dress.obj --unit cm --pattern -o dress.pdf --paper a4", describeFlatten},
    {Command::Batch, "batch", "Flatten a list of garments, each in its own process (docs/batch.md)",
     "Run the same list again to resume it. Exit status 1: a garment failed, and the others are\n"
     "written. Press Ctrl-C to stop; every finished garment is complete.",
     "toile batch shirts.txt -o patterns --formats svg,json --limit 120", describeBatch},
    {Command::Compare, "compare", "Compare flattening methods on a garment", "",
     "toile compare dress.obj --methods isometric,curvature", describeCompare},
    {Command::Check, "check", "Check whether a garment's pattern is ready to cut", "",
     "toile check dress.obj --pattern --fabric denim", describeCheck},
    {Command::Walk, "walk",
     "Walk the seams from notch to notch: the lengths of both sides, and kinks at the ends",
     "Exit status 1: the sides of a seam differ from its ease by more than a millionth of a\n"
     "millimetre, or a piece failed.",
     "toile walk dress.obj --pattern", describeWalk},
    {Command::Marker, "marker",
     "Lay the pieces on cloth as densely as the time allows (docs/marker.md). A .json input is an "
     "instance of the nesting problem",
     "A number of rounds gives the same marker on every machine. Press Ctrl-C to stop at the best\n"
     "marker so far. Exit status 1: a piece failed or is too large.",
     "toile marker dress.obj --pattern --width 1400 --time 60 -o marker.pdf", describeMarker},
    {Command::Prove, "prove",
     "Sew the pattern back together and measure its distance from the design (docs/prove.md)",
     "Exit status 1: the pattern has a fault, such as a mirrored piece or a seam whose sides do\n"
     "not fit, a piece failed, or the cloth has not settled. Press Ctrl-C to stop.",
     "toile prove dress.obj --fabric denim --gravity --report proof.json", describeProve},
    {Command::Info, "info", "Describe a garment or pattern file", "",
     "toile info dress.obj --auto-cut --advice", describeInfo},
    {Command::Render, "render", "Draw a garment and its pattern as the window shows them", "",
     "toile render dress.obj --overlay strain -o dress.png", describeRender},
    {Command::Serve, "serve",
     "Answer requests of another program, a JSON object per line (docs/serve.md)",
     "Ends with the request \"quit\" or the end of the input. Exit status 3: answers could not be\n"
     "written.",
     "echo '{\"id\":1,\"do\":\"load\",\"args\":[\"dress.obj\"]}' | toile serve", describeServe},
};

}  // namespace

std::span<const CommandRow> commandRows() {
    return kCommandRows;
}

Arguments withTyped(Arguments base) {
    OptionArchive at;
    std::ranges::find(commandRows(), base.command, &CommandRow::command)->describe(at, base);
    at.read(base.typed);  // valid, since parsing accepted it
    return base;
}

Arguments withSettingsOf(const Project& project, Arguments arguments) {
    Arguments base = arguments;
    base.options = project.options;
    base.lines = project.lines;
    base.prove.plan = project.proof;
    if (arguments.fabric && !(*arguments.fabric == project.fabric)) {
        base.prove.plan.settings.stiffness = {};
    }
    base = withTyped(std::move(base));
    arguments.options = base.options;
    arguments.lines = std::move(base.lines);
    arguments.prove.plan = std::move(base.prove.plan);
    if (arguments.prove.rounds > 0) {  // improving applies to the garment's own pattern
        arguments.prove.plan.sewn = SewnPattern::Own;
    }
    return arguments;
}

bool isAnyTyped(const Arguments& arguments, unsigned groups) {
    OptionArchive at;
    Arguments ignored;
    std::ranges::find(commandRows(), arguments.command, &CommandRow::command)
        ->describe(at, ignored);
    return !at.wordsOf(arguments.typed, groups).empty();
}

}  // namespace toile::app
