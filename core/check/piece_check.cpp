// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/piece_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "core/base/characters.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/piece_marks.h"
#include "core/quality/measures.h"
#include "core/quality/metric_tensor.h"
#include "core/quality/outline_crossings.h"
#include "core/quality/piece_quality.h"

namespace toile {
namespace {

Finding findingOf(const PieceToCut& piece, FindingKind kind, Severity severity) {
    Finding finding;
    finding.kind = kind;
    finding.severity = severity;
    finding.subject = subjectOf(*piece.result.piece);
    finding.pieces = {piece.index};
    return finding;
}

void checkOutline(const PieceToCut& checked, FindingList& found) {
    const PieceResult& result = checked.result;
    if (result.quality && result.quality->outlineCrossings == 0) {
        return;
    }
    const Piece& piece = *result.piece;
    const auto crossings = findOutlineCrossings(result.flat->Q, piece.boundary);
    if (crossings.empty()) {
        return;
    }
    Finding finding = findingOf(checked, FindingKind::OutlineCrosses, Severity::Fault);
    const OutlineCrossing& first = crossings.front();
    finding.place = placeOnOutline(piece, result.flat->Q, first.first, first.place);
    const auto crossingCount = static_cast<long long>(crossings.size());
    finding.figures = {count(static_cast<double>(crossingCount))};
    finding.error = {ErrorCode::OutlineCrosses, subjectOf(piece),
                     countWording(crossingCount, "crossing")};
    for (const Error& note : result.flat->notes) {
        if (note.code == ErrorCode::OutlineCrosses) {
            finding.error = note;  // it names the cut that helps
        }
    }
    finding.badness = static_cast<double>(crossingCount);
    found.add(std::move(finding));
}

void checkFlips(const PieceToCut& checked, FindingList& found) {
    const PieceResult& result = checked.result;
    if (result.quality && result.quality->flippedTriangles == 0) {
        return;
    }
    const Piece& piece = *result.piece;
    const Eigen::VectorXd areas = triangleAreas2d(result.flat->Q, piece.mesh.F);
    const Eigen::VectorXd worn = triangleAreas3d(piece.mesh);
    const int flipped = flippedTriangles(areas, worn);
    if (flipped == 0) {
        return;
    }
    const Eigen::Index worst = worstFlipped(areas, worn);
    Finding finding = findingOf(checked, FindingKind::FlippedTriangles, Severity::Fault);
    finding.place = placeInTriangle(piece, result.flat->Q, worst);
    finding.figures = {count(flipped), count(static_cast<double>(areas.size()))};
    finding.badness = flipped;
    found.add(std::move(finding));
}

void addStrain(const PieceToCut& checked, FindingKind kind, const StrainExcess& excess,
               FindingList& found) {
    if (excess.face < 0 || excess.share < kStrainDoubtShare) {
        return;
    }
    const bool isFault = excess.share >= kStrainFaultShare && !isRuleOfThumb(checked.fabric);
    Finding finding = findingOf(checked, kind, isFault ? Severity::Fault : Severity::Doubt);
    finding.place = placeInTriangle(*checked.result.piece, checked.result.flat->Q, excess.face);
    finding.figures = {{excess.strain, Figure::Unit::Strain},
                       {excess.limit, Figure::Unit::Strain},
                       {excess.share, Figure::Unit::Percent}};
    if (const std::string& material = checked.settings.material; !material.empty()) {
        finding.reason = " (" + shownText(material, kMaxLabelText) + ")";
    }
    finding.badness = excess.severity;
    found.add(std::move(finding));
}

void checkStrain(const PieceToCut& checked, FindingList& found) {
    if (!hasLimits(checked.fabric)) {
        return;
    }
    const StrainExcesses excesses =
        strainExcesses(checked.result.piece->mesh, checked.result.flat->Q, checked.fabric,
                       grainOf(checked.settings));
    addStrain(checked, FindingKind::StrainWarp, excesses.warp, found);
    addStrain(checked, FindingKind::StrainWeft, excesses.weft, found);
    addStrain(checked, FindingKind::StrainBias, excesses.bias, found);
}

}  // namespace

void checkPiece(const PieceToCut& piece, FindingList& found) {
    const PieceResult& result = piece.result;
    if (result.error && result.error->code != ErrorCode::Cancelled && !isLeftOut(result)) {
        Finding finding = findingOf(piece, FindingKind::NotFlat, Severity::Fault);
        finding.error = result.error;
        if (result.error->code == ErrorCode::SeveralLoops) {
            finding.figures = {count(static_cast<double>(loopLengths(*result.piece).size()))};
        }
        found.add(std::move(finding));
    }
    if (!result.flat) {
        return;
    }
    checkOutline(piece, found);
    checkFlips(piece, found);
    checkStrain(piece, found);
    if (!piece.settings.grain) {
        found.add(findingOf(piece, FindingKind::GrainMissing, Severity::Doubt));
    }
    for (const Error& note : result.flat->notes) {
        if (note.code != ErrorCode::OutlineCrosses && note.code != ErrorCode::TrianglesFlipped) {
            found.add(note, {piece.index});
        }
    }
}

namespace {

/// Unit length, or zero if `v` has no direction.
Eigen::Vector3d unit(const Eigen::Vector3d& v) {
    const double length = v.norm();
    return length > 0 ? Eigen::Vector3d(v / length) : Eigen::Vector3d::Zero();
}

Eigen::Vector3d vertexNormal(const MeshArrays& mesh, int vertex) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        if ((mesh.F.row(f).array() == vertex).any()) {
            sum += doubleAreaNormal(mesh, f);
        }
    }
    return unit(sum);
}

}  // namespace

FindingPlace placeAtVertex(const Piece& piece, const Points2& Q, int vertex) {
    return {Q.row(vertex).transpose(), piece.mesh.V.row(vertex).transpose(),
            vertexNormal(piece.mesh, vertex)};
}

FindingPlace placeOnOutline(const Piece& piece, const Points2& Q, int edge,
                            const Eigen::RowVector2d& flat) {
    const auto n = piece.boundary.size();
    const int v = piece.boundary[static_cast<std::size_t>(edge)];
    const int w = piece.boundary[(static_cast<std::size_t>(edge) + 1) % n];
    const double length = (Q.row(w) - Q.row(v)).norm();
    const double share = length > 0 ? std::min(1.0, (flat - Q.row(v)).norm() / length) : 0;
    FindingPlace place = placeAtVertex(piece, Q, v);
    place.flat = flat.transpose();
    place.position = ((1 - share) * piece.mesh.V.row(v) + share * piece.mesh.V.row(w)).transpose();
    return place;
}

namespace {

/// Gathers one direction over the triangles.
class Counter {
public:
    explicit Counter(const StrainLimits& stated) : bounds_(stated) {}

    double severity(double strain) const { return bounds_.severity(strain); }

    void add(int face, double strain, double area) {
        const double severity = bounds_.severity(strain);
        total_ += area;
        beyond_ += bounds_.isBeyond(strain) ? area : 0;
        if (severity > worst_.severity) {
            worst_ = {0, face, strain, bounds_.limitFor(strain), severity};
        }
    }

    StrainExcess result() const {
        StrainExcess excess = worst_;
        // Collapsed cloth has no area, but its strain exceeds the limit all the same.
        excess.share = total_ > 0                               ? beyond_ / total_
                       : worst_.severity > StrainBounds::kSlack ? 1
                                                                : 0;
        return excess;
    }

private:
    StrainBounds bounds_;
    double total_ = 0, beyond_ = 0;
    StrainExcess worst_;
};

}  // namespace

StrainExcesses strainExcesses(const MeshArrays& mesh, const Points2& Q, const Fabric& fabric,
                              double grain) {
    const auto metrics = wornFaceMetrics(mesh, Q);
    const Eigen::VectorXd areas = triangleAreas2d(Q, mesh.F);
    const Eigen::Vector2d along(std::cos(grain), std::sin(grain));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector2d rising = (along + across) * std::sqrt(0.5);
    const Eigen::Vector2d falling = (along - across) * std::sqrt(0.5);
    Counter warp(fabric.warp), weft(fabric.weft), bias(fabric.bias);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const MetricTensor& metric = metrics[static_cast<std::size_t>(f)];
        const int face = static_cast<int>(f);
        const double area = std::isfinite(areas[f]) ? std::abs(areas[f]) : 0;
        warp.add(face, strainAlong(metric, along), area);
        weft.add(face, strainAlong(metric, across), area);
        const double up = strainAlong(metric, rising), down = strainAlong(metric, falling);
        bias.add(face, bias.severity(up) >= bias.severity(down) ? up : down, area);
    }
    return {warp.result(), weft.result(), bias.result()};
}

}  // namespace toile
