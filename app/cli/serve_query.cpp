// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/serve_query.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/formats/json.h"
#include "core/formats/writers.h"
#include "core/quality/metric_tensor.h"

namespace toile::app {
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

/// Of each triangle the principal strain of larger size: what the cloth does where it is worn.
Json strainJson(const Piece& piece, const FlatPiece& flat) {
    Json list = Json::array();
    for (const MetricTensor& metric : wornFaceMetrics(piece.mesh, flat.Q)) {
        const PrincipalStretch stretch = principalStretch(metric);
        const double most = stretch.largest - 1, least = stretch.least - 1;
        list.push_back(number(std::abs(least) > std::abs(most) ? least : most));
    }
    return list;
}

/// The flat points where they lie on the sheet; null where the pattern has the piece nowhere.
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

/// Which pieces are meant: all where none is named.
std::variant<std::vector<int>, Refusal> piecesMeant(const ServeRequest& request,
                                                    const Garment& garment) {
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

}  // namespace

ServeOutcome serveQuery(const ServeRequest& request, const Garment& garment,
                        const PieceResults& results, const LaidOutPattern* laid) {
    const auto meant = piecesMeant(request, garment);
    if (const auto* refusal = std::get_if<Refusal>(&meant)) {
        return *refusal;
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
            for (const int p : std::get<0>(meant)) {
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

}  // namespace toile::app
