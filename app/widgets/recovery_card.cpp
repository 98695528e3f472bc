// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/recovery_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace toile {

RecoveryCard::RecoveryCard(QWidget* parent) : QFrame(parent), label_(new QLabel(this)) {
    setObjectName("recoveryCard");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    label_->setTextFormat(Qt::PlainText);  // names of files are in it
    label_->setWordWrap(true);
    auto* restore = new QPushButton(tr("&Restore"), this);
    restore->setObjectName("restoreRecovery");
    restore->setToolTip(tr("Open the garment as it was when it was last kept"));
    auto* discard = new QPushButton(tr("&Discard"), this);
    discard->setObjectName("discardRecovery");
    discard->setToolTip(tr("Remove what was kept: it cannot be brought back"));
    connect(restore, &QPushButton::clicked, this, &RecoveryCard::restoreWanted);
    connect(discard, &QPushButton::clicked, this, &RecoveryCard::discardWanted);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(14, 6, 10, 6);
    row->setSpacing(12);
    row->addWidget(label_, 1);
    row->addWidget(restore, 0, Qt::AlignVCenter);
    row->addWidget(discard, 0, Qt::AlignVCenter);
    hide();
}

void RecoveryCard::offer(const QString& sentence) {
    label_->setText(sentence);
    show();
}

QString RecoveryCard::sentence() const {
    return label_->text();
}

}  // namespace toile
