// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/part_depth.h"

#include <algorithm>
#include <cmath>

#include "core/prepare/shell_rays.h"

namespace toile::layers {
namespace {

/// Largest distance between layers: in mm, and relative to the root of the area, so that a small
/// model is not all one thickness.
constexpr double kFarthestLayer = 30, kFarthestOfSize = 0.1;
/// Minimum share of a part's area inside others to count as inside them.
constexpr double kMaxOfIt = 0.6;
/// Number of triangles sampled per part.
constexpr std::size_t kLooksPerPart = 400;
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

    PartDepths look(const Progress& progress) const {
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

    SideSeen sideOf(int f, const Eigen::Vector3d& direction) const {
        SideSeen side;
        double last = 0;
        for (const shell::Meeting& met : rays_.all(f, direction)) {
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
};

}  // namespace

PartDepths depthsOf(const FileSurface& surface, const SurfaceParts& parts,
                    const Progress& progress) {
    return DepthFinder(surface, parts).look(progress);
}

}  // namespace toile::layers
