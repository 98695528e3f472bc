// SPDX-License-Identifier: GPL-3.0-or-later
// Checks combinations of options that are valid individually.
#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "core/base/text.h"
#include "core/formats/drawing/marker_drawing.h"
#include "core/formats/formats.h"

namespace toile::app {
namespace {

using Paths = std::vector<std::filesystem::path>;

/// Options for one kind of input need that kind.
std::string wrongKind(const Arguments& arguments) {
    static constexpr std::pair<const char*, FileKind> kKindOf[] = {
        {"--keep-debris", FileKind::Scan}, {"--close-holes", FileKind::Scan},
        {"--smooth", FileKind::Scan},      {"--remesh", FileKind::Scan},
        {"--weld-within", FileKind::Soup}, {"--surface", FileKind::Shell},
        {"--layer", FileKind::Layers}};
    const auto& as = arguments.load.preparing.as;
    for (const auto& [option, kind] : kKindOf) {
        const bool isDetected = kind == FileKind::Shell || kind == FileKind::Layers;
        if (arguments.isTyped(option) && as != kind && (as || !isDetected)) {
            return std::string(option) + ": works only with --as " +
                   std::string(wordOf(kFileKindWords, kind));
        }
    }
    return {};
}

/// A mistyped output must not overwrite the user's garment.
std::string overwrittenInput(const Arguments& arguments, const Paths& outputs) {
    Paths inputs = arguments.inputs;
    inputs.insert(inputs.end(), arguments.marker.hides.begin(), arguments.marker.hides.end());
    inputs.insert(inputs.end(), {arguments.seams, arguments.pattern, arguments.prove.plan.body});
    for (const auto& output : outputs) {
        for (const auto& input : inputs) {
            std::error_code ignored;
            if (std::filesystem::equivalent(input, output, ignored)) {
                return "\"" + output.string() + "\" is an input and would be overwritten";
            }
        }
    }
    return {};
}

/// Finds a report with the same name as another output; neither needs to exist.
std::string reportAmongOutputs(const Arguments& arguments) {
    const auto whole = [](const std::filesystem::path& path) -> std::filesystem::path {
        std::error_code ignored;
        const auto absolute = std::filesystem::absolute(path, ignored);
        const auto found = std::filesystem::weakly_canonical(absolute, ignored);
        return ignored ? path.lexically_normal() : found;
    };
    const auto& report = arguments.report;
    const auto isSame = [&](const auto& output) { return whole(report) == whole(output); };
    return !report.empty() && std::ranges::any_of(arguments.outputs, isSame)
               ? "\"" + report.string() + "\" is both the report and an output; use two names"
               : std::string();
}

std::string wrongEnding(const std::filesystem::path& output) {
    const Format* format = formatOf(output);
    if (format && format->write) {
        return {};
    }
    return "\"" + output.string() + "\" has a format that " +
           (format ? "this build of Toile" : "Toile") + " cannot write; use " + writtenEndings();
}

std::string wrongPictureName(const std::filesystem::path& output) {
    return isPicture(output)
               ? std::string()
               : "the picture's name must end in .png, not \"" + output.string() + '"';
}

std::string wrongInProve(const Arguments& arguments) {
    const Paths& outputs = arguments.outputs;
    const bool isImproving = arguments.prove.rounds > 0;
    const bool hasPicture = std::ranges::any_of(outputs, isPicture);
    if (!hasPicture) {
        for (const char* option : {"--view", "--overlay", "--size", "--look", "--dark", "--sewn"}) {
            if (arguments.isTyped(option)) {
                return std::string(option) + " is of a picture: ask for one with -o FILE.png";
            }
        }
    }
    for (const auto& output : outputs) {
        if (isPicture(output)) {
            continue;
        }
        const Format* format = formatOf(output);
        if (!isImproving && format && format->write) {
            return "a pattern such as \"" + output.string() +
                   "\" needs --prove-improve; without it, prove writes only a picture (.png)";
        }
        if (std::string wrong = isImproving ? wrongEnding(output) : wrongPictureName(output);
            !wrong.empty()) {
            return wrong;
        }
    }
    if (hasPicture && !proofPictures()) {
        return "this build of Toile cannot draw pictures";
    }
    if (isImproving && std::ranges::all_of(outputs, isPicture)) {
        return "--prove-improve makes a new pattern; add -o FILE to save it";
    }
    return {};
}

/// For the nesting problem, which defines its own shapes and strip.
std::string wrongInNest(const Arguments& arguments) {
    const auto& inputs = arguments.inputs;
    if (inputs.size() > 1) {
        return "a nesting problem must be the only input: \"" +
               std::ranges::find_if(inputs, isNestInstance)->string() + "\"";
    }
    static constexpr std::array<std::string_view, 8> kTaken{
        "INPUT", "--output", "--report", "--rounds", "--time", "--seed", "--threads", "--gap"};
    for (const auto& [option, words] : arguments.typed) {
        if (std::ranges::find(kTaken, option) == kTaken.end() && option != "--border") {
            return option +
                   ": works only with a garment or a project, not with a nesting "
                   "problem";
        }
    }
    for (const auto& output : arguments.outputs) {
        if (!equalsIgnoringCase(output.extension().string(), ".svg")) {
            return "the result of a nesting problem must be .svg, not \"" + output.string() + "\"";
        }
    }
    return {};
}

std::string wrongInMarker(const Arguments& arguments) {
    if (std::ranges::any_of(arguments.inputs, isNestInstance)) {
        return wrongInNest(arguments);
    }
    for (const auto& output : arguments.outputs) {
        if (!holdsMarkers(output)) {
            return "\"" + output.string() +
                   "\" has a format that markers do not support; use .svg, .dxf, .pdf, .plt or, in "
                   "builds with the window, .png";
        }
    }
    if (arguments.isTyped("--width") + arguments.isTyped("--sheet") + arguments.isTyped("--hide") >
        1) {
        return "--width, --sheet and --hide exclude each other; use one of them";
    }
    return {};
}

std::string wrongOutputs(const Arguments& arguments) {
    using Command = Arguments::Command;
    if (arguments.command == Command::Prove) {
        return wrongInProve(arguments);
    }
    const bool isRender = arguments.command == Command::Render;
    if (isRender && arguments.picture.thumbnail > 0) {
        return {};
    }
    for (const auto& output : arguments.outputs) {
        if (std::string wrong = isRender ? wrongPictureName(output) : wrongEnding(output);
            !wrong.empty()) {
            return wrong;
        }
    }
    return {};
}

}  // namespace

bool isPicture(const std::filesystem::path& file) {
    return file.extension() == ".png" || file.extension() == ".PNG";
}

bool isNestInstance(const std::filesystem::path& file) {
    return equalsIgnoringCase(file.extension().string(), ".json");
}

std::string wrongTogether(const Arguments& arguments, const MarkerSettings& settings) {
    const bool isRoll = !settings.sheet && settings.hides.empty();
    if (settings.isFolded && !isRoll &&
        (arguments.isTyped("--folded") || arguments.isTyped("--sheet") ||
         arguments.isTyped("--hide"))) {
        return "--folded needs a roll; leave out --sheet and --hide";
    }
    if (arguments.isTyped("--grade") && settings.hides.empty()) {
        return "--grade needs --hide, whose zones have grades";
    }
    if (arguments.isTyped("--match") && settings.repeat == ClothRepeat{}) {
        return "--match needs the repeat of the stripes; add --repeat";
    }
    return {};
}

std::string wrongIn(const Arguments& arguments) {
    if (arguments.load.split == SplitMode::Seams && arguments.seams.empty()) {
        return "--split seams needs a file with cuts; add --seams FILE";
    }
    Paths outputs = arguments.outputs;
    outputs.push_back(arguments.report);
    const bool isMarker = arguments.command == Arguments::Command::Marker;
    for (std::string wrong :
         {wrongKind(arguments), isMarker ? wrongInMarker(arguments) : std::string(),
          isMarker ? std::string() : wrongOutputs(arguments), overwrittenInput(arguments, outputs),
          reportAmongOutputs(arguments)}) {
        if (!wrong.empty()) {
            return wrong;
        }
    }
    return {};
}

}  // namespace toile::app
