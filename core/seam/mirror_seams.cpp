// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/mirror_seams.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/seam/seam_measure.h"

namespace toile {
namespace {

constexpr const char* kMirrorSeam = "mirror seam";
/// Largest distance of its points from the plane, mm: rounding.
constexpr double kOffPlane = 1e-3;

bool liesInMirror(const SeamSide& side, const Garment& garment) {
    const Piece& piece = *garment.pieces[side.piece];
    const SourceFile& file = *garment.files[piece.file];
    if (!file.reading.half || !file.reading.half->isCompleted) {
        return false;
    }
    const Points3 line = spaceLine(side, piece);
    return std::ranges::all_of(line.rowwise(), [&](const auto& point) {
        const Eigen::Vector3d inFile = asInFile(file.up, point).transpose();
        return std::abs(file.reading.half->plane.signedDistance(inFile)) < kOffPlane;
    });
}

}  // namespace

void nameMirrorSeams(SeamGraph& seams, const Garment& garment) {
    std::set<std::string> taken;
    std::vector<Seam*> mirrored;
    for (Seam& seam : seams.seams) {
        const bool isMirrored = seam.kind == SeamKind::Seam && seam.cuts.empty() &&
                                liesInMirror(seam.left, garment) &&
                                liesInMirror(seam.right, garment);
        if (isMirrored) {
            mirrored.push_back(&seam);
        } else {
            taken.insert(seam.name);
        }
    }
    int number = mirrored.size() > 1 ? 1 : 0;
    for (Seam* seam : mirrored) {
        do {
            seam->name = kMirrorSeam + (number > 0 ? " " + std::to_string(number) : "");
            ++number;
        } while (!taken.insert(seam->name).second);
    }
}

}  // namespace toile
