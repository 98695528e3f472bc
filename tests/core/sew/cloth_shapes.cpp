// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/sew/cloth_shapes.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace toile::test {
namespace {

using Corner =
    std::function<void(int column, int row, Eigen::RowVector2d& q, Eigen::RowVector3d& x)>;

/// Adds a grid of squares that are cut by one diagonal.
void addGrid(sew::CutCloth& cut, int columns, int rows, const Corner& corner) {
    const auto firstPoint = static_cast<int>(cut.Q.rows());
    const auto firstFace = static_cast<int>(cut.F.rows());
    const int piece = cut.pieceOf.empty() ? 0 : cut.pieceOf.back() + 1;
    const int points = (columns + 1) * (rows + 1);
    cut.Q.conservativeResize(firstPoint + points, 2);
    cut.V.conservativeResize(firstPoint + points, 3);
    cut.F.conservativeResize(firstFace + 2 * columns * rows, 3);
    for (int i = 0; i <= columns; ++i) {
        for (int j = 0; j <= rows; ++j) {
            Eigen::RowVector2d q;
            Eigen::RowVector3d x;
            corner(i, j, q, x);
            cut.Q.row(firstPoint + i * (rows + 1) + j) = q;
            cut.V.row(firstPoint + i * (rows + 1) + j) = x;
        }
    }
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const int a = firstPoint + i * (rows + 1) + j, b = a + rows + 1;
            const int f = firstFace + 2 * (i * rows + j);
            cut.F.row(f) << a, b, b + 1;
            cut.F.row(f + 1) << a, b + 1, a + 1;
            cut.pieceOf.insert(cut.pieceOf.end(), 2, piece);
        }
    }
}

void sewSides(sew::CutCloth& cut, int columns, int rows) {
    for (int j = 0; j <= rows; ++j) {
        cut.sewn.emplace_back(j, columns * (rows + 1) + j);
    }
}

}  // namespace

sew::CutCloth flatCloth(int columns, int rows, double size) {
    sew::CutCloth cut;
    addGrid(cut, columns, rows, [&](int i, int j, Eigen::RowVector2d& q, Eigen::RowVector3d& x) {
        q << i * size, j * size;
        x << q, 0;
    });
    return cut;
}

sew::CutCloth tubeCloth(int columns, int rows, double radius, double height) {
    sew::CutCloth cut;
    const double turn = 2 * std::numbers::pi / columns;
    addGrid(cut, columns, rows, [&](int i, int j, Eigen::RowVector2d& q, Eigen::RowVector3d& x) {
        q << i * 2 * radius * std::sin(turn / 2), height * j / rows;
        x << radius * std::sin(i * turn), q[1], radius * std::cos(i * turn);
    });
    sewSides(cut, columns, rows);
    return cut;
}

sew::CutCloth coneCloth(int columns, int rows, double inner, double outer, double slope) {
    sew::CutCloth cut;
    const double turn = 2 * std::numbers::pi / columns;
    // Between two of the slanted edges, whose ends are 2 sin(slope) sin(turn / 2) apart.
    const double flatTurn = 2 * std::asin(std::sin(slope) * std::sin(turn / 2));
    addGrid(cut, columns, rows, [&](int i, int j, Eigen::RowVector2d& q, Eigen::RowVector3d& x) {
        const double along = outer + (inner - outer) * j / rows;
        q << along * std::sin(i * flatTurn), -along * std::cos(i * flatTurn);
        x << along * std::sin(slope) * std::sin(i * turn), -along * std::cos(slope),
            along * std::sin(slope) * std::cos(i * turn);
    });
    sewSides(cut, columns, rows);
    return cut;
}

sew::CutCloth cubeCloth(int side, double size) {
    sew::CutCloth cut;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
            addGrid(cut, side, side,
                    [&](int i, int j, Eigen::RowVector2d& q, Eigen::RowVector3d& x) {
                        q << i * size / side, j * size / side;
                        x[axis] = sign * size / 2;
                        x[(axis + 1) % 3] = sign * (q[0] - size / 2);
                        x[(axis + 2) % 3] = q[1] - size / 2;
                    });
        }
    }
    for (int a = 0; a < static_cast<int>(cut.V.rows()); ++a) {
        for (int b = 0; b < a; ++b) {
            if ((cut.V.row(a) - cut.V.row(b)).norm() < 1e-6 * size) {
                cut.sewn.emplace_back(a, b);
            }
        }
    }
    return cut;
}

Points3 shaken(const Points3& X, double far, unsigned seed) {
    std::mt19937 random(seed);
    Points3 moved = X;
    for (Eigen::Index i = 0; i < moved.size(); ++i) {
        const double share = static_cast<double>(random() % 20001) / 10000 - 1;
        moved.data()[i] += far / std::sqrt(3.0) * share;
    }
    return moved;
}

}  // namespace toile::test
