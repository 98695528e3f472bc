// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/flat_trouble.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "tests/core/support/generator.h"

namespace toile::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// What is left open between the two ends of a flounce, seen along its axis.
constexpr double kFlounceGap = 10 * kDegree;

/// Directions of the rulings: once around the axis, `height` radians up and down.
Points3 wavyDirections(int around, int waves, double height) {
    Points3 directions(around + 1, 3);
    for (int i = 0; i <= around; ++i) {
        const double along = static_cast<double>(i) / around;
        const double longitude = (2 * std::numbers::pi - kFlounceGap) * along;
        const double latitude = height * std::sin(2 * std::numbers::pi * waves * along);
        directions.row(i) << std::cos(latitude) * std::cos(longitude), std::sin(latitude),
            -std::cos(latitude) * std::sin(longitude);
    }
    return directions;
}

double anglesBetween(const Points3& directions) {
    double sum = 0;
    for (int i = 0; i + 1 < directions.rows(); ++i) {
        sum += 2 * std::asin(0.5 * (directions.row(i + 1) - directions.row(i)).norm());
    }
    return sum;
}

/// Two triangles for each square of a grid of `columns` squares a row: `vertex` names the vertex at
/// a column and a row, `falling` says which diagonal to take.
template <class Vertex, class Falling>
Triangles halvedSquares(int columns, int rows, const Vertex& vertex, const Falling& falling) {
    Triangles F(2 * columns * rows, 3);
    int f = 0;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const int a = vertex(c, r);
            const int b = vertex(c + 1, r);
            const int d = vertex(c + 1, r + 1);
            const int e = vertex(c, r + 1);
            if (falling(c, r)) {
                F.row(f++) << a, b, e;
                F.row(f++) << b, d, e;
            } else {
                F.row(f++) << a, b, d;
                F.row(f++) << a, d, e;
            }
        }
    }
    return F;
}

}  // namespace

MeshArrays saddleWithSlit(int side, double size, double bend) {
    const int middle = side / 2;
    const int across = side + 1;
    MeshArrays mesh;
    mesh.V.resize(across * across + middle, 3);
    const auto place = [&](int c, int r) {
        const double x = size * (static_cast<double>(c) / side - 0.5);
        const double y = size * (static_cast<double>(r) / side - 0.5);
        return Eigen::RowVector3d(x, y, bend * (x * x - y * y) / size);
    };
    for (int r = 0; r <= side; ++r) {
        for (int c = 0; c <= side; ++c) {
            mesh.V.row(r * across + c) = place(c, r);
        }
    }
    for (int r = 0; r < middle; ++r) {  // the slit's right side
        mesh.V.row(across * across + r) = place(middle, r);
    }
    mesh.F.resize(2 * side * side, 3);
    // Diagonals mirror each other left and right of the slit.
    int f = 0;
    for (const bool right : {false, true}) {
        const auto vertex = [&](int c, int r) {
            const int column = right ? middle + c : c;
            return right && c == 0 && r < middle ? across * across + r : r * across + column;
        };
        const Triangles half = halvedSquares(middle, side, vertex, [&](int, int) { return right; });
        mesh.F.middleRows(f, half.rows()) = half;
        f += static_cast<int>(half.rows());
    }
    return mesh;
}

MeshArrays flounce(double turnDegrees, double inner, double outer, int around, int across,
                   int waves) {
    double low = 0;
    double high = 0.45 * std::numbers::pi;
    for (int k = 0; k < 100; ++k) {  // the waves' height that makes the cone's angle
        const double middle = 0.5 * (low + high);
        const bool enough =
            anglesBetween(wavyDirections(around, waves, middle)) > turnDegrees * kDegree;
        (enough ? high : low) = middle;
    }
    const Points3 directions = wavyDirections(around, waves, 0.5 * (low + high));
    MeshArrays mesh{Points3((around + 1) * (across + 1), 3), {}};
    const auto vertex = [&](int c, int r) { return r * (around + 1) + c; };
    for (int r = 0; r <= across; ++r) {
        for (int c = 0; c <= around; ++c) {
            mesh.V.row(vertex(c, r)) = (outer + (inner - outer) * r / across) * directions.row(c);
        }
    }
    mesh.F = halvedSquares(around, across, vertex, [](int c, int r) { return (c + r) % 2 == 0; });
    return mesh;
}

MeshArrays sliverGrid(int columns, int rows, double size, unsigned seed) {
    Generator random(seed);
    MeshArrays mesh{Points3((columns + 1) * (rows + 1), 3), {}};
    const auto vertex = [&](int c, int r) { return r * (columns + 1) + c; };
    double y = 0;
    for (int r = 0; r <= rows; ++r) {
        for (int c = 0; c <= columns; ++c) {
            const double x = size * c;
            mesh.V.row(vertex(c, r)) << x, y,
                0.4 * size * (std::sin(1.3 * c) + std::cos(0.8 * y / size));
        }
        y += r % 2 == 0 ? size : 1e-3 * size;
    }
    mesh.F = halvedSquares(columns, rows, vertex, [&](int, int) { return random.chance(0.5); });
    return mesh;
}

}  // namespace toile::test
