// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/garments.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <utility>

#include "core/base/id.h"
#include "core/seam/find_seams.h"

namespace toile::test {

namespace {

/// Triangles of a grid of (columns + 1) x (rows + 1) vertices, row by row.
Triangles gridTriangles(int columns, int rows) {
    Triangles F(2 * columns * rows, 3);
    int face = 0;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const int a = r * (columns + 1) + c, b = a + 1;
            const int d = a + columns + 1, e = d + 1;
            F.row(face++) << a, b, e;
            F.row(face++) << a, e, d;
        }
    }
    return F;
}

template <class Map>
MeshArrays makeGrid(int columns, int rows, const Map& map) {
    MeshArrays mesh;
    mesh.F = gridTriangles(columns, rows);
    mesh.V.resize((columns + 1) * (rows + 1), 3);
    for (int r = 0; r <= rows; ++r) {
        for (int c = 0; c <= columns; ++c) {
            mesh.V.row(r * (columns + 1) + c) =
                map(c / double(columns), r / double(rows)).transpose();
        }
    }
    return mesh;
}

}  // namespace

MeshArrays makeSheet(double width, double height, int columns, int rows,
                     const Eigen::Vector3d& corner) {
    return makeGrid(columns, rows, [&](double u, double v) -> Eigen::Vector3d {
        return corner + Eigen::Vector3d(u * width, v * height, 0);
    });
}

MeshArrays makeBentStrip(double x) {
    constexpr double kRadius = 100, kArc = 200, kHeight = 150;
    return makeGrid(20, 15, [&](double u, double v) -> Eigen::Vector3d {
        const double angle = (u - 0.5) * kArc / kRadius;
        return {x + kRadius * std::sin(angle), v * kHeight, kRadius * std::cos(angle)};
    });
}

MeshArrays makeCap(double x) {
    return makeCapPart(x, 0, 1, 16);
}

MeshArrays makeCapPart(double x, double from, double to, int columns) {
    constexpr double kRadius = 100, kOpening = std::numbers::pi / 3;
    return makeGrid(columns, 16, [&](double u, double v) -> Eigen::Vector3d {
        const double across = (2 * (from + u * (to - from)) - 1) * kOpening;
        const double along = (2 * v - 1) * kOpening;
        const Eigen::Vector3d direction(std::tan(across), std::tan(along), 1);
        return Eigen::Vector3d(x, 75, 0) + kRadius * direction.normalized();
    });
}

std::vector<std::pair<std::string, MeshArrays>> sewnCapParts() {
    MeshArrays narrow = makeCapPart(0, 0, 0.25, 4), wide = makeCapPart(0, 0.25, 1, 12);
    narrow.V *= 2;
    wide.V *= 2;
    return {{"narrow", narrow}, {"wide", wide}};
}

std::shared_ptr<const Garment> makeSewnCap() {
    auto garment = std::make_shared<Garment>(*makeGarment(sewnCapParts()));
    garment->seams = findSeams(garment->pieces);
    return garment;
}

MeshArrays makeTetrahedron(double size) {
    MeshArrays mesh;
    mesh.V.resize(4, 3);
    mesh.V << 0, 0, 0, size, 0, 0, 0, size, 0, 0, 0, size;
    mesh.F.resize(4, 3);
    mesh.F << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
    return mesh;
}

std::shared_ptr<const Garment> makeGarment(std::vector<std::pair<std::string, MeshArrays>> pieces) {
    auto garment = std::make_shared<Garment>();
    auto file = std::make_shared<SourceFile>();
    file->path = "garment.obj";
    garment->files.push_back(file);
    for (auto& [name, mesh] : pieces) {
        auto piece = std::make_shared<Piece>(makePiece(name, std::move(mesh)));
        piece->id.value = contentHash(name);
        piece->lineage = {{piece->id}, {}};
        piece->origins = rimOrigins(*piece, UpAxis::Y);
        garment->pieces.push_back(std::move(piece));
    }
    return garment;
}

void writeObj(const std::filesystem::path& path,
              const std::vector<std::pair<std::string, MeshArrays>>& pieces) {
    std::ofstream out(path);
    out.precision(12);
    Eigen::Index first = 1;
    for (const auto& [name, mesh] : pieces) {
        out << "o " << name << '\n';
        for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
            out << "v " << mesh.V(v, 0) << ' ' << mesh.V(v, 1) << ' ' << mesh.V(v, 2) << '\n';
        }
        for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
            out << "f " << mesh.F(f, 0) + first << ' ' << mesh.F(f, 1) + first << ' '
                << mesh.F(f, 2) + first << '\n';
        }
        first += mesh.V.rows();
    }
}

}  // namespace toile::test
