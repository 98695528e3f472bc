// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/pattern/notched_garments.h"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "core/seam/find_seams.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile::test {

int Notched::indexOf(const std::string& name) const {
    const auto& seams = garment.seams.seams;
    const auto found = std::ranges::find(seams, name, &Seam::name);
    EXPECT_NE(found, seams.end()) << name;
    return static_cast<int>(found - seams.begin());
}

Notched notched(Garment garment, const LineSettings& lines, Method method) {
    Notched made{std::move(garment), {}, {}};
    Progress progress;
    made.results = flattenGarment(made.garment, {method}, progress, 0, lines);
    PieceResults exact;
    for (const auto& result : made.results) {
        exact.push_back(result->exact ? result->exact : result);
    }
    made.segments = findSegments(made.garment, exact, lines);
    if (lines.mirror != Mirror::None) {
        made.symmetry = findSymmetry(made.garment);
    }
    return made;
}

Garment garmentFrom(const std::string& file) {
    Progress progress;
    return *loadGarment(
        {dataFile(file)},
        {.unit =
             file.starts_with("samples/") ? std::optional(LengthUnit::Millimetre) : std::nullopt},
        progress);
}

Garment plane(const std::vector<MeshArrays>& meshes) {
    Garment garment;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        auto piece = std::make_shared<Piece>(
            *asPiece(meshes[k], std::string(1, static_cast<char>('a' + k))));
        identify(*piece, k + 1);
        garment.pieces.push_back(piece);
    }
    garment.seams = findSeams(garment.pieces);
    return garment;
}

}  // namespace toile::test
