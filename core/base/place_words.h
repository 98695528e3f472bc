// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace toile {

/// A place in a sentence: its words, with the unit if there is one, "(1.0, 2.0, 3.0) mm", and its
/// position in mm with y up, with all digits except that a written 0.0 is 0.
struct ToldPlace {
    std::string words;
    std::array<double, 3> at{};
};

/// "1.0, 2.0, 3.0": a place like that of `placeWording`, without brackets.
Wording barePlaceWording(double x, double y, double z);

/// The places on the garment in `sentence(error)`, in order, without those that it cuts off and
/// those on the flat pattern. Callers with other axes or units can replace them in the sentence,
/// from the last to the first, because a name before a place may look like one.
std::vector<ToldPlace> placesIn(const Error& error);

}  // namespace toile
