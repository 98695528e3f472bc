// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace toile::bench {

/// Three significant digits, without an exponent: "0.0123", "1.71", "12.3", "1234". What lies close
/// to 1, as energies and ratios may, has more: "1.00031".
std::string significant(double value);
/// Seconds as milliseconds, likewise: "44.2".
std::string milliseconds(double seconds);
/// "12 %".
std::string percent(double fraction);

}  // namespace toile::bench
