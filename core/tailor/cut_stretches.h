// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace toile::tailor {

/// The stretches of a way along edges of which some are left out. @param isLeftOut  whether one of
/// a way that goes round is, that begins anywhere then: the whole of it where none is
template <class IsLeftOut>
std::vector<std::vector<int>> stretchesOf(std::vector<int> way, const IsLeftOut& isLeftOut) {
    const bool isRound = way.size() > 2 && way.front() == way.back();
    for (std::size_t k = 1; isRound && k < way.size(); ++k) {
        if (isLeftOut(way[k - 1], way[k])) {
            std::vector<int> turned(way.begin() + static_cast<std::ptrdiff_t>(k), way.end());
            turned.insert(turned.end(), way.begin() + 1,
                          way.begin() + static_cast<std::ptrdiff_t>(k) + 1);
            way = std::move(turned);
            break;
        }
    }
    std::vector<std::vector<int>> stretches;
    bool isOpen = false;
    for (std::size_t k = 1; k < way.size(); ++k) {
        const bool isOut = isLeftOut(way[k - 1], way[k]);
        if (!isOut && !isOpen) {
            stretches.push_back({way[k - 1]});
        }
        if (!isOut) {
            stretches.back().push_back(way[k]);
        }
        isOpen = !isOut;
    }
    return stretches;
}

}  // namespace toile::tailor
