// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/history.h"

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
    // The later step has been done already: the state before this one is all that is to be kept.
    setObsolete(other_ == document_.state());
    return true;
}

}  // namespace toile::app
