// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/pole.h"

namespace toile {

/// As `boxPole`, but nothing where a box of this size finds no room: the search ends as soon as
/// that is known, which is soon where it is far from fitting.
std::optional<Pole> boxPlace(const FreeCloth& cloth, const Eigen::Vector2d& size, double angle,
                             const PoleSearch& search = {});

}  // namespace toile
