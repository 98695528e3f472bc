// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/messages_panel.h"

#include <QStyle>

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
    connect(this, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) {
        const int piece = item->data(kPieceRole).toInt();
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
                add(QString::fromStdString(sentence(problem)), !isNote(problem.code), -1);
            }
        }
    }
    int piece = 0;
    for (const auto& result : document_.results()) {
        if (result->error) {
            add(QString::fromStdString(sentence(*result->error)), true, piece);
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

void MessagesPanel::add(const QString& sentence, bool serious, int piece) {
    const QIcon icon = style()->standardIcon(serious ? QStyle::SP_MessageBoxWarning
                                                     : QStyle::SP_MessageBoxInformation);
    auto* item = new QListWidgetItem(icon, sentence, this);
    item->setData(kPieceRole, piece);
}

}  // namespace toile
