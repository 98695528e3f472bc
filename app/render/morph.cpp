// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/morph.h"

#include <algorithm>

#include <Eigen/Dense>

namespace toile::app {

namespace {

/// Zero slope at both ends, so that the two halves of the morph join smoothly.
double eased(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Places a piece on the sheet that faces the eye upright. Mirroring a piece is a rotation in
/// space.
SpaceMotion onStandingSheet(const Placement& placement, const Eigen::Vector2d& sheetMiddle,
                            const Morph& morph) {
    const Eigen::Matrix<double, 3, 2> axes = morph.sheetAxes.leftCols<2>();
    SpaceMotion motion;
    motion.turn.leftCols<2>() = axes * placement.linear();
    motion.turn.col(2) = motion.turn.col(0).cross(motion.turn.col(1));
    motion.offset = morph.sheetCentre + axes * (placement.offset - sheetMiddle);
    return motion;
}

SpaceMotion between(const SpaceMotion& from, const SpaceMotion& to, const Eigen::Vector2d& middle,
                    double share) {
    const Eigen::Quaterniond a(from.turn), b(to.turn);
    SpaceMotion motion;
    motion.turn = a.slerp(share, b).toRotationMatrix();
    const Eigen::Vector3d at = (1 - share) * from.applied(middle) + share * to.applied(middle);
    motion.offset = at - motion.turn.leftCols<2>() * middle;
    return motion;
}

}  // namespace

double Morph::bend() const {
    return eased(2 * way);
}

double Morph::flight() const {
    return eased(2 * way - 1);
}

SpaceMotion bestRest(const Points2& flat, const Points3& worn, const Eigen::Vector3d& origin) {
    Eigen::Vector3d wornSum = Eigen::Vector3d::Zero();
    Eigen::Vector2d flatSum = Eigen::Vector2d::Zero();
    const auto count = static_cast<double>(std::max<Eigen::Index>(1, flat.rows()));
    for (Eigen::Index i = 0; i < flat.rows(); ++i) {
        wornSum += worn.row(i).transpose() - origin;
        flatSum += flat.row(i).transpose();
    }
    const Eigen::Vector3d wornMiddle = wornSum / count;
    const Eigen::Vector2d flatMiddle = flatSum / count;
    Eigen::Matrix<double, 3, 2> covariance = Eigen::Matrix<double, 3, 2>::Zero();
    for (Eigen::Index i = 0; i < flat.rows(); ++i) {
        const Eigen::Vector3d offWorn = worn.row(i).transpose() - origin - wornMiddle;
        const Eigen::Vector2d offFlat = flat.row(i).transpose() - flatMiddle;
        covariance += offWorn * offFlat.transpose();
    }
    SpaceMotion motion;
    if (!covariance.allFinite()) {
        return motion;
    }
    // The nearest orthonormal pair; the cross product gives the third, so nothing is mirrored.
    // Padding with zeros makes this compile eight times as fast: 3 x 3 is a special case.
    Eigen::Matrix3d padded = Eigen::Matrix3d::Zero();
    padded.leftCols<2>() = covariance;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(padded, Eigen::ComputeFullU | Eigen::ComputeFullV);
    motion.turn.leftCols<2>() = (svd.matrixU() * svd.matrixV().transpose()).leftCols<2>();
    motion.turn.col(2) = motion.turn.col(0).cross(motion.turn.col(1));
    motion.offset = wornMiddle - motion.turn.leftCols<2>() * flatMiddle;
    return motion;
}

std::vector<SpaceMotion> morphMotions(const Scene& scene, const SheetPlaces& places,
                                      const Morph& morph) {
    const Eigen::AlignedBox2d sheet = sheetBox(scene, places);
    const Eigen::Vector2d sheetMiddle =
        sheet.isEmpty() ? Eigen::Vector2d::Zero().eval() : sheet.center();
    std::vector<SpaceMotion> motions(scene.pieces.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const PieceScene& piece = scene.pieces[i];
        if (!piece.flat) {
            continue;
        }
        motions[i] = piece.rest;
        if (morph.flight() > 0) {
            const Placement& placement = placeOf(places, static_cast<int>(i)).placement;
            motions[i] = between(piece.rest, onStandingSheet(placement, sheetMiddle, morph),
                                 piece.flatBox.center(), morph.flight());
        }
    }
    return motions;
}

Eigen::Vector3d morphed(const Morph& morph, const SpaceMotion& motion, const Eigen::Vector3d& worn,
                        const Eigen::Vector2d& flat) {
    return (1 - morph.bend()) * worn + morph.bend() * motion.applied(flat);
}

std::vector<Eigen::AlignedBox3d> morphBoxes(const Scene& scene, const SheetPlaces& places,
                                            const Morph& morph) {
    const std::vector<SpaceMotion> motions = morphMotions(scene, places, morph);
    std::vector<Eigen::AlignedBox3d> boxes;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const PieceScene& piece = scene.pieces[i];
        Eigen::AlignedBox3d box;
        if (!piece.flat || piece.flatBox.isEmpty() || morph.way < 1) {
            box = piece.box;
        }
        if (piece.flat && !piece.flatBox.isEmpty() && morph.way > 0) {
            for (const auto corner :
                 {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                  Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight}) {
                box.extend(motions[i].applied(piece.flatBox.corner(corner)));
            }
        }
        boxes.push_back(box);
    }
    return boxes;
}

Morph morphBefore(const Camera3D& camera, const Scene* scene, double way) {
    Morph morph;
    morph.way = way;
    morph.sheetAxes = camera.axes();
    morph.sheetCentre = scene ? scene->box.center() : Eigen::Vector3d::Zero().eval();
    return morph;
}

void frameGarment(Camera3D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, double way) {
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(pieces.size());
    for (const int piece : pieces) {
        boxes.push_back(scene.pieces[static_cast<std::size_t>(piece)].box);
    }
    camera.frame(boxes);
    if (way > 0) {
        const auto all = morphBoxes(scene, places, morphBefore(camera, &scene, 1));
        for (std::size_t i = 0; const int piece : pieces) {
            boxes[i++] = all[static_cast<std::size_t>(piece)];
        }
        Camera3D before = camera;
        before.frame(boxes);
        camera.moveTowards(before, morphBefore(camera, &scene, way).flight());
    }
}

}  // namespace toile::app
