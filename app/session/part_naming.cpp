// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/part_naming.h"

#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/text/proposed_name.h"
#include "core/garment/garment.h"
#include "core/project/piece_names.h"

namespace toile::app {

PartNaming::PartNaming(Document& document) : document_(document) {
    connect(&document, &Document::opened, this, [this] { nameOf_ = nullptr; });
    connect(&document, &Document::changed, this, [this] {
        if (nameOf_ && document_.isCurrent()) {
            // After all listeners have handled this change.
            QMetaObject::invokeMethod(this, &PartNaming::nameParts, Qt::QueuedConnection);
        }
    });
}

void PartNaming::await(PieceId whole, std::function<std::string(const Piece&)> nameOf,
                       int gesture) {
    whole_ = whole;
    nameOf_ = std::move(nameOf);
    gesture_ = gesture;
}

void PartNaming::nameParts() {
    if (!document_.isCurrent()) {
        return;  // edited since: wait for the next garment
    }
    const auto nameOf = std::exchange(nameOf_, nullptr);
    const auto garment = document_.garment();
    const QUndoStack& history = document_.history();
    const auto* step = history.command(history.index() - 1);
    if (!nameOf || !garment || !step || step->id() != gesture_) {
        return;  // undone, or followed by another step
    }
    const auto record = std::ranges::find(garment->cutRecords, whole_,
                                          [](const CutRecord& one) { return one.whole->id; });
    if (record == garment->cutRecords.end() || record->pieces.size() < 2) {
        return;
    }
    const std::string prefix = garment->uncut.size() > 1 ? record->whole->name + ", " : "";
    DocumentState next = document_.state();
    for (std::size_t k = 0; k < garment->pieces.size(); ++k) {
        const auto& piece = garment->pieces[k];
        if (std::ranges::find(record->pieces, piece) == record->pieces.end()) {
            continue;
        }
        if (const std::string name = nameOf(*piece); !name.empty()) {
            next.labels = withName(std::move(next.labels), *garment, static_cast<int>(k),
                                   prefix + proposedPartName(name));
        }
    }
    document_.edit(step->text(), std::move(next), gesture_);
}

}  // namespace toile::app
