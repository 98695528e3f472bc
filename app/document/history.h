// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>

#include "app/document/document_state.h"

namespace toile {

class Document;

/// One step of the history: exchanges the document's state for another, finished one, and so cannot
/// fail. What is worked out afterwards (results) becomes part of the state it was worked out for.
class StateStep : public QUndoCommand {
public:
    /// @param gesture  steps of one gesture, such as a drag, become one; -1: stands alone
    StateStep(Document& document, const QString& text, DocumentState next, int gesture);

    int id() const override { return gesture_; }
    void redo() override;
    void undo() override;
    bool mergeWith(const QUndoCommand* later) override;

    const DocumentState& other() const { return other_; }
    /// See Document::letGo. The step stays the same: what goes follows from what stays.
    void letGo(bool results) const;

private:
    Document& document_;
    /// The state to exchange for; mutable, since the stack shows its steps as constants only.
    mutable DocumentState other_;
    int gesture_;
};

}  // namespace toile
