// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace toile::app {

/// One of the offered answers.
struct CardChoice {
    QString text;
    bool present = false;  ///< it is in use now
    std::function<void()> choose{};
};

/// An answer that the user types.
struct CardLength {
    QString before{}, after{};  ///< labels on both sides of the field
    double millimetres = 0;     ///< current value
    std::function<void(double)> choose{};
};

struct CardQuestion {
    QString sentence{};
    std::vector<CardChoice> choices{};  ///< none: no question
    CardLength other{};                 ///< next to the choices, if `choose` is set
};

/// All questions of the card.
struct GarmentQuestions {
    CardQuestion reading, half, unit, up, division, symmetry;

    bool empty() const {
        return reading.choices.empty() && half.choices.empty() && unit.choices.empty() &&
               up.choices.empty() && division.choices.empty() && symmetry.choices.empty();
    }
};

/// A slim card above the views that asks whether guesses about the file are right: a sentence and a
/// button for each answer. Not modal; hidden without questions.
class GarmentCard : public QFrame {
    Q_OBJECT

public:
    explicit GarmentCard(QWidget* parent = nullptr);

    /// Replaces the previous questions.
    void ask(const GarmentQuestions& questions);
    QString sentence() const;

signals:
    /// The user confirmed the guesses; do not ask about them again.
    void kept();
    /// The user chose another answer.
    void answered();

private:
    struct Row {
        QWidget* widget;
        QLabel* sentence;
        QWidget* buttons = nullptr;
    };

    Row makeRow(const char* name);
    void fillRow(Row& row, const CardQuestion& question);
    void addField(QWidget& buttons, const CardLength& length);
    void keep();

    Row reading_, half_, unit_, up_, division_, symmetry_;
    QPushButton* keep_;  ///< confirms guesses about the file; other questions do not need it
};

}  // namespace toile::app
