// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/layers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/weld.h"
#include "core/prepare/file_surface.h"
#include "core/prepare/shell_rays.h"

namespace toile::layers {
namespace {

/// How deep a connected part lies inside others.
struct PartDepth {
    int layer = 0;        ///< number of parts outside it, close to it over most of its area
    double inside = 0;    ///< share of its area that has others outside it
    double onOthers = 0;  ///< and with others on either side
    /// The outer side was found; else the side of earlier parts in the file counts as outside.
    bool isSure = true;
    std::map<int, double> near{};  ///< area, mm2, per adjacent part
};

struct PartDepths {
    std::vector<PartDepth> parts;                 ///< one per part; empty after a cancel
    std::vector<std::pair<double, double>> gaps;  ///< between adjacent layers, mm, with areas
};

/// Largest distance between layers: in mm, and relative to the root of the area, so that a small
/// model is not all one thickness.
constexpr double kFarthestLayer = 30, kFarthestOfSize = 0.1;
/// Minimum share of a part's area inside others to count as inside them.
constexpr double kMaxOfIt = 0.6;
/// Number of triangles sampled per part.
constexpr std::size_t kLooksPerPart = 400;
/// Triangles that all looks may test, some seconds' work: garments take a tenth of it.
constexpr long kMaxVisitsOfFile = 40'000'000;
/// Minimum cosine between adjacent sheets.
constexpr double kAlongside = 0.8;
/// Minimum shares of a part's area that agree on the garment's inside, and on the part's bend: flat
/// sheets show neither.
constexpr double kMinVote = 0.2, kMinBend = 0.1;

/// Cloth near one side of a triangle.
struct SideSeen {
    std::vector<std::pair<int, double>> parts;  ///< other parts, nearest first; gaps in mm
    int nearest = -1;                           ///< another part, at any angle
    bool isBacked = false;                      ///< there is cloth farther away
};

/// The view from a triangle.
struct Look {
    double area = 0;
    SideSeen before, behind;  ///< along its normal, and the other way
    double fromMiddle = 0;    ///< cosine of its normal and the direction from the part's centroid
};

/// The evidence for a part.
struct PartSeen {
    int part;
    std::vector<Look> looks{};
    double area = 0;  ///< of these
};

class DepthFinder {
public:
    DepthFinder(const FileSurface& surface, const SurfaceParts& parts)
        : surface_(shell::surfaceWith(surface.mesh, surface.face)),
          rays_(surface_),
          parts_(parts),
          farthest_(std::min(kFarthestLayer, kFarthestOfSize * std::sqrt(parts.total))) {}

    PartDepths look(const Progress& progress) {
        std::vector<std::vector<int>> members(parts_.area.size());
        for (std::size_t f = 0; f < parts_.of.size(); ++f) {
            members[parts_.of[f]].push_back(static_cast<int>(f));
        }
        PartDepths depths;
        for (std::size_t p = 0; p < members.size() && !progress.isCancelled(); ++p) {
            const Eigen::RowVector3d middle = middleOf(members[p]);
            const std::size_t step = std::max<std::size_t>(1, members[p].size() / kLooksPerPart);
            PartSeen seen{static_cast<int>(p)};
            for (std::size_t i = 0; i < members[p].size(); i += step) {
                seen.looks.push_back(lookAt(members[p][i], middle));
                seen.area += seen.looks.back().area;
            }
            depths.parts.push_back(judge(seen, depths.gaps));
        }
        return depths;
    }

private:
    Eigen::RowVector3d middleOf(int f) const {
        const MeshArrays& mesh = surface_.mesh;
        return (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3;
    }

    Eigen::RowVector3d middleOf(const std::vector<int>& faces) const {
        Eigen::RowVector3d sum(0, 0, 0);
        double area = 0;
        for (const int f : faces) {
            sum += surface_.area[f] * middleOf(f);
            area += surface_.area[f];
        }
        return area > 0 ? Eigen::RowVector3d(sum / area) : sum;
    }

    SideSeen sideOf(int f, const Eigen::Vector3d& direction) {
        SideSeen side;
        double last = 0;
        for (const shell::Meeting& met : rays_.all(f, direction, visitsLeft_)) {
            const double distance = met.way.norm(), gap = distance - last;
            const int part = parts_.of[met.triangle];
            if (gap > farthest_) {
                side.isBacked = true;
                break;
            }
            side.nearest = side.nearest < 0 && part != parts_.of[f] ? part : side.nearest;
            const bool isAlongside =
                std::abs(direction.dot(surface_.normal.row(met.triangle))) >= kAlongside;
            if (part != parts_.of[f] && isAlongside &&
                std::ranges::find(side.parts, part, &std::pair<int, double>::first) ==
                    side.parts.end()) {
                side.parts.emplace_back(part, gap);
                last = distance;
            }
        }
        return side;
    }

    Look lookAt(int f, const Eigen::RowVector3d& middle) {
        const Eigen::Vector3d normal = surface_.normal.row(f);
        if (normal.isZero()) {
            return {};
        }
        const Eigen::RowVector3d out = middleOf(f) - middle;
        const double length = out.norm();
        return {surface_.area[f], sideOf(f, normal), sideOf(f, -normal),
                length > 0 ? out.dot(normal) / length : 0};
    }

    /// The outward direction if a triangle itself does not show it: as most of the part, else by
    /// its bend, else towards earlier parts in the file, which is a guess.
    /// @return positive where the normals point outwards
    static double outwardsOf(const PartSeen& seen, bool& isSure) {
        double vote = 0, bend = 0, order = 0;
        for (const Look& look : seen.looks) {
            vote += look.area * (int(look.behind.isBacked) - int(look.before.isBacked));
            bend += look.area * look.fromMiddle;
            for (const auto& [side, sign] :
                 {std::pair(&look.before, 1), std::pair(&look.behind, -1)}) {
                for (const auto& [other, gap] : side->parts) {
                    order += look.area * (other < seen.part ? sign : -sign);
                }
            }
        }
        if (std::abs(vote) >= kMinVote * seen.area) {
            return vote;
        }
        if (std::abs(bend) >= kMinBend * seen.area) {
            return bend;
        }
        isSure = order == 0;
        return order;
    }

    static PartDepth judge(const PartSeen& seen, std::vector<std::pair<double, double>>& gaps) {
        PartDepth found;
        const double outwards = outwardsOf(seen, found.isSure);
        std::vector<double> areaOfDepth;
        double on = 0;
        for (const Look& look : seen.looks) {
            const bool isClear = look.before.isBacked != look.behind.isBacked;
            const bool isBefore = isClear ? look.behind.isBacked : outwards > 0;
            const SideSeen& outside = isBefore ? look.before : look.behind;
            areaOfDepth.resize(std::max(areaOfDepth.size(), outside.parts.size() + 1), 0);
            areaOfDepth[outside.parts.size()] += look.area;
            const bool liesOn = !look.before.parts.empty() || !look.behind.parts.empty();
            on += liesOn ? look.area : 0;
            for (const SideSeen* side : {&look.before, &look.behind}) {
                if (side->nearest >= 0) {
                    found.near[side->nearest] += look.area;
                }
            }
            for (const auto& [other, gap] : outside.parts) {
                gaps.emplace_back(gap, look.area);
            }
        }
        double deeper = 0;
        for (std::size_t depth = areaOfDepth.size(); depth-- > 1;) {
            deeper += areaOfDepth[depth];
            if (found.layer == 0 && deeper >= kMaxOfIt * seen.area) {
                found.layer = static_cast<int>(depth);
            }
        }
        found.onOthers = seen.area > 0 ? on / seen.area : 0;
        found.inside = seen.area > 0 ? deeper / seen.area : 0;
        return found;
    }

    shell::Surface surface_;
    shell::Rays rays_;
    const SurfaceParts& parts_;
    double farthest_;
    long visitsLeft_ = kMaxVisitsOfFile;
};

/// Looks outwards from parts. Outside is the side with nothing behind adjacent parts: a garment's
/// front has its back on the other side. If that cannot be seen, the convex side is outside.
/// @param surface  mm, each face once   @param parts  of it
/// Cost: n log n, and rays of at most 400 triangles of each part, shorter ones after 40 million
/// tests of triangles. Pure.
PartDepths depthsOf(const FileSurface& surface, const SurfaceParts& parts,
                    const Progress& progress) {
    return DepthFinder(surface, parts).look(progress);
}

}  // namespace

}  // namespace toile::layers

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
