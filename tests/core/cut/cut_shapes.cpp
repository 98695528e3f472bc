// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/cut/cut_shapes.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "tests/core/support/shapes.h"

namespace toile::test {

MeshArrays voxelSurface(const std::set<Cell>& cells, double side) {
    std::map<Cell, int> index;
    std::vector<Cell> corners;
    std::vector<std::array<int, 3>> faces;
    const auto vertex = [&](const Cell& p) {
        const auto [it, isNew] = index.emplace(p, static_cast<int>(corners.size()));
        if (isNew) {
            corners.push_back(p);
        }
        return it->second;
    };
    for (const Cell& cell : cells) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int end : {0, 1}) {
                Cell beyond = cell;
                beyond[axis] += 2 * end - 1;
                if (cells.contains(beyond)) {
                    continue;
                }
                const auto at = [&](int i, int j) {
                    Cell p = cell;
                    p[axis] += end;
                    p[(axis + 1) % 3] += i;
                    p[(axis + 2) % 3] += j;
                    return vertex(p);
                };
                std::array<int, 4> q{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
                if (end == 0) {
                    std::swap(q[1], q[3]);
                }
                faces.push_back({q[0], q[1], q[2]});
                faces.push_back({q[0], q[2], q[3]});
            }
        }
    }
    MeshArrays mesh{Points3(static_cast<int>(corners.size()), 3),
                    Triangles(static_cast<int>(faces.size()), 3)};
    for (std::size_t v = 0; v < corners.size(); ++v) {
        mesh.V.row(static_cast<int>(v)) =
            side * Eigen::RowVector3d(corners[v][0], corners[v][1], corners[v][2]);
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
        mesh.F.row(static_cast<int>(f)) << faces[f][0], faces[f][1], faces[f][2];
    }
    return mesh;
}

MeshArrays closedBox(int n, double side) {
    std::set<Cell> cells;
    for (int c = 0; c < n * n * n; ++c) {
        cells.insert({c % n, c / n % n, c / n / n});
    }
    return voxelSurface(cells, side / n);
}

MeshArrays openBox(int n, double side) {
    const MeshArrays mesh = closedBox(n, side);
    return without(mesh, [&mesh](int f) {
        return mesh.V(mesh.F(f, 0), 2) + mesh.V(mesh.F(f, 1), 2) + mesh.V(mesh.F(f, 2), 2) == 0;
    });
}

MeshArrays closedTorus(int around, int across) {
    MeshArrays mesh = piercedTorus(around, across);
    const int f = static_cast<int>(mesh.F.rows());
    mesh.F.conservativeResize(f + 1, 3);
    const int i = around - 1;
    const int j = across - 1;
    mesh.F.row(f) << i * across + j, 0, i * across;
    return mesh;
}

MeshArrays revolution(const std::vector<Eigen::Vector2d>& profile, int around) {
    const int rows = static_cast<int>(profile.size());
    MeshArrays mesh{Points3(rows * around, 3), Triangles(2 * (rows - 1) * around, 3)};
    for (int v = 0; v < rows * around; ++v) {
        const double angle = 2 * std::numbers::pi * (v % around) / around;
        const Eigen::Vector2d& p = profile[v / around];
        mesh.V.row(v) << p.x() * std::cos(angle), p.y(), p.x() * std::sin(angle);
    }
    for (int q = 0; q < (rows - 1) * around; ++q) {
        const int next = q / around * around + (q + 1) % around;
        mesh.F.row(2 * q) << q, q + around, next;
        mesh.F.row(2 * q + 1) << next, q + around, next + around;
    }
    return mesh;
}

MeshArrays sphere(int rings) {
    const int around = 2 * rings;
    MeshArrays mesh{Points3((rings - 1) * around + 2, 3), Triangles(2 * around * (rings - 1), 3)};
    mesh.V.row(0) << 0, 0, 50;
    mesh.V.row(mesh.V.rows() - 1) << 0, 0, -50;
    const auto at = [&](int ring, int k) {
        return ring == 0       ? 0
               : ring == rings ? static_cast<int>(mesh.V.rows()) - 1
                               : 1 + (ring - 1) * around + k % around;
    };
    int f = 0;
    for (int r = 0; r < rings; ++r) {
        for (int k = 0; k < around; ++k) {
            if (r > 0) {
                const double tilt = std::numbers::pi * r / rings;
                const double phi = 2 * std::numbers::pi * k / around;
                mesh.V.row(at(r, k)) << 50 * std::sin(tilt) * std::cos(phi),
                    50 * std::sin(tilt) * std::sin(phi), 50 * std::cos(tilt);
                mesh.F.row(f++) << at(r, k), at(r + 1, k + 1), at(r, k + 1);
            }
            if (r + 1 < rings) {
                mesh.F.row(f++) << at(r, k), at(r + 1, k), at(r + 1, k + 1);
            }
        }
    }
    return mesh;
}

MeshArrays without(const MeshArrays& mesh, const std::function<bool(int face)>& isOut) {
    MeshArrays rest{Points3(0, 3), Triangles(0, 3)};
    std::vector<int> newIndex(mesh.V.rows(), -1);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        if (isOut(f)) {
            continue;
        }
        rest.F.conservativeResize(rest.F.rows() + 1, 3);
        for (int k = 0; k < 3; ++k) {
            int& v = newIndex[mesh.F(f, k)];
            if (v < 0) {
                v = static_cast<int>(rest.V.rows());
                rest.V.conservativeResize(v + 1, 3);
                rest.V.row(v) = mesh.V.row(mesh.F(f, k));
            }
            rest.F(rest.F.rows() - 1, k) = v;
        }
    }
    return rest;
}

}  // namespace toile::test
