// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace toile::geometry {

/// How far along a line each of its points is, from 0 on: one more than it has edges, so that of a
/// closed line the last is the first point again, a turn later. @param lengths  of its edges
template <class Lengths>
std::vector<double> arcOf(const Lengths& lengths) {
    std::vector<double> arc{0};
    arc.reserve(static_cast<std::size_t>(lengths.size()) + 1);
    for (const double length : lengths) {
        arc.push_back(arc.back() + length);
    }
    return arc;
}

}  // namespace toile::geometry
