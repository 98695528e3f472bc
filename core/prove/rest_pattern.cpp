// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/rest_pattern.h"

#include <algorithm>
#include <utility>

#include "core/export/apparel_dxf.h"
#include "core/geometry/polygon.h"
#include "core/prove/fault_words.h"
#include "core/prove/our_loops.h"
#include "core/prove/rest_of_file.h"
#include "core/reading/read_pattern.h"

namespace toile::prove {
namespace {

/// The designer's panels: each line is ours.
RestPattern referencePattern(const Garment& garment) {
    RestPattern rest;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        const Piece& piece = *garment.pieces[p];
        rest.pieces.emplace_back();
        if (piece.defect) {
            continue;
        }
        if (!piece.reference) {
            rest.faults.push_back(pieceNotThere(garment, static_cast<int>(p)));
            continue;
        }
        Points2 flat = *piece.reference;
        if (geometry::signedAreaOf(flat(piece.boundary, Eigen::all)) < 0) {
            flat.col(0) *= -1;
        }
        RestPiece& made = rest.pieces.back().emplace();
        for (OurLoop& loop : ourLoops(piece, flat, nullptr)) {
            ClosedLine line(loop.drawn.points());
            const LineMap map(line.length());
            made.loops.emplace_back(
                RestLoop(std::move(loop.space), std::move(loop.drawn), std::move(line), map));
        }
        made.flat = std::move(flat);
        made.warp = kGrainUpwards;
    }
    rest.source = sourceIsReference();
    return rest;
}

/// The garment's own pattern as a program for patterns gets it.
Result<PatternFile> readBack(const ExportSource& source) {
    LaidOutPattern laid;
    laid.wholePattern = source.laid().wholePattern;
    laid.pattern = laid.wholePattern;
    laid.whole = laid.marker = layOut(laid.pattern);
    ExportOptions options;
    const ExportSource whole(source.garment(), source.results(), laid, options, {}, source.lines(),
                             source.fabric());
    // A doll's would be taken for one in centimetres.
    auto file = readPattern(writeApparelDxf(whole), PatternFileKind::Dxf, laid.pattern.name,
                            FileUnit(options.dxf.unit));
    if (!file) {
        return file.error();
    }
    // In the order of ours; names are cut off after some characters.
    std::vector<std::string> slugs;
    for (const PatternPiece& piece : laid.pattern.pieces) {
        if (piece.outline.rows() > 0) {
            slugs.push_back(piece.slug);
        }
    }
    for (std::size_t k = 0; slugs.size() == file->pieces.size() && k < slugs.size(); ++k) {
        file->pieces[k].id = slugs[k];
    }
    return file;
}

}  // namespace

Result<RestPattern> restPattern(const ExportSource& source, const ProofOrder& order) {
    const auto isFlat = [](const PatternPiece& piece) { return piece.outline.rows() > 0; };
    if (!order.isReference && std::ranges::none_of(source.laid().wholePattern.pieces, isFlat)) {
        return Error{ErrorCode::NoGeometry, {}, nothingToSew()};
    }
    RestPattern rest;
    if (order.isReference) {
        rest = referencePattern(source.garment());
    } else if (order.file) {
        rest = restOfFile(source, *order.file);
        rest.source = order.file->format;
    } else {
        const auto file = readBack(source);
        if (!file) {
            const bool isEmpty = file.error().code == ErrorCode::NoGeometry;
            return isEmpty ? Error{ErrorCode::NoGeometry, {}, patternTooSmall()} : file.error();
        }
        rest = restOfFile(source, *file);
        rest.source = sourceIsReadBack();
    }
    if (std::ranges::none_of(rest.pieces, [](const auto& piece) { return piece.has_value(); })) {
        return Error{ErrorCode::NoGeometry, {}, nothingToSew()};
    }
    return rest;
}

}  // namespace toile::prove
