// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"
#include "core/export/drawing.h"
#include "core/export/writers.h"
#include "core/pipeline/pipeline.h"

namespace toile {
namespace {

std::string lowerCaseEnding(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return ending;
}

}  // namespace

LaidOutPattern layOut(const Garment& garment, const PieceResults& results) {
    LaidOutPattern laid;
    laid.pattern.name =
        garment.files.empty() ? std::string() : garment.files.front()->path.stem().string();
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i]->flat) {
            laid.pattern.pieces.push_back(makePatternPiece(*results[i]->piece, *results[i]->flat,
                                                           garment.seams, static_cast<int>(i)));
        }
    }
    makeIdsUnique(laid.pattern);
    laid.sheet = layOutInRows(laid.pattern);
    std::size_t placed = 0;
    for (const auto& result : results) {
        laid.offsets.push_back(result->flat ? laid.sheet.offset[placed++] : Eigen::Vector2d(0, 0));
    }
    return laid;
}

bool canExport(const std::filesystem::path& path) {
    const std::string ending = lowerCaseEnding(path);
    return ending == ".svg" || ending == ".dxf" || ending == ".obj" || ending == ".json";
}

Result<void> exportFile(const std::filesystem::path& path, const Garment& garment,
                        const PieceResults& results) {
    const std::string ending = lowerCaseEnding(path);
    if (ending == ".json") {
        return writeFile(path, writeReport(garment, results));
    }
    const LaidOutPattern laid = layOut(garment, results);
    if (ending == ".obj") {
        return writeFile(path, writeObj(garment, results, laid.offsets));
    }
    if (ending == ".svg") {
        return writeFile(path, writeSvg(draw(laid.pattern, laid.sheet)));
    }
    if (ending == ".dxf") {
        return writeFile(path, writeDxf(draw(laid.pattern, laid.sheet)));
    }
    return Error{ErrorCode::UnknownFormat, path.string(), "ending \"" + ending + "\""};
}

}  // namespace toile
