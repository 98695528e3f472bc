// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "app/document/document_change.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace toile::app {

class ActionRegistry;
class AngleEdit;
class Document;
class FieldGuard;
class LengthEdit;

/// Place, angle, side and grain of the selected pieces as numbers that can be typed, and the
/// material that they are cut from. Where several are selected, the place is that of the box around
/// them; angle, side and grain are each piece's own, and said to differ where they do.
class PositionPanel : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the panel.
    PositionPanel(Document& document, const ActionRegistry& actions, QWidget* parent = nullptr);

    /// Where the keyboard goes.
    QWidget& firstField() const;

private:
    template <class Field>
    Field* makeField(const char* name, const QString& label);
    void makeLayout(const ActionRegistry& actions);
    void onChanged(DocumentChanges what);
    void refresh();
    void movePieces();
    void turnPieces(double degrees);
    void turnGrain(double degrees);
    void mirrorPieces(bool mirrored);
    /// @param isOther  other pieces are selected: what is being typed was about those before
    void showMaterial(bool isOther);
    void takeMaterial();

    Document& document_;
    FieldGuard* fieldGuard_;
    QLabel* title_;
    LengthEdit *x_, *y_;
    AngleEdit *angle_, *grain_;
    QComboBox* material_;
    QCheckBox* mirrored_;
    QLabel* grainNote_;
    QWidget* grainButtons_ = nullptr;
    std::vector<int> pieces_;  ///< shown
    QString shownMaterial_;    ///< that all of them have; empty where they differ
};

}  // namespace toile::app
