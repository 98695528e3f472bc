// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_upgrades.h"

#include <utility>

#include "core/base/content_hash.h"
#include "core/base/id.h"

namespace toile {

void listPieces(JsonDocument& document) {
    const auto pieces = document.find("pieces");
    if (pieces == document.end() || !pieces->is_object()) {
        return;
    }
    JsonDocument list = JsonDocument::array();
    for (auto& item : pieces->items()) {
        JsonDocument& piece = list.emplace_back(std::move(item.value()));
        if (!piece.is_object()) {
            continue;
        }
        piece["name"] = item.key();
        // It only tells which pieces were one: any number that is the same for them will do.
        if (const auto whole = piece.find("partOf"); whole != piece.end() && whole->is_string()) {
            *whole = idText(hashOf({contentHash(whole->get<std::string>())}));
        }
    }
    *pieces = std::move(list);
}

}  // namespace toile
