// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_state.h"

#include <algorithm>

namespace toile::app {

std::set<PieceId> leftOut(const SettingsById& settings) {
    std::set<PieceId> found;
    for (const auto& [id, said] : settings) {
        if (said.leftOut) {
            found.insert(id);
        }
    }
    return found;
}

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
        const auto said = state.settings.find(result->piece->id);
        if (isLeftOut(*result) != (said != state.settings.end() && said->second.leftOut)) {
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
