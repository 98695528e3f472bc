// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>
#include <cstddef>
#include <list>

#include "app/document/document_state.h"

namespace toile::app {

class Document;

/// One step of the history: exchanges the document's state for another, finished one, and so cannot
/// fail. Places that pieces are given afterwards become part of the state they were given for.
class StateStep : public QUndoCommand {
public:
    /// @param gesture  steps of one gesture, such as a drag, become one; -1: stands alone
    StateStep(Document& document, const QString& text, DocumentState next, int gesture);

    int id() const override { return gesture_; }
    void redo() override;
    void undo() override;
    bool mergeWith(const QUndoCommand* later) override;

private:
    Document& document_;
    DocumentState other_;   ///< to exchange the present one for
    bool wasFlat_ = false;  ///< all of it, once
    int gesture_;
};

/// What was worked out before, so that steps back and forth bring it at once. The longest unused
/// goes first; all of it can be worked out again.
class DerivedCache {
public:
    static constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;

    /// Of scenes and results; what follows from several states counts once.
    void setMaxBytes(std::size_t bytes);
    void keep(const Derived& derived);
    /// What follows from the state's inputs: flattened as it asks if that is there, else with the
    /// pieces left out that it leaves out, else any; or null. Valid until the next call.
    const Derived* find(const DocumentState& state);
    void clear() { kept_.clear(); }

private:
    void evict();

    std::list<Derived> kept_;  ///< last used first
    std::size_t maxBytes_ = kMaxBytes;
};

}  // namespace toile::app
