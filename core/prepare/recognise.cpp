// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/recognise.h"

#include <algorithm>
#include <utility>

#include "core/prepare/debris.h"
#include "core/prepare/file_surface.h"

namespace toile {
namespace {

/// At least this many fragments indicate a scan.
constexpr int kFewestFragments = 5;
/// Minimum share of a solid's area in closed surfaces.
constexpr double kClosedShare = 0.95;
/// Up to this share of coinciding faces is only folded, as in the corners of a cushion.
constexpr double kFoldedShare = 0.02;

constexpr const char* kOneThickness = translatable("two surfaces %1 mm apart");
constexpr const char* kThicknesses = translatable("two surfaces %1 to %2 mm apart");
constexpr const char* kWithoutRims = translatable("%1, which no rim joins");

Wording evidenceOf(const Shell& shell) {
    const bool isEven = shell.thickest - shell.thinnest < 0.1 * shell.median;
    return isEven ? worded(kOneThickness, {figure(shell.median, 1)})
                  : worded(kThicknesses, {figure(shell.thinnest, 1), figure(shell.thickest, 1)});
}

/// A double-sided mesh is not closed for that reason.
bool isClosed(const FileSurface& surface) {
    const FileSurface single = withoutDoubles(surface);
    const auto faces = static_cast<double>(surface.mesh.F.rows());
    const bool isFolded = static_cast<double>(single.mesh.F.rows()) >= (1 - kFoldedShare) * faces;
    return partsOf((isFolded ? surface : single).mesh).closedShare() >= kClosedShare;
}

}  // namespace

Recognition recognise(const FileSurface& surface, const Progress& progress) {
    if (auto shell = findShell(surface, progress)) {
        // Two panels behind each other look like this too: nothing may be removed automatically.
        const bool hasRims = std::ranges::find(shell->side, ShellSide::Rim) != shell->side.end();
        if (hasRims) {
            const Wording evidence = evidenceOf(*shell);
            return {FileKind::Shell, evidence, std::move(shell)};
        }
        auto layers = findLayers(surface, progress);
        const Wording evidence = layers && layers->isSure
                                     ? inWords(*layers)
                                     : worded(kWithoutRims, {evidenceOf(*shell)});
        return {FileKind::Layers, evidence, std::move(shell), std::move(layers)};
    }
    if (const Debris debris = findDebris(surface.mesh); debris.fragments >= kFewestFragments) {
        return {FileKind::Scan, worded("%1 beside one large surface",
                                       {countWording(debris.fragments, "fragment")})};
    }
    if (isClosed(surface)) {
        return {FileKind::Solid, worded("a closed surface, with nothing inside it")};
    }
    if (auto layers = findLayers(surface, progress); layers && layers->isSure) {
        const Wording evidence = inWords(*layers);
        return {FileKind::Layers, evidence, {}, std::move(layers)};
    }
    return {};
}

}  // namespace toile
