// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QObject>
#include <QString>
#include <QStringList>
#include <vector>

class QHeaderView;

namespace toile::app {

/// A table whose rows are told by what derives from it. Sorts by `SortRole`.
class ColumnsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int SortRole = Qt::UserRole;

    int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : rows_;
    }
    int columnCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : columns_;
    }
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
        if (orientation != Qt::Horizontal) {
            return {};
        }
        switch (role) {
            case Qt::DisplayRole:
                return headings()[static_cast<std::size_t>(section)].title;
            case Qt::ToolTipRole: {  // the title too: there may be too little room for it
                const Heading heading = headings()[static_cast<std::size_t>(section)];
                return QString("%1\n%2").arg(heading.title, heading.tip);
            }
            case Qt::TextAlignmentRole:
                return alignment(section);
            default:
                return {};
        }
    }
    /// What all columns have alike; rows and columns have to be there.
    QVariant data(const QModelIndex& index, int role) const override {
        switch (role) {
            case Qt::DisplayRole:
                return cell(index.row(), index.column()).text;
            case Qt::TextAlignmentRole:
                return alignment(index.column());
            case SortRole:
                return cell(index.row(), index.column()).sort;
            default:
                return {};
        }
    }

protected:
    struct Heading {
        QString title, tip;
    };

    /// What is said, and by what its row is sorted: a number, or the text.
    struct Cell {
        QString text;
        QVariant sort = text;
    };

    ColumnsModel(int columns, QObject* parent) : QAbstractTableModel(parent), columns_(columns) {}

    /// One per column, in the person's language and unit, as they are now.
    virtual std::vector<Heading> headings() const = 0;
    /// Whether words stand in a column, and not numbers.
    virtual bool isWords(int column) const = 0;
    virtual Cell cell(int row, int column) const = 0;

    /// Between a reset's beginning and its end.
    void setRows(int rows) { rows_ = rows; }
    void showColumns(int first, int last) {
        if (rows_ > 0) {
            emit dataChanged(index(0, first), index(rows_ - 1, last));
        }
    }
    /// All of it, headings too.
    void showAgain() {
        emit headerDataChanged(Qt::Horizontal, 0, columns_ - 1);
        showColumns(0, columns_ - 1);
    }

private:
    int alignment(int column) const {
        return int((isWords(column) ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }

    int columns_, rows_ = 0;
};

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
    /// Those that are not worth their room, as long as nobody has chosen.
    void propose(const QStringList& hidden) { hidden_ = isChosen_ ? hidden_ : hidden; }
    bool isHidden(int column) const { return hidden_.contains(names_.value(column)); }

signals:
    void changed();
    /// By the person; not by setHidden.
    void chosen(const QStringList& hidden);

private:
    void showMenu(const QPoint& at);

    QHeaderView& header_;
    QStringList names_, hidden_;
    bool isChosen_ = false;
};

}  // namespace toile::app
