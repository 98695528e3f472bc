// SPDX-License-Identifier: GPL-3.0-or-later
// Includes CGAL, and therefore is slow to compile.
#include "core/prepare/holes.h"

#include <algorithm>
#include <exception>
#include <iterator>

// Toile checks inputs and results, so CGAL's own checks are off. The Delaunay search would need
// exact predicates and double the compile time.
#ifndef CGAL_NDEBUG
#define CGAL_NDEBUG
#endif
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace toile {
namespace {

constexpr double kFlatness = 0.5;  // minimum for a hole

}  // namespace

double flatness(const MeshArrays& mesh, const EdgeTable& table, const RimLoop& rim) {
    const auto point = [&mesh, &rim](std::size_t i) -> Eigen::Vector3d {
        return mesh.V.row(rim.vertices[i % rim.vertices.size()]).transpose();
    };
    const Eigen::Vector3d origin = point(0);  // avoids cancellation far from the origin
    Eigen::Vector3d area = Eigen::Vector3d::Zero(), cloth = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
        // A patch has the opposite direction of the rim, which has the cloth on its left.
        area -= (point(i) - origin).cross(point(i + 1) - origin);
        const int tail = rim.vertices[i], head = rim.vertices[(i + 1) % rim.vertices.size()];
        const int face = table.usesOf(findEdge(table.edges, tail, head)).front() / 3;
        cloth += (point(i + 1) - point(i)).norm() * doubleAreaNormal(mesh, face).normalized();
    }
    return rim.perimeter > 0 ? area.normalized().dot(cloth) / rim.perimeter : 0;
}

std::vector<RimLoop> findHoles(const MeshArrays& mesh, const EdgeTable& table, double largest) {
    std::vector<RimLoop> holes = rimsOf(mesh, table);
    std::erase_if(holes, [&](const RimLoop& rim) {
        return rim.perimeter > largest || flatness(mesh, table, rim) < kFlatness;
    });
    return holes;
}

namespace {

namespace processing = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;

constexpr std::size_t kMaxHoleEdges = 400;
constexpr double kMaxPatchDistance = 0.25;  // of the perimeter, from the box around a hole

Eigen::Vector3d toEigen(const Kernel::Point_3& p) {
    return {p.x(), p.y(), p.z()};
}

Surface toSurface(const MeshArrays& mesh) {
    Surface surface;
    surface.reserve(static_cast<Surface::size_type>(mesh.V.rows()),
                    static_cast<Surface::size_type>(3 * mesh.F.rows()),
                    static_cast<Surface::size_type>(mesh.F.rows()));
    for (int v = 0; v < mesh.V.rows(); ++v) {
        surface.add_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
    }
    const auto vertex = [&mesh](int f, int k) {
        return Vertex(static_cast<Surface::size_type>(mesh.F(f, k)));
    };
    for (int f = 0; f < mesh.F.rows(); ++f) {
        surface.add_face(vertex(f, 0), vertex(f, 1), vertex(f, 2));
    }
    return surface;
}

/// Vertices and faces in CGAL's order, without those that were removed.
MeshArrays toArrays(Surface& surface) {
    surface.collect_garbage();
    MeshArrays mesh{Points3(surface.number_of_vertices(), 3),
                    Triangles(surface.number_of_faces(), 3)};
    for (const Vertex v : surface.vertices()) {
        mesh.V.row(static_cast<Eigen::Index>(v)) = toEigen(surface.point(v)).transpose();
    }
    for (const Surface::Face_index f : surface.faces()) {
        auto side = surface.halfedge(f);
        for (int k = 0; k < 3; ++k, side = surface.next(side)) {
            mesh.F(static_cast<Eigen::Index>(f), k) = static_cast<int>(surface.source(side));
        }
    }
    return mesh;
}

/// Fairs the patch so that it continues the surface smoothly. If that moves it too far, for example
/// at a ragged rim, the patch is kept as it was.
void fair(Surface& surface, const std::vector<Vertex>& inner, const Eigen::AlignedBox3d& around,
          double farthest) {
    std::vector<Kernel::Point_3> taut;
    taut.reserve(inner.size());
    for (const Vertex v : inner) {
        taut.push_back(surface.point(v));
    }
    bool isFair = false;
    try {
        isFair = processing::fair(surface, inner, processing::parameters::fairing_continuity(1U));
    } catch (const std::exception&) {
        isFair = false;
    }
    for (const Vertex v : inner) {
        const Eigen::Vector3d point = toEigen(surface.point(v));
        isFair = isFair && point.allFinite() && around.exteriorDistance(point) <= farthest;
    }
    for (std::size_t i = 0; !isFair && i < inner.size(); ++i) {
        surface.point(inner[i]) = taut[i];
    }
}

/// Returns how many faces the patch has.
std::size_t closeHole(Surface& surface, const RimLoop& hole) {
    const auto vertex = [&hole](std::size_t i) {
        return Vertex(static_cast<Surface::size_type>(hole.vertices[i % hole.vertices.size()]));
    };
    // The rim runs along the cloth; along the hole it runs the other way.
    const Surface::Halfedge_index side = surface.halfedge(vertex(1), vertex(0));
    if (!side.is_valid() || !surface.is_border(side) || hole.vertices.size() > kMaxHoleEdges) {
        return 0;
    }
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < hole.vertices.size(); ++i) {
        box.extend(toEigen(surface.point(vertex(i))));
    }
    std::vector<Surface::Face_index> faces;
    std::vector<Vertex> inner;
    processing::triangulate_and_refine_hole(
        surface, side, std::back_inserter(faces), std::back_inserter(inner),
        processing::parameters::use_delaunay_triangulation(false)
            .use_2d_constrained_delaunay_triangulation(false));
    if (!inner.empty()) {
        fair(surface, inner, box, kMaxPatchDistance * hole.perimeter);
    }
    return faces.size();
}

}  // namespace

PatchedSurface withPatches(const MeshArrays& mesh, std::span<const RimLoop> holes,
                           const Progress& progress) {
    Surface surface = toSurface(mesh);
    if (static_cast<Eigen::Index>(surface.number_of_faces()) != mesh.F.rows()) {
        return {mesh, {}};  // not manifold
    }
    PatchedSurface patched;
    for (std::size_t i = 0; i < holes.size() && !progress.isCancelled(); ++i) {
        try {
            patched.hole.resize(patched.hole.size() + closeHole(surface, holes[i]),
                                static_cast<int>(i));
        } catch (const std::exception&) {
            return {mesh, {}};  // the surface may be partly changed
        }
        progress.report(static_cast<double>(i + 1) / static_cast<double>(holes.size()));
    }
    patched.mesh = toArrays(surface);
    patched.mesh.F.topRows(mesh.F.rows()) = mesh.F;  // CGAL starts at another corner
    return patched;
}

}  // namespace toile
