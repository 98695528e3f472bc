// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/mirrored_edits.h"

#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "core/pattern/mirrored_edit.h"

namespace toile::app {

namespace {

template <class Values, class Value>
bool holds(const Values& values, const Value& value) {
    return std::ranges::find(values, value) != values.end();
}

/// Another piece; -1 if there is none.
int counterpartOf(const Symmetry& symmetry, int piece) {
    const auto at = static_cast<std::size_t>(piece);
    const std::vector<int>& counterpart = symmetry.pieces.counterpart;
    return at < counterpart.size() && counterpart[at] != piece ? counterpart[at] : -1;
}

}  // namespace

bool mirrorsEdits(const Document& document) {
    if (document.state().lines.mirror == Mirror::None) {
        return false;
    }
    const Symmetry* symmetry = document.derived().symmetry.get();
    return document.view().mirrorsEdits.value_or(symmetry && isWithinTolerance(*symmetry));
}

void setMirrorsEdits(Document& document, bool on) {
    ViewState view = document.view();
    view.mirrorsEdits = on;
    document.setView(view);
}

const Symmetry* editSymmetry(const Document& document) {
    return mirrorsEdits(document) && document.isCurrent() ? document.derived().symmetry.get()
                                                          : nullptr;
}

void addMirroredCuts(std::vector<UserCut>& cuts, UserCut cut, UserCut image) {
    cuts.push_back(std::move(cut));
    giveIds(cuts);
    image.mirrors = cuts.back().id;
    cuts.push_back(std::move(image));
    giveIds(cuts);
}

std::vector<CutId> withMirrorImages(const std::vector<UserCut>& cuts, std::vector<CutId> ids) {
    std::vector<CutId> images;
    for (const UserCut& cut : cuts) {
        const bool isAsked = holds(ids, cut.id);
        if (isAsked && cut.mirrors) {
            images.push_back(cut.mirrors);
        } else if (!isAsked && cut.mirrors && holds(ids, cut.mirrors)) {
            images.push_back(cut.id);
        }
    }
    for (const CutId image : images) {
        if (!holds(ids, image)) {
            ids.push_back(image);
        }
    }
    return ids;
}

std::vector<int> withCounterparts(const Document& document, std::vector<int> pieces) {
    if (const Symmetry* symmetry = editSymmetry(document)) {
        const std::vector<int> asked = pieces;
        for (const int piece : asked) {
            const int other = counterpartOf(*symmetry, piece);
            if (other >= 0 && !holds(pieces, other)) {
                pieces.push_back(other);
            }
        }
    }
    return pieces;
}

std::vector<int> withoutCounterparts(const Document& document, const std::vector<int>& pieces) {
    const Symmetry* symmetry = editSymmetry(document);
    std::vector<int> kept;
    for (const int piece : pieces) {
        if (!symmetry || !holds(kept, counterpartOf(*symmetry, piece))) {
            kept.push_back(piece);
        }
    }
    return kept;
}

std::map<int, std::optional<double>> withMirroredGrains(
    const Document& document, std::map<int, std::optional<double>> grains) {
    const Symmetry* symmetry = editSymmetry(document);
    if (!symmetry) {
        return grains;
    }
    const std::map<int, std::optional<double>> asked = grains;
    for (const auto& [piece, grain] : asked) {
        const int other = counterpartOf(*symmetry, piece);
        if (other < 0) {
            continue;
        }
        const auto direction = grain ? mirroredDirection(*document.garment(), document.results(),
                                                         *symmetry, piece, *grain)
                                     : std::nullopt;
        if (direction || !grain) {
            grains.try_emplace(other, direction);
        }
    }
    return grains;
}

}  // namespace toile::app
