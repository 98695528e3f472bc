// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/allowance_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <initializer_list>
#include <optional>
#include <utility>

#include "app/document/document.h"
#include "app/widgets/number_edits.h"

namespace toile::app {

namespace {

constexpr int kWidestAllowance = 140;  // logical pixels

}  // namespace

AllowanceForm::AllowanceForm(Document& document, FieldGuard& guard, QWidget* parent)
    : QWidget(parent),
      document_(document),
      allowance_(new QCheckBox(tr("Seam &allowance"), this)),
      notched_(new QCheckBox(tr("&Notches"), this)),
      seams_(new LengthEdit(this)),
      hems_(new LengthEdit(this)),
      depth_(new LengthEdit(this)),
      form_(new QComboBox(this)) {
    makeRows(guard);
    connect(&document_, &Document::changed, this, [this](DocumentChanges what) {
        if (what.testFlag(DocumentChange::Opened)) {
            rules_ = {};  // what was said there is not about this garment
        }
    });
    connect(allowance_, &QCheckBox::clicked, this, &AllowanceForm::setAllowance);
    connect(notched_, &QCheckBox::clicked, this, &AllowanceForm::setNotched);
    connect(seams_, &QDoubleSpinBox::valueChanged, this, [this](double width) {
        setWidth(&AllowanceWidths::seam, width, tr("Width of seam allowances"));
    });
    connect(hems_, &QDoubleSpinBox::valueChanged, this,
            [this](double width) { setWidth(&AllowanceWidths::hem, width, tr("Width of hems")); });
    connect(form_, &QComboBox::activated, this, &AllowanceForm::setForm);
    connect(depth_, &QDoubleSpinBox::valueChanged, this, &AllowanceForm::setDepth);
}

void AllowanceForm::makeRows(FieldGuard& guard) {
    allowance_->setObjectName("seamAllowance");
    allowance_->setToolTip(
        tr("Leave cloth beyond the seam lines, and cut along the line round it"));
    seams_->setObjectName("allowanceSeams");
    seams_->setToolTip(tr("Allowance along edges that are sewn to others"));
    seams_->setRange(0, kMaxAllowance);
    showLength(*seams_, AllowanceWidths{}.seam, false);
    hems_->setObjectName("allowanceHems");
    hems_->setToolTip(tr("Allowance along edges that are sewn to nothing"));
    hems_->setRange(0, kMaxAllowance);
    showLength(*hems_, AllowanceWidths{}.hem, false);
    notched_->setObjectName("hasNotches");
    notched_->setToolTip(
        tr("Mark places of the seams that come to lie on each other when they are sewn"));
    form_->setObjectName("notchForm");
    form_->setToolTip(tr("What a notch is cut or drawn as"));
    form_->addItems({tr("Slit"), tr("V"), tr("T"), tr("Castle")});  // in the order of NotchForm
    form_->setFocusPolicy(Qt::StrongFocus);
    guard.install(*form_);
    depth_->setObjectName("notchDepth");
    depth_->setToolTip(
        tr("From the cutting line inwards; at most half the allowance where there is one"));
    depth_->setRange(kMinNotchDepth, kMaxNotchDepth);
    showLength(*depth_, NotchRules{}.depth, false);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(10, 6, 10, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    int row = 0;
    const auto add = [&](QWidget* label, QWidget* field) {
        field->setMaximumWidth(kWidestAllowance);
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row++, 1);
    };
    const auto addMore = [&](const QString& text, QWidget* field) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        label->setIndent(18);
        add(label, field);
    };
    // What is ticked stands beside its first value: the panel is low.
    add(allowance_, seams_);
    addMore(tr("Hems"), hems_);
    add(notched_, form_);
    addMore(tr("Depth"), depth_);
    grid->setColumnStretch(2, 1);
    grid->setRowStretch(row, 1);
    seams_->setAccessibleName(tr("Allowance of seams"));
    hems_->setAccessibleName(tr("Allowance of hems"));
    form_->setAccessibleName(tr("Form of notches"));
    depth_->setAccessibleName(tr("Depth of notches"));
    for (LengthEdit* field : {seams_, hems_, depth_}) {
        field->setFocusPolicy(Qt::StrongFocus);
        field->setMinimumWidth(86);
        guard.install(*field);
        field->installEventFilter(this);
    }
}

bool AllowanceForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        gesture_ = document_.newGesture();
    }
    return QWidget::eventFilter(watched, event);
}

void AllowanceForm::refresh() {
    const LineSettings& lines = document_.state().lines;
    setEnabled(document_.garment() != nullptr);
    allowance_->setChecked(lines.allowance.has_value());
    notched_->setChecked(lines.notches.has_value());
    if (lines.allowance) {  // else they say what would be
        showLength(*seams_, lines.allowance->seam, false);
        showLength(*hems_, lines.allowance->hem, false);
    }
    if (lines.notches) {
        rules_ = *lines.notches;
        showLength(*depth_, rules_.depth, false);
        form_->setCurrentIndex(static_cast<int>(rules_.form));
    }
}

NotchRules AllowanceForm::rules() const {
    NotchRules rules = document_.state().lines.notches.value_or(rules_);
    rules.depth = depth_->value();
    rules.form = static_cast<NotchForm>(form_->currentIndex());
    return rules;
}

void AllowanceForm::setAllowance(bool has) {
    LineSettings lines = document_.state().lines;
    lines.allowance =
        has ? std::optional(AllowanceWidths{seams_->value(), hems_->value()}) : std::nullopt;
    emit wanted(lines, has ? tr("Seam allowance") : tr("No seam allowance"), -1);
}

void AllowanceForm::setWidth(double AllowanceWidths::*field, double width, const QString& text) {
    LineSettings lines = document_.state().lines;
    AllowanceWidths widths =
        lines.allowance.value_or(AllowanceWidths{seams_->value(), hems_->value()});
    widths.*field = width;
    lines.allowance = widths;
    emit wanted(lines, text, gesture_);
}

void AllowanceForm::setNotched(bool notched) {
    LineSettings lines = document_.state().lines;
    lines.notches = notched ? std::optional(rules()) : std::nullopt;
    emit wanted(lines, notched ? tr("Notches") : tr("No notches"), -1);
}

void AllowanceForm::setForm(int) {
    LineSettings lines = document_.state().lines;
    lines.notches = rules();
    emit wanted(lines, tr("Form of notches"), -1);
}

void AllowanceForm::setDepth(double) {
    LineSettings lines = document_.state().lines;
    lines.notches = rules();
    emit wanted(lines, tr("Depth of notches"), gesture_);
}

}  // namespace toile::app
