// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/rest_pattern.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/formats/dxf/apparel_dxf.h"
#include "core/formats/read_pattern.h"
#include "core/formats/tables/pattern_match.h"
#include "core/garment/piece.h"
#include "core/geometry/line.h"
#include "core/geometry/polygon.h"
#include "core/pattern/segments.h"
#include "core/prove/proof_words.h"
#include "core/quality/measures.h"

namespace toile::prove {
namespace {

/// A loop of a piece in our pattern.
struct OurLoop {
    Points3 space;
    geometry::Line drawn;  ///< measured on the garment
};

/// The outline, then the rims of the holes.
/// @param flat  positions of the piece's vertices
/// @param line  of the outline if it is not the polygon of its vertices, or null
/// Cost: linear. Pure.
std::vector<OurLoop> ourLoops(const Piece& piece, const Points2& flat, const FlatLine* line) {
    std::vector<OurLoop> loops;
    const Points3& V = piece.mesh.V;
    const auto add = [&](const std::vector<int>& loop, const FlatLine* drawn) {
        const Points3 space = V(loop, Eigen::all);
        loops.push_back(
            {space, drawn != nullptr
                        ? geometry::Line::closed(drawn->points, drawn->arc)
                        : geometry::Line::closed(flat(loop, Eigen::all),
                                                 geometry::arcOf(boundaryLengths3d(V, loop)))});
    };
    add(piece.boundary, line);
    for (const std::vector<int>& hole : piece.holes) {
        add(hole, nullptr);
    }
    return loops;
}

/// A fit is clearly better if it is below this share of the other minus this many mm.
constexpr double kClearlyShare = 0.6, kClearlyLength = 0.3;
/// From this distance, mm, the fit of other pieces is tested too.
constexpr double kFitsBadly = 1;
/// Largest distance, as a share of their size, between shapes of a pair's two halves.
constexpr double kSameShape = 0.1;

bool isClearlyBetter(double distance, double than) {
    return distance < kClearlyShare * than - kClearlyLength;
}

Points2 turnedOver(const Points2& line) {
    Points2 image = line.colwise().reverse();
    image.col(0) *= -1;
    return image;
}

Points2 turnedBy(const Points2& line, double angle) {
    return angle == 0 ? line : Points2(line * Eigen::Rotation2Dd(-angle).toRotationMatrix());
}

/// The line to sew along.
const Points2& sewingLine(const FilePiece& piece) {
    return piece.sew.rows() > 2 ? piece.sew : piece.cut;
}

double directionOf(const FileChord& chord) {
    const Eigen::Vector2d way = chord[1] - chord[0];
    return std::atan2(way.y(), way.x());
}

/// Fit of a piece of the file to one of ours.
struct FittedPiece {
    bool mirrored = false;
    RoughFit fit;
};

class RestMaker {
public:
    RestMaker(const ExportSource& source, const PatternFile& file)
        : source_(source),
          garment_(source.garment()),
          file_(file),
          pattern_(source.laid().wholePattern) {
        rest_.pieces.resize(garment_.pieces.size());
    }

    RestPattern made() {
        const PatternMatch match = matchPatterns(pattern_, file_);
        for (const PieceMatch& pair : match.pairs) {
            fileOf_[pair.piece] = pair.filePiece;
        }
        for (const int piece : match.alone) {
            if (const auto other = drawnOnce(piece, match)) {
                fileOf_[piece] = *other;
            }
        }
        for (const PieceMatch& pair : match.pairs) {
            add(pair.piece, pair.by);
        }
        for (const int piece : match.alone) {
            if (fileOf_.contains(piece)) {
                add(piece, MatchedBy::Shape);
            } else {
                rest_.faults.push_back(pieceNotThere(garment_, piece));
            }
        }
        for (const int alone : match.aloneInFile) {
            if (!isFacing(file_.pieces[alone])) {
                rest_.faults.push_back(pieceNotNeeded(file_.pieces[alone]));
            }
        }
        return std::move(rest_);
    }

private:
    const PatternPiece& ours(int k) const { return pattern_.pieces[static_cast<std::size_t>(k)]; }
    const FilePiece& theirs(int k) const { return file_.pieces[static_cast<std::size_t>(k)]; }

    /// Angles to try for a file's piece to match ours: those of the grain lines, then 0.
    std::vector<double> anglesFor(int piece, const FilePiece& other, bool mirrored) const {
        std::vector<double> angles{0};
        if (other.grain) {
            const double grain = directionOf(*other.grain);
            const double their = mirrored ? std::numbers::pi - grain : grain;
            const double turn = std::remainder(grainOf(ours(piece)) - their, std::numbers::pi);
            const double back = turn > 0 ? turn - std::numbers::pi : turn + std::numbers::pi;
            // A turn within the chord's rounding is ignored.
            constexpr double kNoTurn = 1e-4;
            angles.insert(
                angles.begin(),
                {std::abs(turn) < kNoTurn ? 0 : turn,
                 std::abs(std::abs(back) - std::numbers::pi) < kNoTurn ? std::numbers::pi : back});
        }
        return angles;
    }

    RoughFit fitOf(int piece, const FilePiece& other, bool mirrored) const {
        const Points2 line = geometry::antiClockwise(sewingLine(other));
        return roughFit(geometry::Line::closed(ours(piece).outline),
                        geometry::Line::closed(mirrored ? turnedOver(line) : line),
                        anglesFor(piece, other, mirrored));
    }

    FittedPiece fittedTo(int piece, const FilePiece& other) const {
        const RoughFit plain = fitOf(piece, other, false), image = fitOf(piece, other, true);
        const bool mirrored = isClearlyBetter(image.distance, plain.distance);
        return {mirrored, mirrored ? image : plain};
    }

    /// The file's piece that also represents a piece without partner, as another copy or mirrored.
    std::optional<int> drawnOnce(int piece, const PatternMatch& match) const {
        std::optional<int> best;
        double least =
            kSameShape * std::sqrt(std::abs(geometry::signedAreaOf(ours(piece).outline)));
        for (const PieceMatch& pair : match.pairs) {
            const FilePiece& other = theirs(pair.filePiece);
            for (const bool mirrored : {true, false}) {
                const bool isCut = mirrored ? other.mirroredQuantity > 0 : other.quantity > 1;
                const double ratio = geometry::perimeterOf(sewingLine(other)) /
                                     geometry::perimeterOf(ours(piece).outline);
                if (!isCut || ratio > 1 + 2 * kSameShape || ratio < 1 - 2 * kSameShape) {
                    continue;
                }
                const double distance = fitOf(piece, other, mirrored).distance;
                if (distance < least) {
                    least = distance;
                    best = pair.filePiece;
                }
            }
        }
        return best;
    }

    /// Whether its name is that of one of our facings, which are never sewn in a proof.
    bool isFacing(const FilePiece& piece) const {
        // Only names of at least this length may have been cut off by their writer.
        constexpr std::size_t kCutOff = 18;
        const std::string called = plainName(piece.name);
        const auto isIt = [&](const std::string& facing) {
            const std::string plain = plainName(facing);
            return plain == called || (piece.name.size() >= kCutOff && plain.starts_with(called));
        };
        const auto& facings = source_.laid().wholePattern.facings;
        return !called.empty() && std::ranges::any_of(facings, [&](const FacingPiece& facing) {
            return isIt(facing.strip.slug) || isIt(facing.strip.name);
        });
    }

    /// Another piece that fits this one's file piece better than its own file piece does.
    int fitsRather(int piece, double distance) const {
        if (distance < kFitsBadly) {
            return -1;
        }
        for (const auto& [other, filePiece] : fileOf_) {
            if (other == piece || filePiece == fileOf_.at(piece)) {
                continue;
            }
            const double there = fitOf(other, theirs(fileOf_.at(piece)), false).distance;
            const double own = fitOf(other, theirs(filePiece), false).distance;
            if (isClearlyBetter(there, distance) && isClearlyBetter(there, own)) {
                return other;
            }
        }
        return -1;
    }

    /// Whether the mirror image of this piece fits another piece unmirrored: a file without names
    /// may mean that piece.
    bool hasImage(int piece, const FilePiece& other, double distance) const {
        for (int k = 0; k < static_cast<int>(pattern_.pieces.size()); ++k) {
            if (k != piece && ours(k).outline.rows() > 2 &&
                !isClearlyBetter(distance, fitOf(k, other, false).distance)) {
                return true;
            }
        }
        return false;
    }

    void add(int piece, MatchedBy by) {
        const auto index = static_cast<std::size_t>(piece);
        const FilePiece& other = theirs(fileOf_.at(piece));
        const PieceResult& result = *source_.results()[index];
        FittedPiece fitted = fittedTo(piece, other);
        const bool isPair = other.mirroredQuantity > 0;
        if (by == MatchedBy::Shape) {
            if (fitted.mirrored && !isPair && !hasImage(piece, other, fitted.fit.distance)) {
                rest_.faults.push_back(pieceMirrored(garment_, piece));
            }
        } else {
            const double plain = fitOf(piece, other, false).distance;
            const int rather = fitsRather(piece, plain);
            if (rather >= 0) {
                rest_.faults.push_back(otherPieceFits(garment_, piece, rather, other));
                fitted = {false, fitOf(piece, other, false)};
            } else if (fitted.mirrored && !isPair) {
                rest_.faults.push_back(pieceMirrored(garment_, piece));
            }
        }
        RestPiece& rest = rest_.pieces[index].emplace();
        rest.flat = result.flat->Q;
        const double grain = other.grain ? directionOf(*other.grain) : 0;
        rest.warp = other.grain
                        ? (fitted.mirrored ? std::numbers::pi - grain : grain) + fitted.fit.angle
                        : grainOf(ours(piece));
        addLoops(rest, ourLoops(*result.piece, rest.flat, result.flat->line.get()), other, fitted);
    }

    static void addLoops(RestPiece& rest, std::vector<OurLoop> loops, const FilePiece& other,
                         const FittedPiece& fitted) {
        const auto asLaid = [&](const Points2& line) {
            return turnedBy(fitted.mirrored ? turnedOver(line) : line, fitted.fit.angle);
        };
        const auto onto = [](OurLoop& loop, const Points2& line, const RoughFit& fit) {
            auto there = geometry::Line::closed(line);
            LineMap map(geometry::Line::closed(loop.drawn.points()), there, fit);
            return RestLoop(std::move(loop.space), std::move(loop.drawn), std::move(there),
                            std::move(map));
        };
        // At rest the piece has our orientation, but not our position.
        const Points2 outline = asLaid(geometry::antiClockwise(sewingLine(other)));
        const Eigen::RowVector2d move = middleOf(geometry::Line::closed(loops[0].drawn.points())) -
                                        middleOf(geometry::Line::closed(outline));
        rest.loops.emplace_back(onto(loops[0], outline, fitted.fit));
        std::vector<Points2> holes;
        for (const Points2& hole : other.holes) {
            if (hole.rows() < 3) {
                continue;
            }
            const Points2 line = asLaid(hole);
            holes.push_back(geometry::signedAreaOf(line) > 0 ? Points2(line.colwise().reverse())
                                                             : line);
        }
        for (std::size_t k = 1; k < loops.size(); ++k) {
            const auto rim = geometry::Line::closed(loops[k].drawn.points());
            const Eigen::RowVector2d middle = middleOf(rim) - move;
            const auto farFrom = [&](const Points2& hole) {
                return (middleOf(geometry::Line::closed(hole)) - middle).norm();
            };
            const auto found = std::ranges::min_element(holes, {}, farFrom);
            if (found == holes.end() || farFrom(*found) > rim.length() / 4) {
                rest.loops.emplace_back();
                continue;
            }
            const RoughFit fit = roughFitAt(rim, geometry::Line::closed(*found), 0);
            rest.loops.emplace_back(onto(loops[k], *found, fit));
            holes.erase(found);
        }
        rest.others = std::move(holes);
    }

    const ExportSource& source_;
    const Garment& garment_;
    const PatternFile& file_;
    const Pattern& pattern_;
    std::map<int, int> fileOf_;  ///< per piece of ours: the file's piece
    RestPattern rest_;
};

/// Matches the pieces of a file to ours: pairs them, orients each, and finds faults. A pair that
/// the file draws once serves both.  Cost: that of `matchPatterns`. Pure.
RestPattern restOfFile(const ExportSource& source, const PatternFile& file) {
    return RestMaker(source, file).made();
}

/// The designer's panels: their lines correspond to ours directly.
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
            auto line = geometry::Line::closed(loop.drawn.points());
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

/// The garment's own pattern as another pattern program would read it.
Result<PatternFile> readBack(const ExportSource& source) {
    LaidOutPattern laid;
    laid.wholePattern = source.laid().wholePattern;
    laid.pattern = laid.wholePattern;
    laid.whole = laid.marker = placeCopies(laid.pattern);
    ExportOptions options;
    const ExportSource whole(source.garment(), source.results(), laid, options, {}, source.lines(),
                             source.fabric());
    // The unit is given, because a doll's file would be taken for one in centimetres.
    auto file = readPattern(writeApparelDxf(whole), PatternFileKind::Dxf, laid.pattern.name,
                            FileUnit(options.dxf.unit));
    if (!file) {
        return file.error();
    }
    // Restores our order; names are cut off after some characters.
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

RestLoop::RestLoop(Points3 space, geometry::Line drawn, geometry::Line rest, LineMap map)
    : space_(geometry::SpaceLine::closed(std::move(space))),
      drawn_(std::move(drawn)),
      along_(geometry::Line::closed(drawn_.points())),
      rest_(std::move(rest)),
      map_(std::move(map)) {
    for (const int k : findCorners(drawn_.points())) {
        // A line drawn as the image of another may begin elsewhere than the outline.
        corners_.push_back(space_.wrap(drawn_.arc()[k]));
    }
}

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
