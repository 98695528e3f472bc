// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QObject>
#include <QString>
#include <QStringList>
#include <vector>

class QHeaderView;

namespace toile::app {

/// Base of table models; derived classes supply the cells. Sorts by `SortRole`.
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
            case Qt::ToolTipRole: {  // include the title, which may be elided
                const Heading heading = headings()[static_cast<std::size_t>(section)];
                return QString("%1\n%2").arg(heading.title, heading.tip);
            }
            case Qt::TextAlignmentRole:
                return alignment(section);
            default:
                return {};
        }
    }
    /// Data that all columns share. Precondition: row and column exist.
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

    /// Text of a cell, and its sort key: a number, or the text.
    struct Cell {
        QString text;
        QVariant sort = text;
    };

    ColumnsModel(int columns, QObject* parent) : QAbstractTableModel(parent), columns_(columns) {}

    /// One per column, in the current language and unit.
    virtual std::vector<Heading> headings() const = 0;
    /// True if a column contains words rather than numbers.
    virtual bool isWords(int column) const = 0;
    virtual Cell cell(int row, int column) const = 0;

    /// Call it only between the beginning and the end of a reset.
    void setRows(int rows) { rows_ = rows; }
    void showColumns(int first, int last) {
        if (rows_ > 0) {
            emit dataChanged(index(0, first), index(rows_ - 1, last));
        }
    }
    /// Updates everything, including the headings.
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

/// Lets the user choose a table's columns by a right click on its headings. The first column is
/// always shown. Only reports the choice; the table hides the columns.
class ColumnChooser : public QObject {
    Q_OBJECT

public:
    /// @param names  of the columns in model order, for the settings; never shown
    ColumnChooser(QHeaderView& header, QStringList names, QObject* parent);

    /// Columns that the user hides. Unknown names are kept and have no effect.
    const QStringList& hidden() const { return hidden_; }
    void setHidden(const QStringList& names);
    /// Columns to hide until the user makes a choice.
    void propose(const QStringList& hidden) { hidden_ = isChosen_ ? hidden_ : hidden; }
    bool isHidden(int column) const { return hidden_.contains(names_.value(column)); }

signals:
    void changed();
    /// The user chose columns. Not emitted by setHidden.
    void chosen(const QStringList& hidden);

private:
    void showMenu(const QPoint& at);

    QHeaderView& header_;
    QStringList names_, hidden_;
    bool isChosen_ = false;
};

}  // namespace toile::app
