// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/line_edits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/assemble/file_space.h"
#include "core/garment/lineage.h"
#include "core/pattern/dart_places.h"
#include "core/pattern/facings.h"
#include "core/pattern/mirrored_edit.h"
#include "core/pattern/notches.h"
#include "core/pattern/pattern.h"
#include "core/pattern/piece_allowance.h"
#include "core/seam/seam_settings.h"
#include "core/symmetry/symmetry.h"

namespace toile::app {

namespace {

/// Places on a line are equal if they differ by less.
constexpr double kSameShare = 1e-7;

/// Whether both stretches cover more than half of each other.
bool isSamePlace(const LineStretch& one, const LineStretch& other) {
    return covered(other, one) > 0.5 && covered(one, other) > 0.5;
}

void addOnce(std::vector<SegmentAt>& segments, const std::optional<SegmentAt>& one) {
    if (one && std::ranges::find(segments, *one) == segments.end()) {
        segments.push_back(*one);
    }
}

/// With allowances if `isNeeded`.
LineSettings withAllowances(LineSettings lines, bool isNeeded) {
    lines.allowance = isNeeded ? lines.allowance.value_or(AllowanceWidths{}) : lines.allowance;
    return lines;
}

/// With one value in the settings of segments.
template <class Value>
LineSettings withValue(LineSettings lines, const LineFacts& facts,
                       const std::vector<SegmentAt>& segments, Value SegmentSettings::*member,
                       const Value& value) {
    for (const SegmentAt& at : segments) {
        SegmentSettings settings = facts.at(at).settings;
        if (settings.place.line) {
            settings.*member = value;
            lines = withSegment(std::move(lines), settings);
        }
    }
    return lines;
}

/// The same corner on an outline that runs the other way.
CornerRule turnedRule(CornerRule rule) {
    switch (rule) {
        case CornerRule::RightAngleFirst:
            return CornerRule::RightAngleSecond;
        case CornerRule::RightAngleSecond:
            return CornerRule::RightAngleFirst;
        case CornerRule::MirrorFirst:
            return CornerRule::MirrorSecond;
        case CornerRule::MirrorSecond:
            return CornerRule::MirrorFirst;
        default:
            return rule;
    }
}

/// The facing that a place is part of; null if there is none.
template <class Facings>
auto* facingAt(Facings& facings, const LineStretch& place) {
    const auto found = std::ranges::find_if(
        facings, [&place](const Facing& facing) { return isFaced(place, facing); });
    return found == facings.end() ? nullptr : &*found;
}

/// The facing of the segment before or after; joins two different ones.
Facing* facingBeside(LineSettings& lines, const LineFacts& facts, const SegmentAt& at) {
    const auto& around = facts.segments[static_cast<std::size_t>(at.piece)].segments;
    const std::size_t count = around.size(), k = static_cast<std::size_t>(at.segment);
    const LineStretch& before = around[(k + count - 1) % count].place;
    const LineStretch& after = around[(k + 1) % count].place;
    Facing* first = facingAt(lines.facings, before);
    Facing* second = facingAt(lines.facings, after);
    if (first && second && first != second) {
        first->edges.insert(first->edges.end(), second->edges.begin(), second->edges.end());
        lines.facings.erase(lines.facings.begin() + (second - lines.facings.data()));
        first = facingAt(lines.facings, before);
    }
    return first ? first : facingAt(lines.facings, after);
}

/// Also removes edges that cover most of the place, or lie mostly within it.
void removeFromFacings(LineSettings& lines, const LineStretch& place) {
    for (Facing& facing : lines.facings) {
        std::erase_if(facing.edges, [&place](const LineStretch& edge) {
            return covered(edge, place) > 0.5 || covered(place, edge) > 0.5;
        });
    }
    std::erase_if(lines.facings, [](const Facing& facing) { return facing.edges.empty(); });
}

const Seam& dartOf(const Garment& garment, int dart) {
    return garment.seams.seams[static_cast<std::size_t>(dart)];
}

LineSettings withDart(LineSettings lines, const Garment& garment, int dart, DartSettings settings) {
    std::erase_if(lines.darts, [&](const DartSettings& one) -> bool {
        return seamAt(garment.seams, one.seam) == dart;
    });
    settings.seam = dartOf(garment, dart).place;
    if (!settings.saysNothing()) {
        lines.darts.push_back(settings);
    }
    return lines;
}

/// The mirror image of a dart, if it is another one.
std::optional<int> mirroredDart(const Garment& garment, int dart, const Symmetry* symmetry) {
    const auto at = static_cast<std::size_t>(dart);
    if (!symmetry || at >= symmetry->lengths.mirrored.size()) {
        return std::nullopt;
    }
    const int image = symmetry->lengths.mirrored[at];
    return image >= 0 && image != dart && dartOf(garment, image).kind == SeamKind::Dart
               ? std::optional(image)
               : std::nullopt;
}

/// With one value in the settings of a dart, and another in those of its mirror image.
template <class Value>
LineSettings withDartValue(LineSettings lines, const Garment& garment, int dart,
                           Value DartSettings::*field, const Value& value, const Value& mirrored,
                           const Symmetry* symmetry) {
    DartSettings settings = dartSettings(garment, lines, dart);
    settings.*field = value;
    lines = withDart(std::move(lines), garment, dart, settings);
    if (const auto image = mirroredDart(garment, dart, symmetry)) {
        DartSettings there = dartSettings(garment, lines, *image);
        there.*field = mirrored;
        lines = withDart(std::move(lines), garment, *image, there);
    }
    return lines;
}

/// Mirrored outlines run in opposite directions.
DartLay mirroredLay(DartLay lay) {
    return lay == DartLay::First ? DartLay::Second : DartLay::First;
}

/// Places on a line, and shares of a seam, are equal if they differ by less.
constexpr double kSamePart = 1e-6;

bool isFirst(const SeamNotch& one, const SeamNotch& other) {
    return std::tie(one.seam, one.share) < std::tie(other.seam, other.share);
}

bool areOne(const SeamNotch& one, const SeamNotch& other) {
    return one.seam == other.seam && std::abs(one.share - other.share) < kSamePart;
}

/// The setting that put a notch exactly there; -1: none.
int indexOf(const NotchRules& rules, const Garment& garment, const NotchAt& at) {
    const auto place = notchSettingsAt(garment, at.seam, at.share);
    const auto found = std::ranges::find_if(rules.notches, [&](const NotchSettings& said) {
        return place && said.isThere && said.line == place->line &&
               said.reversed == place->reversed && std::abs(said.at - place->at) < kSamePart;
    });
    return found == rules.notches.end() ? -1 : static_cast<int>(found - rules.notches.begin());
}

/// The same for the mirrored place; also -1 if it is ambiguous which end of the other seam mirrors
/// the start of this one.
int mirroredIndexOf(const NotchRules& rules, const Garment& garment, const NotchAt& at,
                    const Symmetry* symmetry) {
    const auto seam = static_cast<std::size_t>(at.seam);
    if (!symmetry || seam >= symmetry->lengths.mirrored.size() ||
        symmetry->lengths.mirrored[seam] < 0) {
        return -1;
    }
    const int other = symmetry->lengths.mirrored[seam];
    const int alike = indexOf(rules, garment, {other, at.share});
    const int turned = indexOf(rules, garment, {other, 1 - at.share});
    return alike < 0 || turned < 0 || alike == turned ? std::max(alike, turned) : -1;
}

}  // namespace

LineSettings withFairing(LineSettings lines) {
    lines.fairing = lines.fairing.value_or(Fairing{});
    return lines;
}

LineSettings withSegment(LineSettings lines, const SegmentSettings& settings) {
    std::erase_if(lines.segments, [&settings](const SegmentSettings& one) -> bool {
        return isSamePlace(one.place, settings.place);
    });
    if (!settings.saysNothing()) {
        lines.segments.push_back(settings);
    }
    return lines;
}

LineSettings withoutLength(LineSettings lines, const LineStretch& place) {
    for (SegmentSettings& one : lines.segments) {
        if (isSamePlace(one.place, place)) {
            one.length.reset();
        }
    }
    std::erase_if(lines.segments, [](const SegmentSettings& one) { return one.saysNothing(); });
    return lines;
}

std::vector<SegmentAt> alikeSegments(const Garment& garment, const LineFacts& facts,
                                     const SegmentAt& one, bool bothSides,
                                     const Symmetry* symmetry) {
    std::vector<SegmentAt> alike{one};
    if (bothSides) {
        addOnce(alike, partnerOf(garment, facts, one));
    }
    if (symmetry) {
        const std::vector<SegmentAt> asked = alike;
        for (const SegmentAt& there : asked) {
            addOnce(alike, mirrorOf(garment, facts, *symmetry, there));
        }
    }
    return alike;
}

double allowanceOf(const Garment& garment, const Segment& segment, const LineSettings& lines) {
    PatternSegment kind;
    kind.seam = segment.seam + 1;
    if (segment.seam >= 0) {
        kind.kind = garment.seams.seams[static_cast<std::size_t>(segment.seam)].kind;
    }
    kind.edge = segment.edge();
    kind.isFaced = facingOf(lines, segment).has_value();
    return segment.settings.allowance.value_or(
        usualAllowance(kind, lines.allowance.value_or(AllowanceWidths{})));
}

LineSettings withAllowance(LineSettings lines, const LineFacts& facts,
                           const std::vector<SegmentAt>& segments, std::optional<double> width) {
    return withAllowances(
        withValue(std::move(lines), facts, segments, &SegmentSettings::allowance, width),
        width.has_value());
}

LineSettings withCorner(LineSettings lines, const LineFacts& facts, const SegmentAt& one,
                        const std::optional<SegmentAt>& image, std::optional<CornerRule> rule) {
    lines = withValue(std::move(lines), facts, {one}, &SegmentSettings::corner, rule);
    if (image) {
        const auto& there = facts.segments[static_cast<std::size_t>(image->piece)].segments;
        const std::size_t next = (static_cast<std::size_t>(image->segment) + 1) % there.size();
        const SegmentAt after{image->piece, static_cast<int>(next)};
        if (!(after == one)) {
            lines = withValue(std::move(lines), facts, {after}, &SegmentSettings::corner,
                              rule ? std::optional(turnedRule(*rule)) : std::nullopt);
        }
    }
    return withAllowances(std::move(lines), rule.has_value());
}

LineSettings withEdgeKind(LineSettings lines, const LineFacts& facts,
                          const std::vector<SegmentAt>& segments, std::optional<EdgeKind> kind) {
    return withValue(std::move(lines), facts, segments, &SegmentSettings::edge, kind);
}

LineSettings withExtension(LineSettings lines, const LineFacts& facts,
                           const std::vector<SegmentAt>& segments, std::optional<double> width) {
    return withValue(std::move(lines), facts, segments, &SegmentSettings::extension, width);
}

std::optional<double> facingOf(const LineSettings& lines, const Segment& segment) {
    const Facing* facing = facingAt(lines.facings, segment.place);
    return facing ? std::optional(facing->width) : std::nullopt;
}

LineSettings withFacing(LineSettings lines, const LineFacts& facts,
                        const std::vector<SegmentAt>& segments, std::optional<double> width,
                        const std::vector<std::string>& names) {
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const LineStretch& place = facts.at(segments[k]).place;
        if (!place.line) {
            continue;
        }
        if (!width) {
            removeFromFacings(lines, place);
        } else if (Facing* own = facingAt(lines.facings, place)) {
            own->width = *width;
        } else if (Facing* beside = facingBeside(lines, facts, segments[k])) {
            beside->edges.push_back(place);
            beside->width = *width;
        } else {
            lines.facings.push_back({names[k], {place}, *width});
        }
    }
    return lines;
}

DartSettings dartSettings(const Garment& garment, const LineSettings& lines, int dart) {
    const std::map<int, DartSettings> stated = statedDarts(garment.seams, lines);
    const auto found = stated.find(dart);
    return found != stated.end() ? found->second : DartSettings{};
}

LineSettings withIntake(LineSettings lines, const Garment& garment, int dart,
                        std::optional<double> intake, const Symmetry* symmetry) {
    return withDartValue(std::move(lines), garment, dart, &DartSettings::intake, intake, intake,
                         symmetry);
}

LineSettings withLay(LineSettings lines, const Garment& garment, int dart,
                     std::optional<DartLay> lay, const Symmetry* symmetry) {
    return withDartValue(std::move(lines), garment, dart, &DartSettings::lay, lay,
                         lay ? std::optional(mirroredLay(*lay)) : std::nullopt, symmetry);
}

LineSettings withSeamEnd(LineSettings lines, const SeamGraph& graph, const SeamEnd& end,
                         bool trued) {
    std::erase_if(lines.seamEnds, [&](const SeamEndSettings& one) -> bool {
        return one.atEnd == end.atEnd && seamAt(graph, one.seam) == end.seam;
    });
    if (trued != (std::abs(end.kink) <= lines.trueBelow)) {
        lines.seamEnds.push_back(
            {graph.seams[static_cast<std::size_t>(end.seam)].place, end.atEnd, trued});
    }
    return lines;
}

std::optional<TurnPointSettings> turnPointAt(const Piece& piece, int at) {
    const EdgeOrigin* origin =
        originAt(piece.origins, piece.boundary[static_cast<std::size_t>(at)]);
    if (!origin) {
        return std::nullopt;
    }
    return TurnPointSettings{origin->line, origin->from, origin->from > origin->to};
}

LineSettings withTurnPoint(LineSettings lines, const TurnPointSettings& point) {
    bool isUndone = false;  // the new setting only removes an earlier one
    std::erase_if(lines.turnPoints, [&](const TurnPointSettings& one) -> bool {
        const bool isSame = one.line == point.line && one.reversed == point.reversed &&
                            std::abs(one.at - point.at) < kSameShare;
        isUndone = isUndone || (isSame && one.turns != point.turns);
        return isSame;
    });
    if (!isUndone) {
        lines.turnPoints.push_back(point);
    }
    return lines;
}

LineSettings withInternalLine(LineSettings lines, const Garment& garment, std::string name,
                              ClothPoints points, bool closed) {
    InternalLine& line = lines.internalLines.emplace_back();
    line.name = std::move(name);
    line.points = inFileSpace(std::move(points), garment);
    line.closed = closed && line.points.size() > 2;
    return lines;
}

LineSettings withoutInternalLine(LineSettings lines, std::size_t index) {
    if (index < lines.internalLines.size()) {
        lines.internalLines.erase(lines.internalLines.begin() + static_cast<std::ptrdiff_t>(index));
    }
    return lines;
}

LineSettings withInternalPointMoved(LineSettings lines, const Garment& garment, std::size_t index,
                                    std::size_t point, const Eigen::Vector3d& to) {
    if (index < lines.internalLines.size() && point < lines.internalLines[index].points.size()) {
        lines.internalLines[index].points[point] = inFileSpace(to, {}, garment);
    }
    return lines;
}

std::optional<ClothPoints> mirroredInternalLine(const Garment& garment, const PieceResults& results,
                                                const Symmetry& symmetry, const ClothPoints& points,
                                                bool closed) {
    UserCut cut;
    cut.kind = closed ? UserCut::Kind::Loop : UserCut::Kind::Path;
    cut.points = points;
    if (points.size() == 1) {
        cut.points.push_back(points.front());  // a path of no length
    }
    auto image = mirroredCut(garment, results, symmetry, cut);
    if (!image) {
        return std::nullopt;
    }
    image->points.resize(points.size());
    return std::move(image->points);
}

std::optional<std::size_t> imageOfInternalLine(const LineSettings& lines, const Garment& garment,
                                               const PieceResults& results,
                                               const Symmetry& symmetry, std::size_t index) {
    const InternalLine& line = lines.internalLines[index];
    const auto image = mirroredInternalLine(garment, results, symmetry,
                                            inPieceSpace(line.points, garment), line.closed);
    for (std::size_t k = 0; image && k < lines.internalLines.size(); ++k) {
        const InternalLine& other = lines.internalLines[k];
        if (k == index || other.closed != line.closed ||
            other.points.size() != line.points.size()) {
            continue;
        }
        const ClothPoints points = inPieceSpace(other.points, garment);
        if (std::ranges::equal(points, *image, [](const auto& a, const auto& b) {
                return (a - b).norm() < kSameImage;
            })) {
            return k;
        }
    }
    return std::nullopt;
}

LineSettings withInternalLineAsImage(LineSettings lines, const Garment& garment,
                                     const PieceResults& results, const Symmetry& symmetry,
                                     std::size_t of, std::size_t image) {
    const InternalLine& line = lines.internalLines[of];
    if (auto points = mirroredInternalLine(garment, results, symmetry,
                                           inPieceSpace(line.points, garment), line.closed)) {
        lines.internalLines[image].points = inFileSpace(std::move(*points), garment);
    }
    return lines;
}

std::vector<SeamNotch> notchesOf(const Pattern& pattern) {
    std::vector<SeamNotch> notches;
    for (const PatternPiece& piece : pattern.pieces) {
        for (const PieceNotch& notch : piece.notches) {
            SeamNotch& one = notches.emplace_back();
            one.seam = notch.seam - 1;
            one.share = notch.share;
            one.reason = notch.reason;
        }
    }
    std::ranges::sort(notches, isFirst);
    notches.erase(std::unique(notches.begin(), notches.end(), areOne), notches.end());
    return notches;
}

LineSettings withNotch(LineSettings lines, const Garment& garment, const NotchAt& at) {
    if (const auto said = notchSettingsAt(garment, at.seam, at.share)) {
        lines.notches = lines.notches.value_or(NotchRules{});
        lines.notches->notches.push_back(*said);
    }
    return lines;
}

LineSettings withoutNotch(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                          const Symmetry* symmetry) {
    if (!lines.notches) {
        return lines;
    }
    if (notch.reason == NotchReason::ByHand) {
        int index = indexOf(*lines.notches, garment, notch);
        index = index < 0 ? mirroredIndexOf(*lines.notches, garment, notch, symmetry) : index;
        if (index >= 0) {
            lines.notches->notches.erase(lines.notches->notches.begin() + index);
            return lines;
        }
    }
    if (auto said = notchSettingsAt(garment, notch.seam, notch.share)) {
        said->isThere = false;
        lines.notches->notches.push_back(*said);
    }
    return lines;
}

LineSettings withNotchMoved(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                            double share, const Symmetry* symmetry) {
    return withNotch(withoutNotch(std::move(lines), garment, notch, symmetry), garment,
                     {notch.seam, share});
}

}  // namespace toile::app
