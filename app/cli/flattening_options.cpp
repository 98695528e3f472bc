// SPDX-License-Identifier: GPL-3.0-or-later
// Includes CLI11 as `arguments.cpp` does; both are compiled together.
#include "app/cli/flattening_options.h"

#include <optional>

#include "app/cli/choice_options.h"
#include "app/cli/reading_options.h"
#include "core/flatten/base/flat_piece.h"
#include "core/formats/formats.h"

namespace toile::app {
namespace {

constexpr Word<bool> kNotchesWords[] = {{true, "auto"}, {false, "none"}};

std::optional<Mirror> parseMirror(std::string_view text) {
    return text == "auto"    ? std::optional(Mirror::Close)
           : text == "equal" ? std::optional(Mirror::Mean)
           : text == "none"  ? std::optional(Mirror::None)
                             : std::nullopt;
}

}  // namespace

std::vector<std::string> methodNames() {
    std::vector<std::string> names;
    for (const MethodTraits& method : allMethods()) {
        names.emplace_back(method.name);
    }
    return names;
}

void addMethodOptions(CLI::App& command, StatedOptions& stated, bool isOne) {
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

void addLineOptions(CLI::App& command, StatedOptions& stated) {
    command
        .add_option_function<std::vector<double>>(
            "--fair",
            [&stated](const std::vector<double>& typed) {
                Fairing& fairing = stated.fairing.emplace();
                fairing.tolerance = typed.front();
                fairing.smoothing = typed.size() > 1 ? typed[1] : fairing.smoothing;
            },
            "Draw outlines as fair lines of the same length, at most MM from the exact ones, "
            "smoothed over LAMBDA [1,40]. Without MM, up to 8 on wrinkled garments")
        ->type_name("[MM[,LAMBDA]]")
        ->delimiter(',')
        ->expected(1, 2)
        ->allow_extra_args(false);
    command.add_flag("--true", stated.trueSeams,
                     "True the lines at the ends of seams: kinks up to 10 degrees are taken out; "
                     "draws fair lines");
    addChoice(command, "--mirror", stated.mirror, {"auto", "equal", "none"}, parseMirror,
              "equal: pieces that mirror each other become equal, and those that are symmetric in "
              "themselves symmetric; auto: only where each of their seams differs from its mirror "
              "image by at most 2 mm or 1 %")
        ->default_str("none");
}

void addPatternOptions(CLI::App& command, StatedOptions& stated, bool hasPreset) {
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

void addExporting(CLI::App& command, TypedOptions& typed) {
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

void addFlattening(CLI::App& command, TypedOptions& typed, Arguments& arguments) {
    addMethodOptions(command, arguments.stated);
    addLineOptions(command, arguments.stated);
    addPatternOptions(command, arguments.stated);
    addLabelOptions(command, arguments.stated);
    command.add_flag("--half", arguments.stated.byHalf,
                     "Draw only half of what is symmetric, to be cut on the fold, and one of two "
                     "that mirror each other, to be cut as a pair; asks for --mirror "
                     "auto, which leaves pairs that differ by more whole: see --mirror equal");
    areAbout(kFlattening, command, typed.groups);
    addReading(command, arguments);
    areAbout(kReading, command, typed.groups);
    addExporting(command, typed);
    areAbout(kExporting, command, typed.groups);
}

}  // namespace toile::app
