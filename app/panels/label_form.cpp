// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/label_form.h"

#include <QDate>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QToolButton>
#include <utility>

#include "app/document/document.h"
#include "core/pattern/piece_marks.h"

namespace toile::app {

namespace {

constexpr int kWidestText = 140;  // logical pixels

}  // namespace

LabelForm::LabelForm(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), size_(new QLineEdit(this)), date_(new QLineEdit(this)) {
    size_->setObjectName("labelSize");
    size_->setToolTip(tr("The size that the labels of all pieces name"));
    date_->setObjectName("labelDate");
    date_->setToolTip(tr("The date that the labels of all pieces name, as it is to be read"));
    auto* today = new QToolButton(this);
    today->setObjectName("labelToday");
    today->setText(tr("Today"));
    today->setToolTip(tr("Write the date of today on the labels"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(10, 0, 10, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    const std::pair<QString, QLineEdit*> rows[] = {{tr("Si&ze"), size_}, {tr("&Date"), date_}};
    int row = 0;
    for (const auto& [text, field] : rows) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        field->setAccessibleName(label->text().remove('&'));
        field->setMaxLength(static_cast<int>(kMaxLabelText));
        field->setMaximumWidth(kWidestText);
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row++, 1);
    }
    grid->addWidget(today, row - 1, 2);
    grid->setColumnStretch(3, 1);
    grid->setRowStretch(row, 1);
    const auto takeTyped = [this](QLineEdit* field, std::string LabelTexts::*text,
                                  const QString& step) {
        connect(field, &QLineEdit::editingFinished, this, [this, field, text, step] {
            field->setModified(false);
            take(text, field->text(), step);
        });
    };
    takeTyped(size_, &LabelTexts::size, tr("Size on labels"));
    takeTyped(date_, &LabelTexts::date, tr("Date on labels"));
    connect(&document_, &Document::changed, this, [this](DocumentChanges what) {
        if (what.testFlag(DocumentChange::Opened)) {  // what is half typed was about another
            size_->setModified(false);
            date_->setModified(false);
            refresh();
        }
    });
    connect(today, &QToolButton::clicked, this, [this] {
        const QString date = QLocale().toString(QDate::currentDate(), QLocale::ShortFormat);
        take(&LabelTexts::date, date, tr("Date on labels"));
    });
}

void LabelForm::refresh() {
    const LabelTexts& label = document_.state().lines.label;
    setEnabled(document_.garment() != nullptr);
    const auto show = [](QLineEdit& field, const std::string& text) {
        if (!field.hasFocus() || !field.isModified()) {  // else somebody is at it
            field.setText(QString::fromStdString(text));
        }
    };
    show(*size_, label.size);
    show(*date_, label.date);
}

void LabelForm::take(std::string LabelTexts::*field, const QString& typed, const QString& text) {
    LineSettings lines = document_.state().lines;
    const std::string said = typed.simplified().toStdString();
    if (lines.label.*field != said) {
        lines.label.*field = said;
        emit wanted(lines, text, -1);
    }
    refresh();
}

}  // namespace toile::app
