// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/cut/cut_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/cut/surface_paths.h"
#include "core/mesh/disk_check.h"

namespace toile::test {
namespace {

Eigen::Vector3d areaVector(const MeshArrays& mesh, int face) {
    const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 0));
    const Eigen::Vector3d b = mesh.V.row(mesh.F(face, 1));
    const Eigen::Vector3d c = mesh.V.row(mesh.F(face, 2));
    return 0.5 * (b - a).cross(c - a);
}

std::set<std::pair<int, int>> rim(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    std::set<std::pair<int, int>> edges;
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (table.useStart[e + 1] - table.useStart[e] == 1) {
            edges.emplace(table.edges(e, 0), table.edges(e, 1));
        }
    }
    return edges;
}

void expectRuns(const CutResult& cut, const std::string& what) {
    const auto rimEdges = rim(cut.mesh);
    for (const OpenedCut& opened : cut.cuts) {
        double sum = 0;
        for (const CutRun& run : opened.runs) {
            ASSERT_EQ(run.left.size(), run.right.size()) << what;
            double length = 0;
            for (std::size_t i = 0; i < run.left.size(); ++i) {
                EXPECT_EQ(cut.mesh.V.row(run.left[i]), cut.mesh.V.row(run.right[i])) << what;
                if (i == 0) {
                    continue;
                }
                for (const auto* side : {&run.left, &run.right}) {
                    const std::pair<int, int> edge = std::minmax((*side)[i - 1], (*side)[i]);
                    EXPECT_TRUE(rimEdges.contains(edge)) << what;
                }
                length += (cut.mesh.V.row(run.left[i]) - cut.mesh.V.row(run.left[i - 1])).norm();
            }
            EXPECT_NEAR(run.length, length, 1e-9 * (1 + length)) << what;
            sum += length;
        }
        EXPECT_NEAR(opened.length, sum, 1e-9 * (1 + sum)) << what;
    }
}

}  // namespace

double totalArea(const MeshArrays& mesh) {
    double sum = 0;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        sum += areaVector(mesh, f).norm();
    }
    return sum;
}

double leastAngle(const MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    double least = HUGE_VAL;
    for (int corner = 0; corner < mesh.F.size(); ++corner) {
        least = std::min(least, links.angleAt(corner));
    }
    return least;
}

int rimEdgeCount(const MeshArrays& mesh) {
    return static_cast<int>(rim(mesh).size());
}

int componentCount(const MeshArrays& mesh) {
    const auto labels = faceComponents(mesh.F, static_cast<int>(mesh.V.rows()));
    return 1 + *std::max_element(labels.begin(), labels.end());
}

SurfacePoint randomPoint(const MeshArrays& mesh, std::mt19937& random) {
    const auto unit = [&random] { return (random() + 0.5) / 4294967296.0; };
    SurfacePoint point;
    point.face = static_cast<int>(random() % static_cast<unsigned>(mesh.F.rows()));
    const double s = std::sqrt(unit());
    const double t = unit();
    point.barycentric = {1 - s, s * (1 - t), s * t};
    return point;
}

Result<PathPolyline> randomPath(const SurfaceLinks& links, std::mt19937& random) {
    const SurfacePoint to = randomPoint(links.mesh(), random);
    const SurfacePoint from = randomPoint(links.mesh(), random);
    return geodesicPath(links, from, to);
}

void expectValidCut(const MeshArrays& source, const CutResult& cut, const std::string& what) {
    const double area = totalArea(source);
    EXPECT_NEAR(totalArea(cut.mesh), area, 1e-12 * area) << what;
    ASSERT_EQ(cut.sourceFace.size(), static_cast<std::size_t>(cut.mesh.F.rows())) << what;
    ASSERT_EQ(cut.sourceVertex.size(), static_cast<std::size_t>(cut.mesh.V.rows())) << what;
    std::vector<double> covered(source.F.rows(), 0);
    for (int f = 0; f < cut.mesh.F.rows(); ++f) {
        const Eigen::Vector3d whole = areaVector(source, cut.sourceFace[f]);
        const Eigen::Vector3d part = areaVector(cut.mesh, f);
        EXPECT_GT(part.dot(whole), 0) << what << " face " << f;
        EXPECT_GT(part.norm(), 1e-9 * whole.norm()) << what << " face " << f;
        covered[cut.sourceFace[f]] += part.norm() / whole.norm();
    }
    for (const double share : covered) {
        EXPECT_NEAR(share, 1, 1e-9) << what;
    }
    for (int v = 0; v < cut.mesh.V.rows(); ++v) {
        if (cut.sourceVertex[v] >= 0) {
            EXPECT_EQ(cut.mesh.V.row(v), source.V.row(cut.sourceVertex[v])) << what;
        }
        EXPECT_LT((positionOf(source, cut.place[v]) - cut.mesh.V.row(v).transpose()).norm(),
                  1e-12 * std::sqrt(area))
            << what;
    }
    expectRuns(cut, what);
    int steps = 0;
    for (const OpenedCut& opened : cut.cuts) {
        for (const CutRun& run : opened.runs) {
            steps += static_cast<int>(run.left.size()) - 1;
        }
    }
    // A rim edge of the source may have been split where a cut reaches it: counted by what is new.
    int oldRim = 0;
    const EdgeTable table = buildEdgeTable(source.F, static_cast<int>(source.V.rows()));
    for (int e = 0; e < table.edges.rows(); ++e) {
        oldRim += table.useStart[e + 1] - table.useStart[e] == 1 ? 1 : 0;
    }
    std::set<std::array<double, 3>> splits;
    for (int v = static_cast<int>(source.V.rows()); v < cut.mesh.V.rows(); ++v) {
        const SurfacePoint& place = cut.place[v];
        for (int k = 0; k < 3; ++k) {
            const int e = table.faceEdges(place.face, k);
            if (cut.sourceVertex[v] < 0 && place.barycentric[(k + 2) % 3] == 0 &&
                table.useStart[e + 1] - table.useStart[e] == 1) {
                splits.insert({cut.mesh.V(v, 0), cut.mesh.V(v, 1), cut.mesh.V(v, 2)});
            }
        }
    }
    EXPECT_EQ(rimEdgeCount(cut.mesh), oldRim + static_cast<int>(splits.size()) + 2 * steps) << what;
}

int expectDisks(const MeshArrays& mesh, const std::string& what) {
    const auto labels = faceComponents(mesh.F, static_cast<int>(mesh.V.rows()));
    const int count = 1 + *std::max_element(labels.begin(), labels.end());
    std::vector<std::vector<int>> faces(count);
    for (std::size_t f = 0; f < labels.size(); ++f) {
        faces[labels[f]].push_back(static_cast<int>(f));
    }
    for (const auto& members : faces) {
        MeshArrays part;
        part.F.resize(static_cast<Eigen::Index>(members.size()), 3);
        std::map<int, int> local;
        std::vector<int> vertices;
        for (std::size_t f = 0; f < members.size(); ++f) {
            for (int k = 0; k < 3; ++k) {
                const auto [it, isNew] =
                    local.emplace(mesh.F(members[f], k), static_cast<int>(vertices.size()));
                if (isNew) {
                    vertices.push_back(it->first);
                }
                part.F(static_cast<Eigen::Index>(f), k) = it->second;
            }
        }
        part.V.resize(static_cast<Eigen::Index>(vertices.size()), 3);
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            part.V.row(static_cast<Eigen::Index>(v)) = mesh.V.row(vertices[v]);
        }
        const DiskCheck check = checkDisk(part, what);
        EXPECT_FALSE(check.defect) << (check.defect ? sentence(*check.defect) : "");
    }
    return count;
}

}  // namespace toile::test
