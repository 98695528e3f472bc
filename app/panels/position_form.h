// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QCheckBox;

namespace toile::app {

class AngleEdit;
class Document;
class FieldGuard;
class LengthEdit;

/// Place, angle and side of the selected pieces as numbers that can be typed. Where several are
/// selected, the place is that of the box around them; angle and side are each piece's own.
class PositionForm : public QWidget {
    Q_OBJECT

public:
    /// The document must outlive the form.
    explicit PositionForm(Document& document, QWidget* parent = nullptr);

    /// Where the keyboard goes.
    QWidget& firstField() const;
    /// Shows what is selected now.
    void refresh();

private:
    void makeLayout();
    void movePieces();
    void turnPieces(double degrees);
    void mirrorPieces(bool mirrored);

    Document& document_;
    FieldGuard* fieldGuard_;
    LengthEdit *x_, *y_;
    AngleEdit* angle_;
    QCheckBox* mirrored_;
    std::vector<int> pieces_;  ///< shown: the flat ones
};

}  // namespace toile::app
