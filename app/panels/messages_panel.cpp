// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/messages_panel.h"

#include <QStyle>
#include <algorithm>

#include "app/document/document.h"

namespace toile {

namespace {

constexpr int kPieceRole = Qt::UserRole;

}  // namespace

MessagesPanel::MessagesPanel(Document& document, QWidget* parent)
    : QListWidget(parent), document_(document) {
    setObjectName("messages");
    setFrameShape(QFrame::NoFrame);
    setWordWrap(true);
    setAlternatingRowColors(true);
    connect(&document_, &Document::changed, this, &MessagesPanel::onChanged);
    connect(this, &QListWidget::itemSelectionChanged, this, [this] {
        const QList<QListWidgetItem*> items = selectedItems();
        const int piece = items.isEmpty() ? -1 : items.front()->data(kPieceRole).toInt();
        if (piece >= 0) {
            document_.setSelection({piece});
        }
    });
}

void MessagesPanel::onChanged(DocumentChanges what) {
    if (what & (DocumentChange::Garment | DocumentChange::Results)) {
        rebuild();
    }
}

void MessagesPanel::rebuild() {
    clear();
    if (document_.garment()) {
        for (const auto& file : document_.garment()->files) {
            for (const Error& problem : file->problems) {
                add(problem, -1);
            }
        }
        for (const Error& problem : document_.garment()->problems) {
            add(problem, pieceNamed(problem.where));
        }
    }
    int piece = 0;
    for (const auto& result : document_.results()) {
        if (result->error) {
            add(*result->error, piece);
        }
        if (result->flat) {
            for (const Error& note : result->flat->notes) {
                add(note, piece);
            }
        }
        ++piece;
    }
    emit countChanged(count());
    if (count() == 0) {
        auto* none = new QListWidgetItem(tr("Nothing to report."), this);
        none->setData(kPieceRole, -1);
        none->setFlags(Qt::NoItemFlags);
    }
}

int MessagesPanel::pieceNamed(const std::string& name) const {
    const auto& pieces = document_.garment()->pieces;
    const auto found = std::find_if(pieces.begin(), pieces.end(),
                                    [&name](const auto& piece) { return piece->name == name; });
    return found == pieces.end() ? -1 : static_cast<int>(found - pieces.begin());
}

void MessagesPanel::add(const Error& problem, int piece) {
    const QIcon icon = style()->standardIcon(isNote(problem.code) ? QStyle::SP_MessageBoxInformation
                                                                  : QStyle::SP_MessageBoxWarning);
    auto* item = new QListWidgetItem(icon, QString::fromStdString(sentence(problem)), this);
    item->setData(kPieceRole, piece);
}

}  // namespace toile
