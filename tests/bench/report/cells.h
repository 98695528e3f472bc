// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "tests/bench/report/measurements.h"

namespace toile::bench {

/// A figure as the cell of a table; a dash where there is none.
std::string orDash(const std::optional<double>& value, std::string (*text)(double));
/// The lowest and, in brackets, the middle time, in milliseconds: "44.2 (45.0)".
std::string timeCell(const Measurement* measurement);
/// The same by the clock on the wall.
std::string wallCell(const Measurement* measurement);

}  // namespace toile::bench
