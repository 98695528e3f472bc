// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/proof.h"

#include <algorithm>
#include <thread>

#include "core/base/stopwatch.h"
#include "core/prove/design_surface.h"
#include "core/prove/fresh_cloth.h"
#include "core/prove/measured_cloth.h"
#include "core/prove/seam_strain.h"

namespace toile {
namespace {

constexpr double kPascal = 1e-6;   // N/m² in N/mm²
constexpr double kGravity = 9.81;  // m/s²
/// Of the force at seams, what may be left. At half of it the mean gap of garments is another by
/// less than 1 %; at two and a half times as much by up to 10 %.
constexpr double kShare = 2e-3;

/// What each piece is cut from.
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
