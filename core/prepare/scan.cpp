// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/scan.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/io/soup.h"
#include "core/mesh/disk_check.h"
#include "core/mesh/repair.h"
#include "core/mesh/weld.h"
#include "core/prepare/file_surface.h"
#include "core/prepare/holes.h"
#include "core/prepare/recognise.h"
#include "core/prepare/remesh.h"
#include "core/prepare/smooth.h"

namespace toile {
namespace {

/// The UV of a face of the file at a position, or at another one in the same place, since they were
/// welded; -1 if it has none.
int uvAt(const PolygonSoup& file, int face, int position) {
    for (int corner = file.faceStart[face]; corner < file.faceStart[face + 1]; ++corner) {
        if (file.corners[corner] == position ||
            file.positions[static_cast<std::size_t>(file.corners[corner])] ==
                file.positions[static_cast<std::size_t>(position)]) {
            return file.cornerUvs[corner];
        }
    }
    return -1;
}

void nameFaces(const std::vector<int>& sourceFace, const std::vector<int>& before,
               std::vector<int>& names) {
    if (before.empty()) {
        return;
    }
    for (const int face : sourceFace) {
        names.push_back(face < 0 ? -1 : before[face]);
    }
}

/// Converts triangles made from a file back to a soup in its unit: with the names of their original
/// faces, and optionally with their UV map. Unmoved positions keep the file's numbers, but not the
/// file's text of them.
/// @param part         in mm; `sourceFace` -1: a face without names
/// @param millimetres  per unit of the file
/// Cost: linear. Pure.
PolygonSoup soupOf(const MeshPart& part, const PolygonSoup& file, double millimetres,
                   bool keepsUvs) {
    PolygonSoup soup;
    soup.contentHash = file.contentHash;
    soup.statedUnit = file.statedUnit;
    soup.problems = file.problems;
    for (int v = 0; v < part.mesh.V.rows(); ++v) {
        const Eigen::Vector3d here = part.mesh.V.row(v).transpose();
        const int source = part.sourceVertex[v];
        const bool stays =
            source >= 0 && here == millimetres * file.positions[static_cast<std::size_t>(source)];
        soup.positions.push_back(stays ? file.positions[static_cast<std::size_t>(source)]
                                       : Eigen::Vector3d(here / millimetres));
    }
    soup.corners.assign(part.mesh.F.data(), part.mesh.F.data() + part.mesh.F.size());
    for (int f = 0; f < part.mesh.F.rows(); ++f) {
        soup.faceStart.push_back(3 * (f + 1));
    }
    if (std::ranges::any_of(part.sourceFace, [](int face) { return face >= 0; })) {
        nameFaces(part.sourceFace, file.faceObject, soup.faceObject);
        nameFaces(part.sourceFace, file.faceGroup, soup.faceGroup);
        nameFaces(part.sourceFace, file.faceMaterial, soup.faceMaterial);
        soup.objects = file.objects;
        soup.groups = file.groups;
        soup.materials = file.materials;
    }
    if (keepsUvs && !file.cornerUvs.empty()) {
        soup.uvs = file.uvs;
        for (int f = 0; f < part.mesh.F.rows(); ++f) {
            for (int k = 0; k < 3; ++k) {
                const int source = part.sourceVertex[part.mesh.F(f, k)];
                const int face = part.sourceFace[f];
                soup.cornerUvs.push_back(source < 0 || face < 0 ? -1 : uvAt(file, face, source));
            }
        }
    }
    return soup;
}

/// The triangles during the preparation; one step at a time.
class ScanPreparation {
public:
    ScanPreparation(const PolygonSoup& soup, double millimetres)
        : soup_(soup), millimetres_(millimetres) {
        FileSurface surface = surfaceOf(soup, millimetres);
        effect_.trianglesBefore = static_cast<int>(surface.mesh.F.rows());
        const Weld weld = findWeld(surface.mesh.F, surface.mesh.V, {});
        for (int& v : cornersOf(surface.mesh.F)) {
            v = weld.target[v];
        }
        part_.sourceVertex.resize(soup.positions.size());
        for (std::size_t v = 0; v < soup.positions.size(); ++v) {
            part_.sourceVertex[v] = static_cast<int>(v);
        }
        part_.mesh = std::move(surface.mesh);
        part_.sourceFace = std::move(surface.face);
        eraseUnusedVertices(part_);
    }

    void dropDebris() {
        const Debris debris = findDebris(part_.mesh);
        effect_.fragments += debris.fragments;
        effect_.debrisArea += debris.area;
        std::vector<char> erased(part_.sourceFace.size(), 0);
        for (const int triangle : debris.triangles) {
            erased[triangle] = 1;
            debris_.push_back(part_.sourceFace[triangle]);
        }
        std::ranges::sort(debris_);
        debris_.erase(std::unique(debris_.begin(), debris_.end()), debris_.end());
        eraseFaces(part_, erased);
        eraseUnusedVertices(part_);
    }

    void makeSurface() {
        RepairResult result = repair(std::move(part_), "");
        part_ = std::move(result.part);
        effect_.repairs.insert(effect_.repairs.end(), result.repairs.begin(), result.repairs.end());
        hasChanged_ = hasChanged_ || !result.repairs.empty();
    }

    /// Whether holes, noise and triangles can be processed.
    bool isSurface() {
        effect_.isSurface = isValidSurface(part_.mesh, edges());
        return effect_.isSurface;
    }

    void closeHoles(double largest, const Progress& progress) {
        const EdgeTable table = edges();
        const std::vector<RimLoop> holes = findHoles(part_.mesh, table, largest);
        if (holes.empty()) {
            return;
        }
        PatchedSurface patched = withPatches(part_.mesh, holes, progress);
        const int before = static_cast<int>(part_.sourceFace.size());
        part_.mesh = std::move(patched.mesh);
        part_.sourceVertex.resize(static_cast<std::size_t>(part_.mesh.V.rows()), -1);
        for (std::size_t i = 0; i < patched.hole.size(); ++i) {
            const RimLoop& hole = holes[patched.hole[i]];
            const int edge = findEdge(table.edges, hole.vertices[0], hole.vertices[1]);
            part_.sourceFace.push_back(part_.sourceFace[table.usesOf(edge).front() / 3]);
            effect_.patchArea +=
                doubleAreaNormal(part_.mesh, before + static_cast<int>(i)).norm() / 2;
            effect_.holes += i == 0 || patched.hole[i] != patched.hole[i - 1] ? 1 : 0;
        }
        hasNewFaces_ = hasNewFaces_ || !patched.hole.empty();
        makeSurface();  // a patch may contain flat triangles
    }

    void smooth(double strength, const Progress& progress) {
        Points3 V = smoothed(part_.mesh, strength, progress);
        if (V.rows() > 0) {
            const Eigen::VectorXd moves = (V - part_.mesh.V).rowwise().norm();
            effect_.largestMove = moves.maxCoeff();
            effect_.meanMove = moves.mean();
            hasChanged_ = hasChanged_ || effect_.largestMove > 0;
        }
        part_.mesh.V = std::move(V);
    }

    void remesh(double edgeLength, const Progress& progress) {
        std::optional<MeshArrays> mesh = remeshed(part_.mesh, edgeLength, progress);
        if (!mesh) {
            return;
        }
        effect_.isRemeshed = true;
        part_.mesh = *std::move(mesh);
        part_.sourceVertex.assign(static_cast<std::size_t>(part_.mesh.V.rows()), -1);
        part_.sourceFace.assign(static_cast<std::size_t>(part_.mesh.F.rows()), -1);
        makeSurface();
    }

    PreparedScan finish() && {
        effect_.openings = static_cast<int>(rimsOf(part_.mesh, edges()).size());
        effect_.triangles = static_cast<int>(part_.mesh.F.rows());
        PreparedScan prepared{{}, std::move(debris_), std::move(effect_)};
        if (hasChanged_ || hasNewFaces_ || prepared.effect.isRemeshed) {
            prepared.soup =
                soupOf(part_, soup_, millimetres_, !hasNewFaces_ && !prepared.effect.isRemeshed);
        } else {
            prepared.soup = withFaces(soup_, otherFaces(prepared.debris));
        }
        return prepared;
    }

private:
    EdgeTable edges() const {
        return buildEdgeTable(part_.mesh.F, static_cast<int>(part_.mesh.V.rows()));
    }

    std::vector<int> otherFaces(const std::vector<int>& faces) const {
        std::vector<int> others;
        for (int face = 0; face < soup_.faceCount(); ++face) {
            if (!std::ranges::binary_search(faces, face)) {
                others.push_back(face);
            }
        }
        return others;
    }

    const PolygonSoup& soup_;
    double millimetres_;
    MeshPart part_;
    std::vector<int> debris_;
    ScanEffect effect_;
    bool hasChanged_ = false;   ///< positions, or triangles by repairs
    bool hasNewFaces_ = false;  ///< not in the scan, whatever their names
};

}  // namespace

Result<PreparedScan> prepareScan(const PolygonSoup& soup, double millimetres,
                                 const ScanSteps& steps, Progress& progress) {
    ScanPreparation scan(soup, millimetres);
    const auto isOver = [&progress](double fraction) {
        progress.report(fraction);
        return progress.isCancelled();
    };
    const Error cancelled{ErrorCode::Cancelled};
    if (steps.dropDebris) {
        scan.dropDebris();
    }
    if (isOver(0.1)) {
        return cancelled;
    }
    bool goesOn = steps.largestHole > 0 || steps.smoothing > 0 || steps.edgeLength > 0;
    if (goesOn) {
        scan.makeSurface();
        if (steps.dropDebris) {
            scan.dropDebris();  // parts connected by an edge of three triangles
        }
        goesOn = scan.isSurface();
    }
    if (isOver(0.2)) {
        return cancelled;
    }
    if (goesOn && steps.largestHole > 0) {
        scan.closeHoles(steps.largestHole, Progress(progress, 0.2));
        goesOn = scan.isSurface();
    }
    if (isOver(0.4)) {
        return cancelled;
    }
    if (goesOn && steps.smoothing > 0) {
        scan.smooth(steps.smoothing, Progress(progress, 0.2));
    }
    if (isOver(0.6)) {
        return cancelled;
    }
    if (goesOn && steps.edgeLength > 0) {
        scan.remesh(steps.edgeLength, Progress(progress, 0.4));
    }
    if (progress.isCancelled()) {
        return cancelled;
    }
    PreparedScan prepared = std::move(scan).finish();
    progress.report(1);
    return prepared;
}

}  // namespace toile
