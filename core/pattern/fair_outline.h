// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatten/base/flat_piece.h"
#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"
#include "core/pattern/dart_places.h"
#include "core/pattern/mirrored_lines.h"
#include "core/pattern/outline_reference.h"
#include "core/pattern/segments.h"

namespace toile {

/// A closed line to make fair: near a reference, with steps of given lengths, and with a curvature
/// that changes as little as possible. With kappa_j the turn at node j over half the sum of its two
/// steps, and d_j its distance from the reference, over directions phi and points p
///   minimise  lambda^6 sum (kappa_(j+1) - kappa_j)^2 / h_j + sum (h_(j-1) + h_j)/2 psi(d_j),
///             psi(d) = -tol^2 log(1 - d^2 / tol^2),
///   subject to  p_(j+1) - p_j = h_j (cos phi_j, sin phi_j), and the turns of corners.
/// The first sum skips steps that touch a corner. Smooths waves shorter than about 2 pi lambda.
struct FairProblem {
    /// The line turns by `turn` = phi_node - phi_(node - 1), independent of the reference.
    struct Corner {
        int node = 0;
        double turn = 0;      ///< radians
        bool isFree = false;  ///< the line may turn there by any angle
    };
    /// No curvature at the nodes strictly between; `last` may exceed the node count (wraps around).
    struct Run {
        int first = 0, last = 0;
    };

    Points2 reference;              ///< #n x 2, mm: closed, anti-clockwise, first node not repeated
    Eigen::VectorXd steps;          ///< #n, mm: from node j to the next, kept exactly
    Eigen::VectorXd tolerance;      ///< #n, mm: node j stays nearer than this to its reference
    double smoothing = 40;          ///< lambda, mm
    std::vector<Corner> corners{};  ///< ascending by node
    std::vector<Run> straight{};    ///< where the reference is already straight
};

struct FairLine {
    Points2 points;              ///< #n x 2, mm
    Eigen::VectorXd directions;  ///< #n, radians: of the step after node j; not reduced
    int iterations = 0;
    double farthest = 0;    ///< mm: largest distance of a node from its reference
    bool converged = true;  ///< false: exact steps, but not the minimum; may exceed tolerance
};

/// Solves the problem by a primal-dual interior-point method with sequential quadratic programming:
/// Newton steps by `CyclicKkt`, each shortened until the merit of objective and violation
/// decreases. The chords of the reference may be slightly shorter than the steps. If the minimum is
/// not reached within kMaxFairIterations, or lengths, turns and tolerance contradict each other,
/// returns a line with exact steps and `converged` false; only a contradiction can exceed the
/// tolerance (`farthest`).
/// Preconditions: n >= 3 rows each; steps, tolerance and smoothing positive; smoothing up to about
/// 40 steps. Errors: NotFinite, Cancelled. Cost: O(n) an iteration, 6 to 30 of them. Re-entrant.
Result<FairLine> fairLine(const FairProblem& problem, const Progress& progress);

inline constexpr int kMaxFairIterations = 60;

/// How to draw one outline: all inputs of its line except for the exact outline.
/// Places are arc lengths in 3D along the outline, mm.
struct OutlinePlan {
    struct Stretch {
        double from = 0, to = 0;
        double tolerance = 0;   ///< mm
        bool straight = false;  ///< drawn as a straight line

        bool operator==(const Stretch&) const = default;
    };
    struct Corner {
        double at = 0;
        double turn = 0;      ///< of the line there, radians
        bool isFree = false;  ///< any turn is allowed, as wrinkles have changed it

        bool operator==(const Corner&) const = default;
    };

    /// Its legs are drawn straight, and its mouth as wide as the intake.
    using Dart = TypedDart;

    /// One per segment, in order; they cover the outline. Empty: the line is not made fair.
    std::vector<Stretch> stretches;
    std::vector<Corner> corners;  ///< ascending
    double smoothing = 0;         ///< mm
    double stated = 0;          ///< if wrinkled: default tolerance, mm; larger deviations are noted
    std::vector<Dart> darts{};  ///< set by the user, sorted by `from`
    /// Set if the piece is drawn as a mirror image; stretches, corners and darts are then those of
    /// the leading piece.
    std::optional<MirroredOutline> mirrored{};

    bool operator==(const OutlinePlan&) const = default;
};

/// For outlines roughened by wrinkles: replaces the default tolerance, mm, by about the height of a
/// wrinkle, and multiplies the smoothing length. Custom tolerances disable both.
inline constexpr double kWrinkledTolerance = 8, kWrinkledSmoothing = 1.2;

/// @param turnChanges  per turn point (`truedTurns`)
/// @param isWrinkled   the garment (`roughness`): then also corners that are neither trued nor set
///                     by hand may turn by another angle
OutlinePlan planOutline(const OutlineSegments& segments, const LineSettings& settings,
                        const std::vector<double>& turnChanges, bool isWrinkled = false);

/// The fair line of an outline: near the exact one, of the same length between any two vertices,
/// and as evenly curved as possible (fair_line.h). Before, straight segments are made straight and
/// the user's darts are opened (`reshapedOutline`), whatever the tolerance. In narrow bands the
/// tolerance is a quarter of the width. If the line, or the polygon of the outline's vertices on
/// it, crosses itself more often than the exact outline, the tolerance around the crossings is
/// reduced until it does not (`FlatLine::hasYielded`).
/// @param reference  the exact outline
/// Errors: those of `reshapedOutline`; LineNotDrawn if the line still crosses itself after the last
/// reduction; Cancelled.
/// Cost: n log n in vertices and steps, some milliseconds a metre. Pure.
Result<FlatLine> fairOutline(const OutlineReference& reference, const OutlinePlan& plan,
                             const Progress& progress);

/// Positions of the outline's vertices on its line, #boundary x 2.
Points2 verticesOn(const FlatLine& line, const Piece& piece);

}  // namespace toile
