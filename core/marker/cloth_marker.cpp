// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marker/cloth_marker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/geometry/polygon.h"
#include "core/marker/laid_pieces.h"
#include "core/nest/collision.h"
#include "core/pattern/half_pattern.h"

namespace toile::cloth {
namespace {

using geometry::Polygon;

constexpr double kBetweenParts = 50;  // mm
constexpr double kBeyondHide = 10;    // mm: margin of a hide's surroundings beyond its box
constexpr double kMaxAlong = 9e6;     // mm: largest coordinate of a nest with all its parts

Polygon movedAlong(Polygon line, double x) {
    line.col(0).array() += x;
    return line;
}

Polygon rectangleOf(double left, double bottom, double right, double top) {
    Polygon rectangle(4, 2);
    rectangle << left, bottom, right, bottom, right, top, left, top;
    return rectangle;
}

bool isRectangle(const ClothPart& part) {
    const Eigen::RowVector2d low = part.outline.colwise().minCoeff();
    const Eigen::RowVector2d high = part.outline.colwise().maxCoeff();
    return part.outline.rows() == 4 &&
           std::abs(geometry::signedAreaOf(part.outline)) == (high - low).prod();
}

}  // namespace

std::vector<ClothPart> clothParts(const MarkerSettings& settings, std::size_t copies) {
    std::vector<ClothPart> parts;
    double x = 0;
    for (const auto& hide : settings.hides) {
        const Eigen::RowVector2d low = hide->outline.colwise().minCoeff();
        const auto moved = [&](const Polygon& line) -> Polygon {
            return movedAlong(line.rowwise() - low, x);
        };
        ClothPart part{moved(hide->outline)};
        for (const HideZone& zone : hide->zones) {
            part.zones.push_back({moved(zone.outline), zone.grade});
        }
        x = part.outline.col(0).maxCoeff() + kBetweenParts;
        parts.push_back(std::move(part));
    }
    for (std::size_t k = 0; settings.hides.empty() && settings.sheet && k < copies; ++k) {
        const double along = settings.sheet->x();
        if (k > 0 && x + along > kMaxAlong) {
            break;
        }
        parts.push_back({rectangleOf(x, 0, x + along, settings.sheet->y())});
        x += along + kBetweenParts;
    }
    return parts;
}

double widthOnCloth(const MarkerSettings& settings, const Fabric& fabric) {
    if (!settings.hides.empty()) {
        double width = 0;
        for (const auto& hide : settings.hides) {
            width =
                std::max(width, hide->outline.col(1).maxCoeff() - hide->outline.col(1).minCoeff());
        }
        return width;
    }
    return settings.sheet ? settings.sheet->y()
                          : (settings.width > 0 ? settings.width : fabric.width) *
                                (settings.isFolded ? 0.5 : 1);
}

void addParts(const std::vector<ClothPart>& parts, const std::vector<int>& grades,
              NestInstance& instance) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Polygon& outline = parts[k].outline;
        const double left = outline.col(0).minCoeff(), right = outline.col(0).maxCoeff();
        instance.bands.push_back({right, k + 1 < parts.size()
                                             ? parts[k + 1].outline.col(0).minCoeff()
                                             : std::numeric_limits<double>::infinity()});
        // A sheet narrower than the widest leaves a strip that is not cloth.
        if (!isRectangle(parts[k]) || outline.col(1).maxCoeff() < instance.width) {
            const double top = std::max(instance.width, outline.col(1).maxCoeff());
            instance.obstacles.push_back({"the edge of the hide",
                                          {rectangleOf(left - kBeyondHide, -kBeyondHide,
                                                       right + kBeyondHide, top + kBeyondHide),
                                           outline},
                                          {}});
        }
        for (const HideZone& zone : parts[k].zones) {
            NestObstacle obstacle{"a zone of the hide", {zone.outline}, {}};
            for (std::size_t i = 0; zone.grade > 0 && i < grades.size(); ++i) {
                if (grades[i] > 0 && grades[i] < zone.grade) {
                    obstacle.items.push_back(static_cast<int>(i));
                }
            }
            if (zone.grade == 0 || !obstacle.items.empty()) {
                instance.obstacles.push_back(std::move(obstacle));
            }
        }
    }
}

int partAt(const std::vector<ClothPart>& parts, double x) {
    int found = 0;
    for (std::size_t k = 1; k < parts.size(); ++k) {
        found = parts[k].outline.col(0).minCoeff() <= x ? static_cast<int>(k) : found;
    }
    return found;
}

double areaOf(const ClothPart& part) {
    double area = std::abs(geometry::signedAreaOf(part.outline));
    for (const HideZone& zone : part.zones) {
        area -= zone.grade == 0 ? std::abs(geometry::signedAreaOf(zone.outline)) : 0;
    }
    return area;
}

void measureOn(const std::vector<ClothPart>& parts, const Pattern& pattern, ClothMarker& marker) {
    double area = 0;
    int last = -1;
    for (LaidCopy& copy : marker.copies) {
        const Polygon line = laidOutline(pattern, copy);
        copy.sheet = partAt(parts, line.col(0).minCoeff());
        last = std::max(last, copy.sheet);
        area += std::abs(geometry::signedAreaOf(line));
        marker.length = std::max(marker.length, line.col(0).maxCoeff());
    }
    marker.parts.assign(parts.begin(), parts.begin() + (parts.empty() ? 0 : last + 1));
    marker.sheets = last + 1;
    if (parts.empty()) {
        marker.parts = {{rectangleOf(0, 0, marker.length, marker.width)}};
    }
    marker.clothArea = 0;
    for (const ClothPart& part : marker.parts) {
        marker.clothArea += areaOf(part);
    }
    marker.use = marker.clothArea > 0 ? area / marker.clothArea : 0;
}

}  // namespace toile::cloth

namespace toile {
namespace {

constexpr double kMillimetresPerMetre = 1000;

constexpr const char* kOwnFabric = translatable("Garment's fabric");
constexpr const char* kClothUsed = translatable("%1: %2 mm wide, %3 mm long, %4 % used");
constexpr const char* kSheetsUsed = translatable("%1: %2, %3 % used");

/// Whether an outline is inside a sheet or hide, outside its holes and outside zones worse than
/// `grade`.
bool isInPart(const ClothPart& part, const geometry::Polygon& line, int grade) {
    const Eigen::RowVector2d low =
        part.outline.colwise().minCoeff().cwiseMin(line.colwise().minCoeff()) -
        Eigen::RowVector2d::Ones();
    const Eigen::RowVector2d high =
        part.outline.colwise().maxCoeff().cwiseMax(line.colwise().maxCoeff()) +
        Eigen::RowVector2d::Ones();
    geometry::Polygon around(4, 2);
    around << low.x(), low.y(), high.x(), low.y(), high.x(), high.y(), low.x(), high.y();
    return !nest::doOverlap({line}, nest::wound({around, part.outline})) &&
           std::ranges::none_of(part.zones, [&](const HideZone& zone) {
               return (zone.grade == 0 || (grade > 0 && zone.grade > grade)) &&
                      nest::doOverlap({line}, nest::wound({zone.outline}));
           });
}

bool isOnRoll(double width, const geometry::Polygon& line) {
    return line.minCoeff() >= 0 && line.col(1).maxCoeff() <= width;
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
    return cloth::lineOf(pattern.pieces[static_cast<std::size_t>(copy.piece)], copy.isImage,
                         copy.placement);
}

void measureMoved(const Pattern& pattern, const MarkerSettings& settings, ClothMarker& marker) {
    const std::vector<ClothPart> parts = cloth::clothParts(settings, marker.copies.size());
    marker.length = 0;
    for (const LaidCopy& copy : marker.copies) {
        const double end = laidOutline(pattern, copy).col(0).maxCoeff();
        marker.length = std::max(marker.length, end + (parts.empty() ? settings.border : 0));
    }
    marker.length = std::max(marker.length, 1.0);
    cloth::measureOn(parts, pattern, marker);
}

std::vector<int> misplacedCopies(const Pattern& pattern, const ClothMarker& marker,
                                 const MarkerSettings& settings) {
    const std::vector<ClothPart> parts = cloth::clothParts(settings, marker.copies.size());
    std::vector<nest::Rings> placed;
    std::vector<bool> isMisplaced(marker.copies.size());
    for (std::size_t c = 0; c < marker.copies.size(); ++c) {
        const LaidCopy& copy = marker.copies[c];
        placed.push_back(nest::wound({laidOutline(pattern, copy)}));
        const geometry::Polygon& line = placed.back().front();
        const auto grade =
            settings.grades.find(pattern.pieces[static_cast<std::size_t>(copy.piece)].name);
        const int worst = grade == settings.grades.end() ? 0 : grade->second;
        isMisplaced[c] = parts.empty() ? !isOnRoll(marker.width, line)
                                       : std::ranges::none_of(parts, [&](const ClothPart& part) {
                                             return isInPart(part, line, worst);
                                         });
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

Wording clothSentence(const ClothMarker& marker) {
    const Wording name = marker.material.empty() ? worded(kOwnFabric) : Wording(marker.material);
    const Wording use = figure(100 * marker.use, 1);
    return marker.isRoll
               ? worded(kClothUsed, {name, figure(marker.width), figure(marker.length), use})
               : worded(
                     kSheetsUsed,
                     {name, countWording(marker.sheets, marker.areHides ? "hide" : "sheet"), use});
}

Marker pageOf(const ClothMarker& marker) {
    Marker page;
    for (const LaidCopy& copy : marker.copies) {
        page.copies.push_back({copy.piece, copy.placement});
    }
    page.width = marker.length;
    page.height = marker.width;
    for (const ClothPart& part : marker.parts) {
        page.width = std::max(page.width, part.outline.col(0).maxCoeff());
    }
    return page;
}

MarkerFigures markerFigures(const Pattern& pattern, const ClothMarker& marker) {
    MarkerFigures figures;
    for (const LaidCopy& copy : marker.copies) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(copy.piece)];
        // A half includes its mirrored half, and each seam joins two sides.
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
            const Chord fold = foldOfEdge(piece);
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
