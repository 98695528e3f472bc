// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/stiffness_form.h"

#include <QEvent>
#include <QFormLayout>
#include <utility>

#include "app/widgets/stated_edit.h"
#include "core/prove/proof_settings.h"

namespace toile::app {

namespace {

constexpr double kMicroNewtonMetre = 1e-6;  // N·m

}  // namespace

StiffnessForm::StiffnessForm(FieldGuard& guard, QWidget* parent) : QWidget(parent), guard_(guard) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    const QString asFabric = tr("As the fabric");
    const auto field = [&](double least, double most, const QString& unit) {
        return new StatedEdit(least, most, unit, asFabric, this);
    };
    const QString perMetre = tr("N/m"), bending = tr("µN·m"), weight = tr("g/m²");
    add(tr("Stretch, warp"), "stretchWarp",
        tr("What a strip of the cloth, 1 m wide, resists being stretched along the warp with: the "
           "force by the strain. Empty: as the fabric"),
        {&StatedStiffness::warp, &sew::ClothStiffness::warp, 1,
         field(kLeastStretch, kMostStretch, perMetre)});
    add(tr("Stretch, weft"), "stretchWeft", tr("The same along the weft. Empty: as the fabric"),
        {&StatedStiffness::weft, &sew::ClothStiffness::weft, 1,
         field(kLeastStretch, kMostStretch, perMetre)});
    add(tr("Shear"), "stiffnessShear",
        tr("What it resists being sheared with, on the bias. Empty: as the fabric"),
        {&StatedStiffness::shear, &sew::ClothStiffness::shear, 1,
         field(kLeastShear, kMostShear, perMetre)});
    add(tr("Bending"), "stiffnessBending",
        tr("What it resists being bent with. Empty: as the fabric"),
        {&StatedStiffness::bending, &sew::ClothStiffness::bending, kMicroNewtonMetre,
         field(0, kMostBending / kMicroNewtonMetre, bending)});
    add(tr("Weight"), "clothWeight",
        tr("What it weighs, which counts with gravity. Empty: as the fabric"),
        {&StatedStiffness::weight, &sew::ClothStiffness::weight, 1,
         field(0, kMostClothWeight, weight)});
}

void StiffnessForm::add(const QString& name, const char* objectName, const QString& toolTip,
                        Row row) {
    constexpr int kWidestStiffness = 190;  // logical pixels
    row.field->setObjectName(objectName);
    row.field->setToolTip(toolTip);
    row.field->setMaximumWidth(kWidestStiffness);
    row.field->setFocusPolicy(Qt::StrongFocus);
    row.field->installEventFilter(this);
    guard_.install(*row.field);
    static_cast<QFormLayout*>(layout())->addRow(name, row.field);
    connect(row.field, &QDoubleSpinBox::valueChanged, this, [this, row] { state(row); });
    rows_.push_back(row);
}

void StiffnessForm::state(const Row& row) {
    StatedStiffness stated = stated_;
    const auto number = row.field->stated();
    stated.*row.stated = number ? std::optional(*number * row.unit) : std::nullopt;
    emit wanted(stated, std::exchange(isFirst_, false));
}

bool StiffnessForm::eventFilter(QObject* watched, QEvent* event) {
    isFirst_ = isFirst_ || event->type() == QEvent::FocusIn;
    return QWidget::eventFilter(watched, event);
}

void StiffnessForm::showStated(const StatedStiffness& stated,
                               const std::optional<sew::ClothStiffness>& usual) {
    stated_ = stated;
    for (const Row& row : rows_) {
        const auto& number = stated.*row.stated;
        row.field->showStated(number ? std::optional(*number / row.unit) : std::nullopt,
                              usual ? std::optional((*usual).*row.usual / row.unit) : std::nullopt);
    }
}

}  // namespace toile::app
