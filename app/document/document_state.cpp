// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_state.h"

#include <algorithm>

namespace toile::app {

bool isFlattened(const Derived& derived, const DocumentState& state) {
    if (!derived.garment || derived.results.size() != derived.garment->pieces.size() ||
        derived.lines != state.lines) {
        return false;
    }
    for (std::size_t i = 0; i < derived.results.size(); ++i) {
        const PieceResult* result = derived.results[i].get();
        if (!result || result->piece != derived.garment->pieces[i] ||
            !(result->options == state.options)) {
            return false;
        }
    }
    return true;
}

bool isWarm(const Derived& derived) {
    return std::ranges::any_of(derived.results,
                               [](const auto& result) { return result && isWarm(*result); });
}

}  // namespace toile::app
