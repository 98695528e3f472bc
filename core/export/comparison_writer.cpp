// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/comparison_writer.h"

#include "core/base/version.h"
#include "core/export/json.h"

namespace toile {
namespace {

constexpr int kComparisonVersion = 1;  // of the fields: grows when one changes its meaning or goes

/// The figures that a garment and a piece share; null where there is none.
void addFigures(Json& json, const ComparedFigures& figures) {
    for (const CriterionTraits& criterion : allCriteria()) {
        if (!criterion.key.empty()) {
            const std::optional<double>& value = figures[criterion.criterion];
            const bool isCount = value && criterion.format == FigureFormat::Count;
            json[std::string(criterion.key)] =
                isCount ? Json(static_cast<int>(*value)) : number(value);
        }
    }
}

Json pieceJson(const PieceResult& result, const ComparedFigures& figures) {
    Json json{{"name", result.piece->name},
              {"status", text(statusOf(result))},
              {"error", result.error ? errorJson(*result.error) : Json(nullptr)},
              {"triangles", result.piece->mesh.F.rows()}};
    addFigures(json, figures);
    return json;
}

Json methodJson(const ComparedMethod& method) {
    Json json{{"method", text(name(method.method))},
              {"keeps_lengths", traits(method.method).keepsLengths},
              {"pieces_flat", method.figures.pieces - method.figures.failed},
              {"failed", method.figures.failed},
              {"pieces_with_reference", method.figures.referencedPieces}};
    addFigures(json, method.figures);
    json["pieces"] = Json::array();
    for (std::size_t k = 0; k < method.results.size(); ++k) {
        json["pieces"].push_back(pieceJson(*method.results[k], method.pieceFigures[k]));
    }
    return json;
}

}  // namespace

std::string writeComparison(const Garment& garment, const Comparison& comparison) {
    Json json{{"version", kComparisonVersion}, {"toile", text(version())}};
    json["files"] = filesJson(garment, {});
    json["methods"] = Json::array();
    for (const ComparedMethod& method : comparison.methods) {
        json["methods"].push_back(methodJson(method));
    }
    json["nearer_than_length_keeping"] = Json::array();
    if (const auto nearer = nearerThanLengthKeeping(comparison)) {
        for (const std::size_t k : nearer->freeOutline) {
            json["nearer_than_length_keeping"].push_back(text(name(comparison.methods[k].method)));
        }
    }
    json["problems"] = problemsJson(garment);
    return jsonText(json);
}

}  // namespace toile
