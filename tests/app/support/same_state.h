// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "tests/app/support/moment.h"

namespace toile::test {

using namespace app;

/// What of two moments is not the same to the last bit, a word or two; empty where all is: what was
/// decided, pieces and results by their positions and errors, scenes by their buffers.
QString difference(const Moment& one, const Moment& other);

/// What of two garments' results is not the same to the last bit: pieces, points, errors.
QString pointsDifference(const PieceResults& one, const PieceResults& other);

}  // namespace toile::test
