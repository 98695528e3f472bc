// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/garment_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/widgets/number_edits.h"

namespace toile::app {

GarmentCard::GarmentCard(QWidget* parent) : QFrame(parent) {
    setObjectName("garmentCard");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    reading_ = makeRow("readingQuestion");
    half_ = makeRow("halfQuestion");
    unit_ = makeRow("unitQuestion");
    up_ = makeRow("upQuestion");
    division_ = makeRow("divisionQuestion");
    symmetry_ = makeRow("symmetryQuestion");
    keep_ = new QPushButton(tr("&Close"), this);
    keep_->setObjectName("keepGuess");
    keep_->setToolTip(tr("Confirm these guesses and stop asking about this garment"));
    connect(keep_, &QPushButton::clicked, this, &GarmentCard::keep);

    auto* rows = new QVBoxLayout;
    rows->setSpacing(4);
    rows->addWidget(reading_.widget);
    rows->addWidget(half_.widget);
    rows->addWidget(unit_.widget);
    rows->addWidget(up_.widget);
    rows->addWidget(division_.widget);
    rows->addWidget(symmetry_.widget);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 6, 10, 6);
    layout->setSpacing(12);
    layout->addLayout(rows, 1);
    layout->addWidget(keep_, 0, Qt::AlignVCenter);
    hide();
}

GarmentCard::Row GarmentCard::makeRow(const char* name) {
    Row row{new QWidget(this), new QLabel(this)};
    row.widget->setObjectName(name);
    row.sentence->setTextFormat(Qt::PlainText);  // it contains piece names
    row.sentence->setWordWrap(true);
    auto* layout = new QHBoxLayout(row.widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(row.sentence, 1);
    return row;
}

void GarmentCard::fillRow(Row& row, const CardQuestion& question) {
    row.sentence->setText(question.sentence);
    row.widget->setVisible(!question.choices.empty());
    if (row.buttons) {
        // The sender of this click may be among them, so delete them later.
        row.buttons->hide();
        row.buttons->deleteLater();
    }
    row.buttons = new QWidget(row.widget);
    auto* layout = new QHBoxLayout(row.buttons);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    for (const CardChoice& choice : question.choices) {
        auto* button = new QPushButton(choice.text, row.buttons);
        button->setCheckable(true);
        button->setChecked(choice.present);
        connect(button, &QPushButton::clicked, this, [this, choice] {
            if (choice.present) {
                keep();
            } else {
                emit answered();
                choice.choose();
            }
        });
        layout->addWidget(button);
    }
    const bool isTyped = static_cast<bool>(question.other.choose);
    if (isTyped) {
        addField(*row.buttons, question.other);
    }
    // A row with a field is too wide to fit next to the sentence.
    auto* line = static_cast<QBoxLayout*>(row.widget->layout());
    line->setDirection(isTyped ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    line->addWidget(row.buttons);
    row.buttons->setVisible(true);
}

void GarmentCard::addField(QWidget& buttons, const CardLength& length) {
    auto* before = new QLabel(length.before, &buttons);
    auto* field = new LengthEdit(&buttons);
    field->setObjectName("otherLength");
    field->setAccessibleName(QString("%1 … %2").arg(length.before, length.after));
    field->setRange(1, 1e5);
    field->setValue(length.millimetres);
    field->setKeyboardTracking(false);
    before->setBuddy(field);
    connect(field, &LengthEdit::valueChanged, this, [this, choose = length.choose](double typed) {
        emit answered();
        choose(typed);
    });
    auto* layout = static_cast<QBoxLayout*>(buttons.layout());
    layout->addSpacing(8);
    layout->addWidget(before);
    layout->addWidget(field);
    layout->addWidget(new QLabel(length.after, &buttons));
    layout->addStretch(1);
}

void GarmentCard::ask(const GarmentQuestions& questions) {
    fillRow(reading_, questions.reading);
    fillRow(half_, questions.half);
    fillRow(unit_, questions.unit);
    fillRow(up_, questions.up);
    fillRow(division_, questions.division);
    fillRow(symmetry_, questions.symmetry);
    GarmentQuestions guesses = questions;
    guesses.symmetry = {};
    keep_->setVisible(!guesses.empty());
    setVisible(!questions.empty());
}

QString GarmentCard::sentence() const {
    return reading_.sentence->text() + half_.sentence->text() + unit_.sentence->text() +
           up_.sentence->text() + division_.sentence->text() + symmetry_.sentence->text();
}

void GarmentCard::keep() {
    hide();
    emit kept();
}

}  // namespace toile::app
