// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/scrolled.h"

#include <QScrollArea>
#include <QScrollBar>

namespace toile::app {

namespace {

QScrollArea* makeArea(QWidget& contents, QWidget* parent) {
    auto* area = new QScrollArea(parent);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);  // the fields take the focus
    area->setWidget(&contents);
    return area;
}

}  // namespace

QScrollArea* scrolledColumn(QWidget& contents, QWidget* parent) {
    QScrollArea* area = makeArea(contents, parent);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setMinimumWidth(contents.minimumSizeHint().expandedTo(contents.minimumSize()).width() +
                          area->verticalScrollBar()->sizeHint().width());
    return area;
}

QScrollArea* scrolledRow(QWidget& contents, QWidget* parent) {
    QScrollArea* area = makeArea(contents, parent);
    area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return area;
}

}  // namespace toile::app
