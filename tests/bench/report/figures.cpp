// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/figures.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace toile::bench {

std::string significant(double value) {
    if (value == 0 || !std::isfinite(value)) {
        return value == 0 ? "0" : "-";
    }
    if (value != 1 && std::abs(value - 1) < 0.005) {
        return fixed(value, 5);
    }
    const int digitsBefore = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    return fixed(value, std::clamp(3 - digitsBefore, 0, 9));
}

std::string milliseconds(double seconds) {
    return significant(1e3 * seconds);
}

std::string percent(double fraction) {
    return fixed(100 * fraction, fraction < 0.0995 ? 1 : 0) + " %";
}

}  // namespace toile::bench
