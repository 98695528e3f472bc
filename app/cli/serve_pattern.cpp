// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <sstream>
#include <utility>

#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/proof_order.h"
#include "app/cli/serve_state.h"
#include "app/cli/typed_words.h"
#include "app/cli/write_patterns.h"
#include "core/base/file.h"
#include "core/formats/json.h"
#include "core/formats/tables/report_tables.h"
#include "core/formats/writers.h"
#include "core/project/piece_names.h"

namespace toile::app {

Arguments ServeSession::State::typedOfGarment(const char* command, const ServeRequest& request,
                                              unsigned taken) const {
    std::vector<std::string> files;
    for (const auto& file : asked->typed.inputs) {
        files.push_back(file.string());
    }
    return typedWords(command, files, request.args, taken);
}

std::variant<FinishedPattern, Refusal> ServeSession::State::flat(bool settle, Progress& progress) {
    const Arguments& said = asked->arguments;
    progress.start(1);
    PieceResults found = flattener.flatten(made, said.options, progress, 0,
                                           pattern ? pattern->results : PieceResults(), said.lines);
    if (settle) {
        found = flattener.settle(made, std::move(found), progress, 0, said.lines);
    }
    if (progress.isCancelled()) {
        return Refusal(Error{ErrorCode::Cancelled});
    }
    return finished(said, garment,
                    withoutLeftOut(said, garment, resultsFor(garment, std::move(found))));
}

ServeOutcome ServeSession::State::flatten(bool settle, Progress& progress) {
    auto flattened = flat(settle, progress);
    if (auto* refusal = std::get_if<Refusal>(&flattened)) {
        return std::move(*refusal);
    }
    pattern = std::get<FinishedPattern>(std::move(flattened));
    const PieceResults& results = pattern->results;
    Json pieces = Json::array();
    for (std::size_t p = 0; p < results.size(); ++p) {
        const PieceResult& result = *results[p];
        pieces.push_back({{"name", garment.pieces[p]->name},
                          {"status", text(statusOf(result))},
                          {"error", result.error ? refusalJson(*result.error) : Json(nullptr)},
                          {"settled", !isWarm(result)}});
    }
    const auto seams = seamsByError(garment, results);
    const Json worst = seams.empty() ? Json(nullptr) : number(std::abs(seams[0].measure.errorMm));
    return Json{{"pieces", std::move(pieces)}, {"largest_seam_error_mm", worst}};
}

ServeOutcome ServeSession::State::write(const ServeRequest& request, Progress& progress) {
    std::ostringstream ignored;
    // With a project's meshes, which are not to be overwritten either.
    const Arguments typed =
        withProject(typedOfGarment("flatten", request, kOutputFiles | kExporting), ignored);
    if (typed.isMessage()) {
        return Refusal(typed);
    }
    if (typed.outputs.empty()) {
        return Refusal(kWrongUsage, "an export needs -o FILE");
    }
    for (const auto& output : typed.outputs) {  // a request must not wait for a pipe's reader
        std::error_code missing;
        const auto status = std::filesystem::status(output, missing);
        if (exists(status) && !is_regular_file(status) && !is_directory(status)) {
            return Refusal(Error{ErrorCode::FileUnwritable, Subject::file(output.string()),
                                 "it is a pipe or a device"});
        }
    }
    auto flattened = flat(true, progress);
    if (auto* refusal = std::get_if<Refusal>(&flattened)) {
        return std::move(*refusal);
    }
    if (auto refusal =
            refusalOfNoPattern(std::get<FinishedPattern>(flattened).results, typed.outputs)) {
        return *std::move(refusal);
    }
    auto& settled = std::get<FinishedPattern>(flattened);
    const ExportSource exported = settled.source(typed.exporting);
    Json files = Json::array();
    for (const auto& output : typed.outputs) {
        const auto written = exportFile(output, exported, progress);
        if (!written) {
            return Refusal(written.error());
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
    Arguments typed = typedOfGarment("prove", request, kSewing);
    if (typed.isMessage()) {
        return Refusal(typed);
    }
    typed.project = asked->arguments.project;
    auto flattened = flat(true, progress);
    if (auto* refusal = std::get_if<Refusal>(&flattened)) {
        return std::move(*refusal);
    }
    const auto order = proofOrder(typed, garment, progress);
    if (const auto* refusal = std::get_if<Refusal>(&order)) {
        return *refusal;
    }
    auto& settled = std::get<FinishedPattern>(flattened);
    FinishedPattern proven = settled;
    proven.fabric = typed.fabric.value_or(settled.fabric);
    const auto proof = proofOf(proven.source(), std::get<ProofOrder>(order), progress);
    if (!proof) {
        return refusalOfProof(proof.error(), settled.results);
    }
    pattern = std::move(settled);
    Json told = Json::parse(writeProof(garment, **proof));
    told["notes"] = notesOf(std::get<ProofOrder>(order));
    return told;
}

}  // namespace toile::app
