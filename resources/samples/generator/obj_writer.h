// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "piece.h"

namespace toile::samples {

/// `value` with exactly four decimals and a point, whatever the locale; never "-0.0000".
std::string formatDecimal(double value);

/// The garment as the text of an OBJ file, with LF line ends.
std::string writeObj(const Garment& garment);

}  // namespace toile::samples
