// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "app/cli/serve_request.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/layout/marker.h"

namespace toile::app {

using ServeOutcome = std::variant<OrderedJson, Refusal>;

/// What `query` tells of a garment: parts of its report, and arrays of its pieces by name.
/// @param results  one per piece; empty where it is not flat yet, then the parts of its
///                 description (`toile info --json`) stand for those of the report
/// @param laid     the pattern, where it is flat
/// Refused: unknown-word, no-such-piece, not-flat. Linear in what is asked for.
ServeOutcome serveQuery(const ServeRequest& request, const Garment& garment,
                        const PieceResults& results, const LaidOutPattern* laid);

}  // namespace toile::app
