// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>
#include <utility>

#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/serve_state.h"
#include "app/cli/typed_words.h"
#include "core/formats/json.h"
#include "core/formats/writers.h"
#include "core/project/piece_names.h"

namespace toile::app {
namespace {

/// The sentences that a command would print.
Json sentencesOf(const std::string& printed) {
    Json list = Json::array();
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
        list.push_back(withoutSpeaker(line));
    }
    return list;
}

}  // namespace

ServeOutcome ServeSession::State::load(const ServeRequest& request, Progress& progress) {
    Arguments typed = typedWords("flatten", {}, request.args, kInputFiles | kReading | kFlattening);
    return make({.typed = std::move(typed), .seams = request.seams}, {}, progress);
}

ServeOutcome ServeSession::State::edit(const ServeRequest& request, Progress& progress) {
    Arguments typed =
        request.hasArgs ? typedOfGarment("flatten", request, kReading | kFlattening) : asked->typed;
    return make({.typed = std::move(typed), .seams = request.seams ? request.seams : asked->seams},
                inputs.files, progress);
}

ServeOutcome ServeSession::State::make(Asked next, ReadFiles files, Progress& progress) {
    std::ostringstream err;
    next.arguments = withProject(next.typed, err);
    if (next.arguments.isMessage()) {
        return Refusal(next.arguments);
    }
    if (files.empty()) {
        auto read = readFiles(next.arguments.inputs, progress);
        if (!read) {
            return Refusal(read.error());
        }
        files = std::move(*read);
    }
    if (next.seams && !next.typed.seams.empty()) {
        return Refusal(kWrongUsage, "use either \"seams\" or --seams for the cuts, not both");
    }
    auto loading = loadingOf(next.arguments, err);
    if (!loading) {
        return Refusal(loading.error());
    }
    if (next.seams) {
        Problems notes;
        auto seams = parseSeamsFile(*next.seams, "seams", &notes);
        if (!seams) {
            return Refusal(seams.error());
        }
        for (const Error& note : notes) {
            err << sentence(note) << '\n';
        }
        loading->seams = std::move(*seams);
    }
    GarmentInputs wanted{std::move(files), std::move(*loading)};
    auto garmentMade = makeGarment(wanted, progress, inputs, asked ? &made : nullptr);
    if (!garmentMade) {
        return Refusal(garmentMade.error());
    }
    const bool isOther = !(wanted.files == inputs.files);
    printDifferences(next.arguments, *garmentMade, err);
    next.notes = err.str();
    inputs = std::move(wanted);
    made = std::move(*garmentMade);
    garment = next.arguments.project ? named(made, next.arguments.project->labels) : made;
    asked = std::move(next);
    pattern.reset();
    if (isOther) {
        flattener.reset();
    }
    Json told = Json::parse(writeInfo(garment));
    told["notes"] = sentencesOf(asked->notes);
    return told;
}

}  // namespace toile::app
