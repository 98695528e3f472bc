// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/strip_edits.h"

#include <algorithm>
#include <utility>

#include "app/document/line_edits.h"
#include "core/pattern/facings.h"
#include "core/seam/seam_settings.h"

namespace toile::app {

namespace {

/// The facing that a place is part of; null where it is part of none.
template <class Facings>
auto* facingAt(Facings& facings, const LineStretch& place) {
    const auto found = std::ranges::find_if(
        facings, [&place](const Facing& facing) { return isFaced(place, facing); });
    return found == facings.end() ? nullptr : &*found;
}

/// That of a segment before or after; of two different ones one is made first.
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

/// Also what lies about it, or within it, for the most part.
void takeOut(LineSettings& lines, const LineStretch& place) {
    for (Facing& facing : lines.facings) {
        std::erase_if(facing.edges, [&place](const LineStretch& edge) {
            return covered(edge, place) > 0.5 || covered(place, edge) > 0.5;
        });
    }
    std::erase_if(lines.facings, [](const Facing& facing) { return facing.edges.empty(); });
}

}  // namespace

LineSettings withExtension(LineSettings lines, const LineFacts& facts,
                           const std::vector<SegmentAt>& segments, std::optional<double> width) {
    for (const SegmentAt& at : segments) {
        SegmentSettings said = facts.at(at).settings;
        if (said.place.line) {
            said.extension = width;
            lines = withSegment(std::move(lines), said);
        }
    }
    return lines;
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
            takeOut(lines, place);
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

}  // namespace toile::app
