// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/busy_sheet.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace toile::app {

namespace {

constexpr int kBarWidth = 260;
constexpr int kSteps = 1000;

}  // namespace

BusySheet::BusySheet(QAction& cancel, QWidget* parent)
    : QFrame(parent),
      task_(new QLabel(this)),
      detail_(new QLabel(this)),
      progress_(new QProgressBar(this)) {
    for (QLabel* label : {task_, detail_}) {
        label->setTextFormat(Qt::PlainText);  // it contains file names
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
    }
    QFont font = task_->font();
    font.setPointSizeF(1.15 * font.pointSizeF());
    task_->setFont(font);
    progress_->setRange(0, kSteps);
    progress_->setTextVisible(false);
    progress_->setFixedWidth(kBarWidth);
    auto* button = new QPushButton(tr("Cancel"), this);
    button->setObjectName("busyCancel");
    button->setToolTip(cancel.toolTip());
    connect(button, &QPushButton::clicked, &cancel, &QAction::trigger);

    auto* column = new QVBoxLayout(this);
    column->setSpacing(10);
    column->addStretch(2);
    column->addWidget(task_);
    column->addWidget(detail_);
    column->addWidget(progress_, 0, Qt::AlignHCenter);
    column->addWidget(button, 0, Qt::AlignHCenter);
    column->addStretch(3);
    setAutoFillBackground(true);
    tint();
    if (parent) {
        parent->installEventFilter(this);
        setGeometry(parent->rect());
    }
}

void BusySheet::say(const QString& task, const QString& detail) {
    task_->setText(task);
    progress_->setAccessibleName(task);
    detail_->setText(detail);
}

void BusySheet::setFraction(double fraction) {
    progress_->setValue(static_cast<int>(fraction * kSteps));
}

QString BusySheet::task() const {
    return task_->text();
}

bool BusySheet::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize && !parentWidget()->layout()) {
        setGeometry(parentWidget()->rect());
    }
    return QFrame::eventFilter(watched, event);
}

void BusySheet::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        tint();
    }
}

void BusySheet::tint() {
    QColor faint = palette().color(QPalette::WindowText);
    faint.setAlphaF(0.70F);
    QPalette tinted;
    tinted.setColor(QPalette::WindowText, faint);
    detail_->setPalette(tinted);
}

}  // namespace toile::app
