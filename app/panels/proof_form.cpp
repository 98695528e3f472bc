// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/proof_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolButton>
#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/session/pattern_proof.h"
#include "app/text/fabric_name.h"
#include "core/garment/fabric_stiffness.h"
#include "core/prove/proof_fields.h"

namespace toile::app {
namespace {

/// Dress forms, in the order of the list.
enum Holder { ByDesign, ByBody, ByAnotherBody };

constexpr int kFirstUnit = 1;            // in the list of units, after the unit of the file
constexpr int kMaxProofListWidth = 190;  // logical pixels

void setOffered(QComboBox& list, int row, bool offered) {
    auto* model = qobject_cast<QStandardItemModel*>(list.model());
    model->item(row)->setEnabled(offered);
}

bool hasDesignersPanels(const Document& document) {
    return document.garment() &&
           std::ranges::any_of(document.garment()->pieces,
                               [](const auto& piece) { return piece->reference.has_value(); });
}

}  // namespace

ProofForm::ProofForm(Document& document, PatternProof& proof, QWidget* parent)
    : QWidget(parent),
      document_(document),
      proof_(proof),
      fields_(
          *this, [this] { return document_.newGesture(); },
          [this](const SettingChange& change) { take(change); }),
      form_(new QFormLayout(this)),
      holder_(new QComboBox(this)),
      unit_(new QComboBox(this)),
      cloth_(new QLabel(this)),
      fold_(makeButton("proofMeasured", tr("Measured cloth"),
                       tr("Use measured values of the cloth instead of its fabric's values"),
                       this)),
      measured_(new QWidget(this)) {
    fields_.make<ProofPlan>(kProofFields, "proof");
    makeChoices();
    makeFold();
    cloth_->setObjectName("proofFabric");
    form_->setContentsMargins(10, 6, 10, 6);
    form_->setHorizontalSpacing(8);
    form_->setVerticalSpacing(4);
    fields_.addRow(*form_, "sewn");
    form_->addRow(tr("Dress form"), holder_);
    form_->addRow(tr("Unit of the body"), unit_);
    fields_.addRow(*form_, "pressure");
    fields_.addRow(*form_, "edge");
    form_->addRow(tr("Fabric"), cloth_);
    form_->addRow(&fields_.at("gravity"), &fields_.at("selfContact"));
    fields_.addRow(*form_, "thickness");
    form_->addRow(fold_);
    form_->addRow(measured_);
    connect(&proof_, &PatternProof::changed, this, &ProofForm::show);
    connect(&document_, &Document::opened, this, [this] {
        fold_->setChecked(document_.state().proof.settings.stiffness != StatedStiffness{});
    });
    show();
}

QWidget& ProofForm::firstField() const {
    return fields_.at("sewn");
}

void ProofForm::makeChoices() {
    fields_.dress(
        *holder_, "proofHolder", tr("Dress form"),
        tr("Surface under the cloth during sewing: the design itself, or the mesh of a body."));
    holder_->addItems({tr("The design"), tr("A body…"), tr("Another body…")});
    fields_.dress(*unit_, "proofBodyUnit", tr("Unit of the body"), tr("Unit of the body's file."));
    unit_->addItem(tr("As in the file"));
    for (const LengthUnit unit : kLengthUnits) {
        unit_->addItem(QString::fromUtf8(symbol(unit)));
    }
    for (QWidget* list : std::initializer_list<QWidget*>{&fields_.at("sewn"), holder_, unit_}) {
        list->setMaximumWidth(kMaxProofListWidth);
    }
    connect(holder_, &QComboBox::activated, this, &ProofForm::chooseHolder);
    connect(unit_, &QComboBox::activated, this, &ProofForm::chooseUnit);
}

void ProofForm::makeFold() {
    fold_->setCheckable(true);
    fold_->setAutoRaise(true);
    fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* rows = new QFormLayout(measured_);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setHorizontalSpacing(8);
    rows->setVerticalSpacing(4);
    for (const char* key : {"warp", "weft", "shear", "bending", "weight"}) {
        fields_.addRow(*rows, std::string("stiffness.") + key);
        fields_.at(std::string("stiffness.") + key).setMaximumWidth(kMaxProofListWidth);
    }
    const auto follow = [this](bool open) {
        fold_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        measured_->setVisible(open);
    };
    connect(fold_, &QToolButton::toggled, this, follow);
    follow(false);
}

void ProofForm::take(const SettingChange& change) {
    document_.edit(change.text, &DocumentState::proof,
                   fields_.changed(kProofFields, document_.state().proof, change), change.gesture);
    show();  // the value may have been limited to its range
}

void ProofForm::chooseUnit(int choice) {
    const int known = choice - kFirstUnit;
    if (known < static_cast<int>(std::size(kLengthUnits))) {  // else keep the current unit
        ProofPlan plan = document_.state().proof;
        plan.bodyUnit = known < 0 ? std::nullopt : std::optional<FileUnit>(kLengthUnits[known]);
        document_.edit(tr("Change unit of the body"), &DocumentState::proof, std::move(plan));
    }
}

void ProofForm::chooseHolder(int choice) {
    if (choice == ByDesign) {
        ProofPlan plan = document_.state().proof;
        plan.body.clear();
        plan.bodyUnit.reset();
        document_.edit(tr("Use design as dress form"), &DocumentState::proof, std::move(plan));
        return;
    }
    if (choice == ByAnotherBody || proof_.plan().body.empty()) {
        emit bodyWanted();
    }
    show();  // the choice may be cancelled
}

void ProofForm::show() {
    const ProofPlan plan = proof_.plan();
    ProofPlan usual;
    if (document_.state().materials.empty()) {
        const ClothStiffness fabric = clothStiffness(document_.fabric());
        usual.settings.stiffness = {fabric.warp, fabric.weft, fabric.shear, fabric.bending,
                                    fabric.weight};
    }
    fields_.show(kProofFields, plan, usual);
    auto& sewn = fields_.at<QComboBox>("sewn");
    setOffered(sewn, static_cast<int>(SewnPattern::Designer), hasDesignersPanels(document_));
    setOffered(sewn, static_cast<int>(SewnPattern::Reference),
               document_.state().reference.file != nullptr);
    holder_->setItemText(ByBody, plan.body.empty() ? tr("A body…") : textOf(plan.body.filename()));
    setOffered(*holder_, ByAnotherBody, !plan.body.empty());
    holder_->setCurrentIndex(plan.body.empty() ? ByDesign : ByBody);
    showUnit(plan);
    form_->setRowVisible(&fields_.at("thickness"), plan.settings.touchesItself);
    const QString fabric = fabricName(document_.fabric());
    cloth_->setText(plan.settings.stiffness == StatedStiffness{} ? fabric
                    : hasLimits(document_.fabric())              ? tr("%1, measured").arg(fabric)
                                                                 : tr("measured"));
}

void ProofForm::showUnit(const ProofPlan& plan) {
    form_->setRowVisible(unit_, !plan.body.empty());
    while (unit_->count() > kFirstUnit + static_cast<int>(std::size(kLengthUnits))) {
        unit_->removeItem(unit_->count() - 1);
    }
    const auto named = plan.bodyUnit ? plan.bodyUnit->named() : std::nullopt;
    if (plan.bodyUnit && !named) {
        unit_->addItem(
            tr("1 = %1 mm").arg(QLocale().toString(plan.bodyUnit->millimetres(), 'g', 4)));
    }
    const auto* const known = std::ranges::find(kLengthUnits, named);
    unit_->setCurrentIndex(
        plan.bodyUnit ? kFirstUnit + static_cast<int>(known - std::begin(kLengthUnits)) : 0);
}

}  // namespace toile::app
