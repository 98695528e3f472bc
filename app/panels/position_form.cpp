// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/position_form.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/panels/shared_values.h"
#include "app/widgets/number_edits.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

constexpr double kFarthest = 1e6;    // mm, a kilometre
constexpr double kNowhere = -2e6;    // mm: shown blank
constexpr double kSamePlace = 1e-5;  // mm: what the fields' digits leave out is less

void showPlace(LengthEdit& field, double value, bool any) {
    const QSignalBlocker quiet(field);
    field.setRange(any ? -kFarthest : kNowhere, kFarthest);
    field.setSpecialValueText(any ? QString() : QStringLiteral(" "));
    field.setValue(any ? value : kNowhere);
}

}  // namespace

PositionForm::PositionForm(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      fieldGuard_(new FieldGuard(this)),
      x_(makeField<LengthEdit>(*fieldGuard_, "positionX", tr("Left edge"), this)),
      y_(makeField<LengthEdit>(*fieldGuard_, "positionY", tr("Lower edge"), this)),
      angle_(makeField<AngleEdit>(*fieldGuard_, "positionAngle", tr("Angle"), this)),
      mirrored_(new QCheckBox(tr("Wrong side up"), this)) {
    x_->setToolTip(tr("From the sheet's origin to the left edge of what is selected"));
    y_->setToolTip(tr("From the sheet's origin up to the lower edge of what is selected"));
    angle_->setToolTip(tr("How far the piece is turned anti-clockwise, about its middle"));
    mirrored_->setObjectName("positionMirrored");
    mirrored_->setToolTip(tr("Mirrored: the wrong side of the fabric faces you"));
    for (LengthEdit* place : {x_, y_}) {
        place->setRange(-kFarthest, kFarthest);
        connect(place, &QDoubleSpinBox::valueChanged, this, &PositionForm::movePieces);
    }
    dressAngle(*angle_);
    connect(angle_, &QDoubleSpinBox::valueChanged, this, &PositionForm::turnPieces);
    connect(mirrored_, &QCheckBox::clicked, this, &PositionForm::mirrorPieces);
    makeLayout();
    refresh();
}

QWidget& PositionForm::firstField() const {
    return *x_;
}

void PositionForm::makeLayout() {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(5);
    const std::pair<QString, QWidget*> rows[] = {
        {tr("&Left edge"), x_}, {tr("Lo&wer edge"), y_}, {tr("&Angle"), angle_}};
    int row = 0;
    for (const auto& [text, field] : rows) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row++, 1);
    }
    grid->addWidget(mirrored_, row, 1);
    grid->setColumnStretch(1, 1);
}

void PositionForm::refresh() {
    const std::vector<int> before = std::exchange(pieces_, selectedFlat(document_));
    const bool any = !pieces_.empty();
    const auto isFree = [isOther = pieces_ != before](const QAbstractSpinBox& field) -> bool {
        return isOther || !isTypedIn(field);
    };
    for (QWidget* field : std::initializer_list<QWidget*>{x_, y_, angle_, mirrored_}) {
        field->setEnabled(any);
    }
    const Eigen::AlignedBox2d box = boxOnSheet(document_, pieces_);
    if (isFree(*x_)) {
        showPlace(*x_, any ? box.min().x() : 0, any);
    }
    if (isFree(*y_)) {
        showPlace(*y_, any ? box.min().y() : 0, any);
    }
    std::vector<double> turns;
    for (const int piece : pieces_) {
        turns.push_back(placementOf(document_, piece).turn);
    }
    if (isFree(*angle_)) {
        showAngle(*angle_, sharedAngle(turns), any);
    }
    const auto isMirrored = [this](int piece) -> bool {
        return placementOf(document_, piece).mirrored;
    };
    showChecked(*mirrored_, sharedValue(pieces_, isMirrored), any);
}

void PositionForm::movePieces() {
    const Eigen::AlignedBox2d box = boxOnSheet(document_, pieces_);
    if (box.isEmpty()) {
        return;
    }
    // A field that was not touched holds rounded digits: only what differs from those was typed.
    const auto way = [](const LengthEdit& field, double now) {
        return std::abs(field.value() - now) > kSamePlace ? field.value() - now : 0.0;
    };
    const Eigen::Vector2d move(way(*x_, box.min().x()), way(*y_, box.min().y()));
    PiecePlacements placements;
    for (const int piece : pieces_) {
        placements[piece] = movedBy(placementOf(document_, piece), move);
    }
    place(document_, tr("Move %1"), placements);
    refresh();
}

void PositionForm::turnPieces(double degrees) {
    PiecePlacements placements;
    for (const int piece : pieces_) {
        const Placement before = placementOf(document_, piece);
        placements[piece] = turnedAbout(before, boxOnSheet(document_, piece).center(),
                                        degrees * kDegree - before.turn);
    }
    place(document_, tr("Turn %1"), placements);
    refresh();
}

void PositionForm::mirrorPieces(bool) {
    const bool mirrored = mirrored_->checkState() != Qt::Unchecked;
    PiecePlacements placements;
    for (const int piece : pieces_) {
        const Placement before = placementOf(document_, piece);
        placements[piece] =
            before.mirrored == mirrored
                ? before
                : mirroredAt(before, boxOnSheet(document_, piece).center(), Mirroring::LeftRight);
    }
    place(document_, tr("Mirror %1"), placements);
    refresh();
}

}  // namespace toile::app
