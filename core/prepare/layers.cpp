// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/layers.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/mesh/weld.h"
#include "core/prepare/part_depth.h"
#include "core/prepare/surface_parts.h"

namespace toile {
namespace {

using layers::PartDepth;

/// Minimum share of a part's area inside others for a file to be recognised by it, and minimum
/// share of the file in such parts.
constexpr double kSurelyInside = 0.8, kMinInside = 0.1;
/// Parts with less than this share of the area are not a layer of their own.
constexpr double kSmallPart = 0.02;
/// Up to this share of its area a part does not lie on another.
constexpr double kLiesOnNone = 0.2;

/// Number of vertices that two parts share by position: they are sewn there.
std::vector<std::map<int, int>> sewnTo(const MeshArrays& mesh, const SurfaceParts& parts) {
    std::vector<int> partOf(static_cast<std::size_t>(mesh.V.rows()), -1);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        for (const int v : mesh.F.row(f)) {
            partOf[v] = parts.of[static_cast<std::size_t>(f)];
        }
    }
    const Weld weld = findWeld(mesh.F, mesh.V, {weldTolerance(mesh.F, mesh.V)});
    std::vector<std::map<int, int>> sewn(parts.area.size());
    for (std::size_t v = 0; v < partOf.size(); ++v) {
        const int here = partOf[v], there = partOf[weld.target[v]];
        if (here != there && here >= 0) {
            ++sewn[here][there];
            ++sewn[there][here];
        }
    }
    return sewn;
}

template <class Weight>
int heaviest(const std::map<int, Weight>& weights, const std::vector<char>& isKnown) {
    int found = -1;
    for (const auto& [part, weight] : weights) {
        if (isKnown[part] && (found < 0 || weight > weights.at(found))) {
            found = part;
        }
    }
    return found;
}

/// Assigns parts of unknown layer to the layer of adjacent parts.
void attach(std::vector<PartDepth>& seen, const SurfaceParts& parts,
            const std::vector<std::map<int, int>>& sewn) {
    int deepest = 0;
    for (std::size_t p = 0; p < seen.size(); ++p) {
        if (parts.area[p] >= kSmallPart * parts.total) {
            deepest = std::max(deepest, seen[p].layer);
        }
    }
    std::vector<char> isKnown(seen.size());
    for (std::size_t p = 0; p < seen.size(); ++p) {
        isKnown[p] = seen[p].layer <= deepest && seen[p].onOthers > kLiesOnNone;
    }
    for (bool isAny = true; isAny;) {  // along chains of parts, one ring at a time
        isAny = false;
        const std::vector<char> before = isKnown;
        for (std::size_t p = 0; p < seen.size(); ++p) {
            int host = isKnown[p] ? -1 : heaviest(sewn[p], before);
            host = isKnown[p] || host >= 0 ? host : heaviest(seen[p].near, before);
            if (host >= 0) {
                seen[p].layer = seen[host].layer;
                isKnown[p] = 1;
                isAny = true;
            }
        }
    }
    for (std::size_t p = 0; p < seen.size(); ++p) {
        seen[p].layer = isKnown[p] ? seen[p].layer : 0;
    }
}

/// Renumbers the layers without gaps. @return their number
int renumber(std::vector<PartDepth>& seen) {
    std::vector<int> layers;
    layers.reserve(seen.size());
    for (const PartDepth& part : seen) {
        layers.push_back(part.layer);
    }
    std::ranges::sort(layers);
    layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
    for (PartDepth& part : seen) {
        part.layer = static_cast<int>(std::ranges::find(layers, part.layer) - layers.begin());
    }
    return static_cast<int>(layers.size());
}

double medianGap(std::vector<std::pair<double, double>> gaps) {
    std::ranges::sort(gaps);
    double all = 0, sum = 0;
    for (const auto& [gap, area] : gaps) {
        all += area;
    }
    for (const auto& [gap, area] : gaps) {
        sum += area;
        if (2 * sum >= all) {
            return gap;
        }
    }
    return 0;
}

}  // namespace

std::optional<Layers> findLayers(const FileSurface& surface, const Progress& progress) {
    const FileSurface single = withoutDoubles(surface);
    const SurfaceParts parts = partsOf(single.mesh);
    if (parts.area.size() < 2) {
        return std::nullopt;
    }
    layers::PartDepths depths = layers::depthsOf(single, parts, progress);
    if (progress.isCancelled()) {
        return std::nullopt;
    }
    std::vector<PartDepth>& seen = depths.parts;
    double inside = 0;
    bool isSure = true;
    for (std::size_t p = 0; p < seen.size(); ++p) {
        if (seen[p].inside >= kSurelyInside) {
            inside += parts.area[p];
            isSure = isSure && (seen[p].isSure || parts.area[p] < kSmallPart * parts.total);
        }
    }
    if (inside < kMinInside * parts.total) {
        return std::nullopt;
    }
    attach(seen, parts, sewnTo(single.mesh, parts));
    Layers found{{}, renumber(seen), medianGap(std::move(depths.gaps)), isSure};
    if (found.count < 2) {
        return std::nullopt;
    }
    std::vector<int> ofVertex(static_cast<std::size_t>(surface.mesh.V.rows()), 0);
    for (std::size_t f = 0; f < parts.of.size(); ++f) {
        for (const int v : single.mesh.F.row(static_cast<Eigen::Index>(f))) {
            ofVertex[v] = seen[parts.of[f]].layer;
        }
    }
    for (Eigen::Index f = 0; f < surface.mesh.F.rows(); ++f) {
        found.of.push_back(ofVertex[surface.mesh.F(f, 0)]);
    }
    return found;
}

Wording inWords(const Layers& layers) {
    return worded("surfaces that lie on each other, %1 mm apart", {figure(layers.apart, 1)});
}

}  // namespace toile
