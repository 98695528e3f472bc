// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/columns_model.h"

#include <QAbstractItemModel>
#include <QHeaderView>
#include <QMenu>

namespace toile::app {

ColumnChooser::ColumnChooser(QHeaderView& header, QStringList names, QObject* parent)
    : QObject(parent), header_(header), names_(std::move(names)) {
    header_.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&header_, &QWidget::customContextMenuRequested, this, &ColumnChooser::showMenu);
}

void ColumnChooser::setHidden(const QStringList& names) {
    hidden_ = names;
    isChosen_ = true;
    emit changed();
}

void ColumnChooser::showMenu(const QPoint& at) {
    auto* menu = new QMenu(&header_);
    menu->setObjectName("columnMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (int column = 1; column < names_.size(); ++column) {
        QAction* action =
            menu->addAction(header_.model()->headerData(column, Qt::Horizontal).toString());
        action->setObjectName(names_[column]);
        action->setCheckable(true);
        action->setChecked(!isHidden(column));
        connect(action, &QAction::triggered, this, [this, column](bool shown) {
            QStringList hidden = hidden_;
            hidden.removeAll(names_[column]);
            if (!shown) {
                hidden << names_[column];
            }
            setHidden(hidden);
            emit chosen(hidden_);
        });
    }
    menu->popup(header_.mapToGlobal(at));
}

}  // namespace toile::app
