// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>
#include <cstddef>
#include <list>

#include "app/document/document_state.h"

namespace toile::app {

class Document;

/// One step of the history: swaps the document's state with another complete one, and so cannot
/// fail. Places that pieces are given later become part of the state they were given for.
class StateStep : public QUndoCommand {
public:
    /// @param gesture  steps of one gesture, such as a drag, are merged; -1: a step of its own
    StateStep(Document& document, const QString& text, DocumentState next, int gesture);

    int id() const override { return gesture_; }
    void redo() override;
    void undo() override;
    bool mergeWith(const QUndoCommand* later) override;

private:
    Document& document_;
    DocumentState other_;   ///< swapped with the present one
    bool wasFlat_ = false;  ///< `other_` was flattened before
    int gesture_;
};

/// Derived values of earlier states, so that undo and redo show them at once. Evicts the least
/// recently used; all of it can be derived again.
class DerivedCache {
public:
    static constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;

    /// Counts scenes and results; shared ones once.
    void setMaxBytes(std::size_t bytes);
    void keep(const Derived& derived);
    /// An entry for the state's inputs: preferably flattened as the state asks, else with the same
    /// pieces left out, else any; or null. Valid until the next call.
    const Derived* find(const DocumentState& state);
    void clear() { kept_.clear(); }

private:
    void evict();

    std::list<Derived> kept_;  ///< most recently used first
    std::size_t maxBytes_ = kMaxBytes;
};

}  // namespace toile::app
