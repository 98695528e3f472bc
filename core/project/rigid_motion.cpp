// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/rigid_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/line.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Root mean square distance from the centre.
double spread(const Points2& points) {
    return std::sqrt((points.rowwise() - points.colwise().mean()).rowwise().squaredNorm().mean());
}

bool canBeTrusted(const std::vector<Anchor>& anchors, Eigen::Index vertices) {
    return std::ranges::all_of(anchors, [vertices](const Anchor& anchor) {
        return anchor.vertex >= 0 && anchor.vertex < vertices && anchor.flat.allFinite();
    });
}

/// Present positions of the anchors in Q, and their earlier ones.
std::pair<Points2, Points2> pointsOf(const std::vector<Anchor>& anchors, const Points2& Q) {
    Points2 now(anchors.size(), 2), then(anchors.size(), 2);
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        now.row(static_cast<Eigen::Index>(i)) = Q.row(anchors[i].vertex);
        then.row(static_cast<Eigen::Index>(i)) = anchors[i].flat.transpose();
    }
    return {std::move(now), std::move(then)};
}

/// Whether a motion is negligible for a piece of this radius about the origin.
bool staysThere(const RigidMotion& oldOfNew, double radius) {
    return std::abs(oldOfNew.turn) * radius + oldOfNew.offset.norm() <= kUnmoved;
}

struct Fit {
    RigidMotion motion{};
    double residual = 0;
    double radius = 0;  ///< of the anchors about their mean
};

/// Empty if the anchors cannot be trusted.
std::optional<Fit> fitOf(const std::vector<Anchor>& anchors, const Points2& Q) {
    if (anchors.empty() || !canBeTrusted(anchors, Q.rows())) {
        return std::nullopt;
    }
    const auto [now, then] = pointsOf(anchors, Q);
    const double before = spread(then), after = spread(now);
    if (!(std::abs(after - before) <= kAnchorDoubt * std::max(before, after))) {
        return std::nullopt;
    }
    Fit fit{bestMotion(now, then)};
    fit.residual = residual(fit.motion, now, then);
    fit.radius =
        std::sqrt((now.rowwise() - now.colwise().mean()).rowwise().squaredNorm().maxCoeff());
    return fit;
}

}  // namespace

RigidMotion bestMotion(const Points2& from, const Points2& to) {
    RigidMotion motion{geometry::fitMotion(from, to)};
    if (from.rows() > 0) {
        motion.middle = from.colwise().mean().transpose();
    }
    return motion;
}

double residual(const RigidMotion& motion, const Points2& from, const Points2& to) {
    double most = 0;
    for (Eigen::Index i = 0; i < from.rows(); ++i) {
        most = std::max(most,
                        (motion.applied(from.row(i).transpose()) - to.row(i).transpose()).norm());
    }
    return most;
}

PieceSettings movedSettings(PieceSettings settings, const RigidMotion& oldOfNew, double radius) {
    if (staysThere(oldOfNew, radius)) {
        return settings;
    }
    if (settings.placement) {
        Placement& place = *settings.placement;
        place.offset += place.linear() * oldOfNew.offset;
        // A turn before a reflection equals the opposite turn after it.
        place.turn += place.mirrored ? -oldOfNew.turn : oldOfNew.turn;
    }
    if (settings.grain) {
        *settings.grain -= oldOfNew.turn;
    }
    return settings;
}

PieceSettings uprightSettings(PieceSettings settings, const RigidMotion& oldOfNew, double radius) {
    if (!settings.placement || settings.placement->turn != 0 || staysThere(oldOfNew, radius)) {
        return movedSettings(std::move(settings), oldOfNew, radius);
    }
    Placement& place = *settings.placement;
    place.offset += place.linear() * (oldOfNew.applied(oldOfNew.middle) - oldOfNew.middle);
    if (settings.grain) {
        *settings.grain -= oldOfNew.turn;
    }
    return settings;
}

PieceSettings anchoredSettings(PieceSettings settings, const Points2& Q, double mostAway) {
    const std::vector<Anchor> anchors = std::exchange(settings.anchors, {});
    const auto fit = fitOf(anchors, Q);
    if (!fit) {
        return settings;
    }
    const double radius = Q.rowwise().norm().maxCoeff();
    const bool upright = std::abs(fit->motion.turn) * fit->radius <= mostAway;
    return upright ? uprightSettings(std::move(settings), fit->motion, radius)
                   : movedSettings(std::move(settings), fit->motion, radius);
}

std::optional<double> anchorResidual(const std::vector<Anchor>& anchors, const Points2& Q) {
    const auto fit = fitOf(anchors, Q);
    return fit ? std::optional(fit->residual) : std::nullopt;
}

std::optional<double> anchorGrowth(const std::vector<Anchor>& anchors, const Points2& Q) {
    if (anchors.size() < 2 || !canBeTrusted(anchors, Q.rows())) {
        return std::nullopt;
    }
    const auto [now, then] = pointsOf(anchors, Q);
    const double before = spread(then), after = spread(now);
    return before > 0 && after > 0 ? std::optional(after / before) : std::nullopt;
}

PieceSettings scaledSettings(PieceSettings settings, double factor) {
    if (settings.placement) {
        settings.placement->offset *= factor;
    }
    for (Anchor& anchor : settings.anchors) {
        anchor.flat *= factor;
    }
    return settings;
}

std::vector<Anchor> outlineAnchors(const std::vector<int>& outline, const Points2& Q) {
    if (outline.size() < 2) {
        return {};
    }
    const std::vector<double> arc = geometry::arcOf(boundaryLengths2d(Q, outline));
    const auto count = std::min(outline.size(), std::size_t{kOutlineAnchors});
    std::vector<Anchor> anchors;
    std::size_t at = 0;  // strictly increasing
    for (std::size_t k = 0; k < count; ++k) {
        const double wanted = arc.back() * static_cast<double>(k) / static_cast<double>(count);
        while (outline.size() - at > count - k && arc[at] < wanted) {
            ++at;
        }
        anchors.push_back({outline[at], Q.row(outline[at]).transpose()});
        ++at;
    }
    return anchors;
}

}  // namespace toile
