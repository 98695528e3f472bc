// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/line_facts.h"

namespace toile::app {

/// What a person decides of strips along segments, one edit each: extensions, which are cut with
/// the piece, and facings, which are pieces of their own. The rest of the settings stays. All pure.

/// With free edges drawn out by so much, mm; none: as they are.
/// @param segments  an edge and its mirror image  @param facts  of these lines
LineSettings withExtension(LineSettings lines, const LineFacts& facts,
                           const std::vector<SegmentAt>& segments, std::optional<double> width);

/// The width of the facing that a segment is part of; none where it has none.
std::optional<double> facingOf(const LineSettings& lines, const Segment& segment);

/// With segments part of a facing of this width: of the one that they or their neighbours are part
/// of, which has this width then, else of a new one each; none: part of none.
/// @param names  of new ones, as many as segments  @param facts  of these lines
LineSettings withFacing(LineSettings lines, const LineFacts& facts,
                        const std::vector<SegmentAt>& segments, std::optional<double> width,
                        const std::vector<std::string>& names);

}  // namespace toile::app
