// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/history.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "app/document/document.h"

namespace toile::app {

StateStep::StateStep(Document& document, const QString& text, DocumentState next, int gesture)
    : QUndoCommand(text), document_(document), other_(std::move(next)), gesture_(gesture) {}

void StateStep::redo() {
    document_.exchange(other_, wasFlat_);
}

void StateStep::undo() {
    document_.exchange(other_, wasFlat_);
    setObsolete(document_.takesBack_);
}

bool StateStep::mergeWith(const QUndoCommand*) {
    // The later step is already done: only the state before this one is kept.
    setObsolete(other_ == document_.state());
    return true;
}

void DerivedCache::setMaxBytes(std::size_t bytes) {
    maxBytes_ = bytes;
    evict();
}

void DerivedCache::keep(const Derived& derived) {
    if (!derived.garment) {
        return;
    }
    kept_.remove(derived);
    kept_.push_front(derived);
    evict();
}

const Derived* DerivedCache::find(const DocumentState& state) {
    const auto worth = [&state](const Derived& entry) {
        return isFlattened(entry, state) ? 2 : isLeftOutOtherwise(entry, state) ? 0 : 1;
    };
    auto found = kept_.end();
    int best = -1;
    for (auto entry = kept_.begin(); entry != kept_.end() && best < 2; ++entry) {
        if (!(entry->inputs == state.inputs)) {
            continue;
        }
        if (const int its = worth(*entry); its > best) {
            found = entry;
            best = its;
        }
    }
    if (found == kept_.end()) {
        return nullptr;
    }
    kept_.splice(kept_.begin(), kept_, found);
    return &kept_.front();
}

void DerivedCache::evict() {
    std::set<const Scene*> counted;
    std::size_t bytes = 0;
    const auto first = std::ranges::find_if(kept_, [&](const Derived& entry) {
        bytes += counted.insert(entry.scene.get()).second ? entry.bytes : 0;
        return bytes > maxBytes_;
    });
    kept_.erase(first, kept_.end());
}

}  // namespace toile::app
