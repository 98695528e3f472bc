// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_arguments.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include "core/base/text.h"
#include "core/export/formats.h"

namespace toile::app {
namespace {

std::string wrongFairing(const LineSettings& lines) {
    const Fairing fairing = lines.fairing.value_or(Fairing{});
    const auto isWithin = [](double value, double least, double most) {
        return value >= least && value <= most;
    };
    if (!isWithin(fairing.tolerance, kMinFairTolerance, kMaxFairTolerance)) {
        return "--fair takes a tolerance from " + shortest(kMinFairTolerance) + " to " +
               shortest(kMaxFairTolerance) + " mm";
    }
    if (!isWithin(fairing.smoothing, kMinSmoothing, kMaxSmoothing)) {
        return "--fair takes a smoothing length from " + shortest(kMinSmoothing) + " to " +
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
    std::vector<std::filesystem::path> outputs = arguments.outputs;
    outputs.push_back(arguments.marker.report);
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

/// Not known, or not in this build.
std::string wrongEnding(const std::filesystem::path& output) {
    const Format* format = formatOf(output);
    if (format && format->write) {
        return {};
    }
    return "\"" + output.string() + "\" has an ending that " +
           (format ? "this build of Toile" : "Toile") + " does not write; use " + writtenEndings();
}

std::string wrongOutputs(const Arguments& arguments) {
    for (const auto& output : arguments.outputs) {
        if (arguments.command != Arguments::Command::Render) {
            if (std::string wrong = wrongEnding(output); !wrong.empty()) {
                return wrong;
            }
        } else if (output.extension() != ".png" && output.extension() != ".PNG") {
            return "the picture's name must end in .png, not \"" + output.string() + "\"";
        }
    }
    if (const auto lost = overwrittenInput(arguments)) {
        return "\"" + lost->string() + "\" is an input and would be overwritten";
    }
    return {};
}

}  // namespace

std::string wrongIn(const Arguments& arguments) {
    if (arguments.load.split == SplitMode::Seams && arguments.seams.empty()) {
        return "--split seams divides by the cuts of a file: give it with --seams";
    }
    if (std::string wrong = wrongFairing(arguments.lines); !wrong.empty()) {
        return wrong;
    }
    if (std::isnan(arguments.options.authalic)) {  // which is neither below nor above a limit
        return "--authalic must be a number from 0 to 1";
    }
    if (std::isnan(arguments.picture.morph)) {
        return "--morph must be a number from 0 to 1";
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
