// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/export/drawing.h"
#include "core/export/writers.h"
#include "core/layout/place_pattern.h"
#include "core/pipeline/pipeline.h"

namespace toile {
namespace {

std::string lowerCaseEnding(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), lowered);
    return ending;
}

/// Of the time that an export takes, about; the rest is laying out before and writing after.
constexpr double kLaidOutShare = 0.2, kMakingShare = 0.8;

/// @param ending  one that `canExport`
std::string bytesOf(const std::string& ending, const Garment& garment, const PieceResults& results,
                    const std::vector<PieceOnSheet>& places, const Progress& progress,
                    const DrawingWords& words) {
    if (ending == ".json") {
        return writeReport(garment, results, places);
    }
    const LaidOutPattern laid = layOut(garment, results, places);
    progress.report(kLaidOutShare);
    if (progress.isCancelled()) {
        return {};
    }
    if (ending == ".obj") {
        return writeObj(garment, results, laid.placements);
    }
    const Drawing drawing = draw(laid.pattern, laid.sheet, words);
    return ending == ".svg" ? writeSvg(drawing) : writeDxf(drawing);
}

}  // namespace

LaidOutPattern layOut(const Garment& garment, const PieceResults& results,
                      const std::vector<PieceOnSheet>& places) {
    LaidOutPattern laid;
    laid.pattern.name =
        garment.files.empty() ? std::string() : garment.files.front()->path.stem().string();
    std::vector<PieceOnSheet> ofFlat;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i] && results[i]->flat) {
            ofFlat.push_back(i < places.size() ? places[i] : PieceOnSheet{});
            laid.pattern.pieces.push_back(makePatternPiece(*results[i]->piece, *results[i]->flat,
                                                           garment.seams, static_cast<int>(i)));
        }
    }
    makeIdsUnique(laid.pattern);
    laid.sheet = placeOnSheet(laid.pattern, ofFlat);
    std::size_t placed = 0;
    for (const auto& result : results) {
        Placement placement;
        if (result && result->flat) {
            placement = ofFlat[placed].placement.value_or(placement);
            placement.offset = laid.sheet.offset[placed++];
        }
        laid.offsets.push_back(placement.offset);
        laid.placements.push_back(placement);
    }
    return laid;
}

bool canExport(const std::filesystem::path& path) {
    const std::string ending = lowerCaseEnding(path);
    return ending == ".svg" || ending == ".dxf" || ending == ".obj" || ending == ".json";
}

Result<void> exportFile(const std::filesystem::path& path, const Garment& garment,
                        const PieceResults& results, const std::vector<PieceOnSheet>& places,
                        const Progress& progress, const DrawingWords& words) {
    if (!canExport(path)) {
        return Error{ErrorCode::UnknownFormat, Subject::file(path.string()),
                     "ending \"" + lowerCaseEnding(path) + "\""};
    }
    const std::string bytes =
        bytesOf(lowerCaseEnding(path), garment, results, places, progress, words);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    progress.report(kMakingShare);
    return writeFile(path, bytes);
}

}  // namespace toile
