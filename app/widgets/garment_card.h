// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace toile::app {

/// An answer that the card offers.
struct CardChoice {
    QString text;
    bool present = false;  ///< it is what is used now
    std::function<void()> choose{};
};

/// An answer that is typed.
struct CardLength {
    QString before{}, after{};  ///< what stands on its two sides
    double millimetres = 0;     ///< what is used now
    std::function<void(double)> choose{};
};

struct CardQuestion {
    QString sentence{};
    std::vector<CardChoice> choices{};  ///< none: nothing is in doubt here
    CardLength other{};                 ///< beside the choices, where it says what it is
};

/// What the card asks.
struct GarmentQuestions {
    CardQuestion reading, half, unit, up, division, symmetry;

    bool empty() const {
        return reading.choices.empty() && half.choices.empty() && unit.choices.empty() &&
               up.choices.empty() && division.choices.empty() && symmetry.choices.empty();
    }
};

/// A slim card over the views that asks whether a guess about the file is right: a sentence and a
/// button for each answer. Waits for nobody; hidden where nothing is asked.
class GarmentCard : public QFrame {
    Q_OBJECT

public:
    explicit GarmentCard(QWidget* parent = nullptr);

    /// Replaces what was asked before.
    void ask(const GarmentQuestions& questions);
    QString sentence() const;

signals:
    /// The guesses are right: nothing more is to be asked about them.
    void kept();
    /// They were not.
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
    QPushButton* keep_;  ///< for guesses about the file; other questions have such an answer
};

}  // namespace toile::app
