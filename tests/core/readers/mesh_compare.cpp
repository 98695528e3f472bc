// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/mesh_compare.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace toile {
namespace {

/// The largest difference of two tables of points; none where they are of other sizes.
template <class Matrix>
std::optional<double> apart(const Matrix& is, const Matrix& should) {
    if (is.rows() != should.rows()) {
        return {};
    }
    return is.rows() == 0 ? 0 : (is - should).rowwise().norm().maxCoeff();
}

/// What single floats, as GLB has them, cost beyond 50 m from the origin: nobody cuts there.
template <class Matrix>
double farAllowance(const Matrix& points) {
    constexpr double kFar = 50'000, kFloatShare = 2e-7;
    const double farthest = points.rows() == 0 ? 0 : points.cwiseAbs().maxCoeff();
    return farthest > kFar ? kFloatShare * farthest : 0;
}

std::string millimetresText(const std::optional<double>& distance) {
    return distance ? fixed(*distance, 3) + " mm from their places" : "another number of them";
}

/// @return what is wrong, or the largest difference
Result<double> compareMesh(const FileMesh& file, const PieceMesh& mesh) {
    if (file.name != mesh.name) {
        return notReadBack(mesh.name, "\"" + file.name + "\" stands in its place");
    }
    if (file.F.rows() != mesh.F.rows() || (file.F - mesh.F).cwiseAbs().maxCoeff() != 0) {
        return notReadBack(mesh.name, "its triangles are others");
    }
    const auto points = apart(file.V, mesh.V), flat = apart(file.uv, mesh.uv);
    if (!points || !(*points <= kReadBackCoordinates + farAllowance(mesh.V))) {
        return notReadBack(mesh.name, "points: " + millimetresText(points));
    }
    if (!flat || !(*flat <= kReadBackCoordinates + farAllowance(mesh.uv))) {
        return notReadBack(mesh.name, "points of the pattern: " + millimetresText(flat));
    }
    return std::max(*points, *flat);
}

}  // namespace

Result<ReadBack> comparedWithMeshes(const MeshFile& file, const PieceMeshes& meshes) {
    if (file.meshes.size() != meshes.meshes.size() || file.seams.size() != meshes.seams.size()) {
        return notReadBack("garment", std::to_string(file.meshes.size()) + " meshes and " +
                                          std::to_string(file.seams.size()) + " seams");
    }
    ReadBack found;
    std::vector<Points2> uv;
    std::size_t nextFlat = 0;
    for (std::size_t k = 0; k < file.meshes.size(); ++k) {
        const PieceMesh& mesh = meshes.meshes[k];
        Result<double> difference = compareMesh(file.meshes[k], mesh);
        if (!difference) {
            return difference.error();
        }
        found.largest = std::max(found.largest, *difference);
        found.pieces += mesh.uv.rows() > 0 ? 1 : 0;
        uv.push_back(file.meshes[k].uv);
        if (!file.flat.empty() && mesh.uv.rows() > 0) {
            PieceMesh flat = mesh;
            flat.V = Points3::Zero(mesh.uv.rows(), 3);
            flat.V.leftCols<2>() = mesh.uv;
            difference = nextFlat < file.flat.size()
                             ? compareMesh(file.flat[nextFlat++], flat)
                             : notReadBack(mesh.name, "its flat mesh is missing");
            if (!difference) {
                return difference.error();
            }
        }
    }
    for (std::size_t k = 0; k < file.seams.size(); ++k) {
        if (file.seams[k].vertices != meshes.seams[k].vertices ||
            file.seams[k].name != meshes.seams[k].name) {
            return notReadBack(meshes.seams[k].name, "its vertices are others");
        }
    }
    double rounding = 0;
    for (const PieceMesh& mesh : meshes.meshes) {
        rounding = std::max(rounding, farAllowance(mesh.uv));
    }
    return withSeamsCompared(found, meshes, uv, rounding);
}

}  // namespace toile
