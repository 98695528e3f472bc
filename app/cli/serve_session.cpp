// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/serve_session.h"

#include <cmath>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/proof_order.h"
#include "app/cli/serve_query.h"
#include "app/cli/typed_words.h"
#include "core/base/file.h"
#include "core/export/export_file.h"
#include "core/export/json.h"
#include "core/export/report_tables.h"
#include "core/export/writers.h"
#include "core/pipeline/garment_flattener.h"
#include "core/project/piece_names.h"

namespace toile::app {
namespace {

ServeFault cancelledServe() {
    return serveFault({ErrorCode::Cancelled});
}

/// The sentences that a command would print.
Json sentencesOf(const std::string& printed) {
    Json list = Json::array();
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
        list.push_back(withoutSpeaker(line));
    }
    return list;
}

ServeFault usageFault(const Arguments& message) {
    const bool isFile = message.status == kExitUnreadable;
    return {isFile ? std::string(name(ErrorCode::FileUnreadable)) : kWrongUsage,
            withoutSpeaker(message.message)};
}

std::vector<std::string> namesOf(const std::vector<std::filesystem::path>& files) {
    std::vector<std::string> names;
    names.reserve(files.size());
    for (const auto& file : files) {
        names.push_back(file.string());
    }
    return names;
}

bool isMessage(const Arguments& arguments) {
    return arguments.command == Arguments::Command::Message;
}

/// Whether words name files beside the garment's, which come first: not by their names, which
/// `typedWords` may have changed.
bool namesFiles(const Arguments& typed, const Arguments& garment) {
    return typed.inputs.size() != garment.inputs.size();
}

}  // namespace

struct ServeSession::State {
    /// What was said of a garment: by it everything follows.
    struct Asked {
        Arguments typed, arguments;  ///< as the words say; and with what a project says
        std::optional<std::string> seams;
        std::string notes;  ///< sentences
    };

    /// How its pieces lie. Kept aside until what asked for them is done.
    struct Pattern {
        PieceResults results;
        std::optional<LaidOutPattern> laid;
    };

    std::optional<Asked> asked;
    GarmentInputs inputs;
    Garment made;     ///< as the inputs say
    Garment garment;  ///< with the names that a project gives
    Pattern pattern;
    GarmentFlattener flattener;

    ServeOutcome answer(const ServeRequest& request, Progress& progress);
    ServeOutcome load(const ServeRequest& request, Progress& progress);
    ServeOutcome edit(const ServeRequest& request, Progress& progress);
    ServeOutcome make(Asked next, ReadFiles files, Progress& progress);
    ServeOutcome flatten(bool settle, Progress& progress);
    ServeOutcome write(const ServeRequest& request, Progress& progress);
    ServeOutcome prove(const ServeRequest& request, Progress& progress);
    std::variant<Pattern, ServeFault> flat(bool settle, Progress& progress);
    ExportSource source(const Pattern& of, const ExportOptions& options,
                        const Arguments& typed) const;
    bool saysMore(const Arguments& typed) const;
};

namespace {

using ServeAsked = std::variant<Arguments, ServeFault>;

/// The words of a garment, with its seams read.
ServeAsked typedOf(const std::vector<std::string>& words,
                   const std::vector<std::filesystem::path>& files) {
    Arguments typed = typedWords("flatten", namesOf(files), words);
    if (isMessage(typed)) {
        return usageFault(typed);
    }
    if (const char* word = wordOutOfPlace(typed)) {
        return ServeFault{kWrongUsage, outOfPlaceSentence(word)};
    }
    return typed;
}

}  // namespace

ServeOutcome ServeSession::State::make(Asked next, ReadFiles files, Progress& progress) {
    std::ostringstream err;
    next.arguments = withProject(next.typed, err);
    if (isMessage(next.arguments)) {
        return usageFault(next.arguments);
    }
    if (files.empty()) {
        auto read = readFiles(next.arguments.inputs, progress);
        if (!read) {
            return serveFault(read.error());
        }
        files = std::move(*read);
    }
    if (next.seams && !next.typed.seams.empty()) {
        return ServeFault{kWrongUsage, "give the cuts as \"seams\" or as --seams, not both"};
    }
    auto loading = loadingOf(next.arguments, err);
    if (!loading) {
        return serveFault(loading.error());
    }
    if (next.seams) {
        Problems notes;
        auto seams = parseSeamsFile(*next.seams, "seams", &notes);
        if (!seams) {
            return serveFault(seams.error());
        }
        for (const Error& note : notes) {
            err << sentence(note) << '\n';
        }
        loading->seams = std::move(*seams);
    }
    GarmentInputs wanted{std::move(files), std::move(*loading)};
    auto garmentMade = makeGarment(wanted, progress, inputs, asked ? &made : nullptr);
    if (!garmentMade) {
        return serveFault(garmentMade.error());
    }
    const bool isOther = !(wanted.files == inputs.files);
    printDifferences(next.arguments, *garmentMade, err);
    next.notes = err.str();
    inputs = std::move(wanted);
    made = std::move(*garmentMade);
    garment = next.arguments.project ? named(made, next.arguments.project->labels) : made;
    asked = std::move(next);
    pattern = {};
    if (isOther) {
        flattener.reset();
    }
    Json told = Json::parse(writeInfo(garment));
    told["notes"] = sentencesOf(asked->notes);
    return told;
}

ServeOutcome ServeSession::State::load(const ServeRequest& request, Progress& progress) {
    auto typed = typedOf(request.args, {});
    if (auto* fault = std::get_if<ServeFault>(&typed)) {
        return *fault;
    }
    Asked next;
    next.typed = std::get<Arguments>(std::move(typed));
    next.seams = request.seams;
    return make(std::move(next), {}, progress);
}

ServeOutcome ServeSession::State::edit(const ServeRequest& request, Progress& progress) {
    Asked next;
    next.typed = asked->typed;
    next.seams = request.seams ? request.seams : asked->seams;
    if (request.hasArgs) {
        auto typed = typedOf(request.args, asked->typed.inputs);
        if (auto* fault = std::get_if<ServeFault>(&typed)) {
            return *fault;
        }
        next.typed = std::get<Arguments>(std::move(typed));
        if (namesFiles(next.typed, asked->typed)) {
            return ServeFault{kWrongUsage, "files are read by \"load\"; an edit has options alone"};
        }
    }
    return make(std::move(next), inputs.files, progress);
}

std::variant<ServeSession::State::Pattern, ServeFault> ServeSession::State::flat(
    bool settle, Progress& progress) {
    const Arguments& said = asked->arguments;
    progress.start(1);
    PieceResults found =
        flattener.flatten(made, said.options, progress, 0, pattern.results, said.lines);
    if (settle) {
        found = flattener.settle(made, std::move(found), progress, 0, said.lines);
    }
    if (progress.isCancelled()) {
        return cancelledServe();
    }
    Pattern next;
    next.results = withoutLeftOut(said, garment, resultsFor(garment, std::move(found)));
    next.laid = laidOut(said, garment, next.results);
    return next;
}

bool ServeSession::State::saysMore(const Arguments& typed) const {
    return !(typed.load == Arguments{}.load) || !typed.seams.empty() ||
           !(typed.stated == StatedOptions{}) || namesFiles(typed, asked->typed);
}

ServeOutcome ServeSession::State::flatten(bool settle, Progress& progress) {
    auto flattened = flat(settle, progress);
    if (auto* fault = std::get_if<ServeFault>(&flattened)) {
        return std::move(*fault);
    }
    pattern = std::get<Pattern>(std::move(flattened));
    const PieceResults& results = pattern.results;
    Json pieces = Json::array();
    for (std::size_t p = 0; p < results.size(); ++p) {
        const PieceResult& result = *results[p];
        pieces.push_back({{"name", garment.pieces[p]->name},
                          {"status", text(statusOf(result))},
                          {"error", result.error ? errorJson(*result.error) : Json(nullptr)},
                          {"settled", !isWarm(result)}});
    }
    const auto seams = seamsByError(garment, results);
    const Json worst = seams.empty() ? Json(nullptr) : number(std::abs(seams[0].measure.errorMm));
    return Json{{"pieces", std::move(pieces)}, {"largest_seam_error_mm", worst}};
}

ExportSource ServeSession::State::source(const Pattern& of, const ExportOptions& options,
                                         const Arguments& typed) const {
    return {garment,
            of.results,
            *of.laid,
            options,
            {},
            asked->arguments.lines,
            typed.fabric.value_or(asked->arguments.fabric.value_or(fabricPresets().front()))};
}

ServeOutcome ServeSession::State::write(const ServeRequest& request, Progress& progress) {
    const Arguments typed = typedWords("flatten", namesOf(asked->typed.inputs), request.args);
    if (isMessage(typed)) {
        return usageFault(typed);
    }
    if (saysMore(typed) || typed.outputs.empty()) {
        return ServeFault{kWrongUsage, "an export has -o FILE and the options of files alone"};
    }
    if (const char* word = wordOutOfPlace(typed, true)) {
        return ServeFault{kWrongUsage, outOfPlaceSentence(word)};
    }
    std::ostringstream ignored;
    if (const Arguments refused = withProject(typed, ignored); isMessage(refused)) {
        return usageFault(refused);
    }
    auto flattened = flat(true, progress);
    if (auto* fault = std::get_if<ServeFault>(&flattened)) {
        return std::move(*fault);
    }
    auto& settled = std::get<Pattern>(flattened);
    const ExportSource exported = source(settled, typed.exporting, typed);
    Json files = Json::array();
    for (const auto& output : typed.outputs) {
        const auto written = exportFile(output, exported, progress);
        if (!written) {
            return serveFault(written.error());
        }
        for (const auto& file : written->files) {
            files.push_back({{"path", pathText(file)},
                             {"read_back", written->readBack && file == written->files.front()
                                               ? Json(readBackSentence(*written->readBack))
                                               : Json(nullptr)}});
        }
    }
    pattern = std::move(settled);
    return Json{{"files", std::move(files)}};
}

ServeOutcome ServeSession::State::prove(const ServeRequest& request, Progress& progress) {
    Arguments typed = typedWords("prove", namesOf(asked->typed.inputs), request.args);
    if (isMessage(typed)) {
        return usageFault(typed);
    }
    if (saysMore(typed) || !typed.outputs.empty() || !typed.prove.report.empty() ||
        typed.prove.rounds > 0) {
        return ServeFault{kWrongUsage,
                          "a proof here has the options of sewing alone, and no files"};
    }
    auto flattened = flat(true, progress);
    if (auto* fault = std::get_if<ServeFault>(&flattened)) {
        return std::move(*fault);
    }
    const auto order = proofOrder(typed, garment, progress);
    if (const auto* error = std::get_if<Error>(&order)) {
        return serveFault(*error);
    }
    if (const auto* unfit = std::get_if<UnfitProof>(&order)) {
        return ServeFault{"not-proved", unfit->sentence, unfit->subject};
    }
    auto& settled = std::get<Pattern>(flattened);
    const auto proof = proofOf(source(settled, {}, typed), std::get<ProofOrder>(order), progress);
    if (!proof) {
        return serveFault(proof.error());
    }
    pattern = std::move(settled);
    return Json::parse(writeProof(garment, **proof));
}

ServeOutcome ServeSession::State::answer(const ServeRequest& request, Progress& progress) {
    if (request.fault) {
        return *request.fault;
    }
    if (progress.isCancelled()) {
        return cancelledServe();
    }
    const std::string& what = request.what;
    if (what == "load") {
        return load(request, progress);
    }
    if (what == "cancel" || what == "quit") {
        return Json::object();
    }
    if (!asked) {
        return ServeFault{"no-garment", "there is no garment: ask for \"load\" first"};
    }
    if (what == "edit") {
        return edit(request, progress);
    }
    if (what == "flatten") {
        return flatten(request.settle, progress);
    }
    if (what == "query") {
        return serveQuery(request, garment, pattern.results,
                          pattern.laid ? &*pattern.laid : nullptr);
    }
    if (what == "export") {
        return write(request, progress);
    }
    if (what == "prove") {
        return prove(request, progress);
    }
    asked.reset();  // close
    inputs = {};
    made = garment = {};
    pattern = {};
    flattener.reset();
    return Json::object();
}

ServeSession::ServeSession() : state_(std::make_unique<State>()) {}
ServeSession::~ServeSession() = default;

std::string ServeSession::answer(const ServeRequest& request, Progress& progress) {
    try {
        const ServeOutcome outcome = state_->answer(request, progress);
        const auto* fault = std::get_if<ServeFault>(&outcome);
        return fault ? serveAnswer(request.id, *fault)
                     : serveAnswer(request.id, std::get<OrderedJson>(outcome));
    } catch (const std::bad_alloc&) {
        return serveAnswer(request.id, serveFault({ErrorCode::OutOfMemory}));
    } catch (const std::exception& fault) {  // a bug: still an answer
        return serveAnswer(request.id, ServeFault{"unexpected", fault.what()});
    }
}

}  // namespace toile::app
