// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/file.h"
#include "core/base/version.h"
#include "core/diagnose/doubt.h"
#include "core/formats/json.h"
#include "core/formats/writers.h"
#include "core/geometry/line.h"
#include "core/pattern/darts.h"
#include "core/pattern/fair_outline.h"
#include "core/pattern/piece_allowance.h"
#include "core/pattern/trueing.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Strain over pieces: the extremes, and the mean weighted by area. Null if no piece has any.
Json strainJson(const PieceResults& results, const std::vector<int>& pieces) {
    double least = std::numeric_limits<double>::infinity(), most = -least, sum = 0, area = 0;
    for (const int p : pieces) {
        const auto& q = results[p]->quality;
        if (!q || !q->strainMin || !q->strainMax || !q->strainMeanAbs) {
            least = most = sum = std::numeric_limits<double>::quiet_NaN();
            break;
        }
        least = std::min(least, *q->strainMin);
        most = std::max(most, *q->strainMax);
        sum += q->area3d * *q->strainMeanAbs;
        area += q->area3d;
    }
    return {{"strain_min", number(least)},
            {"strain_max", number(most)},
            {"strain_mean_abs", number(sum / area)}};
}

/// Strain as drawn, and with the exact outlines.
void addStrain(Json& json, const PieceResults& results, const std::vector<int>& pieces) {
    json.update(strainJson(results, pieces));
    json["exact"] = strainJson(exactResults(results), pieces);
}

bool isDrawnMirrored(const PieceResult& result) {
    return result.flat && result.flat->line && result.plan && result.plan->mirrored;
}

/// Pairs of mirrored pieces, each once, and pieces that are symmetric in themselves.
Json pairsJson(const Garment& garment, const PieceResults& results, const MirrorPieces& pieces) {
    Json pairs = Json::array();
    for (int p = 0; p < static_cast<int>(pieces.counterpart.size()); ++p) {
        const int other = pieces.counterpart[p];
        if (other < p) {
            continue;
        }
        const std::vector<int> both = other == p ? std::vector{p} : std::vector{p, other};
        Json names = Json::array();
        for (const int piece : both) {
            names.push_back(garment.pieces[piece]->name);
        }
        Json pair{{"pieces", std::move(names)},
                  {"deviation", number(pieces.deviation[p])},
                  {"equal", isDrawnMirrored(*results[p]) && isDrawnMirrored(*results[other])}};
        addStrain(pair, results, both);
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

}  // namespace

Json lineJson(const PieceResult& result) {
    const FlatLine& line = *result.flat->line;
    const PieceQuality& exact = *result.exact->quality;
    return {{"smoothing", number(result.plan->smoothing)},
            {"farthest", number(line.farthest)},
            {"iterations", line.iterations},
            {"converged", line.converged},
            {"exact",
             {{"symmetric_dirichlet", number(exact.symmetricDirichlet)},
              {"strain_min", number(exact.strainMin)},
              {"strain_max", number(exact.strainMax)},
              {"strain_mean_abs", number(exact.strainMeanAbs)}}}};
}

Json seamEndsJson(const Garment& garment, const PieceResults& results) {
    const auto segments = findSegments(garment, exactResults(garment, results), {});
    const auto turnAt = [&](const OutlineCorner& corner) -> double {
        return drawnTurn(*results[corner.piece], segments[corner.piece].turnPoints[corner.point]);
    };
    Json ends = Json::array();
    for (const SeamEnd& end : findSeamEnds(garment, segments, {})) {
        ends.push_back({{"seam", garment.seams.seams[end.seam].name},
                        {"end", text(end.atEnd ? "end" : "start")},
                        {"kink_exact", number(end.kink)},
                        {"kink", number(kinkOf(turnAt(end.left), turnAt(end.right)))}});
    }
    return ends;
}

Json symmetryJson(const Garment& garment, const PieceResults& results, const Symmetry& symmetry) {
    const MirrorPlane& plane = symmetry.plane;
    const double change = largestChange(garment.seams, symmetry.lengths);
    Json without = Json::array();
    for (const int s : symmetry.lengths.withoutCounterpart()) {
        without.push_back(garment.seams.seams[s].name);
    }
    std::vector<int> mirrored;
    for (int p = 0; p < static_cast<int>(results.size()); ++p) {
        if (isDrawnMirrored(*results[p])) {
            mirrored.push_back(p);
        }
    }
    Json json{
        {"normal", {number(plane.normal.x()), number(plane.normal.y()), number(plane.normal.z())}},
        {"offset", number(plane.offset)},
        {"deviation", number(plane.deviation)},
        {"farthest", number(plane.farthest)},
        {"pairs", pairsJson(garment, results, symmetry.pieces)},
        {"largest_length_change", number(change)}};
    for (const UnequalPieces& one : symmetry.unequal) {
        json["unequal"].push_back(
            {{"pieces", {garment.pieces[one.piece]->name, garment.pieces[one.counterpart]->name}},
             {"seams",
              {garment.seams.seams[one.seam].name, garment.seams.seams[one.mirrored].name}},
             {"difference", number(one.difference)},
             {"tolerance", number(one.tolerance)}});
    }
    addStrain(json, results, mirrored);
    json["without_counterpart"] = std::move(without);
    return json;
}

namespace {

Json notchJson(const Pattern& pattern, const PieceNotch& notch) {
    return {{"seam", notch.seam},
            {"share", number(notch.share)},
            {"hole", notch.hole < 0 ? Json(nullptr) : Json(notch.hole + 1)},
            {"at", number(notch.at)},
            {"count", notch.count},
            {"form", text(wordOf(kNotchFormWords, pattern.notchForm))},
            {"reason", text(wordOf(kNotchReasonWords, notch.reason))}};
}

Json segmentJson(const PatternSegment& segment, CornerRule corner) {
    Json json{{"seam", segment.seam > 0 ? Json(segment.seam) : Json(nullptr)},
              {"from", number(segment.from)},
              {"to", number(segment.to)},
              {"fold", segment.isFold},
              {"allowance", number(segment.allowance)},
              {"corner", text(wordOf(kCornerRuleWords, corner))}};
    if (segment.seam > 0 && segment.kind == SeamKind::Free) {
        json["edge"] = text(wordOf(kEdgeKindWords, segment.edge));
        if (segment.edge != segment.foundEdge) {
            json["edge_found"] = text(wordOf(kEdgeKindWords, segment.foundEdge));
        }
    }
    if (segment.limit != AllowanceLimit::None) {
        json["usual_allowance"] = number(segment.usualAllowance);
        json["limited_by"] = text(wordOf(kAllowanceLimitWords, segment.limit));
    }
    if (segment.extension > 0) {
        json["extension"] = number(segment.extension);
    }
    return json;
}

Json dartJson(const PieceDart& dart) {
    return {{"seam", dart.seam},
            {"intake", number(dart.intake)},
            {"intake_typed", dart.isTyped},
            {"angle", number(dart.angle)},
            {"leg", number(dart.leg)},
            {"laid_over", text(dart.lay == DartLay::First ? "first" : "second")}};
}

/// A strip as cut; only its name if it has no room.
Json facingJson(const PatternPiece& piece, const PatternPiece& strip) {
    Json json{{"name", strip.name}, {"piece", piece.name}, {"drawn", strip.outline.rows() > 0}};
    if (strip.outline.rows() > 0) {
        json["perimeter_2d"] = number(geometry::Line::closed(strip.outline).length());
        json["quantity"] = strip.quantity;
        json["mirrored_pair"] = strip.mirroredPair;
        if (strip.cuttingLine.rows() > 0) {
            json["cutting_line_length"] =
                number(geometry::Line::closed(strip.cuttingLine).length());
        }
    }
    return json;
}

Json internalJson(const PieceInternal& internal) {
    Json points = Json::array();
    for (const auto& point : internal.points.rowwise()) {
        points.push_back({number(point.x()), number(point.y())});
    }
    return {{"name", text(internal.name)},
            {"closed", internal.closed},
            {"length", number(internal.length)},
            {"points", std::move(points)}};
}

}  // namespace

Json facingsJson(const Pattern& pattern) {
    Json facings = Json::array();
    const std::size_t first = pattern.pieces.size() - pattern.facings.size();
    for (std::size_t k = 0; k < pattern.facings.size(); ++k) {
        const PatternPiece& piece = pattern.pieces[pattern.facings[k].piece];
        facings.push_back(facingJson(piece, pattern.pieces[first + k]));
    }
    return facings;
}

void addPatternJson(Json& json, const Pattern& pattern, const PatternPiece& piece) {
    if (pattern.hasAllowance && piece.cuttingLine.rows() > 0) {
        json["cutting_line_length"] = number(geometry::Line::closed(piece.cuttingLine).length());
        json["segments"] = Json::array();
        for (std::size_t k = 0; k < piece.segments.size(); ++k) {
            json["segments"].push_back(segmentJson(piece.segments[k], cornerOf(piece, k)));
        }
    }
    for (const PieceDart& dart : piece.darts) {
        json["darts"].push_back(dartJson(dart));
    }
    for (const PieceInternal& internal : piece.internals) {
        if (internal.points.rows() > 0) {
            json["internal_lines"].push_back(internalJson(internal));
        }
    }
    if (pattern.hasNotches) {
        json["notches"] = Json::array();
        for (const PieceNotch& notch : piece.notches) {
            json["notches"].push_back(notchJson(pattern, notch));
        }
    }
}

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
    for (const Finding& doubt : findDoubts(garment, results, fabrics)) {
        const bool isOfPiece = doubt.subject.kind == Subject::Kind::Piece;
        doubts.push_back({{"code", text(name(doubt.kind))},
                          {"piece", textOrNull(isOfPiece ? doubt.subject.name : "")},
                          {"fault", doubt.severity == Severity::Fault},
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
