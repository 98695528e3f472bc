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

/// Name, quantity, material and grain of the selected pieces. If several are selected, a field
/// shows their common value, or that they differ.
class PieceForm : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the form.
    PieceForm(Document& document, const ActionRegistry& actions, QWidget* parent = nullptr);

    /// Shows what is selected now.
    void refresh();

private:
    void connectFields();
    void makeLayout(const ActionRegistry& actions);
    QWidget* makeGrainRow(const ActionRegistry& actions);
    /// @param isOther  other pieces are selected: what is being typed was about those before
    void showName(bool isOther);
    void showMaterial(bool isOther);
    void showGrain(bool isOther);
    /// Of the flat piece as it is cut, across and along its grain.
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
    std::vector<int> pieces_, flat_;  ///< shown, and those of them that are flat
    QString shownMaterial_;           ///< that all of them have; empty where they differ
};

/// What can be said and typed about the selected pieces: what they are, and where they lie. Nothing
/// moves whatever is selected; what makes no sense is grey.
class PiecePanel : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the panel.
    PiecePanel(Document& document, const ActionRegistry& actions, QWidget* parent = nullptr);

    /// Where the keyboard goes that wants to place pieces.
    QWidget& placeField() const;

private:
    void refresh();

    PieceForm* piece_;
    PositionForm* position_;
};

}  // namespace toile::app
