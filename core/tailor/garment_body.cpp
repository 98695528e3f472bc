// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/garment_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/cut/fill_holes.h"

namespace toile {
namespace {

constexpr double kShortestOpening = 80;  // mm
/// An opening is in the middle if its centre is closer to the plane than this share of the width.
constexpr double kMiddle = 0.25;
/// Largest distance between an opening's image and its partner, as a fraction of its length.
constexpr double kPartnerApart = 0.25;
/// A plane whose normal is closer to vertical than this cosine does not separate left from right.
constexpr double kNearlyLevel = 0.5;
/// Share of the neck that is examined for its lowest side.
constexpr double kLowPart = 0.3;
/// A vertex whose image is closer to another vertex than this, mm, is its mirror image; number of
/// vertices examined.
constexpr double kSameVertex = 0.01;
constexpr Eigen::Index kPolishedBy = 4000;

BodyOpening openingOf(const Points3& V, RimLoop loop) {
    BodyOpening opening;
    const std::size_t n = loop.vertices.size();
    double total = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const Eigen::Vector3d a = V.row(loop.vertices[k]), b = V.row(loop.vertices[(k + 1) % n]);
        const double length = (b - a).norm();
        opening.centre += length * (a + b) / 2;
        total += length;
    }
    opening.centre /= total;
    opening.loop = std::move(loop);
    return opening;
}

bool crossesPlane(const GarmentBody& body, const Points3& V, const RimLoop& loop) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const int v : loop.vertices) {
        const double x = body.across(V.row(v));
        least = std::min(least, x);
        most = std::max(most, x);
    }
    return least < 0 && most > 0;
}

void findPartners(GarmentBody& body, const std::vector<int>& aside) {
    for (const int i : aside) {
        BodyOpening& one = body.openings[i];
        const Eigen::Vector3d image = body.plane.reflected(one.centre);
        double nearest = kPartnerApart * one.loop.perimeter;
        int found = -1;
        for (const int j : aside) {
            const double distance = (body.openings[j].centre - image).norm();
            if (j != i && body.openings[j].partner < 0 && distance < nearest) {
                nearest = distance;
                found = j;
            }
        }
        if (one.partner < 0 && found >= 0) {
            one.partner = found;
            body.openings[found].partner = i;
        }
    }
}

/// Names the openings, the middle ones from top to bottom. @param middle  highest first
void nameOpenings(GarmentBody& body, const std::vector<int>& middle, const std::vector<int>& aside,
                  double centreHeight) {
    std::vector<int> paired;
    std::ranges::copy_if(aside, std::back_inserter(paired),
                         [&body](int i) { return body.openings[i].partner >= 0; });
    const auto heightOf = [&body](int i) { return body.height(body.openings[i].centre); };
    const auto name = [&body](int i, OpeningKind kind) { body.openings[i].kind = kind; };
    if (middle.size() == 1 && paired.size() == 2 && heightOf(paired[0]) < centreHeight) {
        body.form = BodyForm::Trousers;
        name(middle.front(), OpeningKind::Waist);
        name(paired[0], OpeningKind::Ankle);
        name(paired[1], OpeningKind::Ankle);
    } else if (middle.size() >= 2 && paired.size() >= 2) {
        body.form = BodyForm::Top;
        name(middle.front(), OpeningKind::Neck);
        name(middle.back(), OpeningKind::Hem);
        for (const int i : paired) {
            name(i, OpeningKind::Cuff);
        }
    } else if (middle.size() == 2 && paired.empty()) {
        body.form = BodyForm::Skirt;
        name(middle.front(), OpeningKind::Waist);
        name(middle.back(), OpeningKind::Hem);
    }
}

/// Turns `forward` to the side where the neck is lower.
void guessFront(GarmentBody& body, const Points3& V) {
    const BodyOpening* neck = body.find(OpeningKind::Neck);
    if (!neck) {
        return;
    }
    std::vector<int> rim = neck->loop.vertices;
    std::ranges::sort(rim, {}, [&](int v) { return body.height(V.row(v)); });
    const auto low =
        std::max<std::size_t>(1, static_cast<std::size_t>(kLowPart * double(rim.size())));
    double ahead = 0;
    for (std::size_t k = 0; k < low; ++k) {
        ahead += body.forward.dot(V.row(rim[k]).transpose() - neck->centre);
    }
    if (ahead < 0) {
        body.forward = -body.forward;
    }
}

/// The body on both sides of a plane.
GarmentBody bodyBeside(const Piece& piece, const MirrorPlane& plane) {
    GarmentBody body;
    body.plane = plane;
    const Eigen::Vector3d upright(0, 1, 0);
    body.up = (upright - plane.normal.dot(upright) * plane.normal).normalized();
    body.forward = plane.normal.cross(body.up);
    const Points3& V = piece.mesh.V;
    const Eigen::VectorXd x = (V * plane.normal).array() - plane.offset;
    const double width = x.maxCoeff() - x.minCoeff();
    const double centreHeight = (V * body.up).mean();
    std::vector<int> middle, aside;
    for (RimLoop& loop : rimsOf(piece.mesh, piece.table)) {
        if (loop.perimeter < kShortestOpening) {
            continue;
        }
        body.openings.push_back(openingOf(V, std::move(loop)));
        const BodyOpening& opening = body.openings.back();
        const bool isMiddle = std::abs(body.across(opening.centre)) < kMiddle * width &&
                              crossesPlane(body, V, opening.loop);
        (isMiddle ? middle : aside).push_back(static_cast<int>(body.openings.size()) - 1);
    }
    findPartners(body, aside);
    std::ranges::sort(middle, std::ranges::greater{},
                      [&body](int i) { return body.height(body.openings[i].centre); });
    nameOpenings(body, middle, aside, centreHeight);
    guessFront(body, V);
    return body;
}

/// Refines the plane by vertices and their images alone if a mesh is its own mirror image: to the
/// last digits, so that both sides are cut symmetrically.
MirrorPlane polished(MirrorPlane plane, const MeshArrays& mesh) {
    const NearestSurface nearest(mesh);
    std::vector<std::array<Eigen::Vector3d, 2>> pairs;
    Eigen::Vector3d middle(0, 0, 0);
    const Eigen::Index stride = mesh.V.rows() / kPolishedBy + 1;
    for (Eigen::Index v = 0; v < mesh.V.rows(); v += stride) {
        const Eigen::Vector3d image = plane.reflected(mesh.V.row(v).transpose());
        const SurfacePoint place = nearest.find(image);
        int corner = 0;
        place.barycentric.maxCoeff(&corner);
        const Eigen::Vector3d other = mesh.V.row(mesh.F(place.face, corner)).transpose();
        if ((other - image).norm() > kSameVertex) {
            return plane;
        }
        pairs.push_back({mesh.V.row(v).transpose(), other});
        middle += mesh.V.row(v).transpose() + other;
    }
    middle /= 2 * static_cast<double>(pairs.size());
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const auto& [one, other] : pairs) {
        const Eigen::Matrix3d product = (one - middle) * (other - middle).transpose();
        sum += product + product.transpose();
    }
    const Eigen::Vector3d normal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(0);
    plane.normal = normal.dot(plane.normal) < 0 ? Eigen::Vector3d(-normal) : normal;
    plane.offset = plane.normal.dot(middle);
    return plane;
}

}  // namespace

const BodyOpening* GarmentBody::find(OpeningKind kind) const {
    const auto found = std::ranges::find(openings, kind, &BodyOpening::kind);
    return found == openings.end() ? nullptr : &*found;
}

std::optional<std::array<const BodyOpening*, 2>> GarmentBody::pair(OpeningKind kind) const {
    const BodyOpening* first = find(kind);
    if (!first || first->partner < 0) {
        return std::nullopt;
    }
    const BodyOpening* second = &openings[first->partner];
    return across(first->centre) < across(second->centre) ? std::array{first, second}
                                                          : std::array{second, first};
}

std::optional<GarmentBody> readBody(const std::shared_ptr<const Piece>& piece,
                                    const Progress& progress, bool isFrontSwapped) {
    auto plane = findMirrorPlane({piece}, progress);
    const Eigen::Vector3d upright(0, 1, 0);
    if (!plane || std::abs(plane->normal.dot(upright)) > kNearlyLevel) {
        return std::nullopt;
    }
    if (plane->deviation < kSameVertex) {
        plane = polished(*plane, piece->mesh);
    }
    const auto turned = [isFrontSwapped](GarmentBody body) {
        body.forward *= isFrontSwapped ? -1 : 1;
        return body;
    };
    GarmentBody body = bodyBeside(*piece, *plane);
    if (body.form == BodyForm::Unknown) {
        // Front and back may be symmetric too, more so than left and right.
        MirrorPlane across;
        across.normal = body.up.cross(plane->normal);
        across.offset = (piece->mesh.V * across.normal).mean();
        across.deviation = across.farthest = std::numeric_limits<double>::infinity();
        GarmentBody other = bodyBeside(*piece, across);
        if (other.form != BodyForm::Unknown) {
            return turned(std::move(other));
        }
    }
    return turned(std::move(body));
}

}  // namespace toile
