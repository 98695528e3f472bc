// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/proof.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/base/progress.h"
#include "core/prove/fresh_cloth.h"
#include "core/prove/pattern_faults.h"
#include "core/prove/proof_words.h"
#include "core/sew/contact.h"

namespace toile::prove {
namespace {

/// Cloth farther than this from its support touches nothing, mm.
constexpr double kTouches = 0.5;

/// The vertex of the piece that is nearest to a triangle of the cloth.
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

/// Positions of the vertices of a garment's pieces on the cloth at X, one list per piece. Linear.
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

/// Measures settled cloth: the pieces, gap, strain and free share.
/// @param held  the support of the cloth, the design or a body
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

}  // namespace
}  // namespace toile::prove

namespace toile {
namespace {

constexpr double kPascal = 1e-6;   // N/m² in N/mm²
constexpr double kGravity = 9.81;  // m/s²
/// Allowed residual as a share of the force at seams. Half of it changes the mean gap of garments
/// by less than 1 %; two and a half times as much by up to 10 %.
constexpr double kShare = 2e-3;
constexpr double kNowhereNear = 0.1;  // of the design's size: beyond the mean gap of any garment

/// The fabric of each piece.
std::vector<Fabric> fabricsOf(const ExportSource& source) {
    const LaidOutPattern& laid = source.laid();
    std::vector<Fabric> fabrics(source.garment().pieces.size(), source.fabric());
    for (std::size_t p = 0; p < fabrics.size() && p < laid.wholePattern.pieces.size(); ++p) {
        fabrics[p] =
            fabricOf(laid.wholePattern.pieces[p].material, laid.pattern.materials, source.fabric());
    }
    return fabrics;
}

/// Mean length of the triangles' edges in the pattern, mm.
double meanEdge(const sew::Cloth& cloth) {
    double sum = 0;
    for (Eigen::Index f = 0; f < cloth.patternF.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            sum += (cloth.Q.row(cloth.patternF(f, k)) - cloth.Q.row(cloth.patternF(f, (k + 1) % 3)))
                       .norm();
        }
    }
    return cloth.patternF.rows() > 0 ? sum / static_cast<double>(cloth.patternF.size()) : 0;
}

sew::SettleOptions settleOptions(const ProofSettings& settings,
                                 const std::vector<Fabric>& fabrics) {
    sew::SettleOptions options;
    options.pressure = settings.pressure * kPascal;
    options.gravity = settings.hasGravity ? kGravity : 0;
    options.touchesItself = settings.touchesItself;
    options.thickness = settings.thickness;
    options.share = kShare;
    options.threads = settings.threads > 0
                          ? settings.threads
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    for (const Fabric& fabric : fabrics) {
        options.stiffness.push_back(settings.stiffness.over(clothStiffness(fabric)));
    }
    return options;
}

}  // namespace

Result<std::shared_ptr<const Proof>> proofOf(const ExportSource& source, const ProofOrder& order,
                                             const Progress& progress) {
    const Stopwatch watch;
    auto fresh = prove::freshCloth(source, order, Progress(progress, 0.1));
    if (!fresh) {
        return fresh.error();
    }
    fresh->cloth.Q *= order.scale;
    const auto surface = prove::designSurface(source.garment());
    if (!surface) {
        return surface.error();
    }
    const sew::WornSurface design(*surface);
    const std::optional<sew::WornSurface> body =
        order.body ? std::make_optional<sew::WornSurface>(*order.body) : std::nullopt;
    const sew::WornSurface& held = body ? *body : design;
    const std::vector<Fabric> fabrics = fabricsOf(source);
    sew::SettleOptions options = settleOptions(order.settings, fabrics);
    if (order.watch) {
        options.watch = [&](const Points3& X) { order.watch(prove::sewnPieces(*fresh, X)); };
    }
    const auto settled =
        sew::settle(fresh->cloth, fresh->cloth.X, held, options, Progress(progress, 0.9));
    if (!settled) {
        return settled.error();
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    auto proof = std::make_shared<Proof>();
    proof->seams = fresh->seams;
    proof->faults = fresh->faults;
    proof->source = fresh->source;
    proof->settings = order.settings;
    proof->hasBody = order.body.has_value();
    proof->bodyName = order.bodyName;
    proof->scale = order.scale;
    proof->fabrics = fabrics;
    prove::measureCloth(*fresh, settled->X, design, held, *proof);
    for (ProvenSeam& seam : proof->seams) {
        seam.left *= order.scale;
        seam.right *= order.scale;
        seam.slip *= order.scale;
        seam.strain = prove::seamStrain(source.garment(), seam, proof->pieces);
    }
    const double size = (surface->V.colwise().maxCoeff() - surface->V.colwise().minCoeff()).norm();
    if (!(proof->gap.mean <= kNowhereNear * size)) {
        proof->faults.push_back(clothNowhereNear(proof->gap.mean, size));
    }
    proof->edge = meanEdge(fresh->cloth);
    proof->triangles = static_cast<int>(fresh->cloth.F.rows());
    proof->iterations = settled->iterations;
    proof->restForce = settled->restForce;
    proof->seamForce = settled->seamForce;
    proof->hasSettled = settled->hasSettled;
    proof->seconds = watch.seconds();
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    return std::shared_ptr<const Proof>(std::move(proof));
}

}  // namespace toile
