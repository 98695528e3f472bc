// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/cells.h"

#include "tests/bench/report/figures.h"

namespace toile::bench {

std::string orDash(const std::optional<double>& value, std::string (*text)(double)) {
    return value ? text(*value) : "-";
}

std::string timeCell(const Measurement* measurement) {
    if (measurement == nullptr) {
        return "-";
    }
    return milliseconds(measurement->lowest()) + " (" + milliseconds(measurement->median()) + ")";
}

}  // namespace toile::bench
