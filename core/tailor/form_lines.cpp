// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/form_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/geometry/shortest_paths.h"

namespace toile {
namespace {

/// Edges with a larger bend, radians, are ridges. A tube of twelve sides has none.
constexpr double kRidgeFold = 0.6;
/// A ridge continues if it turns by less than acos of this.
constexpr double kGoesOn = 0.5;

void sortByLength(std::vector<FormLine>& lines) {
    std::ranges::stable_sort(lines, std::ranges::greater{}, [](const FormLine& line) {
        return lengthOf(line.points, line.isRound);
    });
}

class Ridges {
public:
    explicit Ridges(const SurfaceLinks& links)
        : links_(links), ridgesAt_(static_cast<std::size_t>(links.vertexCount())) {
        for (int e = 0; e < links.edgeCount(); ++e) {
            if (links.foldAngle(e) > kRidgeFold) {
                ridgesAt_[at(e, 0)].push_back(e);
                ridgesAt_[at(e, 1)].push_back(e);
                ridges_.push_back(e);
            }
        }
        isDone_.assign(static_cast<std::size_t>(links.edgeCount()), 0);
    }

    std::vector<FormLine> lines() {
        std::vector<FormLine> made;
        for (const bool fromEnds : {true, false}) {  // the rest is closed
            for (const int e : ridges_) {
                for (const int side : {0, 1}) {
                    const int end = static_cast<int>(at(e, side));
                    if (isDone_[static_cast<std::size_t>(e)] == 0 &&
                        (!fromEnds || onFrom(e, end) < 0)) {
                        made.push_back(from(end, e));
                    }
                }
            }
        }
        sortByLength(made);
        return made;
    }

private:
    std::size_t at(int edge, int side) const {
        return static_cast<std::size_t>(links_.table().edges(edge, side));
    }
    int otherEnd(int edge, int vertex) const {
        return links_.table().edges(edge, 0) == vertex ? links_.table().edges(edge, 1)
                                                       : links_.table().edges(edge, 0);
    }
    Eigen::Vector3d position(int vertex) const { return links_.mesh().V.row(vertex); }

    /// The edge that continues an edge beyond a vertex; -1 if the line ends.
    int onFrom(int edge, int vertex) const {
        const std::vector<int>& there = ridgesAt_[static_cast<std::size_t>(vertex)];
        if (there.size() != 2) {
            return -1;
        }
        const int next = there[0] == edge ? there[1] : there[0];
        const Eigen::Vector3d in =
            (position(vertex) - position(otherEnd(edge, vertex))).normalized();
        const Eigen::Vector3d out =
            (position(otherEnd(next, vertex)) - position(vertex)).normalized();
        return in.dot(out) > kGoesOn ? next : -1;
    }

    FormLine from(int vertex, int edge) {
        FormLine line;
        line.points.push_back(position(vertex));
        int here = vertex;
        while (edge >= 0 && isDone_[static_cast<std::size_t>(edge)] == 0) {
            isDone_[static_cast<std::size_t>(edge)] = 1;
            here = otherEnd(edge, here);
            line.points.push_back(position(here));
            edge = onFrom(edge, here);
        }
        if (here == vertex) {
            line.points.pop_back();
            line.isRound = true;
        }
        return line;
    }

    const SurfaceLinks& links_;
    std::vector<std::vector<int>> ridgesAt_;  ///< per vertex
    std::vector<int> ridges_;
    std::vector<char> isDone_;  ///< per edge
};

class Sections {
public:
    Sections(const SurfaceLinks& links, const MirrorPlane& plane)
        : links_(links), across_(links.mesh().V * plane.normal) {
        across_.array() -= plane.offset;
        isDone_.assign(static_cast<std::size_t>(links.faceCount()), 0);
    }

    std::vector<FormLine> lines() {
        std::vector<FormLine> made;
        for (const bool fromRims : {true, false}) {  // the rest is closed
            for (int use = 0; use < 3 * links_.faceCount(); ++use) {
                if (isCrossed(use) && isDone_[static_cast<std::size_t>(use) / 3] == 0 &&
                    (!fromRims || links_.twin(use) < 0)) {
                    made.push_back(from(use));
                }
            }
        }
        sortByLength(made);
        return made;
    }

private:
    bool isCrossed(int use) const {
        return (across_[links_.tail(use)] < 0) != (across_[links_.head(use)] < 0);
    }
    Eigen::Vector3d crossing(int use) const {
        const int a = links_.tail(use), b = links_.head(use);
        const double t = across_[a] / (across_[a] - across_[b]);
        return (1 - t) * links_.mesh().V.row(a) + t * links_.mesh().V.row(b);
    }

    FormLine from(int use) {
        FormLine line;
        line.points.push_back(crossing(use));
        while (use >= 0 && isDone_[static_cast<std::size_t>(use) / 3] == 0) {
            isDone_[static_cast<std::size_t>(use) / 3] = 1;
            const int next = nextSide(use);
            const int out = isCrossed(next) ? next : nextSide(next);
            // A vertex in the plane is met once for each triangle there.
            if (const Eigen::Vector3d point = crossing(out); point != line.points.back()) {
                line.points.push_back(point);
            }
            use = links_.twin(out);
        }
        line.isRound = use >= 0 && line.points.size() > 1;
        if (line.isRound && line.points.back() == line.points.front()) {
            line.points.pop_back();
        }
        return line;
    }

    const SurfaceLinks& links_;
    Eigen::VectorXd across_;
    std::vector<char> isDone_;  ///< per face
};

}  // namespace

std::vector<FormLine> ridgesOf(const SurfaceLinks& links) {
    return Ridges(links).lines();
}

std::vector<FormLine> sectionsOf(const SurfaceLinks& links, const MirrorPlane& plane) {
    return Sections(links, plane).lines();
}

double lengthOf(const std::vector<Eigen::Vector3d>& points, bool isRound) {
    double length = isRound && !points.empty() ? (points.front() - points.back()).norm() : 0;
    for (std::size_t k = 1; k < points.size(); ++k) {
        length += (points[k] - points[k - 1]).norm();
    }
    return length;
}

}  // namespace toile

namespace toile::tailor {
namespace {

constexpr double kLikely = 0.8, kShortest = 60;  // mm
/// A line is known if more than this share of it is within this distance of known ones, mm.
constexpr double kKnownPart = 0.4, kByKnown = 20;
/// Leads from its ends: smallest likeliness, or largest length, mm.
constexpr double kLikelyLead = 0.7, kShortLead = 40;
/// If more than this share of all edges looks like seams, as on a lathed mesh, only borders of the
/// file count.
constexpr double kMaxSeams = 0.05;
/// Share of its mirror image that must be on other likely lines.
constexpr double kMirroredPart = 0.7;

/// Points in space, with a test whether any are near a place.
class PointCloud {
public:
    void add(const Eigen::Vector3d& point) { cells_[cellOf(point)].push_back(point); }

    bool hasNear(const Eigen::Vector3d& place) const {
        const Cell middle = cellOf(place);
        for (int k = 0; k < 27; ++k) {
            const auto cell = cells_.find(
                {middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
            if (cell != cells_.end() && std::ranges::any_of(cell->second, [&](const auto& point) {
                    return (point - place).squaredNorm() < kByKnown * kByKnown;
                })) {
                return true;
            }
        }
        return false;
    }

private:
    using Cell = std::array<long long, 3>;

    static Cell cellOf(const Eigen::Vector3d& point) {
        const auto at = [&point](int axis) {
            return std::llround(std::floor(point[axis] / kByKnown));
        };
        return {at(0), at(1), at(2)};
    }

    std::map<Cell, std::vector<Eigen::Vector3d>> cells_;
};

class StyleLines {
public:
    StyleLines(const BodyWays& ways, const MeshLines& lines, const SeamPull& pull)
        : ways_(ways),
          lines_(lines),
          pull_(pull),
          easedLengths_(pull.eased(ways.lengths())),
          isInNetwork_(static_cast<std::size_t>(ways.links().vertexCount()), 0) {
        std::vector<int> rim;
        for (int v = 0; v < ways.links().vertexCount(); ++v) {
            if (!ways.links().isInner(v)) {
                rim.push_back(v);
                likely_.add(ways.at(v));
            }
        }
        addKnown(rim);
        for (std::size_t line = 0; line < lines.ways.size(); ++line) {
            for (std::size_t k = 0; isLikely(line) && k < lines.ways[line].size(); ++k) {
                likely_.add(ways.at(lines.ways[line][k]));
            }
        }
    }

    void addKnown(const std::vector<int>& way) {
        for (const int v : way) {
            if (std::exchange(isInNetwork_[v], 1) == 0) {
                network_.push_back(v);
                networkPoints_.add(ways_.at(v));
            }
        }
    }

    std::vector<std::vector<int>> run() {
        std::vector<std::size_t> order;
        std::size_t edges = 0;
        for (std::size_t line = 0; line < lines_.ways.size(); ++line) {
            if (isLikely(line)) {
                order.push_back(line);
                edges += isBorder(line) ? 0 : lines_.ways[line].size() - 1;
            }
        }
        if (static_cast<double>(edges) > kMaxSeams * static_cast<double>(lines_.lineOf.size())) {
            std::erase_if(order, [this](std::size_t line) { return !isBorder(line); });
        }
        std::ranges::stable_sort(order, std::ranges::greater{}, [this](std::size_t line) {
            return ways_.length(lines_.ways[line]) * lines_.likeliness[line];
        });
        std::vector<std::vector<int>> found;
        for (const std::size_t line : order) {
            if (ways_.isCancelled()) {
                return {};
            }
            const std::vector<int>& way = lines_.ways[line];
            if (nearPart(way, networkPoints_, false) >= kKnownPart ||
                nearPart(way, likely_, true) < kMirroredPart) {
                continue;
            }
            const std::vector<int> whole = ledOn(way);
            if (!whole.empty() && pull_.along(whole) >= kLikely) {
                found.push_back(whole);
                addKnown(whole);
            }
        }
        return found;
    }

private:
    bool isBorder(std::size_t line) const { return lines_.isBorderLine(static_cast<int>(line)); }

    bool isLikely(std::size_t line) const {
        return lines_.likeliness[line] > kLikely && ways_.length(lines_.ways[line]) > kShortest;
    }

    /// Share of a path, or of its mirror image, near some vertices.
    double nearPart(const std::vector<int>& way, const PointCloud& others, bool isMirrored) const {
        int near = 0;
        for (const int v : way) {
            const Eigen::Vector3d here =
                isMirrored ? ways_.body().plane.reflected(ways_.at(v)) : ways_.at(v);
            near += others.hasNear(here) ? 1 : 0;
        }
        return static_cast<double>(near) / static_cast<double>(way.size());
    }

    /// The path with both ends extended to the network; empty if an end does not reach it.
    std::vector<int> ledOn(const std::vector<int>& way) const {
        std::vector<int> whole = way;
        if (way.front() == way.back()) {
            return whole;
        }
        for (int end = 0; end < 2; ++end) {
            std::ranges::reverse(whole);
            if (isInNetwork_[whole.back()] != 0) {
                continue;
            }
            const std::vector<int> lead = ways_.cheapest(easedLengths_, {whole.back()}, network_);
            if (lead.empty() ||
                (pull_.along(lead) <= kLikelyLead && ways_.length(lead) >= kShortLead)) {
                return {};
            }
            whole.insert(whole.end(), lead.begin() + 1, lead.end());
        }
        return whole;
    }

    const BodyWays& ways_;
    const MeshLines& lines_;
    const SeamPull& pull_;
    const std::vector<double> easedLengths_;
    std::vector<char> isInNetwork_;
    std::vector<int> network_;
    PointCloud networkPoints_, likely_;
};

}  // namespace

std::vector<std::vector<int>> styleLines(const BodyWays& ways, const MeshLines& lines,
                                         const SeamPull& pull,
                                         const std::vector<std::vector<int>>& known) {
    StyleLines style(ways, lines, pull);
    for (const std::vector<int>& way : known) {
        style.addKnown(way);
    }
    return style.run();
}

}  // namespace toile::tailor
