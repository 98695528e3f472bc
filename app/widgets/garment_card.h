// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>
#include <optional>
#include <vector>

#include "core/base/length_unit.h"
#include "core/io/up_axis.h"

class QHBoxLayout;
class QLabel;

namespace toile {

/// A choice the card offers: what it is called and whether it is what is used now.
template <class Value>
struct CardChoice {
    Value value;
    QString text;
    bool present = false;
};

/// What the card asks. No choices: nothing is in doubt there.
struct GarmentQuestions {
    QString unitSentence;
    std::vector<CardChoice<LengthUnit>> units;
    QString upSentence;
    std::vector<CardChoice<UpAxis>> axes;

    bool empty() const { return units.empty() && axes.empty(); }
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
    /// An answer other than the present one.
    void unitChosen(toile::LengthUnit unit);
    void upAxisChosen(toile::UpAxis axis);
    /// The guesses are right: nothing more is to be asked about them.
    void kept();

private:
    struct Row {
        QWidget* widget;
        QLabel* sentence;
        QWidget* buttons = nullptr;
    };

    Row makeRow(const char* name);
    template <class Value, class Chosen>
    void fillRow(Row& row, const QString& sentence, const std::vector<CardChoice<Value>>& choices,
                 const Chosen& chosen);
    void keep();

    Row unit_, up_;
};

}  // namespace toile
