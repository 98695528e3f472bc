// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/cut_advice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/unique_names.h"
#include "core/cut/auto_cut.h"
#include "core/cut/fill_holes.h"
#include "core/tailor/cut_order.h"
#include "core/tailor/form_lines.h"
#include "core/tailor/part_names.h"

namespace toile {
namespace {

/// From here on a line of the mesh is named as the reason for a cut.
constexpr double kSeamLikely = 0.6;
/// Mean strain that is enough for what nobody wears, where nothing is stated.
constexpr double kEnoughOfForms = 0.015;
/// Beyond this mean strain the shortest cuts are no way to cover a form.
constexpr double kFormInDoubt = 0.025;
/// Of lines of the form, as many are looked at; of darts, as many are proposed.
constexpr std::size_t kFormLines = 16, kDarts = 10;
/// A ridge shorter than this part of the root of the area is none of the form.
constexpr double kShortestRidge = 0.25;

AdvisedCut advisedCut(TailorCut cut) {
    AdvisedCut made;
    made.evidence = cut.isFileBorder ? worded("a border of the file, in its UV map or its parts")
                    : cut.likeliness > kSeamLikely
                        ? worded("the mesh has a line there that looks like a seam (%1)",
                                 {figure(cut.likeliness, 2)})
                        : worded("by the form");
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

/// Ridges, and where the mirror plane goes through.
std::vector<AdvisedCut> formCuts(const std::shared_ptr<const Piece>& piece,
                                 const SurfaceLinks& links, const Progress& progress) {
    std::vector<AdvisedCut> cuts;
    double area = 0;
    for (int f = 0; f < links.faceCount(); ++f) {
        area += doubleAreaNormal(links.mesh(), f).norm() / 2;
    }
    for (const FormLine& line : ridgesOf(links)) {
        if (cuts.size() < kFormLines && line.points.size() > 2 &&
            lengthOf(line.points, line.isRound) > kShortestRidge * std::sqrt(area)) {
            cuts.push_back(formCut(line, TailorLine::Ridge, worded("along a ridge of the form")));
        }
    }
    if (const auto plane = findMirrorPlane({piece}, progress)) {
        for (const FormLine& line : sectionsOf(links, *plane)) {
            if (line.points.size() > 2) {
                cuts.push_back(formCut(line, TailorLine::Centre,
                                       worded("where left meets right, %1 mm from symmetric",
                                              {figure(plane->deviation, 1)})));
            }
        }
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
    for (const SurfacePoint& point : path.points) {
        made.what.cut.points.push_back(positionOf(mesh, point));
    }
    made.evidence = worded("the shortest that lets it lie flat");
    return made;
}

void giveNames(std::vector<AdvisedCut>& cuts) {
    UniqueNames names;
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

/// Trousers have side seams where the mesh shows them or strain asks for them: many have none.
bool isUsual(const AdvisedCut& cut, bool areTrousers) {
    return cut.what.line != TailorLine::Dart &&
           (!areTrousers || cut.what.line != TailorLine::Side || cut.what.likeliness > kSeamLikely);
}

/// Without a bound the usual seams are needed; with one, what comes before it is reached.
void markNeeded(CutAdvice& advice, bool isWorn, const std::optional<double>& enough) {
    const bool areTrousers = std::ranges::any_of(
        advice.cuts, [](const AdvisedCut& cut) { return cut.what.line == TailorLine::Inseam; });
    double before = advice.before.mean;
    for (AdvisedCut& cut : advice.cuts) {
        cut.isNeeded = isWorn && !enough ? isUsual(cut, areTrousers)
                                         : before > enough.value_or(kEnoughOfForms);
        before = cut.predicted.mean;
    }
}

}  // namespace

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
    const bool isWorn = !tailors.empty();
    for (const TailorCut& cut : tailors) {
        order.propose(advisedCut(cut));
    }
    order.takeAll();
    if (!isWorn && advice.before.mean > kFormInDoubt) {
        std::vector<AdvisedCut> cuts = formCuts(piece, links, progress);
        if (cuts.empty() && rimLoops(links).empty()) {  // closed, and darts have to begin somewhere
            for (const PathPolyline& path : opening) {
                order.propose(openingCut(piece->mesh, path));
            }
            order.takeAll();
        }
        for (AdvisedCut& cut : cuts) {
            order.propose(std::move(cut));
        }
    }
    if (isWorn || advice.before.mean > kFormInDoubt) {
        order.takeWorthwhile(kDarts);
    }
    if (progress.isCancelled()) {
        return {};
    }
    advice.cuts = std::move(order.taken());
    giveNames(advice.cuts);
    markNeeded(advice, isWorn, options.enoughStrain);
    if (isWorn) {
        advice.nameOf = [piece, body = *body, tailors](const Piece& part) {
            return partName(*piece, body, tailors, part);
        };
    }
    return advice;
}

}  // namespace toile
