// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/layers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/mesh/weld.h"
#include "core/prepare/shell_rays.h"
#include "core/prepare/surface_parts.h"

namespace toile {
namespace {

/// How far a layer lies from the next at most: mm, and of the root of the area, lest a small model
/// is all one thickness.
constexpr double kFarthestLayer = 30, kFarthestOfSize = 0.1;
/// Of its area, what a part must have inside others to count as inside them; and of those that a
/// file is recognised by, and how much of the file these must be.
constexpr double kMostOfIt = 0.6, kSurelyInside = 0.8, kLeastInside = 0.1;
/// Parts of less than this share of the area are no layer of their own.
constexpr double kSmallPart = 0.02;
/// Of its area, up to which a part lies on no other.
constexpr double kLiesOnNone = 0.2;
/// Triangles that are looked at of one part.
constexpr std::size_t kLooksPerPart = 400;
/// Least cosine between sheets that lie on each other.
constexpr double kAlongside = 0.8;
/// Shares of a part's area that must agree on where the garment's inside is, and on how the part is
/// bent: flat sheets say neither.
constexpr double kLeastVote = 0.2, kLeastBend = 0.1;

/// What lies near one side of a triangle.
struct SideSeen {
    std::vector<std::pair<int, double>> parts;  ///< others than its own, nearest first; gaps in mm
    int nearest = -1;                           ///< another part, however it lies
    bool isBacked = false;                      ///< there is cloth farther off
};

/// A triangle, looked at.
struct Look {
    double area = 0;
    SideSeen before, behind;  ///< where its normal points, and the other way
    double fromMiddle = 0;    ///< cosine of its normal to the way from the part's middle
};

/// A part, looked at.
struct PartSeen {
    std::vector<Look> looks{};
    double area = 0;  ///< of these
    int layer = 0;
    double inside = 0;  ///< share of the area that has other parts outside it
    double onOthers = 0;
    bool isSure = true;
    std::map<int, double> near{};  ///< area by part that is next to it
};

class LayerFinder {
public:
    LayerFinder(const FileSurface& surface, const SurfaceParts& parts)
        : surface_(shell::surfaceWith(surface.mesh, surface.face)),
          rays_(surface_),
          parts_(parts),
          farthest_(std::min(kFarthestLayer, kFarthestOfSize * std::sqrt(parts.total))) {}

    std::vector<PartSeen> look(const Progress& progress) {
        std::vector<std::vector<int>> members(parts_.area.size());
        for (std::size_t f = 0; f < parts_.of.size(); ++f) {
            members[parts_.of[f]].push_back(static_cast<int>(f));
        }
        std::vector<PartSeen> seen(members.size());
        for (std::size_t p = 0; p < members.size() && !progress.isCancelled(); ++p) {
            const Eigen::RowVector3d middle = middleOf(members[p]);
            const std::size_t step = std::max<std::size_t>(1, members[p].size() / kLooksPerPart);
            for (std::size_t i = 0; i < members[p].size(); i += step) {
                seen[p].looks.push_back(lookAt(members[p][i], middle));
                seen[p].area += seen[p].looks.back().area;
            }
            judge(static_cast<int>(p), seen[p]);
        }
        return seen;
    }

    /// Gaps between layers, with areas.
    const std::vector<std::pair<double, double>>& gaps() const { return gaps_; }

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

    SideSeen sideOf(int f, const Eigen::Vector3d& direction) const {
        SideSeen side;
        double last = 0;
        for (const shell::Meeting& met : rays_.all(f, direction)) {
            const double distance = met.way.norm(), gap = distance - last;
            const int part = parts_.of[met.triangle];
            if (distance > farthest_ && gap > farthest_) {
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

    Look lookAt(int f, const Eigen::RowVector3d& middle) const {
        const Eigen::Vector3d normal = surface_.normal.row(f);
        if (normal.isZero()) {
            return {};
        }
        const Eigen::RowVector3d out = middleOf(f) - middle;
        const double length = out.norm();
        return {surface_.area[f], sideOf(f, normal), sideOf(f, -normal),
                length > 0 ? out.dot(normal) / length : 0};
    }

    /// Which way is out where a triangle itself does not show it: as most of the part says, else
    /// as it is bent, else towards what comes earlier in the file. Of these the last is a guess.
    /// @return positive where the normals point outwards
    static double outwardsOf(int part, PartSeen& seen) {
        double vote = 0, bend = 0, order = 0;
        for (const Look& look : seen.looks) {
            vote += look.area * (int(look.behind.isBacked) - int(look.before.isBacked));
            bend += look.area * look.fromMiddle;
            for (const auto& [side, sign] :
                 {std::pair(&look.before, 1), std::pair(&look.behind, -1)}) {
                for (const auto& [other, gap] : side->parts) {
                    order += look.area * (other < part ? sign : -sign);
                }
            }
        }
        if (std::abs(vote) >= kLeastVote * seen.area) {
            return vote;
        }
        if (std::abs(bend) >= kLeastBend * seen.area) {
            return bend;
        }
        seen.isSure = order == 0;
        return order;
    }

    /// How deep a part lies inside others.
    void judge(int part, PartSeen& seen) {
        const double outwards = outwardsOf(part, seen);
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
                    seen.near[side->nearest] += look.area;
                }
            }
            for (const auto& [other, gap] : outside.parts) {
                gaps_.emplace_back(gap, look.area);
            }
        }
        seen.onOthers = seen.area > 0 ? on / seen.area : 0;
        double deeper = 0;
        for (std::size_t depth = areaOfDepth.size(); depth-- > 1;) {
            deeper += areaOfDepth[depth];
            if (seen.layer == 0 && deeper >= kMostOfIt * seen.area) {
                seen.layer = static_cast<int>(depth);
            }
        }
        seen.inside = seen.area > 0 ? deeper / seen.area : 0;
    }

    shell::Surface surface_;
    shell::Rays rays_;
    const SurfaceParts& parts_;
    double farthest_;
    std::vector<std::pair<double, double>> gaps_;
};

/// How many vertices each two parts have at the same places: they are sewn there.
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

/// Gives parts that say nothing of their layer that of the parts next to them.
void attach(std::vector<PartSeen>& seen, const SurfaceParts& parts,
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
    for (bool isAny = true; isAny;) {  // along chains of parts, a ring at a time
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

/// The layers numbered without gaps. @return how many
int renumber(std::vector<PartSeen>& seen) {
    std::vector<int> layers;
    for (const PartSeen& part : seen) {
        layers.push_back(part.layer);
    }
    std::ranges::sort(layers);
    layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
    for (PartSeen& part : seen) {
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
    LayerFinder finder(single, parts);
    std::vector<PartSeen> seen = finder.look(progress);
    double inside = 0;
    bool isSure = true;
    for (std::size_t p = 0; p < seen.size(); ++p) {
        if (seen[p].inside >= kSurelyInside) {
            inside += parts.area[p];
            isSure = isSure && (seen[p].isSure || parts.area[p] < kSmallPart * parts.total);
        }
    }
    if (progress.isCancelled() || inside < kLeastInside * parts.total) {
        return std::nullopt;
    }
    attach(seen, parts, sewnTo(single.mesh, parts));
    Layers layers{{}, renumber(seen), medianGap(finder.gaps()), isSure};
    if (layers.count < 2) {
        return std::nullopt;
    }
    std::vector<int> ofVertex(static_cast<std::size_t>(surface.mesh.V.rows()), 0);
    for (std::size_t f = 0; f < parts.of.size(); ++f) {
        for (const int v : single.mesh.F.row(static_cast<Eigen::Index>(f))) {
            ofVertex[v] = seen[parts.of[f]].layer;
        }
    }
    for (Eigen::Index f = 0; f < surface.mesh.F.rows(); ++f) {
        layers.of.push_back(ofVertex[surface.mesh.F(f, 0)]);
    }
    return layers;
}

Wording inWords(const Layers& layers) {
    return worded("surfaces that lie on each other, %1 mm apart", {figure(layers.apart, 1)});
}

}  // namespace toile
