// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/sewn_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "app/document/shown_proof.h"
#include "app/render/scene_builder.h"
#include "app/text/figures.h"
#include "app/views/reference_gaps.h"
#include "core/geometry/line.h"
#include "core/seam/seam_measure.h"

namespace toile::app {

namespace {

/// Rounding tolerance, shorter than any stitch, mm.
constexpr double kNothing = 1e-3;

using Span = geometry::Interval;

geometry::Arc arcsOf(const Piece& piece) {
    return geometry::SpaceLine::closed(piece.mesh.V(piece.boundary, Eigen::all)).arc();
}

Span spanOf(const SeamSide& side) {
    return {std::min(side.start, side.end), std::max(side.start, side.end)};
}

/// The part of a side between two arc lengths, in the side's direction.
SeamSide partOf(const SeamSide& side, const geometry::Arc& arcs, Span span) {
    SeamSide part = side;
    part.start = side.reversed ? span.high : span.low;
    part.end = side.reversed ? span.low : span.high;
    part.count = 0;
    for (int k = side.first; k < side.first + side.count; ++k) {
        const double touched =
            std::min(span.high, arcs.placeOf(k + 1)) - std::max(span.low, arcs.placeOf(k));
        if (touched > kNothing) {
            part.first = part.count == 0 ? k : part.first;
            part.count = k - part.first + 1;
        }
    }
    return part;
}

double wornLength(const SeamSide& side) {
    return std::abs(side.end - side.start);
}

}  // namespace

std::vector<SewnPart> sewnParts(const Garment& garment, const Feature& run) {
    const Piece& piece = *garment.pieces[static_cast<std::size_t>(run.piece)];
    const geometry::Arc arcs = arcsOf(piece);
    const Span taken{arcs.placeOf(run.first), arcs.placeOf(run.first + run.count)};
    std::vector<SewnPart> parts;
    for (std::size_t s = 0; s < garment.seams.seams.size(); ++s) {
        const Seam& seam = garment.seams.seams[s];
        if (seam.right.piece < 0 || seam.matches.size() < 2) {
            continue;
        }
        for (const bool left : {true, false}) {
            const SeamSide& here = left ? seam.left : seam.right;
            const SeamSide& there = left ? seam.right : seam.left;
            // List a stacked third layer only for its own piece (the left side).
            if (here.piece != run.piece || (seam.stacked && !left)) {
                continue;
            }
            const Span all = spanOf(here);
            for (const auto& both : geometry::commonParts(all, taken, arcs.length())) {
                if (both.length() <= kNothing) {
                    continue;
                }
                const Piece& other = *garment.pieces[static_cast<std::size_t>(there.piece)];
                const auto ends = std::minmax(
                    {placeAcross(seam, both.low, !left), placeAcross(seam, both.high, !left)});
                parts.push_back({static_cast<int>(s), all.length() - both.length() <= kNothing,
                                 partOf(here, arcs, both),
                                 partOf(there, arcsOf(other), {ends.first, ends.second})});
            }
        }
    }
    return parts;
}

std::optional<int> seamOfRun(const Garment& garment, const Feature& run) {
    const auto parts = sewnParts(garment, run);
    if (parts.size() != 1 || !parts.front().whole) {
        return std::nullopt;
    }
    const auto arcs = arcsOf(*garment.pieces[static_cast<std::size_t>(run.piece)]);
    const double length = arcs.placeOf(run.first + run.count) - arcs.placeOf(run.first);
    return length - wornLength(parts.front().here) <= kNothing ? std::optional(parts.front().seam)
                                                               : std::nullopt;
}

RunLengths runLengths(const Garment& garment, const PieceResults& results, const Feature& run) {
    const auto parts = sewnParts(garment, run);
    const auto flatOf = [&](int piece) { return flatPieceOf(garment, results, piece); };
    const Piece& piece = *garment.pieces[static_cast<std::size_t>(run.piece)];
    const auto arcs = arcsOf(piece);
    RunLengths lengths;
    lengths.flat = flatOf(run.piece) && std::ranges::all_of(parts, [&](const SewnPart& part) {
                       return flatOf(part.there.piece) != nullptr;
                   });
    const auto lengthOf = [&](const SeamSide& side) -> double {
        return lengths.flat
                   ? flatLength(side, *garment.pieces[static_cast<std::size_t>(side.piece)],
                                *flatOf(side.piece))
                   : wornLength(side);
    };
    SeamSide whole;
    whole.piece = run.piece;
    whole.first = run.first;
    whole.count = run.count;
    whole.start = arcs.placeOf(run.first);
    whole.end = arcs.placeOf(run.first + run.count);
    for (const SewnPart& part : parts) {
        lengths.sewn += lengthOf(part.here);
        lengths.partner += lengthOf(part.there);
    }
    lengths.free = std::max(0.0, lengthOf(whole) - lengths.sewn);
    return lengths;
}

std::vector<Feature> markedFeatures(const Document& document) {
    if (!document.mark() || !document.garment()) {
        return {};
    }
    std::vector<Feature> features{*document.mark()};
    if (features.front().kind == Feature::Kind::Run) {
        for (const SewnPart& part : sewnParts(*document.garment(), features.front())) {
            const auto& boundary =
                document.garment()->pieces[static_cast<std::size_t>(part.there.piece)]->boundary;
            features.push_back({.kind = Feature::Kind::Run,
                                .piece = part.there.piece,
                                .first = part.there.first % static_cast<int>(boundary.size()),
                                .count = part.there.count});
        }
    }
    return features;
}

std::shared_ptr<const SewnCloth> sewnOf(const Document& document) {
    for (const auto& shown : {document.sewing(), document.proof()}) {
        if (shown && shown->cloth && shown->cloth->scene == document.scene() &&
            document.isOfThisPattern(*shown)) {
            return shown->cloth;
        }
    }
    return nullptr;
}

SceneContent contentOf(const Document& document) {
    return {.scene = document.scene(),
            .reference = referenceLinesOf(document),
            .places = placesOf(document.settings(), document.colours(), document.state().materials),
            .selection = document.selection(),
            .seam = document.seam(),
            .marks = markedFeatures(document),
            .hover = document.hover(),
            .sewn = sewnOf(document),
            .fabric = document.fabric(),
            .squareSide = checkerSquare()};
}

}  // namespace toile::app
