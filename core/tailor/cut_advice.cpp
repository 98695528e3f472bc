// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/cut_advice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/text.h"
#include "core/cut/auto_cut.h"
#include "core/cut/fill_holes.h"
#include "core/cut/surface_paths.h"
#include "core/mesh/cotangents.h"
#include "core/mesh/mesh_arrays.h"
#include "core/tailor/cut_order.h"
#include "core/tailor/form_lines.h"
#include "core/tailor/part_names.h"

namespace toile {
namespace {

/// Limit of |log|: length factors beyond e^3 are not distinguished.
constexpr double kMaxLog = 3;
/// A vertex with a smaller coupling to others is ignored.
constexpr double kLoose = 1e-9;
/// On garments an isometric map needs about this share of a conformal map's strain.
constexpr double kIsometricPart = 0.45;
constexpr double kPassedOver = 0.001;  ///< of the area

}  // namespace

StrainFigures strainFigures(std::vector<std::pair<double, double>> strainsAndAreas) {
    StrainFigures figures;
    double area = 0;
    for (auto& [strain, around] : strainsAndAreas) {
        strain = std::abs(strain);
        figures.mean += around * strain;
        area += around;
    }
    figures.mean /= area > 0 ? area : 1;
    std::ranges::sort(strainsAndAreas, std::ranges::greater{});
    double above = 0;
    for (const auto& [strain, around] : strainsAndAreas) {
        above += around;
        if (above > kPassedOver * area) {
            figures.most = strain;
            break;
        }
    }
    return figures;
}

StrainModel::StrainModel(const SurfaceLinks& links)
    : curvature_(Eigen::VectorXd::Zero(links.vertexCount())),
      rims_(static_cast<std::size_t>(links.vertexCount()), 0),
      areas_(static_cast<std::size_t>(links.vertexCount()), 0) {
    const MeshArrays& mesh = links.mesh();
    linalg::SymmetricBuilder builder(links.vertexCount());
    const auto connect = [&builder](int a, int b, double weight) {
        builder.add(a, b, -weight);
        builder.add(a, a, weight);
        builder.add(b, b, weight);
    };
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const CornerProducts corners = cornerProducts(mesh, f);
        for (int k = 0; k < 3; ++k) {
            const int v = mesh.F(f, k);
            areas_[static_cast<std::size_t>(v)] += corners.doubledArea / 6;
            curvature_[v] -= std::atan2(corners.doubledArea, corners.at[k]);
            const double weight =
                corners.doubledArea > 0 ? corners.at[k] / (2 * corners.doubledArea) : 0;
            connect(mesh.F(f, (k + 1) % 3), mesh.F(f, (k + 2) % 3), weight);
        }
    }
    for (int v = 0; v < links.vertexCount(); ++v) {
        const bool isInner = !links.cornersAt(v).empty() && links.isInner(v);
        rims_[static_cast<std::size_t>(v)] = isInner ? 0 : 1;
        curvature_[v] = isInner ? curvature_[v] + 2 * std::numbers::pi : 0;
    }
    laplacian_ = builder.build();
}

std::optional<FlatScale> StrainModel::solve(std::vector<char> parted) {
    linalg::SymmetricMatrix system = laplacian_;
    for (int v = 0; v < system.size; ++v) {
        if (system.value[system.columnStart[v]] < kLoose) {  // only in flat triangles
            parted[static_cast<std::size_t>(v)] = 1;
        }
    }
    for (int j = 0; j < system.size; ++j) {
        for (int p = system.columnStart[j]; p < system.columnStart[j + 1]; ++p) {
            if (parted[static_cast<std::size_t>(j)] != 0 ||
                parted[static_cast<std::size_t>(system.row[p])] != 0) {
                system.value[p] = system.row[p] == j ? 1 : 0;
            }
        }
    }
    Eigen::VectorXd sources = -curvature_;
    for (int v = 0; v < system.size; ++v) {
        if (parted[static_cast<std::size_t>(v)] != 0) {
            sources[v] = 0;
        }
    }
    const auto made = isOrdered_ ? factor_.refactorise(system) : factor_.factorise(system);
    if (!made) {
        return std::nullopt;
    }
    isOrdered_ = true;
    const auto solved = factor_.solve(sources);
    if (!solved || !solved->allFinite()) {
        return std::nullopt;
    }
    FlatScale scale;
    scale.log = solved->col(0);
    scale.absorbed = curvature_;
    std::vector<std::pair<double, double>> strains;
    strains.reserve(areas_.size());
    for (int v = 0; v < system.size; ++v) {
        const auto at = static_cast<std::size_t>(v);
        const double log = std::clamp(scale.log[v], -kMaxLog, kMaxLog);
        strains.emplace_back(kIsometricPart * std::expm1(-log), areas_[at]);
        for (int p = laplacian_.columnStart[v]; p < laplacian_.columnStart[v + 1]; ++p) {
            const int other = laplacian_.row[p];
            if (parted[at] != 0) {
                scale.absorbed[v] += laplacian_.value[p] * scale.log[other];
            }
            if (other != v && parted[static_cast<std::size_t>(other)] != 0) {
                scale.absorbed[other] += laplacian_.value[p] * scale.log[v];
            }
        }
    }
    scale.strain = strainFigures(std::move(strains));
    return scale;
}

namespace {

/// Sufficient mean strain for forms that are not worn, if no value is set.
constexpr double kEnoughOfForms = 0.015;
/// Above this mean strain the shortest cuts cannot cover a form well.
constexpr double kFormInDoubt = 0.025;
/// Largest number of form lines of a kind, and of proposed darts.
constexpr unsigned kFormLines = 16, kDarts = 10;
/// Shorter lines, as a fraction of the root of the area, do not count as lines of the form.
constexpr double kShortestLine = 0.25;

Wording evidenceOf(const TailorCut& cut) {
    if (cut.isFileBorder) {
        return worded("a border in the file's UV map or parts");
    }
    if (cut.likeliness > MeshLines::kLikely) {
        return worded("the mesh has a line there that looks like a seam (%1)",
                      {figure(cut.likeliness, 2)});
    }
    return worded("from the shape");
}

Wording ridgeEvidence() {
    return worded("along a ridge of the shape");
}

Wording planeEvidence(double deviation) {
    return worded("where left meets right, %1 mm from symmetric", {figure(deviation, 1)});
}

Wording openingEvidence() {
    return worded("the shortest cut that lets the piece lie flat");
}

AdvisedCut advisedCut(TailorCut cut) {
    AdvisedCut made;
    made.evidence = evidenceOf(cut);
    made.what = std::move(cut);
    return made;
}

AdvisedCut formCut(const FormLine& line, TailorLine kind, Wording evidence) {
    AdvisedCut made;
    made.what.line = kind;
    made.what.cut.kind = line.isRound ? UserCut::Kind::Loop : UserCut::Kind::Path;
    made.what.cut.points = line.points;
    made.evidence = std::move(evidence);
    return made;
}

/// Ridges and intersections with the mirror plane; only long ones, up to a limit.
std::vector<AdvisedCut> formCuts(const SurfaceLinks& links,
                                 const std::optional<MirrorPlane>& plane) {
    const double size = std::sqrt(surfaceArea(links.mesh()));
    std::vector<AdvisedCut> cuts;
    const auto add = [&](const std::vector<FormLine>& lines, TailorLine kind,
                         const Wording& evidence) {
        for (std::size_t k = 0; k < std::min<std::size_t>(lines.size(), kFormLines); ++k) {
            if (lines[k].points.size() > 2 &&
                lengthOf(lines[k].points, lines[k].isRound) > kShortestLine * size) {
                cuts.push_back(formCut(lines[k], kind, evidence));
            }
        }
    };
    add(ridgesOf(links), TailorLine::Ridge, ridgeEvidence());
    if (plane) {
        add(sectionsOf(links, *plane), TailorLine::Centre, planeEvidence(plane->deviation));
    }
    return cuts;
}

/// The shortest cuts that open the piece.
std::vector<PathPolyline> openingPaths(const Piece& piece, const Progress& progress) {
    const auto opening = proposeCuts(piece.mesh, piece.table, {}, progress);
    return opening ? opening->cuts : std::vector<PathPolyline>{};
}

AdvisedCut openingCut(const MeshArrays& mesh, const PathPolyline& path) {
    AdvisedCut made;
    made.what.line = TailorLine::Opening;
    made.what.cut.points = positionsOf(mesh, path);
    made.evidence = openingEvidence();
    return made;
}

void giveNames(std::vector<AdvisedCut>& cuts, const std::vector<UserCut>& own) {
    UniqueNames names;
    for (const UserCut& cut : own) {
        names.take(cut.name);
    }
    for (const AdvisedCut& cut : cuts) {
        if (!cut.what.cut.name.empty()) {
            names.take(cut.what.cut.name);
        }
    }
    for (AdvisedCut& cut : cuts) {
        if (cut.what.cut.name.empty()) {
            cut.what.cut.name = names.free(wordOf(cut.what.line));
        }
    }
}

/// Trousers have side seams only if the mesh shows them: many have none. UV maps are also cut for
/// reasons other than seams: of their borders, bands are cut, and others are offered.
bool isUsual(const AdvisedCut& cut, bool areTrousers) {
    switch (cut.what.line) {
        case TailorLine::Dart:
            return false;
        case TailorLine::Style:
            return !cut.what.isFileBorder;
        case TailorLine::Side:
            return !areTrousers || cut.what.likeliness > MeshLines::kLikely;
        default:
            return true;
    }
}

bool isOtherSide(const TailorCut& a, const TailorCut& b) {
    return a.side != 0 && a.line == b.line && a.side == -b.side;
}

}  // namespace

void markNeeded(CutAdvice& advice, const std::optional<double>& enough) {
    const bool areTrousers = std::ranges::any_of(
        advice.cuts, [](const AdvisedCut& cut) { return cut.what.line == TailorLine::Inseam; });
    const double bound = enough.value_or(kEnoughOfForms);
    bool isReached = advice.before.mean <= bound;
    for (std::size_t k = 0; k < advice.cuts.size(); ++k) {
        AdvisedCut& cut = advice.cuts[k];
        if (advice.isWorn && !enough) {
            cut.isNeeded = isUsual(cut, areTrousers);
        } else if (k > 0 && isOtherSide(cut.what, advice.cuts[k - 1].what)) {
            cut.isNeeded = advice.cuts[k - 1].isNeeded;
        } else {
            cut.isNeeded = !isReached;
        }
        isReached = isReached || cut.predicted.mean <= bound;
    }
}

CutAdvice adviseCuts(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& own,
                     const AdviceOptions& options, const Progress& progress) {
    CutAdvice advice;
    const SurfaceLinks links(piece->mesh, piece->table);
    const std::vector<PathPolyline> opening = openingPaths(*piece, progress);
    tailor::CutOrder order(links, opening, progress);
    for (const UserCut& cut : own) {
        order.add(cut);
    }
    if (const auto& scale = order.look()) {
        advice.before = scale->strain;
    }
    const auto body = readBody(piece, progress, options.isFrontSwapped);
    const std::vector<TailorCut> tailors =
        body ? tailorCuts(*piece, *body, own, progress, options.borders) : std::vector<TailorCut>{};
    advice.isWorn = !tailors.empty();
    for (const TailorCut& cut : tailors) {
        order.propose(advisedCut(cut));
    }
    order.takeAll();
    if (!advice.isWorn && advice.before.mean > kFormInDoubt) {
        const bool isKnown = body && std::isfinite(body->plane.deviation);
        std::vector<AdvisedCut> cuts =
            formCuts(links, isKnown ? body->plane : findMirrorPlane({piece}, progress));
        // Darts need a start on a closed form.
        if (cuts.empty() && rimsOf(piece->mesh, piece->table).empty()) {
            for (const PathPolyline& path : opening) {
                order.propose(openingCut(piece->mesh, path));
            }
            order.takeAll();
        }
        for (AdvisedCut& cut : cuts) {
            order.propose(std::move(cut));
        }
    }
    if (advice.isWorn || advice.before.mean > kFormInDoubt) {
        order.takeWorthwhile(kDarts);
    }
    if (progress.isCancelled()) {
        return {};
    }
    advice.cuts = std::move(order.taken());
    giveNames(advice.cuts, own);
    markNeeded(advice, options.enoughStrain);
    if (advice.isWorn) {
        advice.nameOf = [piece, body = *body, tailors](const Piece& part) {
            return partName(*piece, body, tailors, part);
        };
    }
    return advice;
}

}  // namespace toile
