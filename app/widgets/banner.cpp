// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "app/widgets/icon.h"

namespace toile::app {

SentenceBar::SentenceBar(QWidget* parent)
    : QFrame(parent), label_(new QLabel(this)), row_(new QHBoxLayout(this)) {
    setAutoFillBackground(true);
    label_->setTextFormat(Qt::PlainText);  // it contains file names
    label_->setWordWrap(true);
    row_->addWidget(label_, 1);
    hide();
}

void SentenceBar::showSentence(const QString& sentence) {
    label_->setText(sentence);
    show();
}

QString SentenceBar::sentence() const {
    return label_->text();
}

Banner::Banner(QWidget* parent) : SentenceBar(parent) {
    setObjectName("banner");
    // An amber on which dark text is legible in both themes.
    QPalette colours = palette();
    colours.setColor(QPalette::Window, QColor(255, 226, 168));
    colours.setColor(QPalette::WindowText, QColor(58, 40, 8));
    setPalette(colours);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton(this);
    close->setAutoRaise(true);
    close->setIcon(themedIcon("close", QColor(58, 40, 8)));
    close->setAccessibleName(tr("Close"));
    close->setToolTip(tr("Close this message"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    row_->setContentsMargins(14, 8, 8, 8);
    row_->addWidget(close, 0, Qt::AlignTop);
}

RecoveryCard::RecoveryCard(QWidget* parent) : SentenceBar(parent) {
    setObjectName("recoveryCard");
    setBackgroundRole(QPalette::AlternateBase);
    auto* restore = new QPushButton(tr("&Restore"), this);
    restore->setObjectName("restoreRecovery");
    restore->setToolTip(tr("Open the garment from the last backup"));
    auto* discard = new QPushButton(tr("&Discard"), this);
    discard->setObjectName("discardRecovery");
    discard->setToolTip(tr("Delete the backup permanently"));
    connect(restore, &QPushButton::clicked, this, &RecoveryCard::restoreWanted);
    connect(discard, &QPushButton::clicked, this, &RecoveryCard::discardWanted);
    row_->setContentsMargins(14, 6, 10, 6);
    row_->setSpacing(12);
    row_->addWidget(restore, 0, Qt::AlignVCenter);
    row_->addWidget(discard, 0, Qt::AlignVCenter);
}

}  // namespace toile::app
