// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/bench_meshes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>

namespace toile::bench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kJitter = 0.2;
constexpr unsigned kSeed = 20051;

/// Moves of points and choices of diagonals.
class Unevenness {
public:
    /// Zero at the ends of the range, so that outlines stay where they are.
    double of(int index, int last) {
        const double offset = kJitter * uniform_(random_);
        return index == 0 || index == last ? index : index + offset;
    }
    bool turned() { return uniform_(random_) > 0; }

private:
    std::mt19937 random_{kSeed};
    std::uniform_real_distribution<double> uniform_{-1, 1};
};

/// Two triangles for each cell of a grid of vertex numbers, row by row.
void appendCells(const std::vector<int>& vertex, int columns, int rows, Unevenness& uneven,
                 std::vector<std::array<int, 3>>& faces) {
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int a = vertex[row * (columns + 1) + column];
            const int b = vertex[row * (columns + 1) + column + 1];
            const int c = vertex[(row + 1) * (columns + 1) + column + 1];
            const int d = vertex[(row + 1) * (columns + 1) + column];
            if (uneven.turned()) {
                faces.push_back({a, b, c});
                faces.push_back({a, c, d});
            } else {
                faces.push_back({a, b, d});
                faces.push_back({b, c, d});
            }
        }
    }
}

MeshArrays meshOf(const std::vector<Vector3d>& points,
                  const std::vector<std::array<int, 3>>& faces) {
    MeshArrays mesh{Points3(points.size(), 3), Triangles(faces.size(), 3)};
    for (std::size_t v = 0; v < points.size(); ++v) {
        mesh.V.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            mesh.F(static_cast<Eigen::Index>(f), k) = faces[f][k];
        }
    }
    return mesh;
}

double bump(double x, double y, double width) {
    return std::exp(-(x * x + y * y) / (width * width));
}

/// x in [-1, 1] across, y in [0, 1] from hem to shoulder.
Vector3d onShirt(double x, double y) {
    const double half = 250 - 40 * std::sin(std::numbers::pi * std::min(1.4 * y, 1.0)) -
                        60 * std::max(0.0, y - 0.7) / 0.3;
    const double neck = 90 * std::exp(-8 * x * x) * std::max(0.0, y - 0.6) / 0.4;
    const double height = 680 * y - neck;
    const double turn = 1.1 * x;  // round the body
    const double folds = 9 * std::sin(17 * x + 3 * y) * (1 - y) + 4 * std::sin(41 * x - 9 * y);
    const double bust =
        45 * (bump(x - 0.42, 2.2 * (y - 0.62), 0.3) + bump(x + 0.42, 2.2 * (y - 0.62), 0.3));
    const double depth = 150 + folds + bust - 25 * std::sin(std::numbers::pi * y);
    return {half * std::sin(turn), height, depth * std::cos(turn)};
}

/// From a direction on the sphere, y up, to the head. What lies below is drawn out to the neck.
Vector3d onHead(Vector3d n) {
    n.normalize();
    double radius = 100;
    const auto grow = [&](const Vector3d& at, double width, double height) {
        radius += height * std::exp(-(n - at.normalized()).squaredNorm() / (width * width));
    };
    grow({0.45, 0.9, 0.25}, 0.2, 75);    // horns
    grow({-0.45, 0.9, 0.25}, 0.2, 75);   //
    grow({0, -0.05, 1}, 0.16, 28);       // nose
    grow({1, 0, -0.1}, 0.2, 35);         // ears
    grow({-1, 0, -0.1}, 0.2, 35);        //
    grow({0.35, 0.2, 0.9}, 0.18, -14);   // eyes
    grow({-0.35, 0.2, 0.9}, 0.18, -14);  //
    const double round = std::atan2(n.x(), n.z());
    const double back = std::max(0.0, -n.z());
    radius += 7 * back * std::sin(26 * round + 9 * n.y());  // hair
    return radius * n;
}

}  // namespace

MeshArrays panelMesh(int triangles) {
    const int columns =
        std::max(2, static_cast<int>(std::lround(std::sqrt(0.5 * triangles / 1.3))));
    const int rows = std::max(2, static_cast<int>(std::lround(0.5 * triangles / columns)));
    Unevenness uneven;
    std::vector<Vector3d> points;
    std::vector<int> grid;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            grid.push_back(static_cast<int>(points.size()));
            const double x = uneven.of(column, columns) / columns;
            const double y = uneven.of(row, rows) / rows;
            points.push_back(onShirt(2 * x - 1, y));
        }
    }
    std::vector<std::array<int, 3>> faces;
    appendCells(grid, columns, rows, uneven, faces);
    return meshOf(points, faces);
}

// Five sides of a cube blown up to a sphere: front, right, back, left in one band, with the neck's
// opening below, and the top.
MeshArrays headMesh(int triangles) {
    const int n = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / 12.0))));
    const int high = n + n / 4;  // the band goes on below, towards the neck
    Unevenness uneven;
    std::vector<Vector3d> points;
    const auto pointOn = [&](double round, double up) {
        // `round` in [0, 4): position along the four sides; `up` from 1 at the top to below -1.
        const int side = static_cast<int>(std::floor(round)) % 4;
        const double s = std::tan(0.5 * std::numbers::pi * (round - std::floor(round) - 0.5));
        Vector3d p(s, std::tan(0.25 * std::numbers::pi * std::max(up, -1.0)), 1);
        if (up < -1) {
            const double in = 1 - 0.7 * (-1 - up);  // the side turns under
            p = {s * in, -1, in};
        }
        const double quarter = 0.5 * std::numbers::pi * side;
        return Eigen::AngleAxisd(quarter, Vector3d::UnitY()) * p;
    };
    std::vector<int> band;
    for (int row = 0; row <= high; ++row) {
        const int first = static_cast<int>(points.size());
        for (int column = 0; column < 4 * n; ++column) {
            band.push_back(static_cast<int>(points.size()));
            const bool edge = row == 0 || row == high || column % n == 0;
            const double x = edge ? column : uneven.of(column, 4 * n);
            const double y = edge ? row : uneven.of(row, high);
            const double up = 1 - 2.0 * (high - y) / n;
            points.push_back(onHead(pointOn(x / n, up)));
        }
        band.push_back(first);
    }
    std::vector<std::array<int, 3>> faces;
    appendCells(band, 4 * n, high, uneven, faces);

    // The top's rim is the band's last row, in the order front, right, back, left.
    const int* rim = &band[static_cast<std::size_t>(high) * (4 * n + 1)];
    std::vector<int> top;
    for (int row = 0; row <= n; ++row) {
        for (int column = 0; column <= n; ++column) {
            if (row == 0) {
                top.push_back(rim[column]);
            } else if (column == n) {
                top.push_back(rim[n + row]);
            } else if (row == n) {
                top.push_back(rim[3 * n - column]);
            } else if (column == 0) {
                top.push_back(rim[4 * n - row]);
            } else {
                const auto bent = [&](double k) {
                    return std::tan(0.5 * std::numbers::pi * (k / n - 0.5));
                };
                top.push_back(static_cast<int>(points.size()));
                points.push_back(onHead({bent(uneven.of(column, n)), 1, -bent(uneven.of(row, n))}));
            }
        }
    }
    appendCells(top, n, n, uneven, faces);
    return meshOf(points, faces);
}

}  // namespace toile::bench
