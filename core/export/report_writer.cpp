// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/file.h"
#include "core/base/version.h"
#include "core/diagnose/doubt.h"
#include "core/export/json.h"
#include "core/export/writers.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

constexpr int kReportVersion = 1;  // increased when a field changes its meaning or is removed

/// Figures of a flat piece; all null if it is not flat.
void addQuality(Json& json, const PieceQuality* q) {
    const auto put = [&json, q](const char* key, auto member) {
        json[key] = q ? number(q->*member) : Json(nullptr);
    };
    const auto putCount = [&json, q](const char* key, int PieceQuality::*member) {
        json[key] = q ? Json(q->*member) : Json(nullptr);
    };
    put("area_3d", &PieceQuality::area3d);
    put("area_2d", &PieceQuality::area2d);
    put("perimeter_3d", &PieceQuality::perimeter3d);
    put("perimeter_2d", &PieceQuality::perimeter2d);
    put("pi_theta", &PieceQuality::piTheta);
    put("pi_l", &PieceQuality::piL);
    put("pi_e", &PieceQuality::piE);
    put("pi_a", &PieceQuality::piA);
    put("max_boundary_length_error", &PieceQuality::maxBoundaryLengthError);
    put("symmetric_dirichlet", &PieceQuality::symmetricDirichlet);
    put("quasi_conformal_mean", &PieceQuality::quasiConformalMean);
    put("quasi_conformal_max", &PieceQuality::quasiConformalMax);
    put("strain_min", &PieceQuality::strainMin);
    put("strain_max", &PieceQuality::strainMax);
    put("strain_mean_abs", &PieceQuality::strainMeanAbs);
    putCount("flipped_triangles", &PieceQuality::flippedTriangles);
    putCount("outline_crossings", &PieceQuality::outlineCrossings);
}

/// Distance of the piece from the reference panel, if the file has one.
Json referenceJson(const PieceResult& result) {
    if (!result.quality || !result.quality->reference) {
        return nullptr;
    }
    const ReferenceFit& fit = *result.quality->reference;
    return {{"rms", number(fit.rms)}, {"max", number(fit.max)}, {"mirrored", fit.mirrored}};
}

/// Solver diagnostics; boundary figures only if the method solves a boundary problem.
void addDiagnostics(Json& json, const PieceResult& result) {
    const bool boundary = result.flat && traits(result.options.method).solvesBoundary;
    json["boundary_iterations"] = boundary ? Json(result.flat->boundaryIterations) : Json(nullptr);
    json["closure_gap"] = boundary ? number(result.flat->closureGap) : Json(nullptr);
    json["angle_energy"] = boundary ? number(result.flat->angleEnergy) : Json(nullptr);
    json["interior_iterations"] =
        result.flat ? Json(result.flat->interiorIterations) : Json(nullptr);
    json["delaunay_flips"] = result.flat ? Json(result.flat->delaunayFlips) : Json(nullptr);
}

/// Notes on a flat piece for the user.
Json notesJson(const PieceResult& result) {
    Json notes = Json::array();
    if (result.flat) {
        for (const Error& note : result.flat->notes) {
            notes.push_back(errorJson(note));
        }
    }
    return notes;
}

/// Inner loops that remain open.
Json holesJson(const Piece& piece, const PieceResult& result) {
    Json holes = Json::array();
    for (const auto& hole : piece.holes) {
        const Json flat =
            result.flat ? number(boundaryLengths2d(result.flat->Q, hole).sum()) : Json(nullptr);
        holes.push_back({{"length_3d", number(boundaryLengths3d(piece.mesh.V, hole).sum())},
                         {"length_2d", flat}});
    }
    return holes;
}

Json secondsJson(const PieceResult& result, double readSeconds) {
    const FlatPiece* flat = result.flat ? &*result.flat : nullptr;
    return {{"read", number(readSeconds)},
            {"boundary", flat ? number(flat->boundarySeconds) : Json(nullptr)},
            {"interior", flat ? number(flat->interiorSeconds) : Json(nullptr)},
            {"total", number(result.seconds)}};
}

/// How the piece is cut; once without a pattern. Halves are listed only if requested.
void addCutting(Json& json, const Pattern& pattern, std::size_t index) {
    const PatternPiece none;
    const PatternPiece& piece = index < pattern.pieces.size() ? pattern.pieces[index] : none;
    json["quantity"] = piece.quantity;
    json["mirrored_pair"] = piece.mirroredPair;
    if (!piece.material.empty()) {
        json["material"] = text(piece.material);
    }
    if (piece.grain) {
        json["grain"] = number(*piece.grain);
    }
    if (piece.byHalf) {
        json["by_half"] = true;
    }
    if (piece.cutAs != CutAs::Whole) {
        json["cut_as"] = piece.cutAs == CutAs::OnFold ? "fold" : "pair";
    }
    if (piece.cutAs == CutAs::Image) {
        json["cut_with"] = pattern.pieces[piece.mirror.counterpart].name;
    }
    addPatternJson(json, pattern, piece);
}

/// The materials of the pieces apart from the garment's own fabric.
Json materialsJson(const Pattern& pattern) {
    const auto limits = [](const StrainLimits& stated) -> Json {
        return {number(stated.least), number(stated.most)};
    };
    Json materials = Json::array();
    for (const auto& [name, fabric] : pattern.materials) {
        if (std::ranges::find(pattern.pieces, name, &PatternPiece::material) !=
            pattern.pieces.end()) {
            materials.push_back({{"name", text(name)},
                                 {"fabric", text(fabric.id)},
                                 {"warp", limits(fabric.warp)},
                                 {"weft", limits(fabric.weft)},
                                 {"bias", limits(fabric.bias)},
                                 {"width_mm", number(fabric.width)}});
        }
    }
    return materials;
}

/// Adds the label texts of all pieces and their materials; nothing if none are set.
void addStated(Json& report, const Pattern& pattern) {
    const auto put = [&report](const char* key, const std::string& stated) {
        if (!stated.empty()) {
            report[key] = text(stated);
        }
    };
    put("size", pattern.label.size);
    put("date", pattern.label.date);
    if (Json materials = materialsJson(pattern); !materials.empty()) {
        report["materials"] = std::move(materials);
    }
}

Json pieceJson(const Garment& garment, const Piece& piece, const PieceResult& result,
               const Pattern& pattern, std::size_t index) {
    const SourceFile& file = *garment.files[piece.file];
    const bool solves = traits(result.options.method).solvesBoundary;
    Json json{{"name", piece.name},
              {"file", pathText(file.path)},
              {"method", text(name(result.options.method))},
              {"boundary_solver", solves ? text(name(result.flat ? result.flat->boundarySolver
                                                                 : result.options.boundarySolver))
                                         : Json(nullptr)},
              {"status", text(statusOf(result))},
              {"error", result.error ? errorJson(*result.error) : Json(nullptr)},
              {"vertices", piece.mesh.V.rows()},
              {"triangles", piece.mesh.F.rows()},
              {"boundary_edges", piece.defect ? Json(nullptr) : Json(piece.boundary.size())}};
    addQuality(json, result.flat && result.quality ? &*result.quality : nullptr);
    addChanges(json, changesOf(result));
    addDiagnostics(json, result);
    json["notes"] = notesJson(result);
    json["holes"] = holesJson(piece, result);
    json["reference"] = referenceJson(result);
    if (result.flat && result.flat->line) {
        json["line"] = lineJson(result);
    }
    addCutting(json, pattern, index);
    json["seconds"] = secondsJson(result, file.readSeconds);
    return json;
}

Json doubtsJson(const Garment& garment, const PieceResults& results,
                const std::vector<Fabric>& fabrics) {
    Json doubts = Json::array();
    for (const Doubt& doubt : findDoubts(garment, results, fabrics)) {
        const bool isOfPiece = doubt.subject.kind == Subject::Kind::Piece;
        doubts.push_back({{"code", text(doubtWords(doubt.kind).name)},
                          {"piece", textOrNull(isOfPiece ? doubt.subject.name : "")},
                          {"fault", doubt.isFault},
                          {"message", sentence(doubt)}});
    }
    return doubts;
}

}  // namespace

std::string writeReport(const Garment& garment, const PieceResults& results, const Pattern& pattern,
                        const Fabric& own) {
    Json report{{"version", kReportVersion}, {"toile", text(version())}};
    report["files"] = filesJson(garment, results);
    addStated(report, pattern);
    report["pieces"] = Json::array();
    for (std::size_t i = 0; i < results.size(); ++i) {
        report["pieces"].push_back(pieceJson(garment, *garment.pieces[i], *results[i], pattern, i));
    }
    report["cuts"] = cutsJson(garment);
    report["seams"] = seamsJson(garment, results);
    if (std::ranges::any_of(results, [](const auto& result) { return result->exact != nullptr; })) {
        report["seam_ends"] = seamEndsJson(garment, results);
    }
    if (!pattern.facings.empty()) {
        report["facings"] = facingsJson(pattern);
    }
    if (pattern.symmetry) {
        report["symmetry"] = symmetryJson(garment, results, *pattern.symmetry);
    }
    report["problems"] = problemsJson(garment);
    report["doubts"] = doubtsJson(garment, results, fabricsOf(pattern, own));
    return jsonText(report);
}

namespace {

constexpr int kInfoVersion = 1;  // increased when a field changes its meaning or is removed

Json pieceJson(const Garment& garment, const Piece& piece) {
    const Eigen::RowVector3d size =
        piece.mesh.V.colwise().maxCoeff() - piece.mesh.V.colwise().minCoeff();
    Json loops = Json::array();
    for (const double length : loopLengths(piece)) {
        loops.push_back(number(length));
    }
    return {{"name", piece.name},
            {"file", pathText(garment.files[piece.file]->path)},
            {"kind", piece.defect ? text(name(piece.defect->code)) : Json("disk")},
            {"vertices", piece.mesh.V.rows()},
            {"triangles", piece.mesh.F.rows()},
            {"size", {number(size.x()), number(size.y()), number(size.z())}},
            {"loops", std::move(loops)},
            {"holes", piece.holes.size()},
            {"has_reference", piece.reference.has_value()}};
}

}  // namespace

std::string writeInfo(const Garment& garment) {
    Json info{{"version", kInfoVersion}, {"toile", text(version())}};
    info["files"] = filesJson(garment, {});
    info["pieces"] = Json::array();
    for (const auto& piece : garment.pieces) {
        info["pieces"].push_back(pieceJson(garment, *piece));
    }
    info["cuts"] = cutsJson(garment);
    info["seams"] = seamsJson(garment, {});
    info["problems"] = problemsJson(garment);
    info["doubts"] = doubtsJson(garment, {}, {});
    return jsonText(info);
}

}  // namespace toile
