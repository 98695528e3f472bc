// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/garment_surface.h"

#include <algorithm>
#include <cmath>

#include "core/quality/measures.h"

namespace toile::symmetry {
namespace {

/// Appends the arrays of all pieces.
void appendPieces(const Pieces& pieces, GarmentSurface& surface) {
    Eigen::Index vertices = 0, faces = 0;
    for (const auto& piece : pieces) {
        vertices += piece->mesh.V.rows();
        faces += piece->mesh.F.rows();
    }
    surface.mesh.V.resize(vertices, 3);
    surface.mesh.F.resize(faces, 3);
    Eigen::Index v = 0, f = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const MeshArrays& mesh = pieces[p]->mesh;
        surface.mesh.V.middleRows(v, mesh.V.rows()) = mesh.V;
        surface.mesh.F.middleRows(f, mesh.F.rows()) = mesh.F.array() + static_cast<int>(v);
        v += mesh.V.rows();
        f += mesh.F.rows();
        surface.pieceOfVertex.resize(static_cast<std::size_t>(v), static_cast<int>(p));
        surface.pieceOfFace.resize(static_cast<std::size_t>(f), static_cast<int>(p));
    }
}

void weigh(GarmentSurface& surface) {
    const MeshArrays& mesh = surface.mesh;
    const Eigen::VectorXd areas = triangleAreas3d(mesh);
    surface.area = Eigen::VectorXd::Zero(mesh.V.rows());
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            surface.area[mesh.F(f, k)] += areas[f] / 3;
        }
    }
    const double sum = surface.area.sum();
    if (!(sum > 0)) {
        return;
    }
    surface.centre = mesh.V.transpose() * surface.area / sum;
    const Points3 centred = mesh.V.rowwise() - surface.centre.transpose();
    surface.spread = centred.transpose() * surface.area.asDiagonal() * centred / sum;
}

}  // namespace

double GarmentSurface::radius() const {
    return std::sqrt(spread.trace());
}

std::vector<int> GarmentSurface::sampled(int most) const {
    const auto count = static_cast<int>(mesh.V.rows());
    const int step = std::max(1, (count + most - 1) / most);
    std::vector<int> vertices;
    for (int v = 0; v < count; v += step) {
        vertices.push_back(v);
    }
    return vertices;
}

GarmentSurface surfaceOf(const Pieces& pieces) {
    GarmentSurface surface;
    appendPieces(pieces, surface);
    weigh(surface);
    return surface;
}

}  // namespace toile::symmetry
