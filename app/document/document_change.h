// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_state.h"

namespace toile::app {

/// One change of the document, valid while it is announced: the document before and after it.
/// Listeners ask whether it touches what they read, so that a new setting needs no edit here, nor
/// in listeners.
class DocumentChange {
public:
    /// Parts of the document besides its state and results.
    enum Part : unsigned {
        Selection = 1U << 0,       ///< which pieces, seam or mark are selected
        View = 1U << 1,            ///< ViewState
        Proof = 1U << 2,           ///< the proof, or cloth that is being sewn
        ReferenceMatch = 1U << 3,  ///< how the reference pattern lies on the pieces
    };

    DocumentChange() = default;
    /// All arguments outlive this. `stateBefore` is `state`, and `before` is `after`, if they have
    /// not changed.
    DocumentChange(const DocumentState& stateBefore, const DocumentState& state,
                   const Derived& before, const Derived& after, unsigned parts = 0)
        : stateBefore_(&stateBefore),
          state_(&state),
          before_(&before),
          after_(&after),
          parts_(parts) {}

    /// True if the garment has other pieces: indices of pieces and seams may mean others now.
    bool hasOtherPieces() const {
        const Garment *was = before_->garment.get(), *is = after_->garment.get();
        return was != is && !(was && is && was->pieces == is->pieces);
    }
    /// True if something that is saved, or that follows from it, may have changed.
    bool touchesContent() const { return state_ != stateBefore_ || after_ != before_; }
    /// True if any of these has changed: members of DocumentState or of Derived, or parts.
    template <class... Keys>
    bool touches(Keys... keys) const {
        return (isTouched(keys) || ...);
    }

private:
    template <class Value>
    bool isTouched(Value DocumentState::*key) const {
        return state_ != stateBefore_ && !(state_->*key == stateBefore_->*key);
    }
    template <class Value>
    bool isTouched(Value Derived::*key) const {
        return after_ != before_ && !(after_->*key == before_->*key);
    }
    bool isTouched(Part part) const {
        return (parts_ & part) != 0 || (part == Selection && hasOtherPieces());
    }

    const DocumentState *stateBefore_ = nullptr, *state_ = nullptr;
    const Derived *before_ = nullptr, *after_ = nullptr;
    unsigned parts_ = 0;
};

}  // namespace toile::app
