// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace toile::samples {

/// A vertex exactly as written in the file: units of 0.0001 mm.
using Place = std::array<long long, 3>;

/// One `o` group of a sample file; corners count from 0 within the piece.
struct SamplePiece {
    std::string name;
    std::vector<Place> vertices;
    std::vector<std::array<int, 3>> triangles;
};

/// A directed triangle side, as a pair of vertices.
using Side = std::pair<int, int>;

/// The whole file as bytes.
std::string readBytes(const std::filesystem::path& path);

/// Reads a sample strictly: throws std::runtime_error for any line the samples should not have,
/// such as a number without exactly four decimals, "-0.0000", or a face across two pieces.
std::vector<SamplePiece> readSample(const std::filesystem::path& path);

/// The committed sample of that name, a path within the samples without its ending.
std::vector<SamplePiece> loadSample(const std::string& name);

/// The piece of that name; throws std::runtime_error where there is none.
const SamplePiece& pieceNamed(const std::vector<SamplePiece>& pieces, const std::string& name);

/// Names of all samples.
std::vector<std::string> sampleNames();

/// The piece on the other side of the body: left and right swapped, other names as they are.
std::string otherSide(std::string name);

/// Distance in mm.
double distanceBetween(const Place& a, const Place& b);

/// Angle at `a` in the triangle a, b, c; radians.
double angleAt(const Place& a, const Place& b, const Place& c);

/// How often each directed side occurs.
std::map<Side, int> countSides(const SamplePiece& piece);

/// The sides without a partner in the piece, directed as in their triangle.
std::vector<Side> outlineSides(const SamplePiece& piece);

}  // namespace toile::samples
