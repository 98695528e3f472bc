// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "tests/app/support/moment.h"

namespace toile::test {

using namespace app;

/// Names a part of two moments that is not equal to the last bit; empty if all are. Compares
/// decisions, positions and errors of pieces and results, and the buffers of scenes.
QString difference(const Moment& one, const Moment& other);

/// Names a difference between two garments' results, to the last bit: pieces, points, errors.
QString pointsDifference(const PieceResults& one, const PieceResults& other);

}  // namespace toile::test
