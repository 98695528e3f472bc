// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/hole_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/linalg/sparse_cholesky.h"
#include "core/mesh/cotangents.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/tri_mesh.h"

namespace toile {
namespace {

constexpr int kMaxHoleEdges = 400;
constexpr double kMaxBulge = 0.25;  // of the perimeter, from the box around a hole
constexpr double kSameCosine = 1e-9;
constexpr double kFlatHeight = 1e-3;  // of the longest side
constexpr int kMaxRefinements = 10;
constexpr int kFairings = 2;  // the second measures on the surface that the first has bent
constexpr Eigen::Index kMaxPatchFaces = 100000;

/// The faces around the vertices of all holes. No vertex is on two of them, so patches of other
/// holes are not among them.
class HoleSurroundings {
public:
    HoleSurroundings(const MeshArrays& mesh, std::span<const RimLoop> holes)
        : faces_(static_cast<std::size_t>(mesh.V.rows())) {
        std::vector<char> isOnHole(faces_.size(), 0);
        for (const RimLoop& hole : holes) {
            for (const int v : hole.vertices) {
                isOnHole[v] = 1;
            }
        }
        for (int f = 0; f < mesh.F.rows(); ++f) {
            for (const int v : mesh.F.row(f)) {
                if (isOnHole[v] != 0) {
                    faces_[v].emplace_back(mesh.F.row(f).transpose());
                }
            }
        }
    }

    const std::vector<Eigen::Vector3i>& facesAt(int v) const { return faces_[v]; }

    bool areJoined(int v, int w) const {
        return std::ranges::any_of(
            faces_[v], [w](const Eigen::Vector3i& f) { return (f.array() == w).any(); });
    }

    /// The third vertex of the face that runs from one to the other, or -1.
    int apexOver(int tail, int head) const {
        for (const Eigen::Vector3i& face : faces_[tail]) {
            for (int k = 0; k < 3; ++k) {
                if (face[k] == tail && face[(k + 1) % 3] == head) {
                    return face[(k + 2) % 3];
                }
            }
        }
        return -1;
    }

private:
    std::vector<std::vector<Eigen::Vector3i>> faces_;
};

/// A corner's part of a triangle's area: what is nearer to it than to the other corners, or if an
/// angle is obtuse half of the area there and a quarter elsewhere ([MDSB03] section 3.3).
double cornerArea(const MeshArrays& mesh, int f, int k, const CornerProducts& corners) {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    if (std::min({corners.at[0], corners.at[1], corners.at[2]}) < 0) {
        return corners.doubledArea / (corners.at[k] < 0 ? 4 : 8);
    }
    const auto square = [&](int other) {
        return (mesh.V.row(mesh.F(f, other)) - mesh.V.row(mesh.F(f, k))).squaredNorm();
    };
    return (square(next) * corners.at[previous] + square(previous) * corners.at[next]) /
           (8 * corners.doubledArea);
}

/// A patch for one hole: its first vertices are those of the rim, backwards, as a patch has the
/// hole on its left.
class HolePatch {
public:
    HolePatch(const MeshArrays& mesh, const RimLoop& hole, const HoleSurroundings& around)
        : V_(mesh.V),
          around_(around),
          rim_(hole.vertices.rbegin(), hole.vertices.rend()),
          perimeter_(hole.perimeter) {}

    /// @return false if the hole cannot be closed
    bool triangulate();
    void refine();
    void fair();

    const MeshArrays& patch() const { return patch_; }
    const std::vector<int>& rim() const { return rim_; }

private:
    using Vertex = TriMesh::VertexHandle;
    using Edge = TriMesh::EdgeHandle;
    using Halfedge = TriMesh::HalfedgeHandle;

    int count() const { return static_cast<int>(rim_.size()); }
    Eigen::Vector3d at(int i) const { return V_.row(rim_[i]).transpose(); }
    Eigen::Vector3d normal(int i, int j, int k) const {
        return (at(j) - at(i)).cross(at(k) - at(i));
    }
    bool shouldFlip(const TriMesh& mesh, Edge e) const;
    std::vector<double> scales() const;

    const Points3& V_;
    const HoleSurroundings& around_;
    std::vector<int> rim_;
    double perimeter_;
    MeshArrays patch_;
};

/// The triangulation whose largest angle between two normals is least, of those of least area, by
/// dynamic programming over the stretches of the rim ([Lie03] section 3).
bool HolePatch::triangulate() {
    struct Weight {
        double cosine = 1, area = 0;  // the largest angle has the least cosine
        int middle = -1;              // of the triangle over the stretch; -1: there is none
    };
    const int n = count();
    if (n < 3 || n > kMaxHoleEdges) {
        return false;
    }
    std::vector<int> apexes;
    std::vector<Eigen::Vector3d> normals;  // of the faces beside the rim
    for (int i = 0; i < n; ++i) {
        const int tail = rim_[(i + 1) % n], head = rim_[i], apex = around_.apexOver(tail, head);
        if (apex < 0 || around_.apexOver(head, tail) >= 0) {
            return false;  // no rim
        }
        apexes.push_back(apex);
        const Eigen::Vector3d a = V_.row(tail), b = V_.row(head), c = V_.row(apex);
        normals.push_back((b - a).cross(c - a).normalized());
    }
    std::vector<char> isFree(static_cast<std::size_t>(n) * n, 1);  // for an edge of the patch
    std::vector<Weight> weights(isFree.size());
    for (int i = 0; i < n; ++i) {
        for (int k = i + 2; k < n; ++k) {
            isFree[i * n + k] =
                (i == 0 && k == n - 1) || (at(i) != at(k) && !around_.areJoined(rim_[i], rim_[k]));
        }
    }
    for (int span = 2; span < n; ++span) {
        for (int i = 0, k = span; k < n; ++i, ++k) {
            Weight best{-2, std::numeric_limits<double>::infinity(), -1};
            for (int m = i + 1; isFree[i * n + k] != 0 && m < k; ++m) {
                const Weight &left = weights[i * n + m], &right = weights[m * n + k];
                const bool isLast = span == n - 1;
                if ((m > i + 1 && left.middle < 0) || (m < k - 1 && right.middle < 0) ||
                    std::min(left.cosine, right.cosine) < best.cosine ||
                    (m == i + 1 && apexes[i] == rim_[k]) || (m == k - 1 && apexes[m] == rim_[i]) ||
                    (isLast && apexes[k] == rim_[m])) {
                    continue;  // the last three: two triangles in one place
                }
                const Eigen::Vector3d area = normal(i, m, k), unit = area.normalized();
                const double longest =
                    std::max({(at(m) - at(i)).squaredNorm(), (at(k) - at(m)).squaredNorm(),
                              (at(i) - at(k)).squaredNorm()});
                const bool isFlat = !(area.norm() > kFlatHeight * longest);
                const auto bend = [&](int from, int to, const Weight& weight) {
                    return unit.dot(weight.middle < 0
                                        ? normals[from]
                                        : normal(from, weight.middle, to).normalized());
                };
                Weight made{
                    std::min({left.cosine, right.cosine, bend(i, m, left), bend(m, k, right),
                              isLast ? unit.dot(normals[k]) : 1.0, isFlat ? -1.0 : 1.0}),
                    left.area + right.area + area.norm() / 2, m};
                if (made.cosine > best.cosine + kSameCosine ||
                    (made.cosine > best.cosine - kSameCosine && made.area < best.area)) {
                    best = made;
                }
            }
            weights[i * n + k] = best;
        }
    }
    if (weights[n - 1].middle < 0) {
        return false;
    }
    patch_.V.resize(n, 3);
    patch_.F.resize(n - 2, 3);
    for (int i = 0; i < n; ++i) {
        patch_.V.row(i) = V_.row(rim_[i]);
    }
    std::vector<std::pair<int, int>> open{{0, n - 1}};
    for (int f = 0; !open.empty(); ++f) {
        const auto [i, k] = open.back();
        const int m = weights[i * n + k].middle;
        open.pop_back();
        patch_.F.row(f) << i, m, k;
        for (const auto& stretch : {std::pair(m, k), std::pair(i, m)}) {
            if (stretch.second - stretch.first > 1) {
                open.push_back(stretch);
            }
        }
    }
    return true;
}

/// How long edges are around each vertex of the rim, on average.
std::vector<double> HolePatch::scales() const {
    std::vector<double> scales;
    for (const int v : rim_) {
        double sum = 0;
        int edges = 0;
        for (const Eigen::Vector3i& face : around_.facesAt(v)) {
            for (const int w : face) {  // edges within twice, on the rim once
                sum += (V_.row(w) - V_.row(v)).norm();
                edges += w != v ? 1 : 0;
            }
        }
        scales.push_back(sum / edges);
    }
    return scales;
}

/// Whether an edge is not Delaunay and can be flipped.
bool HolePatch::shouldFlip(const TriMesh& mesh, Edge e) const {
    if (mesh.is_boundary(e)) {
        return false;
    }
    std::array<int, 2> apexes{};
    double angles = 0;
    for (int side = 0; side < 2; ++side) {
        const Halfedge h = mesh.halfedge_handle(e, side);
        const Vertex apex = mesh.opposite_vh(h);
        const auto p = mesh.point(apex);
        const auto a = mesh.point(mesh.from_vertex_handle(h)) - p;
        const auto b = mesh.point(mesh.to_vertex_handle(h)) - p;
        angles += std::atan2((a % b).norm(), a | b);
        apexes[static_cast<std::size_t>(side)] = apex.idx();
    }
    constexpr double kClearly = 1e-9;  // so that no edge flips to and fro
    if (mesh.point(Vertex(apexes[0])) == mesh.point(Vertex(apexes[1]))) {
        return false;
    }
    const bool isOutside = std::max(apexes[0], apexes[1]) < count() &&
                           around_.areJoined(rim_[apexes[0]], rim_[apexes[1]]);
    return angles > std::numbers::pi + kClearly && !isOutside && mesh.is_flip_ok(e);
}

/// Divides triangles that are large for the mesh around, and makes the patch Delaunay ([Lie03]
/// section 4).
void HolePatch::refine() {
    TriMesh mesh(*buildTriMesh(patch_, buildEdgeTable(patch_.F, count())));
    std::vector<double> scale = scales();
    const auto makeDelaunay = [&] {
        bool hasFlipped = true;
        for (int pass = 0; hasFlipped && pass < kMaxRefinements; ++pass) {
            hasFlipped = false;
            for (int e = 0; e < static_cast<int>(mesh.n_edges()); ++e) {
                if (shouldFlip(mesh, Edge(e))) {
                    mesh.flip(Edge(e));
                    hasFlipped = true;
                }
            }
        }
    };
    makeDelaunay();
    bool isDone = false;
    for (int pass = 0; !isDone && pass < kMaxRefinements; ++pass) {
        isDone = true;
        const int faces = static_cast<int>(mesh.n_faces());
        for (int f = 0; f < faces && static_cast<Eigen::Index>(mesh.n_faces()) < kMaxPatchFaces;
             ++f) {
            const TriMesh::FaceHandle face(f);
            OpenMesh::Vec3d centre(0, 0, 0);
            double size = 0;
            for (const Vertex v : mesh.fv_range(face)) {
                centre += mesh.point(v) / 3.0;
                size += scale[v.idx()] / 3;
            }
            bool isLarge = true;
            for (const Vertex v : mesh.fv_range(face)) {
                isLarge = isLarge && std::sqrt(2.0) * (mesh.point(v) - centre).norm() >
                                         std::max(size, scale[v.idx()]);
            }
            if (!isLarge) {
                continue;
            }
            isDone = false;
            const std::array<Edge, 3> sides{
                mesh.edge_handle(mesh.halfedge_handle(face)),
                mesh.edge_handle(mesh.next_halfedge_handle(mesh.halfedge_handle(face))),
                mesh.edge_handle(mesh.prev_halfedge_handle(mesh.halfedge_handle(face)))};
            mesh.split(face, mesh.add_vertex(centre));
            scale.push_back(size);
            for (const Edge side : sides) {
                if (shouldFlip(mesh, side)) {
                    mesh.flip(side);
                }
            }
        }
        makeDelaunay();
    }
    patch_.V.resize(static_cast<Eigen::Index>(mesh.n_vertices()), 3);
    patch_.F.resize(static_cast<Eigen::Index>(mesh.n_faces()), 3);
    for (const Vertex v : mesh.vertices()) {
        patch_.V.row(v.idx()) = Eigen::RowVector3d::Map(mesh.point(v).data());
    }
    for (const TriMesh::FaceHandle f : mesh.faces()) {
        int k = 0;
        for (const Vertex v : mesh.fv_range(f)) {
            patch_.F(f.idx(), k++) = v.idx();
        }
    }
}

/// Bends the patch so that the surface goes on without an edge: its inner vertices get the least
/// sum of squared mean curvatures, rim and surroundings staying. If that throws it far out, as a
/// ragged rim does, it stays taut.
void HolePatch::fair() {
    const int rimCount = count(), inner = static_cast<int>(patch_.V.rows()) - rimCount;
    if (inner == 0) {
        return;
    }
    // The patch and the faces around its rim; further vertices are numbered as they come.
    MeshArrays mesh = patch_;
    std::vector<Eigen::Vector3i> faces;
    std::vector<std::pair<int, int>> numbers;
    for (int i = 0; i < rimCount; ++i) {
        numbers.emplace_back(rim_[i], i);
        for (const Eigen::Vector3i& face : around_.facesAt(rim_[i])) {
            faces.push_back(face);
        }
    }
    std::ranges::sort(faces, [](const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
        return std::ranges::lexicographical_compare(a, b);
    });
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::ranges::sort(numbers);
    int next = static_cast<int>(patch_.V.rows());
    mesh.V.conservativeResize(next + 3 * static_cast<Eigen::Index>(faces.size()), 3);
    mesh.F.conservativeResize(patch_.F.rows() + static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const auto found = std::ranges::lower_bound(numbers, std::pair(faces[i][k], 0));
            int number = 0;
            if (found != numbers.end() && found->first == faces[i][k]) {
                number = found->second;
            } else {  // its own number in each face: it is fixed
                number = next++;
                mesh.V.row(number) = V_.row(faces[i][k]);
            }
            mesh.F(patch_.F.rows() + static_cast<Eigen::Index>(i), k) = number;
        }
    }
    // Rows of the Laplacian at vertices of the patch.
    const int rows = rimCount + inner;
    std::vector<std::vector<std::pair<int, double>>> laplacian(static_cast<std::size_t>(rows));
    std::vector<double> areas(laplacian.size(), 0);
    const auto addTo = [&laplacian](int row, int column, double weight) {
        for (auto& [other, sum] : laplacian[row]) {
            if (other == column) {
                sum += weight;
                return;
            }
        }
        laplacian[row].emplace_back(column, weight);
    };
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const CornerProducts corners = cornerProducts(mesh, f);
        if (!(corners.doubledArea > 0)) {
            return;
        }
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.F(f, (k + 1) % 3), b = mesh.F(f, (k + 2) % 3);
            const double weight = corners.at[k] / (2 * corners.doubledArea);
            for (const auto& [v, w] : {std::pair(a, b), std::pair(b, a)}) {
                if (v < rows) {
                    addTo(v, w, weight);
                    addTo(v, v, -weight);
                }
            }
            if (mesh.F(f, k) < rows) {
                areas[mesh.F(f, k)] += cornerArea(mesh, f, k, corners);
            }
        }
    }
    linalg::SymmetricBuilder builder(inner);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(inner, 3);
    for (int row = 0; row < rows; ++row) {
        Eigen::RowVector3d fixed = Eigen::RowVector3d::Zero();
        for (const auto& [v, weight] : laplacian[row]) {
            if (v < rimCount || v >= rows) {
                fixed += weight * mesh.V.row(v);
            }
        }
        for (const auto& [v, weight] : laplacian[row]) {
            if (v < rimCount || v >= rows) {
                continue;
            }
            right.row(v - rimCount) -= weight / areas[row] * fixed;
            for (const auto& [w, other] : laplacian[row]) {
                if (w >= rimCount && w <= v) {
                    builder.add(v - rimCount, w - rimCount, weight * other / areas[row]);
                }
            }
        }
    }
    linalg::SparseCholesky cholesky;
    if (!cholesky.factorise(builder.build())) {
        return;
    }
    const auto solution = cholesky.solve(right);
    Eigen::AlignedBox3d box;
    for (int i = 0; i < rimCount; ++i) {
        box.extend(at(i));
    }
    const auto isNear = [&](int i) {
        const Eigen::Vector3d p = solution->row(i).transpose();
        return p.allFinite() && box.exteriorDistance(p) <= kMaxBulge * perimeter_;
    };
    for (int i = 0; i < inner; ++i) {
        if (!solution || !isNear(i)) {
            return;
        }
    }
    patch_.V.bottomRows(inner) = *solution;
}

}  // namespace

PatchedSurface withPatches(const MeshArrays& mesh, std::span<const RimLoop> holes,
                           const Progress& progress) {
    const HoleSurroundings around(mesh, holes);
    PatchedSurface patched{mesh, {}};
    Points3& V = patched.mesh.V;
    Triangles& F = patched.mesh.F;
    for (std::size_t i = 0; i < holes.size() && !progress.isCancelled(); ++i) {
        HolePatch closing(mesh, holes[i], around);
        if (closing.triangulate()) {
            closing.refine();
            for (int fairing = 0; fairing < kFairings; ++fairing) {
                closing.fair();
            }
            const MeshArrays& patch = closing.patch();
            const auto rimCount = static_cast<Eigen::Index>(closing.rim().size());
            const Eigen::Index vertices = V.rows(), faces = F.rows();
            V.conservativeResize(vertices + patch.V.rows() - rimCount, 3);
            F.conservativeResize(faces + patch.F.rows(), 3);
            V.bottomRows(patch.V.rows() - rimCount) = patch.V.bottomRows(patch.V.rows() - rimCount);
            for (Eigen::Index f = 0; f < patch.F.rows(); ++f) {
                for (int k = 0; k < 3; ++k) {
                    const int v = patch.F(f, k);
                    F(faces + f, k) =
                        v < rimCount ? closing.rim()[v] : static_cast<int>(vertices + v - rimCount);
                }
            }
            patched.hole.resize(patched.hole.size() + static_cast<std::size_t>(patch.F.rows()),
                                static_cast<int>(i));
        }
        progress.report(static_cast<double>(i + 1) / static_cast<double>(holes.size()));
    }
    return patched;
}

}  // namespace toile
