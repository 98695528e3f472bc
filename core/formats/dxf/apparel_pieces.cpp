// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/apparel_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/characters.h"
#include "core/formats/drawing/key_points.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/darts.h"
#include "core/pattern/half_pattern.h"
#include "core/pattern/internal_lines.h"
#include "core/pattern/notch_mark.h"

namespace toile {
namespace {

constexpr std::size_t kLongestName = 20;
constexpr double kSameStation = 1e-6;  // mm
constexpr double kNearCut = 1;         // mm; maximum distance to move a notch onto the cutting line
constexpr double kLongestGrain = 300;  // mm
constexpr double kGrainShare = 0.8;    // of the cloth along it
constexpr double kMinGrain = 10;       // mm to either side

const PatternPiece& pieceOf(const Pattern& pattern, const DrawnBlock& block) {
    return pattern.pieces[static_cast<std::size_t>(block.piece)];
}

/// Darts whose cloth stays; the cutting line goes round the others.
std::vector<PieceDart> cappedDarts(const PatternPiece& piece) {
    std::vector<PieceDart> darts = piece.darts;
    std::erase_if(darts, [](const PieceDart& dart) { return dart.cap.rows() == 0; });
    return darts;
}

void addLegs(ApparelDrawing& made, const Pattern& pattern, std::size_t index) {
    const DrawnBlock block = made.drawing.blocks[index];
    const PatternPiece& piece = pieceOf(pattern, block);
    const std::vector<PieceDart> darts = cappedDarts(piece);
    for (std::size_t k = 0; k < darts.size(); ++k) {
        made.lines[index].push_back({made.drawing.paths.size(), kInternalLayer});
        made.drawing.paths.push_back(
            {"piece-" + piece.slug + "--dart-" + std::to_string(k + 1) + "-legs",
             LayerKind::Internal,
             placedLine(geometry::Line::closed(piece.outline).part(darts[k].from, darts[k].to),
                        block.placement),
             false});
    }
}

/// The point on a closed line nearest to a point.
Eigen::Vector2d nearestOn(const Points2& line, const Eigen::Vector2d& point) {
    Eigen::Vector2d best = point;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
        const Eigen::Vector2d a = line.row(k), b = line.row((k + 1) % line.rows());
        const Eigen::Vector2d there = a + geometry::nearestShare(point, a, b) * (b - a);
        if ((there - point).norm() < least) {
            least = (there - point).norm();
            best = there;
        }
    }
    return best;
}

/// Starts and directions of notch slits, independent of the drawn form, as the record needs. An
/// allowance is parallel to the seam line except for fractions of a millimetre, so each start is
/// moved onto the cutting line.
std::vector<ApparelNotch> notchRecords(const Pattern& pattern, const PatternPiece& piece,
                                       const Placement& placement) {
    const auto marks = notchMarks(pattern, piece, NotchForm::Slit);
    std::vector<ApparelNotch> records;
    for (std::size_t k = 0; k < marks.size(); ++k) {
        const int hole = piece.notches[k].hole;
        const Points2& cut = hole < 0 ? edgeOf(piece) : piece.holes[static_cast<std::size_t>(hole)];
        for (const Points2& slit : marks[k]) {
            const Eigen::Vector2d at = slit.row(0), end = slit.row(1);
            const Eigen::Vector2d there = nearestOn(cut, at);
            records.push_back({placement.applied((there - at).norm() < kNearCut ? there : at),
                               placement.linear() * (end - at).normalized(), (end - at).norm()});
        }
    }
    return records;
}

/// The line through an inner point in a direction, to the edge on both sides, slightly shortened.
Chord chordThrough(const Points2& outline, const Eigen::Vector2d& place, double angle) {
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    double before = std::numeric_limits<double>::infinity(), after = before;
    for (Eigen::Index k = 0; k < outline.rows(); ++k) {
        const Eigen::Vector2d a = outline.row(k), b = outline.row((k + 1) % outline.rows());
        const double sideA = geometry::cross(way, a - place),
                     sideB = geometry::cross(way, b - place);
        if ((sideA < 0) == (sideB < 0)) {
            continue;
        }
        const double at = way.dot(a + sideA / (sideA - sideB) * (b - a) - place);
        (at > 0 ? after : before) = std::min(at > 0 ? after : before, std::abs(at));
    }
    const auto kept = [](double room) -> double {
        return std::isfinite(room) ? std::min(kGrainShare * room, 0.5 * kLongestGrain) : kMinGrain;
    };
    return {place - kept(before) * way, place + kept(after) * way};
}

/// Every receiving program expects a grain line: the drawn one, else one through the middle.
Chord grainOfBlock(const Drawing& drawing, const DrawnBlock& block, const PatternPiece& piece,
                   const Eigen::Vector2d& middle) {
    for (std::size_t k = block.path; k < block.path + block.pathCount; ++k) {
        if (drawing.paths[k].layer == LayerKind::Grain) {
            return {drawing.paths[k].points.row(0), drawing.paths[k].points.row(1)};
        }
    }
    return chordThrough(drawing.paths[block.path].points, middle,
                        directionOnSheet(block.placement, grainOf(piece)));
}

/// The fold over the full extent of the cloth, including hems.
Chord mirrorOf(const PatternPiece& piece, const Placement& placement) {
    const Chord fold = foldOfEdge(piece);
    return {placement.applied(fold.from), placement.applied(fold.to)};
}

int layerOf(const DrawnPath& path, bool isOutline) {
    switch (path.layer) {
        case LayerKind::Cut:
            return isOutline ? kCutLayer : kHoleLayer;
        case LayerKind::Sew:
            return kSewLayer;
        case LayerKind::Internal:
            return kInternalLayer;
        default:
            return 0;
    }
}

ApparelLine apparelLine(const Drawing& drawing, std::size_t path, int layer,
                        const KeyPoints& keys) {
    const DrawnPath& drawn = drawing.paths[path];
    const geometry::Line line(drawn.points, drawn.closed);
    ApparelLine made{layer, path, drawn.closed};
    made.keys.resize(static_cast<Eigen::Index>(keys.size()), 2);
    std::vector<Eigen::Vector2d> dense;
    double before = keys.front().at, turns = 0;  // the last key point
    const auto addPointsUntil = [&](double end) {
        const int last = line.firstAfter(end - kSameStation);
        for (int k = line.firstAfter(before + kSameStation); k < last; ++k) {
            dense.push_back(line.point(k).transpose());
        }
        before = end;
    };
    for (std::size_t k = 0; k < keys.size(); ++k) {
        turns += k > 0 && keys[k].at < keys[k - 1].at ? line.length() : 0;
        const double at = turns + keys[k].at;
        addPointsUntil(at);
        const Eigen::Vector2d point = line.pointAt(keys[k].at).transpose();
        made.keys.row(static_cast<Eigen::Index>(k)) = point.transpose();
        made.isTurn.push_back(keys[k].isTurn);
        dense.push_back(point);
    }
    if (drawn.closed) {
        addPointsUntil(keys.front().at + line.length());
    }
    made.dense.resize(static_cast<Eigen::Index>(dense.size()), 2);
    for (std::size_t k = 0; k < dense.size(); ++k) {
        made.dense.row(static_cast<Eigen::Index>(k)) = dense[k].transpose();
    }
    return made;
}

/// A name of limited length that is not taken yet.
std::string freeName(const std::string& wanted, std::set<std::string>& taken) {
    std::string name = wanted;
    for (int k = 2; !taken.insert(name).second; ++k) {
        const std::string number = "-" + std::to_string(k);
        name = wanted.substr(0, kLongestName - number.size()) + number;
    }
    return name;
}

Eigen::Vector2d middleOf(const Drawing& drawing, const DrawnBlock& block) {
    for (std::size_t k = block.text; k < block.text + block.textCount; ++k) {
        if (drawing.texts[k].layer == LayerKind::Text) {
            return drawing.texts[k].position;
        }
    }
    return drawing.paths[block.path].points.colwise().mean().transpose();
}

}  // namespace

int validationLayer(int layer) {
    switch (layer) {
        case kInternalLayer:
            return 85;
        case kHoleLayer:
            return 86;
        case kSewLayer:
            return 87;
        default:
            return 84;
    }
}

std::string apparelName(std::string_view name, std::string_view otherwise) {
    std::string made;
    bool hasSign = false;
    for (const char c : asciiText(name)) {
        const bool isLower = c >= 'a' && c <= 'z';
        const bool isSign = isLower || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        hasSign |= isSign;
        const char sign = isLower ? static_cast<char>(c - 'a' + 'A') : isSign || c == '-' ? c : '_';
        if (sign != '_' || made.empty() || made.back() != '_') {
            made += sign;  // one sign for a run of unsupported characters
        }
    }
    if (!hasSign) {
        return otherwise.empty() ? "PIECE" : apparelName(otherwise, {});
    }
    made = made.substr(0, kLongestName);
    while (made.size() > 1 && made.back() == '_') {
        made.pop_back();
    }
    return made.substr(made.size() > 1 && made.front() == '_' ? 1 : 0);
}

ApparelDrawing apparelDrawing(const ExportSource& source) {
    ApparelDrawing made{source.drawing(), {}};
    for (DrawnPath& path : made.drawing.paths) {
        path.layer = path.isDrill ? LayerKind::Marks : path.layer;
    }
    made.lines.resize(made.drawing.blocks.size());
    for (std::size_t b = 0; b < made.lines.size(); ++b) {
        const DrawnBlock& block = made.drawing.blocks[b];
        for (std::size_t k = block.path; k < block.path + block.pathCount; ++k) {
            const DrawnPath& path = made.drawing.paths[k];
            const int layer = layerOf(path, k == block.path);
            if (layer != 0 && path.points.rows() > 0) {
                made.lines[b].push_back({k, layer});
            }
        }
        addLegs(made, source.laid().pattern, b);
    }
    return made;
}

std::vector<std::string> apparelNames(const Pattern& pattern, const Drawing& drawing) {
    std::set<std::string> taken{kControlName};
    std::vector<std::string> names;
    for (const DrawnBlock& block : drawing.blocks) {
        const PatternPiece& piece = pieceOf(pattern, block);
        const std::string number =
            piece.number > 0 ? "piece-" + std::to_string(piece.number) : piece.slug;
        names.push_back(freeName(apparelName(piece.name, number), taken));
    }
    return names;
}

std::vector<ApparelPiece> apparelPieces(const ExportSource& source, const ApparelDrawing& made) {
    const Pattern& pattern = source.laid().pattern;
    const Drawing& drawing = made.drawing;
    const std::vector<KeyPoints> keys = keyPoints(drawing, pattern, source.garment());
    const std::vector<std::string> names = apparelNames(pattern, drawing);
    std::vector<ApparelPiece> pieces;
    for (std::size_t b = 0; b < drawing.blocks.size(); ++b) {
        const DrawnBlock& block = drawing.blocks[b];
        const PatternPiece& piece = pieceOf(pattern, block);
        ApparelPiece& out = pieces.emplace_back();
        out.name = names[b];
        out.block = b;
        out.middle = middleOf(drawing, block);
        out.grain = grainOfBlock(drawing, block, piece, out.middle);
        out.notches = notchRecords(pattern, piece, block.placement);
        for (const PieceInternal& internal : piece.internals) {
            if (isDrillPoint(internal)) {
                out.drills.push_back(block.placement.applied(internal.points.row(0).transpose()));
            }
        }
        for (const PieceDart& dart : cappedDarts(piece)) {
            out.drills.push_back(block.placement.applied(dart.drill));
        }
        if (piece.cutAs == CutAs::OnFold) {
            out.mirror = mirrorOf(piece, block.placement);
        }
        for (const auto& [path, layer] : made.lines[b]) {
            out.lines.push_back(apparelLine(drawing, path, layer, keys[path]));
        }
    }
    return pieces;
}

}  // namespace toile
