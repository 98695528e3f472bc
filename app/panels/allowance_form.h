// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/pattern/line_settings.h"

class QCheckBox;
class QComboBox;

namespace toile::app {

class Document;
class FieldGuard;
class LengthEdit;

/// What is added to the lines of the pattern: seam allowances by kind, and notches. Says what is to
/// be said of all pieces.
class AllowanceForm : public QWidget {
    Q_OBJECT

public:
    AllowanceForm(Document& document, FieldGuard& guard, QWidget* parent = nullptr);

    /// Shows what the document says now.
    void refresh();

signals:
    /// @param gesture  as for Document::edit
    void wanted(const toile::LineSettings& lines, const QString& text, int gesture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeRows(FieldGuard& guard);
    void setAllowance(bool has);
    void setWidth(double AllowanceWidths::*field, double width, const QString& text);
    void setNotched(bool notched);
    void setForm(int row);
    void setDepth(double depth);
    /// Those of the document; where it has none those it had, as the fields have them.
    NotchRules rules() const;

    Document& document_;
    QCheckBox *allowance_, *notched_;
    LengthEdit *seams_, *hems_, *depth_;
    QComboBox* form_;
    NotchRules rules_{};  ///< that were there last: what was placed by hand comes back with them
    int gesture_ = -1;
};

}  // namespace toile::app
