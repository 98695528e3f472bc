// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_state.h"

namespace toile {

bool isFlattened(const DocumentState& state) {
    if (!state.garment || state.results.size() != state.garment->pieces.size()) {
        return false;
    }
    for (std::size_t i = 0; i < state.results.size(); ++i) {
        const PieceResult* result = state.results[i].get();
        if (!result || result->piece != state.garment->pieces[i] ||
            !(result->options == state.options)) {
            return false;
        }
    }
    return true;
}

}  // namespace toile
