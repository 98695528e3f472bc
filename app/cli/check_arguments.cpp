// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_arguments.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include "app/cli/proof_picture.h"
#include "core/base/text.h"
#include "core/formats/formats.h"

namespace toile::app {
namespace {

std::string wrongFairing(const LineSettings& lines) {
    const Fairing fairing = lines.fairing.value_or(Fairing{});
    const auto isWithin = [](double value, double least, double most) {
        return value >= least && value <= most;
    };
    if (!isWithin(fairing.tolerance, kMinFairTolerance, kMaxFairTolerance)) {
        return "--fair needs a tolerance from " + shortest(kMinFairTolerance) + " to " +
               shortest(kMaxFairTolerance) + " mm";
    }
    if (!isWithin(fairing.smoothing, kMinSmoothing, kMaxSmoothing)) {
        return "--fair needs a smoothing length from " + shortest(kMinSmoothing) + " to " +
               shortest(kMaxSmoothing) + " mm";
    }
    return {};
}

/// A mistyped output must not cost the user the garment.
std::optional<std::filesystem::path> overwrittenInput(const Arguments& arguments) {
    std::vector<std::filesystem::path> inputs = arguments.inputs;
    if (!arguments.seams.empty()) {
        inputs.push_back(arguments.seams);
    }
    for (const std::filesystem::path& hide : arguments.marker.hides) {
        inputs.push_back(hide);
    }
    for (const std::filesystem::path& read : {arguments.pattern, arguments.prove.typed.body}) {
        inputs.push_back(read);
    }
    std::vector<std::filesystem::path> outputs = arguments.outputs;
    outputs.push_back(arguments.marker.report);
    outputs.push_back(arguments.prove.report);
    for (const auto& output : outputs) {
        for (const auto& input : inputs) {
            std::error_code ignored;
            if (std::filesystem::equivalent(input, output, ignored)) {
                return output;
            }
        }
    }
    return std::nullopt;
}

/// A report that would lie over the pattern, or under it; neither needs to be there yet.
std::optional<std::filesystem::path> reportAmongOutputs(const Arguments& arguments) {
    const auto whole = [](const std::filesystem::path& path) -> std::filesystem::path {
        std::error_code ignored;
        const auto absolute = std::filesystem::absolute(path, ignored);
        const auto found = std::filesystem::weakly_canonical(absolute, ignored);
        return ignored ? path.lexically_normal() : found;
    };
    for (const auto& report : {arguments.marker.report, arguments.prove.report}) {
        for (const auto& output : arguments.outputs) {
            if (!report.empty() && whole(report) == whole(output)) {
                return report;
            }
        }
    }
    return std::nullopt;
}

/// Not known, or not in this build.
std::string wrongEnding(const std::filesystem::path& output) {
    const Format* format = formatOf(output);
    if (format && format->write) {
        return {};
    }
    return "\"" + output.string() + "\" has a format that " +
           (format ? "this build of Toile" : "Toile") + " cannot write; use " + writtenEndings();
}

std::string wrongOutputs(const Arguments& arguments) {
    const bool isProof = arguments.command == Arguments::Command::Prove;
    const bool isPattern =
        isProof ? arguments.prove.rounds > 0 : arguments.command != Arguments::Command::Render;
    for (const auto& output : arguments.outputs) {
        if (isPattern && !(isProof && isPicture(output))) {
            if (std::string wrong = wrongEnding(output); !wrong.empty()) {
                return wrong;
            }
        } else if (!isPicture(output) && arguments.picture.thumbnail == 0) {
            const Format* format = isProof ? formatOf(output) : nullptr;
            if (format && format->write) {
                return "a pattern such as \"" + output.string() +
                       "\" needs --prove-improve; without it, prove writes only a picture (.png)";
            }
            return "the picture's name must end in .png, not \"" + output.string() + "\"";
        }
    }
    if (isProof && std::ranges::any_of(arguments.outputs, isPicture) && !proofPictures()) {
        return "this build of Toile cannot draw pictures";
    }
    if (isProof && isPattern && std::ranges::all_of(arguments.outputs, isPicture)) {
        return "--prove-improve makes a new pattern; add -o FILE to save it";
    }
    if (const auto lost = overwrittenInput(arguments)) {
        return "\"" + lost->string() + "\" is an input and would be overwritten";
    }
    if (const auto twice = reportAmongOutputs(arguments)) {
        return "\"" + twice->string() + "\" is both the report and an output; use two names";
    }
    return {};
}

}  // namespace

bool isPicture(const std::filesystem::path& file) {
    return file.extension() == ".png" || file.extension() == ".PNG";
}

std::string wrongIn(const Arguments& arguments) {
    if (arguments.load.split == SplitMode::Seams && arguments.seams.empty()) {
        return "--split seams needs a file with cuts; add --seams FILE";
    }
    if (std::string wrong = wrongFairing(arguments.lines); !wrong.empty()) {
        return wrong;
    }
    if (arguments.command == Arguments::Command::Marker) {
        if (std::string wrong =
                wrongInMarker(arguments.inputs, arguments.outputs, arguments.marker);
            !wrong.empty()) {
            return wrong;
        }
    }
    return wrongOutputs(arguments);
}

}  // namespace toile::app
