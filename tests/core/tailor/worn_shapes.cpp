// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/tailor/worn_shapes.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "tests/core/support/shapes.h"

namespace toile::test {
namespace {

constexpr double kSquare = 20, kBulge = 80, kBulgeWithin = 120;

using Corner = std::pair<int, int>;
/// Whether there is cloth in a square, by its lower left corner, of the front or the back.
using Cloth = std::function<bool(bool isFront, int column, int row)>;
/// Whether an edge of the outline is at an opening, by its middle in squares.
using Opening = std::function<bool(double column, double row)>;

class TwoSheets {
public:
    TwoSheets(Cloth cloth, Opening opening)
        : cloth_(std::move(cloth)), opening_(std::move(opening)) {}

    MeshArrays make() {
        for (const bool isFront : {true, false}) {
            collect(isFront);
        }
        for (const bool isFront : {true, false}) {
            addSheet(isFront);
        }
        MeshArrays mesh{Points3(std::ssize(points_), 3), Triangles(std::ssize(faces_), 3)};
        for (std::size_t v = 0; v < points_.size(); ++v) {
            mesh.V.row(static_cast<Eigen::Index>(v)) = points_[v];
        }
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            mesh.F.row(static_cast<Eigen::Index>(f)) << faces_[f][0], faces_[f][1], faces_[f][2];
        }
        return mesh;
    }

private:
    static constexpr int kMost = 60;  // squares, each way

    void collect(bool isFront) {
        for (int i = -kMost; i < kMost; ++i) {
            for (int j = 0; j < kMost; ++j) {
                if (!cloth_(isFront, i, j)) {
                    continue;
                }
                const std::pair<Corner, std::pair<Corner, Corner>> sides[] = {
                    {{i, j - 1}, {{i, j}, {i + 1, j}}},
                    {{i, j + 1}, {{i, j + 1}, {i + 1, j + 1}}},
                    {{i - 1, j}, {{i, j}, {i, j + 1}}},
                    {{i + 1, j}, {{i + 1, j}, {i + 1, j + 1}}}};
                for (const auto& [beside, edge] : sides) {
                    const auto& [a, b] = edge;
                    if (!cloth_(isFront, beside.first, beside.second) &&
                        !opening_((a.first + b.first) / 2.0, (a.second + b.second) / 2.0)) {
                        seam_.insert(a);
                        seam_.insert(b);
                    }
                }
            }
        }
    }

    int vertex(bool isFront, Corner at) {
        const bool isShared = seam_.contains(at);
        const auto [found, isNew] =
            number_.try_emplace({isShared || isFront, at}, static_cast<int>(points_.size()));
        if (isNew) {
            double distance = std::numeric_limits<double>::infinity();
            for (const Corner& seam : seam_) {
                distance = std::min(
                    distance, kSquare * std::hypot(at.first - seam.first, at.second - seam.second));
            }
            const double share = std::min(distance / kBulgeWithin, 1.0);
            const double deep = kBulge * std::sin(share * std::numbers::pi / 2);
            points_.emplace_back(kSquare * at.first, kSquare * at.second, isFront ? deep : -deep);
        }
        return found->second;
    }

    void addSheet(bool isFront) {
        for (int i = -kMost; i < kMost; ++i) {
            for (int j = 0; j < kMost; ++j) {
                if (!cloth_(isFront, i, j)) {
                    continue;
                }
                const std::array square{vertex(isFront, {i, j}), vertex(isFront, {i + 1, j}),
                                        vertex(isFront, {i + 1, j + 1}),
                                        vertex(isFront, {i, j + 1})};
                const bool isLeft = i < 0;  // diagonals are mirror images, too
                const std::array<std::array<int, 3>, 2> halves =
                    isLeft ? std::array<std::array<int, 3>, 2>{{{0, 1, 2}, {0, 2, 3}}}
                           : std::array<std::array<int, 3>, 2>{{{0, 1, 3}, {1, 2, 3}}};
                for (const auto& [a, b, c] : halves) {
                    faces_.push_back(isFront ? std::array{square[a], square[b], square[c]}
                                             : std::array{square[a], square[c], square[b]});
                }
            }
        }
    }

    const Cloth cloth_;
    const Opening opening_;
    std::set<Corner> seam_;  ///< where front and back hang together
    std::map<std::pair<bool, Corner>, int> number_;
    std::vector<Eigen::RowVector3d> points_;
    std::vector<std::array<int, 3>> faces_;
};

}  // namespace

MeshArrays wornShirt() {
    const auto isNeck = [](bool isFront, int i, int j) {
        return -4 <= i && i < 4 && j >= (isFront ? 26 : 29);
    };
    return TwoSheets(
               [isNeck](bool isFront, int i, int j) {
                   const bool isTrunk = -10 <= i && i < 10 && 0 <= j && j < 30;
                   const bool isSleeve = -18 <= i && i < 18 && 22 <= j && j < 30;
                   return (isTrunk || isSleeve) && !isNeck(isFront, i, j);
               },
               [](double i, double j) {
                   return j == 0 || std::abs(i) == 18 || (std::abs(i) <= 4 && j >= 26);
               })
        .make();
}

MeshArrays wornTrousers() {
    return TwoSheets(
               [](bool isFront, int i, int j) {
                   const bool isTrunk = -10 <= i && i < 10 && 20 <= j && j < (isFront ? 39 : 40);
                   const bool isLeg =
                       ((-10 <= i && i < -1) || (1 <= i && i < 10)) && 0 <= j && j < 20;
                   return isTrunk || isLeg;
               },
               [](double, double j) { return j == 0 || j >= 39; })
        .make();
}

MeshArrays wornSkirt(int around, int along) {
    MeshArrays mesh{Points3(around * (along + 1), 3), Triangles(2 * around * along, 3)};
    for (int j = 0; j <= along; ++j) {
        const double radius = 350 - 200.0 * j / along;
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            mesh.V.row(around * j + i) << radius * std::cos(angle), 600.0 * j / along,
                -0.6 * radius * std::sin(angle);
        }
    }
    for (int j = 0, f = 0; j < along; ++j) {
        for (int i = 0; i < around; ++i) {
            const int a = around * j + i, b = around * j + (i + 1) % around;
            mesh.F.row(f++) << a, b, b + around;
            mesh.F.row(f++) << a, b + around, a + around;
        }
    }
    return mesh;
}

std::shared_ptr<const Piece> wornPiece(MeshArrays mesh) {
    auto piece = std::make_shared<Piece>(*asPiece(std::move(mesh)));
    piece->sourceVertex.resize(static_cast<std::size_t>(piece->mesh.V.rows()));
    piece->sourceFace.resize(static_cast<std::size_t>(piece->mesh.F.rows()));
    std::iota(piece->sourceVertex.begin(), piece->sourceVertex.end(), 0);
    std::iota(piece->sourceFace.begin(), piece->sourceFace.end(), 0);
    return piece;
}

}  // namespace toile::test
