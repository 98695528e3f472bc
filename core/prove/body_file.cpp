// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/body_file.h"

#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "core/assemble/weld_soup.h"
#include "core/io/conventions.h"
#include "core/io/soup.h"
#include "core/io/triangulate.h"
#include "core/mesh/repair.h"

namespace toile {
namespace {

MeshPart bodyPart(const PolygonSoup& soup, UpAxis up, double millimetres, const std::string& name) {
    MeshPart part;
    part.mesh.V.resize(static_cast<Eigen::Index>(soup.positions.size()), 3);
    for (std::size_t v = 0; v < soup.positions.size(); ++v) {
        part.mesh.V.row(static_cast<Eigen::Index>(v)) =
            millimetres * withYUp(up, soup.positions[v].transpose());
    }
    part.sourceVertex.resize(soup.positions.size());
    std::iota(part.sourceVertex.begin(), part.sourceVertex.end(), 0);
    Triangulation triangles = triangulate(soup, name);
    part.mesh.F = std::move(triangles.F);
    part.sourceFace = std::move(triangles.sourceFace);
    return part;
}

/// Turns the faces of every connected part outwards, so that its volume, relative to its own
/// middle, is not negative.
void turnOutwards(MeshArrays& mesh) {
    const auto count = static_cast<int>(mesh.V.rows());
    geometry::DisjointSets parts(count);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        parts.join(mesh.F(f, 0), mesh.F(f, 1));
        parts.join(mesh.F(f, 0), mesh.F(f, 2));
    }
    Points3 sum = Points3::Zero(count, 3);
    Eigen::VectorXd members = Eigen::VectorXd::Zero(count), enclosed = members;
    for (int v = 0; v < count; ++v) {
        sum.row(parts.root(v)) += mesh.V.row(v);
        members[parts.root(v)] += 1;
    }
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const int root = parts.root(mesh.F(f, 0));
        const Eigen::Vector3d middle = sum.row(root).transpose() / members[root];
        enclosed[root] +=
            doubleAreaNormal(mesh, f).dot(mesh.V.row(mesh.F(f, 0)).transpose() - middle);
    }
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        if (enclosed[parts.root(mesh.F(f, 0))] < 0) {
            std::swap(mesh.F(f, 1), mesh.F(f, 2));
        }
    }
}

}  // namespace

Result<MeshArrays> readBody(const std::filesystem::path& path, const std::optional<FileUnit>& unit,
                            const Garment& garment, Progress& progress) {
    auto read = readSoup(path, progress);
    if (!read) {
        return read.error();
    }
    auto soup = std::make_shared<const PolygonSoup>(std::move(*read));
    const std::string name = path.filename().string();
    const SourceFile like = garment.files.empty() ? SourceFile{} : *garment.files.front();
    const FileUnit taken = unit               ? *unit
                           : soup->statedUnit ? FileUnit(soup->statedUnit->unit)
                                              : like.unit;
    const double millimetres = millimetresPer(taken);
    weldSoup(soup, std::nullopt, millimetres, name);
    RepairResult repaired = repair(
        bodyPart(*soup, soup->statedUp ? soup->statedUp->axis : like.up, millimetres, name), name);
    eraseUnusedVertices(repaired.part);
    if (repaired.part.mesh.F.rows() == 0) {
        return Error{ErrorCode::NoGeometry, Subject::file(path.string())};
    }
    turnOutwards(repaired.part.mesh);
    return std::move(repaired.part.mesh);
}

bool isNear(const MeshArrays& body, const Garment& garment) {
    Eigen::AlignedBox3d box, worn;
    for (Eigen::Index v = 0; v < body.V.rows(); ++v) {
        box.extend(body.V.row(v).transpose());
    }
    for (const auto& piece : garment.pieces) {
        for (Eigen::Index v = 0; v < piece->mesh.V.rows(); ++v) {
            worn.extend(piece->mesh.V.row(v).transpose());
        }
    }
    return box.intersects(worn);
}

Error bodyNotNear(const std::filesystem::path& path) {
    return {ErrorCode::CannotReadAs, Subject::file(path.string()),
            worded("it is far from the garment; check its unit and its axes")};
}

}  // namespace toile
