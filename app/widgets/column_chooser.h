// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

class QHeaderView;

namespace toile::app {

/// Lets a person choose a table's columns by a right click on its headings. The first column always
/// stays. Says what is chosen; the table hides the columns.
class ColumnChooser : public QObject {
    Q_OBJECT

public:
    /// @param names of the columns in the model's order, for the settings; never shown
    ColumnChooser(QHeaderView& header, QStringList names, QObject* parent);

    /// Those the person does not want; unknown names are kept and mean nothing.
    const QStringList& hidden() const { return hidden_; }
    void setHidden(const QStringList& names);
    bool isHidden(int column) const { return hidden_.contains(names_.value(column)); }

signals:
    void changed();
    /// By the person; not by setHidden.
    void chosen(const QStringList& hidden);

private:
    void showMenu(const QPoint& at);

    QHeaderView& header_;
    QStringList names_, hidden_;
};

}  // namespace toile::app
