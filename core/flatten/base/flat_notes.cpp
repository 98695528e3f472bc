// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/base/flat_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "core/base/text.h"
#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"
#include "core/mesh/repair.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Height relative to the longest edge below which a triangle is reported. It exceeds the height
/// that loading rejects (kDegenerateHeight), at which an angle has no digits left.
constexpr double kSliverHeight = 1e-6;
constexpr int kNamedFaces = 3;
/// Relative error of a boundary edge's flat length that still counts as exact.
constexpr double kExactLength = 1e-9;
/// At the tip of a slit in flat cloth the angle is 2 pi up to rounding, which is in range.
constexpr double kAngleRounding = 1e-9;

Wording place(const Eigen::RowVector3d& p) {
    return placeWording(p.x(), p.y(), p.z());
}

Wording flatPlace(const Eigen::RowVector2d& p) {
    return worded("(%1, %2)", {figure(p.x(), 1), figure(p.y(), 1)});
}

Eigen::RowVector3d middleOf(const MeshArrays& mesh, Eigen::Index face) {
    return mesh.V(mesh.F.row(face), Eigen::all).colwise().mean();
}

Wording crossingCount(int count) {
    return count == kMaxOutlineCrossings ? worded("%1 crossings or more", {figure(count)})
                                         : countWording(count, "crossing");
}

/// The position on the piece of a place on a flat outline edge.
Eigen::RowVector3d onPiece(const Piece& piece, const Points2& Q, int edge,
                           const Eigen::RowVector2d& at) {
    const int v = piece.boundary[edge];
    const int w = piece.boundary[(edge + 1) % static_cast<int>(piece.boundary.size())];
    const double length = (Q.row(w) - Q.row(v)).norm();
    const double share = length > 0 ? std::min(1.0, (at - Q.row(v)).norm() / length) : 0;
    return (1 - share) * piece.mesh.V.row(v) + share * piece.mesh.V.row(w);
}

}  // namespace

std::optional<Error> crossingNote(const Piece& piece, const Points2& Q,
                                  const std::vector<OutlineCrossing>& crossings) {
    if (crossings.empty()) {
        return std::nullopt;
    }
    const OutlineCrossing& first = crossings.front();
    const auto count = static_cast<int>(crossings.size());
    const std::vector<Wording> places{crossingCount(count), flatPlace(first.place),
                                      place(onPiece(piece, Q, first.first, first.place)),
                                      place(onPiece(piece, Q, first.second, first.place))};
    Wording detail =
        count > 1
            ? worded("%1, the first at %2 mm in the pattern, where %3 and %4 mm on the piece meet",
                     places)
            : worded("%1 at %2 mm in the pattern, where %3 and %4 mm on the piece meet", places);
    return Error{ErrorCode::OutlineCrosses, subjectOf(piece), detail};
}

void noteFlips(const Piece& piece, const Points2& Q, Problems& notes) {
    const Eigen::VectorXd areas = triangleAreas2d(Q, piece.mesh.F);
    const Eigen::VectorXd worn = triangleAreas3d(piece.mesh);
    const int flipped = flippedTriangles(areas, worn);
    if (flipped == 0) {
        return;
    }
    const Eigen::Index worst = worstFlipped(areas, worn);
    const std::vector<Wording> words{figure(flipped), countWording(areas.size(), "triangle"),
                                     place(middleOf(piece.mesh, worst))};
    Wording detail = flipped > 1 ? worded("%1 of %2, the worst at %3 mm", words)
                                 : worded("%1 of %2, at %3 mm", words);
    std::erase_if(notes, [&detail](const Error& note) {
        if (note.code != ErrorCode::EndedEarly) {
            return false;
        }
        detail += "; ";
        detail += note.detail;
        return true;
    });
    notes.push_back({ErrorCode::TrianglesFlipped, subjectOf(piece), detail});
}

std::optional<Error> shortEdgesNote(const Piece& piece, const Points2& Q,
                                    const OutlineTargets& targets) {
    const Eigen::VectorXd on = outlineLengths(piece, targets);
    const Eigen::ArrayXd off =
        (boundaryLengths2d(Q, piece.boundary).array() / on.array() - 1).abs();
    Eigen::Index worst = 0;
    const double most = off.maxCoeff(&worst);
    if (!(most > kExactLength)) {
        return std::nullopt;
    }
    const long long count = (off > kExactLength).count();
    const double length = on[worst];
    const std::vector<Wording> words{
        countWording(count, "edge"), length < 1e-3 ? scientific(length, 1) : figure(length, 3),
        place(piece.mesh.V.row(piece.boundary[worst])), scientific(most, 1)};
    return Error{ErrorCode::EdgesTooShort, subjectOf(piece),
                 count > 1
                     ? worded("%1, the worst %2 mm long at %3 mm, off by %4 of its length", words)
                     : worded("%1 of %2 mm at %3 mm, off by %4 of its length", words)};
}

Error uncrossedNote(const Piece& piece, int crossings) {
    return {ErrorCode::OutlineUncrossed, subjectOf(piece), crossingCount(crossings)};
}

std::optional<Error> degenerateNote(const Piece& piece) {
    int count = 0;
    Wording named;
    for (int f = 0; f < piece.mesh.F.rows(); ++f) {
        const double longest = shapeOf(piece.mesh, f).longest;
        if (doubleAreaNormal(piece.mesh, f).norm() >= kSliverHeight * longest * longest) {
            continue;
        }
        if (count++ < kNamedFaces) {
            const bool hasSource = f < static_cast<int>(piece.sourceFace.size());
            const int face = hasSource ? piece.sourceFace[f] : f;
            named += named.empty() ? ": " : ", ";
            const Wording at = place(middleOf(piece.mesh, f));
            named += face >= 0 ? worded("face %1 at %2 mm", {std::to_string(face), at})
                               : worded("an added face at %1 mm", {at});
        }
    }
    if (count == 0) {
        return std::nullopt;
    }
    Wording detail = countWording(count, "triangle");
    detail += named;
    detail += count > kNamedFaces ? ", ..." : "";
    return Error{ErrorCode::DegenerateTriangles, subjectOf(piece), detail};
}

std::optional<Error> anglesNote(const Piece& piece, const Eigen::VectorXd& angles) {
    int count = 0;
    int first = -1;
    for (int i = 0; i < angles.size(); ++i) {
        if (angles[i] < -kAngleRounding || angles[i] > 2 * std::numbers::pi + kAngleRounding) {
            first = count++ == 0 ? i : first;
        }
    }
    if (count == 0) {
        return std::nullopt;
    }
    return Error{
        ErrorCode::AnglesOutOfRange, subjectOf(piece),
        worded("%1, %2 degrees at %3 mm", {countWording(count, "outline vertex"),
                                           figure(angles[first] * 180 / std::numbers::pi),
                                           place(piece.mesh.V.row(piece.boundary[first]))})};
}

Error endedEarlyNote(const Piece& piece, const Wording& how) {
    return {ErrorCode::EndedEarly, subjectOf(piece), how};
}

Error rimsNote(const Piece& piece, const Points2& Q, const Wording& why) {
    double furthest = -1;
    Wording text;
    for (const auto& rim : piece.holes) {
        const double on = boundaryLengths3d(piece.mesh.V, rim).sum();
        const double flat = boundaryLengths2d(Q, rim).sum();
        if (std::abs(flat - on) > furthest) {
            furthest = std::abs(flat - on);
            text = worded("%1 mm flat, %2 mm on the garment", {figure(flat, 1), figure(on, 1)});
        }
    }
    return {ErrorCode::RimsNotKept, subjectOf(piece),
            why.empty() ? text : worded("%1; %2", {text, why})};
}

}  // namespace toile
