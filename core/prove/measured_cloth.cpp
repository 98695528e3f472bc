// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/measured_cloth.h"

#include <algorithm>
#include <cmath>

namespace toile::prove {
namespace {

/// Farther than this from what holds it cloth touches nothing, mm.
constexpr double kTouches = 0.5;

/// The piece's vertex that is nearest to a triangle of the cloth.
int vertexAt(const std::vector<SurfacePoint>& placeOf, const ProvenPiece& piece,
             const sew::Cloth& cloth, const Points3& X, int triangle) {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        middle += X.row(cloth.F(triangle, k)) / 3;
    }
    int best = 0;
    for (int v = 1; v < static_cast<int>(placeOf.size()); ++v) {
        if ((piece.sewn.row(v) - middle).squaredNorm() <
            (piece.sewn.row(best) - middle).squaredNorm()) {
            best = v;
        }
    }
    return best;
}

}  // namespace

std::vector<Points3> sewnPieces(const FreshCloth& fresh, const Points3& X) {
    std::vector<Points3> pieces;
    for (const auto& places : fresh.placeOf) {
        Points3& piece = pieces.emplace_back(static_cast<Eigen::Index>(places.size()), 3);
        for (std::size_t v = 0; v < places.size(); ++v) {
            Eigen::RowVector3d at = Eigen::RowVector3d::Zero();
            for (int k = 0; k < 3; ++k) {
                at += places[v].barycentric[k] * X.row(fresh.cloth.F(places[v].face, k));
            }
            piece.row(static_cast<Eigen::Index>(v)) = at;
        }
    }
    return pieces;
}

void measureCloth(const FreshCloth& fresh, const Points3& X, const sew::WornSurface& design,
                  const sew::WornSurface& held, Proof& proof) {
    const sew::Cloth& cloth = fresh.cloth;
    const Eigen::VectorXd areas = sew::restAreas(cloth);
    const std::vector<double> strains = sew::principalStrains(cloth, X);
    const sew::ClothGaps gaps = sew::gapsTo(design, cloth, X);
    const int count = static_cast<int>(cloth.F.rows());
    Eigen::VectorXd strainSum = Eigen::VectorXd::Zero(X.rows()), areaSum = strainSum;
    std::vector<char> isFree(static_cast<std::size_t>(X.rows()));
    for (Eigen::Index v = 0; v < X.rows(); ++v) {
        isFree[v] = held.distanceTo(X.row(v).transpose()) > kTouches;
    }
    std::vector<double> freeArea(fresh.placeOf.size(), 0), area = freeArea;
    for (int f = 0; f < count; ++f) {
        for (int k = 0; k < 3; ++k) {
            const int v = cloth.F(f, k);
            strainSum[v] += strains[f] * areas[f];
            areaSum[v] += areas[f];
            freeArea[cloth.pieceOf[f]] += isFree[v] ? areas[f] / 3 : 0;
        }
        area[cloth.pieceOf[f]] += areas[f];
    }
    const std::vector<Points3> sewn = sewnPieces(fresh, X);
    proof.pieces.assign(sewn.size(), {});
    double wholeArea = 0, wholeFree = 0;
    for (std::size_t p = 0; p < sewn.size(); ++p) {
        const auto& places = fresh.placeOf[p];
        if (places.empty()) {
            continue;
        }
        ProvenPiece& piece = proof.pieces[p];
        piece.sewn = sewn[p];
        piece.gap.resize(sewn[p].rows());
        piece.strain = Eigen::VectorXd::Zero(sewn[p].rows());
        for (Eigen::Index v = 0; v < sewn[p].rows(); ++v) {
            const Eigen::Vector3d at = sewn[p].row(v).transpose();
            const double distance = design.distanceTo(at);
            piece.gap[v] = design.placeOf(at).distance < 0 ? -distance : distance;
            for (int k = 0; k < 3; ++k) {
                const int w = cloth.F(places[v].face, k);
                piece.strain[v] += places[v].barycentric[k] * strainSum[w] / areaSum[w];
            }
        }
        piece.gapFigures = gaps.pieces[p];
        piece.gap.cwiseAbs().maxCoeff(&piece.gapFigures.place);
        std::vector<sew::SpreadSample> pulls, slacks;
        for (int f = 0; f < count; ++f) {
            if (cloth.pieceOf[f] == static_cast<int>(p)) {
                pulls.push_back({std::max(strains[f], 0.0), areas[f], f});
                slacks.push_back({std::max(-strains[f], 0.0), areas[f], f});
            }
        }
        piece.mostPull = sew::spreadOf(std::move(pulls)).most95;
        piece.mostSlack = sew::spreadOf(std::move(slacks)).most95;
        piece.freeShare = area[p] > 0 ? freeArea[p] / area[p] : 0;
        wholeArea += area[p];
        wholeFree += freeArea[p];
    }
    proof.freeShare = wholeArea > 0 ? wholeFree / wholeArea : 0;
    proof.gap = gaps.whole;
    proof.strain = sew::strainOf(cloth, X);
    const auto toVertex = [&](sew::SpreadFigures& figures, int& piece) {
        if (figures.place >= 0) {
            piece = cloth.pieceOf[figures.place];
            figures.place =
                vertexAt(fresh.placeOf[piece], proof.pieces[piece], cloth, X, figures.place);
        }
    };
    toVertex(proof.gap, proof.gapPiece);
    toVertex(proof.strain, proof.strainPiece);
}

}  // namespace toile::prove
