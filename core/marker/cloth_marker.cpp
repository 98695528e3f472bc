// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marker/cloth_marker.h"

#include <algorithm>
#include <set>

#include "core/geometry/polygon.h"
#include "core/marker/laid_pieces.h"
#include "core/nest/exact_overlap.h"
#include "core/nest/nest.h"
#include "core/pattern/half_pattern.h"

namespace toile {
namespace {

constexpr double kMillimetresPerMetre = 1000;

std::vector<geometry::Polygon> ringsOnCloth(const Pattern& pattern, const LaidCopy& copy) {
    NestItem item;
    item.rings = {cloth::lineOnCloth(pattern.pieces[static_cast<std::size_t>(copy.piece)],
                                     copy.placement.mirrored)};
    return placedRings(item, cloth::nestPlacementOf(copy.placement));
}

}  // namespace

Pattern patternOnCloth(Pattern whole, const MarkerSettings& settings) {
    for (PatternPiece& piece : whole.pieces) {
        piece.byHalf = settings.isFolded;
    }
    return asCut(std::move(whole));
}

std::vector<std::string> markerMaterials(const Pattern& pattern) {
    std::set<std::string> materials;
    for (const PatternPiece& piece : pattern.pieces) {
        if (piece.outline.rows() > 2 && piece.quantity > 0) {
            materials.insert(cloth::materialOnCloth(pattern, piece));
        }
    }
    return {materials.begin(), materials.end()};
}

Points2 laidOutline(const Pattern& pattern, const LaidCopy& copy) {
    return ringsOnCloth(pattern, copy).front();
}

std::vector<int> misplacedCopies(const Pattern& pattern, const ClothMarker& marker,
                                 const MarkerSettings& settings) {
    std::vector<nest::Rings> placed;
    std::vector<bool> isMisplaced(marker.copies.size());
    for (std::size_t c = 0; c < marker.copies.size(); ++c) {
        placed.push_back(nest::wound(ringsOnCloth(pattern, marker.copies[c])));
        const geometry::Polygon& line = placed.back().front();
        isMisplaced[c] = line.col(0).minCoeff() < settings.border ||
                         line.col(1).minCoeff() < settings.border ||
                         line.col(1).maxCoeff() > marker.width - settings.border;
        for (std::size_t d = 0; d < c; ++d) {
            if (nest::doOverlap(placed[d], placed[c])) {
                isMisplaced[c] = isMisplaced[d] = true;
            }
        }
    }
    std::vector<int> misplaced;
    for (std::size_t c = 0; c < isMisplaced.size(); ++c) {
        if (isMisplaced[c]) {
            misplaced.push_back(static_cast<int>(c));
        }
    }
    return misplaced;
}

Marker pageOf(const ClothMarker& marker) {
    Marker page;
    for (const LaidCopy& copy : marker.copies) {
        page.copies.push_back({copy.piece, copy.placement});
    }
    page.width = marker.length;
    page.height = marker.width;
    return page;
}

MarkerFigures markerFigures(const Pattern& pattern, const ClothMarker& marker) {
    MarkerFigures figures;
    for (const LaidCopy& copy : marker.copies) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(copy.piece)];
        // A half has its other half too, and of each seam two sides are sewn to each other.
        const int halves = piece.cutAs == CutAs::OnFold ? 2 : copy.yield;
        for (const SeamLine& seam : piece.seams) {
            if (seam.kind == SeamKind::Seam || seam.kind == SeamKind::Dart) {
                const double closing =
                    seam.closed ? (seam.line.row(0) - seam.line.row(seam.line.rows() - 1)).norm()
                                : 0;
                double length = closing;
                for (Eigen::Index k = 1; k < seam.line.rows(); ++k) {
                    length += (seam.line.row(k) - seam.line.row(k - 1)).norm();
                }
                figures.seamMetres += halves * length / 2 / kMillimetresPerMetre;
            }
        }
        double cut = geometry::perimeterOf(edgeOf(piece));
        if (piece.cutAs == CutAs::OnFold) {
            const Chord fold = foldOf(piece);
            cut -= (fold.to - fold.from).norm();
        }
        for (const Points2& hole : piece.holes) {
            cut += geometry::perimeterOf(hole);
        }
        figures.cutMetres += cut / kMillimetresPerMetre;
        for (const PieceNotch& notch : piece.notches) {
            figures.notches += notch.count;
        }
        figures.copies += copy.yield;
    }
    return figures;
}

}  // namespace toile
