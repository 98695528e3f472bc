// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/shapes.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include <Eigen/SVD>

#include "core/base/id.h"
#include "core/geometry/disjoint_sets.h"

namespace toile::test {
namespace {

/// Triangles of a grid of (columns + 1) x (rows + 1) vertices, row by row; anti-clockwise where
/// columns run to the right and rows up.
Triangles gridTriangles(int columns, int rows) {
    Triangles F(2 * columns * rows, 3);
    int f = 0;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const int a = r * (columns + 1) + c;
            const int b = a + columns + 1;
            F.row(f++) << a, a + 1, b + 1;
            F.row(f++) << a, b + 1, b;
        }
    }
    return F;
}

MeshArrays gridSurface(int columns, int rows,
                       const std::function<Eigen::RowVector3d(double, double)>& at) {
    MeshArrays mesh{Points3((columns + 1) * (rows + 1), 3), gridTriangles(columns, rows)};
    for (int r = 0; r <= rows; ++r) {
        for (int c = 0; c <= columns; ++c) {
            mesh.V.row(r * (columns + 1) + c) =
                at(static_cast<double>(c) / columns, static_cast<double>(r) / rows);
        }
    }
    return mesh;
}

using Corner = std::array<int, 3>;
constexpr int kCubeSquares = 8;

/// A cube with integer corner coordinates 0 .. 8, opened along the given cube edges.
MeshArrays openedCube(const std::vector<std::pair<Corner, Corner>>& cuts) {
    constexpr int n = kCubeSquares;
    std::map<Corner, int> index;
    std::vector<Corner> points;
    const auto vertex = [&](const Corner& p) {
        const auto [it, isNew] = index.emplace(p, static_cast<int>(points.size()));
        if (isNew) {
            points.push_back(p);
        }
        return it->second;
    };
    std::vector<std::array<int, 3>> faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, n}) {
            const auto at = [&](int i, int j) {
                Corner p{};
                p[axis] = side;
                p[(axis + 1) % 3] = i;
                p[(axis + 2) % 3] = j;
                return vertex(p);
            };
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const std::array<int, 4> q{at(i, j), at(i + 1, j), at(i + 1, j + 1),
                                               at(i, j + 1)};
                    const int k = (i + j) % 2;  // the diagonals alternate
                    for (std::array<int, 3> t : {std::array{q[k], q[k + 1], q[k + 2]},
                                                 std::array{q[k], q[k + 2], q[(k + 3) % 4]}}) {
                        if (side == 0) {
                            std::swap(t[1], t[2]);  // the outside is on the other side
                        }
                        faces.push_back(t);
                    }
                }
            }
        }
    }

    std::set<std::pair<int, int>> cutEdges;
    for (const auto& [from, to] : cuts) {
        for (int k = 0; k < n; ++k) {
            Corner a{};
            Corner b{};
            for (int d = 0; d < 3; ++d) {
                a[d] = from[d] * n + (to[d] - from[d]) * k;
                b[d] = from[d] * n + (to[d] - from[d]) * (k + 1);
            }
            cutEdges.insert(std::minmax(index.at(a), index.at(b)));
        }
    }
    // Corners of faces stay one vertex only across edges that are not cut.
    geometry::DisjointSets corners(static_cast<int>(3 * faces.size()));
    std::map<std::pair<int, int>, std::array<int, 2>> seen;  // corners at the smaller, larger end
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int v = faces[f][k];
            const int w = faces[f][(k + 1) % 3];
            std::array<int, 2> here{3 * f + k, 3 * f + (k + 1) % 3};
            if (v > w) {
                std::swap(here[0], here[1]);
            }
            const auto [it, isFirst] = seen.emplace(std::minmax(v, w), here);
            if (!isFirst && !cutEdges.contains(std::minmax(v, w))) {
                corners.join(here[0], it->second[0]);
                corners.join(here[1], it->second[1]);
            }
        }
    }
    std::map<int, int> vertexOfRoot;
    MeshArrays mesh;
    mesh.F.resize(static_cast<int>(faces.size()), 3);
    std::vector<Eigen::RowVector3d> V;
    for (int c = 0; c < static_cast<int>(3 * faces.size()); ++c) {
        const auto [it, isNew] = vertexOfRoot.emplace(corners.root(c), static_cast<int>(V.size()));
        if (isNew) {
            const Corner& p = points[faces[c / 3][c % 3]];
            V.emplace_back(Eigen::RowVector3d(p[0], p[1], p[2]) / n);
        }
        mesh.F(c / 3, c % 3) = it->second;
    }
    mesh.V.resize(static_cast<int>(V.size()), 3);
    for (std::size_t v = 0; v < V.size(); ++v) {
        mesh.V.row(static_cast<int>(v)) = V[v];
    }
    return mesh;
}

}  // namespace

MeshArrays planeGrid(int columns, int rows, double size) {
    return gridSurface(columns, rows, [=](double s, double t) {
        return Eigen::RowVector3d(size * columns * s, size * rows * t, 0);
    });
}

MeshArrays bentPanel(int side) {
    MeshArrays mesh = planeGrid(side, side, 600.0 / side);
    for (auto vertex : mesh.V.rowwise()) {
        const double x = vertex.x() / 300 - 1;
        const double y = vertex.y() / 300 - 1;
        vertex.z() = 120 * std::exp(-2 * (x * x + y * y)) + 40 * x * y;
    }
    return mesh;
}

MeshArrays cylinderSector(int columns, int rows, double radius, double angle, double height) {
    return gridSurface(columns, rows, [=](double s, double t) {
        const double phi = angle * (s - 0.5);
        // The upper end slants, so that the outline is no rectangle.
        return Eigen::RowVector3d(radius * std::sin(phi), height * t * (1 + 0.4 * s),
                                  radius * std::cos(phi));
    });
}

MeshArrays coneSector(int columns, int rows, double inner, double outer, double openingAngle,
                      double slope) {
    return gridSurface(columns, rows, [=](double s, double t) {
        const double phi = openingAngle * (s - 0.5);
        const double along = inner + (outer - inner) * (1 - t);
        return Eigen::RowVector3d(along * std::sin(slope) * std::sin(phi), -along * std::cos(slope),
                                  along * std::sin(slope) * std::cos(phi));
    });
}

MeshArrays sphericalCap(int rings, double radius, double halfAngle) {
    std::vector<Eigen::RowVector3d> V{{0, radius, 0}};
    std::vector<std::array<int, 3>> F;
    const auto at = [](int ring, int step) {
        return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + step % (6 * ring);
    };
    for (int ring = 1; ring <= rings; ++ring) {
        const double tilt = halfAngle * ring / rings;
        for (int k = 0; k < 6 * ring; ++k) {
            const double phi = std::numbers::pi * k / (3.0 * ring);
            V.emplace_back(radius * std::sin(tilt) * std::sin(phi), radius * std::cos(tilt),
                           radius * std::sin(tilt) * std::cos(phi));
        }
        for (int sector = 0; sector < 6; ++sector) {
            for (int k = 0; k < ring; ++k) {
                const int outer = sector * ring + k;
                const int inner = sector * (ring - 1) + k;
                F.push_back({at(ring, outer), at(ring, outer + 1), at(ring - 1, inner)});
                if (k + 1 < ring) {
                    F.push_back(
                        {at(ring, outer + 1), at(ring - 1, inner + 1), at(ring - 1, inner)});
                }
            }
        }
    }
    MeshArrays mesh{Points3(static_cast<int>(V.size()), 3),
                    Triangles(static_cast<int>(F.size()), 3)};
    for (std::size_t v = 0; v < V.size(); ++v) {
        mesh.V.row(static_cast<int>(v)) = V[v];
    }
    for (std::size_t f = 0; f < F.size(); ++f) {
        mesh.F.row(static_cast<int>(f)) << F[f][0], F[f][1], F[f][2];
    }
    return mesh;
}

MeshArrays saddle(int side, double size, double bend) {
    return gridSurface(side, side, [=](double s, double t) {
        const double x = size * (s - 0.5);
        const double y = size * (t - 0.5);
        return Eigen::RowVector3d(x, y, bend * x * y / size);
    });
}

MeshArrays cubeOpenedAlongH() {
    return openedCube({{{0, 0, 0}, {1, 0, 0}},
                       {{0, 0, 0}, {0, 1, 0}},
                       {{0, 0, 0}, {0, 0, 1}},
                       {{1, 0, 0}, {1, 1, 0}},
                       {{1, 0, 0}, {1, 0, 1}}});
}

MeshArrays cubeSlitAlongOneEdge() {
    return openedCube({{{0, 0, 0}, {1, 0, 0}}});
}

MeshArrays moebiusStrip(int quads) {
    MeshArrays mesh{Points3(2 * quads, 3), Triangles(2 * quads, 3)};
    for (int k = 0; k < quads; ++k) {
        const double phi = 2 * std::numbers::pi * k / quads;
        for (int side = 0; side < 2; ++side) {
            const double w = side == 0 ? -10 : 10;
            const double r = 50 + w * std::cos(phi / 2);
            mesh.V.row(2 * k + side) << r * std::cos(phi), w * std::sin(phi / 2), r * std::sin(phi);
        }
        const bool last = k + 1 == quads;
        const int a = 2 * k;
        const int b = last ? 1 : 2 * k + 2;  // the half turn swaps the sides
        const int c = last ? 0 : 2 * k + 3;
        mesh.F.row(2 * k) << a, b, c;
        mesh.F.row(2 * k + 1) << a, c, a + 1;
    }
    return mesh;
}

MeshArrays tube(int around, int along) {
    MeshArrays mesh{Points3(around * (along + 1), 3), Triangles(2 * around * along, 3)};
    int f = 0;
    for (int r = 0; r <= along; ++r) {
        for (int k = 0; k < around; ++k) {
            const double phi = 2 * std::numbers::pi * k / around;
            mesh.V.row(r * around + k) << 50 * std::sin(phi), 20.0 * r, 50 * std::cos(phi);
            if (r < along) {
                const int a = r * around + k;
                const int b = r * around + (k + 1) % around;
                mesh.F.row(f++) << a, b, b + around;
                mesh.F.row(f++) << a, b + around, a + around;
            }
        }
    }
    return mesh;
}

MeshArrays octahedron() {
    MeshArrays mesh{Points3(6, 3), Triangles(8, 3)};
    mesh.V << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
    mesh.F << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
    return mesh;
}

MeshArrays piercedTorus(int around, int across) {
    MeshArrays mesh{Points3(around * across, 3), Triangles(2 * around * across - 1, 3)};
    int f = 0;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2 * std::numbers::pi * i / around;
            const double v = 2 * std::numbers::pi * j / across;
            const double r = 50 + 20 * std::cos(v);
            mesh.V.row(i * across + j) << r * std::cos(u), r * std::sin(u), 20 * std::sin(v);
            const int i1 = (i + 1) % around;
            const int j1 = (j + 1) % across;
            mesh.F.row(f++) << i * across + j, i1 * across + j, i1 * across + j1;
            if (f < mesh.F.rows()) {  // the last triangle is left out
                mesh.F.row(f++) << i * across + j, i1 * across + j1, i * across + j1;
            }
        }
    }
    return mesh;
}

MeshArrays part(const MeshArrays& mesh,
                const std::function<bool(const Eigen::RowVector3d& middle)>& inside) {
    MeshArrays part;
    std::vector<int> number(static_cast<std::size_t>(mesh.V.rows()), -1);
    part.V.resize(mesh.V.rows(), 3);
    part.F.resize(mesh.F.rows(), 3);
    int vertices = 0;
    Eigen::Index faces = 0;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
        for (int k = 0; k < 3; ++k) {
            middle += mesh.V.row(mesh.F(f, k)) / 3;
        }
        if (!inside(middle)) {
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            int& known = number[static_cast<std::size_t>(mesh.F(f, k))];
            if (known < 0) {
                known = vertices++;
                part.V.row(known) = mesh.V.row(mesh.F(f, k));
            }
            part.F(faces, k) = known;
        }
        ++faces;
    }
    part.V.conservativeResize(vertices, 3);
    part.F.conservativeResize(faces, 3);
    return part;
}

Renumbered renumber(const MeshArrays& mesh, unsigned seed) {
    std::mt19937 random(seed);
    const auto shuffled = [&](Eigen::Index count) {
        std::vector<int> order(static_cast<std::size_t>(count));
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t k = order.size(); k > 1; --k) {  // std::shuffle differs by library
            std::swap(order[k - 1], order[random() % k]);
        }
        return order;
    };
    Renumbered result{mesh, shuffled(mesh.V.rows())};
    const std::vector<int> newFace = shuffled(mesh.F.rows());
    for (int v = 0; v < mesh.V.rows(); ++v) {
        result.mesh.V.row(result.newIndex[v]) = mesh.V.row(v);
    }
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const int turn = static_cast<int>(random() % 3);
        for (int k = 0; k < 3; ++k) {
            result.mesh.F(newFace[f], k) = result.newIndex[mesh.F(f, (k + turn) % 3)];
        }
    }
    return result;
}

std::shared_ptr<const Piece> asPiece(MeshArrays mesh, const std::string& name) {
    auto piece = std::make_shared<Piece>(makePiece(name, std::move(mesh)));
    identify(*piece, contentHash(name));
    return piece;
}

void identify(Piece& piece, std::uint64_t id) {
    piece.id.value = id;
    piece.lineage = {{piece.id}, {}};
    piece.origins = rimOrigins(piece, UpAxis::Y);
}

double distanceAfterRigidMotion(const Points2& P, const Points2& Q) {
    const Eigen::RowVector2d p = P.colwise().mean();
    const Eigen::RowVector2d q = Q.colwise().mean();
    const Eigen::Matrix2d H = (P.rowwise() - p).transpose() * (Q.rowwise() - q);
    // The best rotation in the plane has a closed form: no reflection can slip in.
    const double angle = std::atan2(H(0, 1) - H(1, 0), H(0, 0) + H(1, 1));
    Eigen::Matrix2d R;
    R << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
    const Points2 moved = ((P.rowwise() - p) * R).rowwise() + q;
    return (moved - Q).rowwise().norm().maxCoeff();
}

}  // namespace toile::test
