// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace toile::app {

class ActionRegistry;
class AngleEdit;
class Document;
class FieldGuard;
class LengthEdit;

/// Position, angle and side of the selected pieces as editable numbers. For several pieces the
/// position is that of their bounding box; angle and side are each piece's own.
class PositionForm : public QWidget {
    Q_OBJECT

public:
    /// The document must outlive the form.
    explicit PositionForm(Document& document, QWidget* parent = nullptr);

    /// The field that takes the keyboard focus.
    QWidget& firstField() const;
    /// Shows the current selection.
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
    std::vector<int> pieces_;  ///< shown pieces; only flat ones
};

/// Name, quantity, material and grain of the selected pieces. If several are selected, a field
/// shows their common value, or that they differ.
class PieceForm : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the form.
    PieceForm(Document& document, const ActionRegistry& actions, QWidget* parent = nullptr);

    /// Shows the current selection.
    void refresh();

private:
    void connectFields();
    void makeLayout(const ActionRegistry& actions);
    QWidget* makeGrainRow(const ActionRegistry& actions);
    /// @param isOther  the selection changed, so text being typed belongs to other pieces
    void showName(bool isOther);
    void showMaterial(bool isOther);
    void showGrain(bool isOther);
    /// Size of the flat piece as cut, across and along its grain.
    QString sizeText(int piece) const;
    void takeName();
    void takeMaterial();
    void turnGrain(double degrees);

    Document& document_;
    FieldGuard* fieldGuard_;
    QLineEdit* name_;
    QLabel* size_;
    QSpinBox* quantity_;
    QCheckBox* pair_;
    QComboBox* material_;
    AngleEdit* grain_;
    QLabel* grainNote_;
    QWidget* grainButtons_ = nullptr;
    std::vector<int> pieces_, flat_;  ///< shown pieces, and the flat ones among them
    QString shownMaterial_;           ///< common to all; empty if they differ
};

}  // namespace toile::app
