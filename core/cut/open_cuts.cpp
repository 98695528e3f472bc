// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/open_cuts.h"

#include <algorithm>

#include "core/cut/surface_links.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/edge_table.h"

namespace toile {
namespace {

/// A path's edge with the sides to its left and right.
struct Step {
    int left, right;  ///< uses
};

class Opener {
public:
    Opener(OpenedMesh& result, const std::vector<std::vector<int>>& paths)
        : result_(result),
          source_(result.mesh),
          table_(buildEdgeTable(source_.F, static_cast<int>(source_.V.rows()))),
          links_(source_, table_),
          isCut_(table_.edges.rows(), 0),
          steps_(paths.size()) {
        for (std::size_t p = 0; p < paths.size(); ++p) {
            collect(paths[p], steps_[p]);
        }
    }

    void run() {
        divideVertices();
        for (const auto& steps : steps_) {
            result_.cuts.push_back(follow(steps));
        }
    }

private:
    static int next(int use) { return 3 * (use / 3) + (use % 3 + 1) % 3; }

    int newTail(int use) const { return result_.mesh.F(use / 3, use % 3); }
    int newHead(int use) const { return newTail(next(use)); }

    /// The steps of a path; {-1, -1} where it runs along a rim or an earlier cut.
    void collect(const std::vector<int>& path, std::vector<Step>& steps) {
        for (std::size_t i = 1; i < path.size(); ++i) {
            const int e = findEdge(table_.edges, path[i - 1], path[i]);
            Step step{-1, -1};
            if (e >= 0 && isCut_[e] == 0 && links_.twin(table_.use[table_.useStart[e]]) >= 0) {
                isCut_[e] = 1;
                const int use = table_.use[table_.useStart[e]];
                const bool along = links_.tail(use) == path[i - 1];
                step = along ? Step{use, links_.twin(use)} : Step{links_.twin(use), use};
            }
            steps.push_back(step);
        }
    }

    void divideVertices() {
        const int cornerCount = static_cast<int>(source_.F.size());
        DisjointSets corners(cornerCount);
        std::vector<char> isTouched(source_.V.rows(), 0);
        for (int e = 0; e < table_.edges.rows(); ++e) {
            if (isCut_[e] != 0) {
                isTouched[table_.edges(e, 0)] = 1;
                isTouched[table_.edges(e, 1)] = 1;
                continue;
            }
            const int* uses = table_.use.data() + table_.useStart[e];
            for (int i = 1; i < table_.useStart[e + 1] - table_.useStart[e]; ++i) {
                const bool opposed = links_.tail(uses[0]) != links_.tail(uses[i]);
                corners.join(uses[0], opposed ? next(uses[i]) : uses[i]);
                corners.join(next(uses[0]), opposed ? uses[i] : next(uses[i]));
            }
        }
        const int sourceCount = static_cast<int>(source_.V.rows());
        std::vector<char> isTaken(sourceCount, 0);
        std::vector<int> vertexOf(cornerCount, -1);  // per root
        for (int c = 0; c < cornerCount; ++c) {
            const int v = links_.tail(c);
            if (isTouched[v] == 0) {
                continue;
            }
            int& vertex = vertexOf[corners.root(c)];
            if (vertex < 0 && isTaken[v] == 0) {
                isTaken[v] = 1;
                vertex = v;
            } else if (vertex < 0) {
                vertex = sourceCount + static_cast<int>(result_.copyOf.size());
                result_.copyOf.push_back(v);
            }
            result_.mesh.F(c / 3, c % 3) = vertex;
        }
        const int added = static_cast<int>(result_.copyOf.size());
        result_.mesh.V.conservativeResize(sourceCount + added, 3);
        for (int k = 0; k < added; ++k) {
            result_.mesh.V.row(sourceCount + k) = source_.V.row(result_.copyOf[k]);
        }
    }

    OpenedCut follow(const std::vector<Step>& steps) {
        OpenedCut cut;
        bool isOpen = false;
        for (const Step& step : steps) {
            if (step.left < 0) {
                isOpen = false;
                continue;
            }
            const int leftFrom = newTail(step.left);
            const int leftTo = newHead(step.left);
            const int rightFrom = newHead(step.right);
            const int rightTo = newTail(step.right);
            if (!isOpen || cut.runs.back().left.back() != leftFrom ||
                cut.runs.back().right.back() != rightFrom) {
                cut.runs.push_back({{leftFrom}, {rightFrom}, 0});
                isOpen = true;
            }
            CutRun& run = cut.runs.back();
            const double length =
                (result_.mesh.V.row(leftTo) - result_.mesh.V.row(leftFrom)).norm();
            run.left.push_back(leftTo);
            run.right.push_back(rightTo);
            run.length += length;
            cut.length += length;
            if (leftFrom == rightFrom && leftTo == rightTo) {
                result_.stillShut.push_back({links_.tail(step.left), links_.head(step.left),
                                             std::min(step.left, step.right) / 3});
            }
        }
        return cut;
    }

    OpenedMesh& result_;
    const MeshArrays source_;
    const EdgeTable table_;
    const SurfaceLinks links_;
    std::vector<char> isCut_;
    std::vector<std::vector<Step>> steps_;
};

}  // namespace

OpenedMesh openAlong(MeshArrays mesh, const std::vector<std::vector<int>>& paths) {
    OpenedMesh result;
    result.mesh = std::move(mesh);
    Opener(result, paths).run();
    return result;
}

}  // namespace toile
