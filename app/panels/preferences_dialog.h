// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QDialog>
#include <QToolButton>

#include "app/settings/choices.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace toile::app {

class Preferences;

/// Shows a colour. A click offers another one or the default.
class ColourButton : public QToolButton {
    Q_OBJECT

public:
    explicit ColourButton(QWidget* parent = nullptr);

    /// Invalid for the default colour.
    QColor colour() const { return colour_; }
    void setColour(const QColor& colour);

signals:
    /// The user chose a colour. Not emitted by setColour.
    void colourChosen(const QColor& colour);

private:
    void choose(const QColor& colour);

    QColor colour_;
};

/// The user's preferences. Changes apply at once. Cancel restores the values from when the dialog
/// opened, Reset the defaults.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    /// `preferences` must outlive the dialog.
    explicit PreferencesDialog(Preferences& preferences, QWidget* parent);

    void reject() override;

private:
    void makeUnits(QFormLayout& form);
    void makeLook(QFormLayout& form);
    void makeWork(QFormLayout& form);
    /// Lines up the fields of all groups.
    void alignLabels();
    QComboBox* makeCombo(const char* name, const QStringList& texts);
    QSpinBox* makeNumber(const char* name, int largest, int step);
    void showChoices();
    void showRestartNote();
    void takeChoices();

    Preferences& preferences_;
    Choices before_;
    QComboBox *unit_ = nullptr, *theme_ = nullptr, *language_ = nullptr, *navigation_ = nullptr,
              *newGarment_ = nullptr, *menus_ = nullptr;
    ColourButton *selection_ = nullptr, *seam_ = nullptr;
    QSpinBox *autosave_ = nullptr, *heavy_ = nullptr;
    QLabel* restart_ = nullptr;
    bool showing_ = false;  ///< fields are changed by code, not by the user
};

}  // namespace toile::app
