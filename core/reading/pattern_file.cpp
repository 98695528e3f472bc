// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/pattern_file.h"

#include <algorithm>

namespace toile {

std::vector<int> sampleOf(const PatternFile& file) {
    const bool hasSample = std::ranges::find(file.sizes, file.sampleSize) != file.sizes.end();
    const std::string size = hasSample            ? file.sampleSize
                             : file.sizes.empty() ? std::string()
                                                  : file.sizes.front();
    std::vector<int> found;
    for (int k = 0; k < static_cast<int>(file.pieces.size()); ++k) {
        const std::string& own = file.pieces[static_cast<std::size_t>(k)].size;
        if (own.empty() || own == size) {
            found.push_back(k);
        }
    }
    return found;
}

}  // namespace toile
