// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include "app/cli/command_line.h"
#include "app/cli/serve.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/formats/export_file.h"
#include "core/formats/json.h"
#include "core/formats/tables/report_tables.h"
#include "core/formats/writers.h"
#include "core/layout/marker.h"
#include "core/project/piece_names.h"
#include "core/quality/metric_tensor.h"
#include "core/toile/garment_flattener.h"

namespace toile::app {

using ServeOutcome = Answer<OrderedJson>;

/// The state of a session, and one function per request. A refused one leaves it unchanged.
struct ServeSession::State {
    /// The options about a garment, which determine everything else.
    struct Asked {
        Arguments typed{};
        std::optional<std::string> seams{};
        Arguments arguments{};  ///< with a project's settings
    };

    std::optional<Asked> asked;
    GarmentInputs inputs;
    Garment made;     ///< from the inputs
    Garment garment;  ///< with a project's names
    /// Last flattened pattern; nullopt before.
    std::optional<FinishedPattern> pattern;
    GarmentFlattener flattener;

    ServeOutcome answer(const ServeRequest& request, Progress& progress);
    ServeOutcome load(const ServeRequest& request, Progress& progress);
    ServeOutcome make(Asked next, ReadFiles files, Progress& progress);

    // Precondition: a garment is loaded.
    ServeOutcome edit(const ServeRequest& request, Progress& progress);
    ServeOutcome flatten(bool settle, Progress& progress);
    ServeOutcome write(const ServeRequest& request, Progress& progress);
    ServeOutcome prove(const ServeRequest& request, Progress& progress);
    void close();
    /// Makes the current pattern; a request stores it after success.
    Answer<FinishedPattern> flat(bool settle, Progress& progress);
    /// Parses options that refer to the loaded garment.
    Answer<Arguments> typedOfGarment(const char* command, const ServeRequest& request,
                                     unsigned taken) const;
};

namespace {

constexpr std::string_view kReportParts[] = {"files", "pieces",   "cuts",
                                             "seams", "problems", "doubts"};
constexpr std::string_view kMeshArrays[] = {"vertices", "triangles", "source_vertices",
                                            "source_faces", "outline"};
constexpr std::string_view kFlatArrays[] = {"flat", "sheet", "strain"};

template <std::size_t n>
bool isAmong(const std::string& word, const std::string_view (&words)[n]) {
    return std::ranges::find(words, word) != std::end(words);
}

template <class Matrix>
Json rowsJson(const Matrix& rows) {
    Json list = Json::array();
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        Json row = Json::array();
        for (Eigen::Index k = 0; k < rows.cols(); ++k) {
            row.push_back(rows(i, k));
        }
        list.push_back(std::move(row));
    }
    return list;
}

/// For each triangle, the principal strain of the worn cloth with the larger magnitude.
Json strainJson(const Piece& piece, const FlatPiece& flat) {
    Json list = Json::array();
    for (const MetricTensor& metric : wornFaceMetrics(piece.mesh, flat.Q)) {
        const PrincipalStretch stretch = principalStretch(metric);
        const double most = stretch.largest - 1, least = stretch.least - 1;
        list.push_back(number(std::abs(least) > std::abs(most) ? least : most));
    }
    return list;
}

/// The flat points on the sheet; null if the pattern does not contain the piece.
Json sheetJson(const LaidOutPattern& laid, int piece, const FlatPiece& flat) {
    const auto copy = std::ranges::find(laid.whole.copies, piece, &PlacedCopy::piece);
    if (copy == laid.whole.copies.end()) {
        return nullptr;
    }
    Points2 placed = flat.Q;
    for (Eigen::Index v = 0; v < placed.rows(); ++v) {
        placed.row(v) = copy->placement.applied(flat.Q.row(v).transpose()).transpose();
    }
    return rowsJson(placed);
}

Json meshArray(const std::string& word, const Piece& piece) {
    return word == "vertices"          ? rowsJson(piece.mesh.V)
           : word == "triangles"       ? rowsJson(piece.mesh.F)
           : word == "source_vertices" ? Json(piece.sourceVertex)
           : word == "source_faces"    ? Json(piece.sourceFace)
                                       : Json(piece.boundary);
}

Json flatArray(const std::string& word, const Garment& garment, const PieceResults& results,
               const LaidOutPattern& laid, int index) {
    const auto& flat = results[static_cast<std::size_t>(index)]->flat;
    const Piece& piece = *garment.pieces[static_cast<std::size_t>(index)];
    return !flat              ? Json(nullptr)
           : word == "flat"   ? rowsJson(flat->Q)
           : word == "strain" ? strainJson(piece, *flat)
                              : sheetJson(laid, index, *flat);
}

/// The requested pieces; all if the request names no piece.
Answer<std::vector<int>> piecesMeant(const ServeRequest& request, const Garment& garment) {
    std::vector<int> meant;
    for (const std::string& wanted : request.pieces) {
        const auto found = std::ranges::find_if(
            garment.pieces, [&wanted](const auto& piece) { return piece->name == wanted; });
        if (found == garment.pieces.end()) {
            return Refusal("no-such-piece", "the garment has no piece of this name", wanted);
        }
        meant.push_back(static_cast<int>(found - garment.pieces.begin()));
    }
    for (std::size_t p = 0; request.pieces.empty() && p < garment.pieces.size(); ++p) {
        meant.push_back(static_cast<int>(p));
    }
    return meant;
}

/// Parts of the report of a garment, and arrays of its pieces by name.
/// @param results  one per piece; empty if it is not flat yet: then parts of its description
/// (`toile info --json`) are used
/// @param laid     the pattern, if it is flat
/// Refused: unknown-word, no-such-piece, not-flat. Linear in the requested data.
ServeOutcome serveQuery(const ServeRequest& request, const Garment& garment,
                        const PieceResults& results, const LaidOutPattern* laid) {
    const auto meant = piecesMeant(request, garment);
    if (!meant) {
        return meant.refusal();
    }
    Json report, arrays = Json::object(), told = Json::object();
    for (const std::string& word : request.wanted) {
        const bool isOfMesh = isAmong(word, kMeshArrays), isOfFlat = isAmong(word, kFlatArrays);
        if (!isOfMesh && !isOfFlat && word != "report" && !isAmong(word, kReportParts)) {
            return Refusal("unknown-word", "unknown query: \"" + word + "\"; see docs/serve.md");
        }
        if (!laid && (isOfFlat || word == "doubts")) {
            return Refusal(kNotFlat, "nothing is flattened yet; send \"flatten\" first");
        }
        if (isOfMesh || isOfFlat) {
            for (const int p : *meant) {
                const Piece& piece = *garment.pieces[static_cast<std::size_t>(p)];
                arrays[piece.name][word] =
                    isOfMesh ? meshArray(word, piece) : flatArray(word, garment, results, *laid, p);
            }
            continue;
        }
        if (report.is_null()) {
            report = Json::parse(laid ? writeReport(garment, results, laid->pattern)
                                      : writeInfo(garment));
        }
        if (word == "report") {
            told["report"] = report;
        } else {
            told[word] = report.at(word);
        }
    }
    if (!arrays.empty()) {
        told["arrays"] = std::move(arrays);
    }
    return told;
}

}  // namespace

ServeOutcome ServeSession::State::load(const ServeRequest& request, Progress& progress) {
    auto typed = typedWords("flatten", {}, request.args, kInputFiles | kReading | kFlattening);
    return typed ? make({.typed = *std::move(typed), .seams = request.seams}, {}, progress)
                 : typed.refusal();
}

ServeOutcome ServeSession::State::edit(const ServeRequest& request, Progress& progress) {
    auto typed =
        request.hasArgs ? typedOfGarment("flatten", request, kReading | kFlattening) : asked->typed;
    if (!typed) {
        return typed.refusal();
    }
    return make({.typed = *std::move(typed), .seams = request.seams ? request.seams : asked->seams},
                inputs.files, progress);
}

ServeOutcome ServeSession::State::make(Asked next, ReadFiles files, Progress& progress) {
    Messages messages;
    auto arguments = withProject(next.typed, messages);
    if (!arguments) {
        return arguments.refusal();
    }
    next.arguments = *std::move(arguments);
    if (files.empty()) {
        auto read = readFiles(next.arguments.inputs, progress);
        if (!read) {
            return read.error();
        }
        files = std::move(*read);
    }
    if (next.seams && !next.typed.seams.empty()) {
        return usageRefusal("use either \"seams\" or --seams for the cuts, not both");
    }
    auto loading = loadingOf(next.arguments, messages);
    if (!loading) {
        return loading.refusal();
    }
    if (next.seams) {
        Problems notes;
        auto seams = parseSeamsFile(*next.seams, "seams", &notes);
        if (!seams) {
            return seams.error();
        }
        for (const Error& note : notes) {
            messages.add(note);
        }
        loading->seams = std::move(*seams);
    }
    GarmentInputs wanted{std::move(files), std::move(*loading)};
    auto garmentMade = makeGarment(wanted, progress, inputs, asked ? &made : nullptr);
    if (!garmentMade) {
        return garmentMade.error();
    }
    const bool isOther = !(wanted.files == inputs.files);
    reportDifferences(next.arguments, *garmentMade, messages);
    inputs = std::move(wanted);
    made = std::move(*garmentMade);
    garment = next.arguments.project ? named(made, next.arguments.project->labels) : made;
    asked = std::move(next);
    pattern.reset();
    if (isOther) {
        flattener.reset();
    }
    Json told = Json::parse(writeInfo(garment));
    told["notes"] = messages.sentences();
    return told;
}

ServeOutcome ServeSession::State::answer(const ServeRequest& request, Progress& progress) {
    if (request.refusal) {
        return *request.refusal;
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    const std::string& what = request.what;
    if (what == "load") {
        return load(request, progress);
    }
    if (what == "cancel" || what == "quit") {
        return OrderedJson::object();
    }
    if (!asked) {
        return Refusal("no-garment", "there is no garment; send \"load\" first");
    }
    if (what == "edit") {
        return edit(request, progress);
    }
    if (what == "flatten") {
        return flatten(request.settle, progress);
    }
    if (what == "query") {
        return serveQuery(request, garment, pattern ? pattern->results : PieceResults(),
                          pattern ? &pattern->laid : nullptr);
    }
    if (what == "export") {
        return write(request, progress);
    }
    if (what == "prove") {
        return prove(request, progress);
    }
    close();
    return OrderedJson::object();
}

void ServeSession::State::close() {
    asked.reset();
    inputs = {};
    made = garment = {};
    pattern.reset();
    flattener.reset();
}

ServeSession::ServeSession() : state_(std::make_unique<State>()) {}
ServeSession::~ServeSession() = default;

std::string ServeSession::answer(const ServeRequest& request, Progress& progress) {
    try {
        const ServeOutcome outcome = state_->answer(request, progress);
        return outcome ? serveAnswer(request.id, *outcome)
                       : serveAnswer(request.id, outcome.refusal());
    } catch (const std::bad_alloc&) {
        return serveAnswer(request.id, Refusal(Error{ErrorCode::OutOfMemory}));
    } catch (const std::exception& fault) {  // a bug: answer anyway
        return serveAnswer(request.id, Refusal("unexpected", fault.what()));
    }
}

Answer<Arguments> ServeSession::State::typedOfGarment(const char* command,
                                                      const ServeRequest& request,
                                                      unsigned taken) const {
    std::vector<std::string> files;
    for (const auto& file : asked->typed.inputs) {
        files.push_back(file.string());
    }
    return typedWords(command, files, request.args, taken);
}

Answer<FinishedPattern> ServeSession::State::flat(bool settle, Progress& progress) {
    const Arguments& arguments = asked->arguments;
    progress.start(1);
    PieceResults found =
        flattener.flatten(made, arguments.options, progress, 0,
                          pattern ? pattern->results : PieceResults(), arguments.lines);
    if (settle) {
        found = flattener.settle(made, std::move(found), progress, 0, arguments.lines);
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    return finished(arguments, garment,
                    withoutLeftOut(arguments, garment, resultsFor(garment, std::move(found))));
}

ServeOutcome ServeSession::State::flatten(bool settle, Progress& progress) {
    auto flattened = flat(settle, progress);
    if (!flattened) {
        return flattened.refusal();
    }
    pattern = *std::move(flattened);
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
    Messages ignored;
    auto typed = typedOfGarment("flatten", request, kOutputFiles | kExporting);
    if (typed) {  // a project's meshes must not be overwritten either
        typed = withProject(*std::move(typed), ignored);
    }
    if (!typed) {
        return typed.refusal();
    }
    if (typed->outputs.empty()) {
        return usageRefusal("an export needs -o FILE");
    }
    for (const auto& output : typed->outputs) {  // writing would wait for a pipe's reader
        std::error_code missing;
        const auto status = std::filesystem::status(output, missing);
        if (exists(status) && !is_regular_file(status) && !is_directory(status)) {
            return Error{ErrorCode::FileUnwritable, Subject::file(output.string()),
                         "it is a pipe or a device"};
        }
    }
    auto flattened = flat(true, progress);
    if (!flattened) {
        return flattened.refusal();
    }
    FinishedPattern& settled = *flattened;
    if (auto refusal = refusalOfNoPattern(settled.results, typed->outputs)) {
        return *std::move(refusal);
    }
    const ExportSource exported = settled.source(typed->exporting);
    Json files = Json::array();
    for (const auto& output : typed->outputs) {
        const auto written = exportFile(output, exported, progress);
        if (!written) {
            return written.error();
        }
        for (const auto& file : written->files) {
            files.push_back({{"path", pathText(file)},
                             {"read_back", written->readBack && file == written->files.front()
                                               ? Json(readBackSentence(*written->readBack))
                                               : Json(nullptr)}});
        }
        for (const Wording& note : written->notes) {
            files.back()["notes"].push_back(text(note));
        }
    }
    pattern = std::move(settled);
    return Json{{"files", std::move(files)}};
}

ServeOutcome ServeSession::State::prove(const ServeRequest& request, Progress& progress) {
    auto typed = typedOfGarment("prove", request, kSewing);
    if (!typed) {
        return typed.refusal();
    }
    if (const auto& project = asked->arguments.project) {
        typed = withSettingsOf(*project, *std::move(typed));
        typed->project = project;
    }
    auto flattened = flat(true, progress);
    if (!flattened) {
        return flattened.refusal();
    }
    const auto order = proofOrder(*typed, garment, progress);
    if (!order) {
        return order.refusal();
    }
    FinishedPattern& settled = *flattened;
    FinishedPattern proven = settled;
    proven.fabric = typed->fabric.value_or(settled.fabric);
    const auto proof = proofOf(proven.source(), *order, progress);
    if (!proof) {
        return refusalOfProof(proof.error(), settled.results);
    }
    pattern = std::move(settled);
    Json told = Json::parse(writeProof(garment, **proof));
    told["notes"] = notesOf(*order);
    return told;
}

}  // namespace toile::app
