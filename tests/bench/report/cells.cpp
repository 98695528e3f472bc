// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/cells.h"

#include "tests/bench/report/figures.h"

namespace toile::bench {
namespace {

std::string cell(double lowest, double median) {
    return milliseconds(lowest) + " (" + milliseconds(median) + ")";
}

}  // namespace

std::string orDash(const std::optional<double>& value, std::string (*text)(double)) {
    return value ? text(*value) : "-";
}

std::string timeCell(const Measurement* measurement) {
    return measurement == nullptr ? "-" : cell(measurement->lowest(), measurement->median());
}

std::string wallCell(const Measurement* measurement) {
    return measurement == nullptr ? "-"
                                  : cell(measurement->lowestWall(), measurement->medianWall());
}

}  // namespace toile::bench
