// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>

#include "app/document/document_state.h"

namespace toile::app {

/// What was worked out before, so that steps back and forth bring it at once. The longest unused
/// goes first; all of it can be worked out again.
class DerivedCache {
public:
    static constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;

    /// Of scenes and results; what follows from several states counts once.
    void setMaxBytes(std::size_t bytes);
    void keep(const Derived& derived);
    /// What follows from these inputs, flattened by these options if it is there; else null.
    /// Valid until the next call.
    const Derived* find(const GarmentInputs& inputs, const FlattenOptions& options);
    void clear() { kept_.clear(); }

private:
    void evict();

    std::list<Derived> kept_;  ///< last used first
    std::size_t maxBytes_ = kMaxBytes;
};

}  // namespace toile::app
