// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/text.h"
#include "core/pipeline/pipeline.h"
#include "core/quality/measures.h"
#include "core/seam/find_seams.h"
#include "core/seam/name_after_cuts.h"

namespace toile {
namespace {

/// The cuts as the pieces are: in millimetres, y up.
std::vector<UserCut> inPieceSpace(const SeamsFile& seams, const Garment& garment) {
    std::vector<UserCut> cuts = seams.cuts;
    if (garment.files.empty()) {
        return cuts;
    }
    const SourceFile& file = *garment.files.front();
    const double millimetres = millimetresPer(seams.unit.value_or(file.unit));
    for (UserCut& cut : cuts) {
        for (Eigen::Vector3d& point : cut.points) {
            point = millimetres * withYUp(file.up, point).transpose();
        }
    }
    return cuts;
}

/// A hole is no fault, but its rim may change its length, and that is to be said.
void noteHoles(Garment& garment) {
    for (const auto& piece : garment.pieces) {
        if (!piece->holes.empty()) {
            double longest = 0;
            for (const auto& hole : piece->holes) {
                longest = std::max(longest, boundaryLengths3d(piece->mesh.V, hole).sum());
            }
            const auto count = static_cast<long long>(piece->holes.size());
            garment.problems.push_back({ErrorCode::HolesKept, piece->name,
                                        counted(count, "hole") + ", " +
                                            (count > 1 ? "the longest rim " : "its rim ") +
                                            fixed(longest, 1) + " mm"});
        }
    }
}

void setEase(Garment& garment, const SeamsFile& seams) {
    for (const auto& [name, ease] : seams.ease) {
        const auto seam = std::find_if(garment.seams.seams.begin(), garment.seams.seams.end(),
                                       [&name = name](const Seam& s) { return s.name == name; });
        if (seam == garment.seams.seams.end() || seam->kind == SeamKind::Free) {
            garment.problems.push_back(
                {ErrorCode::NoSuchSeam, name, "the seams file gives it an ease"});
        } else {
            seam->ease = ease;
        }
    }
}

}  // namespace

Result<Garment> cutGarment(const Garment& garment, const LoadOptions& options, Progress& progress) {
    Garment made;
    made.files = garment.files;
    made.wholes = garment.wholes;
    CutPieces cut =
        cutPieces(garment.wholes, inPieceSpace(options.seams, garment), options.autoCut, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    made.pieces = std::move(cut.pieces);
    made.cuts = std::move(cut.cuts);
    made.problems = std::move(cut.problems);
    noteHoles(made);
    made.seams = findSeams(made.pieces);
    nameAfterCuts(made.seams, made.pieces, made.cuts);
    setEase(made, options.seams);
    return made;
}

}  // namespace toile
