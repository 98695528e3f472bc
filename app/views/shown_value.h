// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/render/overlay_values.h"

namespace toile {

class Document;

/// The number that the document's overlay shows at a place, in its unit: what the mark on the bar
/// and the plate at the pointer say. None where the overlay shows none or the piece is not flat.
/// Cost: linear in the pieces.
std::optional<double> shownValueAt(const Document& document, const SurfacePlace& place);

}  // namespace toile
