// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/derived_cache.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace toile::app {

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

const Derived* DerivedCache::find(const GarmentInputs& inputs, const FlattenOptions& options) {
    auto found = kept_.end();
    for (auto entry = kept_.begin(); entry != kept_.end(); ++entry) {
        if (!(entry->inputs == inputs)) {
            continue;
        }
        if (isFlattened(*entry, options)) {
            found = entry;
            break;
        }
        found = found == kept_.end() ? entry : found;
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
