// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/form_lines.h"

#include <algorithm>
#include <array>
#include <utility>

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
