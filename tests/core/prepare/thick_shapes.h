// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/io/soup.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::test {

/// A tube of 100 mm across and 400 mm long.
PolygonSoup tubeSheet();

/// The T-shirt of our samples: panels that share no vertices.
PolygonSoup shirtSample();

/// Triangles as a file has them, without names or map.
PolygonSoup asSoup(const MeshArrays& mesh);

/// The triangles with a UV map, one entry per position of the sheet.
PolygonSoup withMap(PolygonSoup soup);

/// Equal positions become one, as in a file that a program has welded; the map stays.
PolygonSoup weldedSoup(PolygonSoup soup);

/// All faces but these.
PolygonSoup withoutFaces(const PolygonSoup& soup, const std::vector<int>& gone);

/// Every corner gets a position of its own, as in a file that repeats them.
PolygonSoup looseSoup(const PolygonSoup& soup);

/// How a sheet is thickened.
struct Thickening {
    /// At a position, in the soup's unit.
    std::function<double(const Eigen::Vector3d&)> thickness = [](const auto&) { return 1.5; };
    bool rims = true;
};

/// As exporters do: the sheet's faces, then as many of a copy that lies against the normals and
/// looks the other way, then rims of quads. Names and map are copied.
PolygonSoup thickened(const PolygonSoup& sheet, const Thickening& how = {});

/// A soup without map in which each of some triangles becomes four; the polygons that adjoin them
/// get the new corners too.
PolygonSoup withDivided(const PolygonSoup& soup, int firstFace, int lastFace);

/// A profile of radius and height turned about z, in quads; seen from outside where it runs
/// upwards.
PolygonSoup revolved(const std::vector<Eigen::Vector2d>& profile, int around);

/// A closed shell of revolution about z of two tubes that are divided differently.
PolygonSoup tubeInTube(double outerRadius, int outerAround, double innerRadius, int innerAround);

}  // namespace toile::test
