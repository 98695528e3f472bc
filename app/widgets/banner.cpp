// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "app/widgets/icon.h"

namespace toile {

Banner::Banner(QWidget* parent) : QFrame(parent), label_(new QLabel(this)) {
    setObjectName("banner");
    setAutoFillBackground(true);
    // Amber that carries dark text in either palette.
    QPalette colours = palette();
    colours.setColor(QPalette::Window, QColor(255, 226, 168));
    colours.setColor(QPalette::WindowText, QColor(58, 40, 8));
    setPalette(colours);

    label_->setTextFormat(Qt::PlainText);  // names of files are in it
    label_->setWordWrap(true);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton(this);
    close->setAutoRaise(true);
    close->setIcon(themedIcon("close", QColor(58, 40, 8)));
    close->setToolTip(tr("Close this message"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(14, 8, 8, 8);
    row->addWidget(label_, 1);
    row->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void Banner::showSentence(const QString& sentence) {
    label_->setText(sentence);
    show();
}

QString Banner::sentence() const {
    return label_->text();
}

}  // namespace toile
