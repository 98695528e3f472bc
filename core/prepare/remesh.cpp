// SPDX-License-Identifier: GPL-3.0-or-later
// Includes CGAL, and slow to compile: 30 seconds.
#include "core/prepare/remesh.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <tuple>

#include "core/prepare/holes.h"

// Inputs are checked before, results after. The Delaunay search of hole filling needs exact
// predicates, and compiles as long as all the rest.
#ifndef CGAL_NDEBUG
#define CGAL_NDEBUG
#endif
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace toile {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;

constexpr std::size_t kMostHoleEdges = 400;
constexpr double kFarthestPatch = 0.25;  // of the perimeter, from the box around a hole
constexpr double kRimLoss = 0.003;       // of length
constexpr int kMostAround = 400;         // triangles at a vertex, whose third power CGAL takes
constexpr double kMostTriangles = 5e6;
constexpr int kRemeshings = 3;
constexpr int kRelaxations = 2;

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

/// Bends the patch so that the surface goes on without an edge; where that throws it far out, as a
/// ragged rim does, it stays as taut as it was.
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
    if (!side.is_valid() || !surface.is_border(side) || hole.vertices.size() > kMostHoleEdges) {
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
        fair(surface, inner, box, kFarthestPatch * hole.perimeter);
    }
    return faces.size();
}

/// Whether CGAL can make triangles anew in bounded time.
bool isFeasible(const MeshArrays& mesh, const EdgeTable& table, double edgeLength) {
    std::vector<int> around(static_cast<std::size_t>(mesh.V.rows()), 0);
    double area = 0, divisions = 0;  // long thin triangles are divided often
    for (int f = 0; f < mesh.F.rows(); ++f) {
        area += doubleAreaNormal(mesh, f).norm() / 2;
    }
    for (int e = 0; e < table.edges.rows(); ++e) {
        const int a = table.edges(e, 0), b = table.edges(e, 1);
        if (++around[a] > kMostAround || ++around[b] > kMostAround) {
            return false;
        }
        divisions += (mesh.V.row(b) - mesh.V.row(a)).norm() / edgeLength;
    }
    const double equilateral = std::sqrt(3) / 4 * edgeLength * edgeLength;
    return std::max(area / equilateral, divisions) < kMostTriangles;  // false for no number
}

struct Cancellation : std::exception {};

/// Which vertices stay, as CGAL asks it; it asks so often that this is where to hear of a cancel.
struct KeptVertices {
    using key_type = Vertex;
    using value_type = bool;
    using reference = bool;
    using category = boost::read_write_property_map_tag;

    Surface::Property_map<Vertex, bool> isKept;
    const Progress* progress = nullptr;

    friend bool get(const KeptVertices& kept, Vertex v) {
        if (kept.progress->isCancelled()) {
            throw Cancellation();
        }
        return kept.isKept[v];
    }
    friend void put(const KeptVertices& kept, Vertex v, bool value) { kept.isKept[v] = value; }
};

/// Vertices of a rim between which its chords are as long as it is, nearly, and up to an edge's
/// length: the others may go.
void keepShape(const Points3& V, const RimLoop& rim, double edgeLength, KeptVertices& kept) {
    const std::size_t count = rim.vertices.size();
    std::size_t last = 0;
    double way = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const int from = rim.vertices[last], here = rim.vertices[i];
        const int ahead = rim.vertices[(i + 1) % count];
        const double longer = way + (V.row(ahead) - V.row(here)).norm();
        const double chord = (V.row(ahead) - V.row(from)).norm();
        if (i == 0 || longer > edgeLength || longer - chord > kRimLoss * longer) {
            put(kept, Vertex(static_cast<Surface::size_type>(here)), true);
            last = i;
            way = (V.row(ahead) - V.row(here)).norm();
        } else {
            way = longer;
        }
    }
}

}  // namespace

PatchedSurface withPatches(const MeshArrays& mesh, std::span<const RimLoop> holes,
                           const Progress& progress) {
    Surface surface = toSurface(mesh);
    if (static_cast<Eigen::Index>(surface.number_of_faces()) != mesh.F.rows()) {
        return {mesh, {}};  // no manifold
    }
    PatchedSurface patched;
    for (std::size_t i = 0; i < holes.size() && !progress.isCancelled(); ++i) {
        try {
            patched.hole.resize(patched.hole.size() + closeHole(surface, holes[i]),
                                static_cast<int>(i));
        } catch (const std::exception&) {
            return {mesh, {}};  // nobody knows what it has left
        }
        progress.report(static_cast<double>(i + 1) / static_cast<double>(holes.size()));
    }
    patched.mesh = toArrays(surface);
    patched.mesh.F.topRows(mesh.F.rows()) = mesh.F;  // CGAL begins with another corner
    return patched;
}

std::optional<MeshArrays> remeshed(const MeshArrays& mesh, double edgeLength,
                                   const Progress& progress) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    if (!isFeasible(mesh, table, edgeLength)) {
        return std::nullopt;
    }
    Surface surface = toSurface(mesh);
    if (static_cast<Eigen::Index>(surface.number_of_faces()) != mesh.F.rows()) {
        return std::nullopt;
    }
    KeptVertices kept{surface.add_property_map<Vertex, bool>("v:kept", false).first, &progress};
    for (const RimLoop& rim : rimsOf(mesh, table)) {
        keepShape(mesh.V, rim, edgeLength, kept);
    }
    try {
        processing::isotropic_remeshing(surface.faces(), edgeLength, surface,
                                        processing::parameters::number_of_iterations(kRemeshings)
                                            .number_of_relaxation_steps(kRelaxations)
                                            .vertex_is_constrained_map(kept));
    } catch (const std::exception&) {
        return std::nullopt;
    }
    return toArrays(surface);
}

}  // namespace toile
