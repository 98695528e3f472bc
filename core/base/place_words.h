// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace toile {

/// A place that a sentence tells: its words as they stand there, with their unit where it has one,
/// "(1.0, 2.0, 3.0) mm", and the place, mm with y up: all its digits but where the words say 0.0.
struct ToldPlace {
    std::string words;
    std::array<double, 3> at{};
};

/// "1.0, 2.0, 3.0": a place as `placeWording` has it, without brackets.
Wording barePlaceWording(double x, double y, double z);

/// The places on the garment that `sentence(error)` tells, in their order; none that it cuts off,
/// and none of the flat pattern. So whoever has other axes or units can put them into the sentence,
/// from the last to the first: before a place may stand a name that looks like one.
std::vector<ToldPlace> placesIn(const Error& error);

}  // namespace toile
