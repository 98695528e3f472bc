// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/toile/pipeline.h"

namespace toile::test {

/// Small garments with known shapes, made here so that a clone needs no other files for its tests.

/// Flat rectangle in the plane z = 0, lower left corner at `corner`, facing +z.
MeshArrays makeSheet(double width, double height, int columns, int rows,
                     const Eigen::Vector3d& corner = Eigen::Vector3d::Zero());
/// Part of an upright cylinder of radius 100 mm around the y axis, arc length 200 mm, 150 mm high,
/// bulging to +z; `x` shifts it sideways.
MeshArrays makeBentStrip(double x);
/// Cap of a sphere of radius 100 mm, opening 60 degrees to either side, bulging to +z.
MeshArrays makeCap(double x);
/// The part of that cap between two shares of its width, 0 to 1. Parts that share a border have
/// the same vertices there.
MeshArrays makeCapPart(double x, double from, double to, int columns);
/// A closed surface, so not a disk.
MeshArrays makeTetrahedron(double size);

std::shared_ptr<const Garment> makeGarment(std::vector<std::pair<std::string, MeshArrays>> pieces);

/// Two unequal parts of a cap of radius 200 mm, sewn along the line between them. The line is bent
/// on both, so free flattening gives its sides different lengths. The seams are found.
std::shared_ptr<const Garment> makeSewnCap();
/// The same two parts, "narrow" and "wide", to write to a file.
std::vector<std::pair<std::string, MeshArrays>> sewnCapParts();

/// Writes all pieces to an OBJ file in millimetres, an object each.
void writeObj(const std::filesystem::path& path,
              const std::vector<std::pair<std::string, MeshArrays>>& pieces);

}  // namespace toile::test
