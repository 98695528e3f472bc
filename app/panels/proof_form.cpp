// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/proof_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <algorithm>

#include "app/actions/pattern_proof.h"
#include "app/base/text.h"
#include "app/document/document.h"
#include "app/text/fabric_name.h"
#include "app/widgets/number_edits.h"

namespace toile::app {

namespace {

/// What the pattern is held by, in the order of the list.
enum Holder { ByDesign, ByBody, ByAnotherBody };

constexpr double kMostProofPressure = 100000;  // N/m²
constexpr int kWidestProofField = 190;         // logical pixels

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

ProofForm::ProofForm(const Document& document, PatternProof& proof, QWidget* parent)
    : QWidget(parent),
      document_(document),
      proof_(proof),
      guard_(new FieldGuard(this)),
      sewn_(new QComboBox(this)),
      holder_(new QComboBox(this)),
      pressure_(new QDoubleSpinBox(this)),
      edge_(new LengthEdit(this)),
      gravity_(new QCheckBox(tr("Gravity"), this)),
      touching_(new QCheckBox(tr("Cloth touches itself"), this)),
      cloth_(new QLabel(this)) {
    makeFields();
    auto* form = new QFormLayout(this);
    form->setContentsMargins(10, 6, 10, 6);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    form->addRow(tr("Sew"), sewn_);
    form->addRow(tr("Held by"), holder_);
    form->addRow(tr("Pressure"), pressure_);
    form->addRow(tr("Triangles"), edge_);
    form->addRow(tr("Fabric"), cloth_);
    form->addRow(gravity_, touching_);
    connect(&proof_, &PatternProof::changed, this, &ProofForm::show);
    connect(&document_, &Document::changed, this, [this](DocumentChanges what) {
        if (what & (DocumentChange::Opened | DocumentChange::Garment | DocumentChange::Fabric |
                    DocumentChange::Reference)) {
            show();
        }
    });
    show();
}

QWidget& ProofForm::firstField() const {
    return *sewn_;
}

void ProofForm::makeFields() {
    sewn_->setObjectName("proofSewn");
    sewn_->addItems({tr("This pattern"), tr("The designer's panels"), tr("The reference pattern")});
    sewn_->setToolTip(
        tr("What is sewn: the pattern as it is written to a file and read back, or "
           "another to compare with"));
    holder_->setObjectName("proofHolder");
    holder_->addItems({tr("The design"), tr("A body…"), tr("Another body…")});
    holder_->setToolTip(
        tr("What the cloth lies on while it is sewn: the design's own surface, or "
           "the mesh of a body in the garment's place"));
    pressure_->setObjectName("proofPressure");
    pressure_->setRange(-kMostProofPressure, kMostProofPressure);
    pressure_->setDecimals(1);
    pressure_->setSuffix(tr(" Pa"));
    pressure_->setKeyboardTracking(false);
    pressure_->setToolTip(
        tr("Presses the cloth onto what holds it; below 0 it is filled as a "
           "cushion is. 10 Pa are 1 g on 10 cm²"));
    edge_->setObjectName("proofEdge");
    edge_->setRange(0, kMostProofEdge);
    edge_->setSpecialValueText(tr("As the garment has them"));
    edge_->setToolTip(
        tr("Length of the edges of the triangles that are sewn; the shorter, the "
           "finer, and the longer it takes. 0: as the garment has them"));
    gravity_->setObjectName("proofGravity");
    gravity_->setToolTip(tr("Let the cloth hang by its weight"));
    touching_->setObjectName("proofSelfContact");
    touching_->setToolTip(
        tr("Layers of cloth keep off each other; it takes longer. Else cloth goes through cloth"));
    cloth_->setObjectName("proofFabric");
    for (QWidget* field : {static_cast<QWidget*>(sewn_), static_cast<QWidget*>(holder_),
                           static_cast<QWidget*>(pressure_), static_cast<QWidget*>(edge_)}) {
        field->setMaximumWidth(kWidestProofField);
        guard_->install(*field);
    }
    connect(sewn_, &QComboBox::activated, this, [this](int choice) {
        change([choice](ProofPlan& plan) { plan.sewn = static_cast<SewnPattern>(choice); });
    });
    connect(holder_, &QComboBox::activated, this, &ProofForm::chooseHolder);
    connect(pressure_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        change([value](ProofPlan& plan) { plan.settings.pressure = value; });
    });
    connect(edge_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        const double edge = value > 0 ? std::max(value, kLeastProofEdge) : 0;
        change([edge](ProofPlan& plan) { plan.settings.edge = edge; });
        show();  // the least, where less was typed
    });
    connect(gravity_, &QCheckBox::clicked, this,
            [this](bool on) { change([on](ProofPlan& plan) { plan.settings.hasGravity = on; }); });
    connect(touching_, &QCheckBox::clicked, this, [this](bool on) {
        change([on](ProofPlan& plan) { plan.settings.touchesItself = on; });
    });
}

template <class Change>
void ProofForm::change(const Change& change) {
    ProofPlan plan = proof_.plan();
    change(plan);
    proof_.setPlan(plan);
}

void ProofForm::chooseHolder(int choice) {
    if (choice == ByDesign) {
        change([](ProofPlan& plan) { plan.body.clear(); });
        return;
    }
    if (choice == ByAnotherBody || proof_.plan().body.empty()) {
        emit bodyWanted();
    }
    show();  // whatever came of it
}

void ProofForm::show() {
    const ProofPlan& plan = proof_.plan();
    sewn_->setCurrentIndex(static_cast<int>(plan.sewn));
    setOffered(*sewn_, static_cast<int>(SewnPattern::Designer), hasDesignersPanels(document_));
    setOffered(*sewn_, static_cast<int>(SewnPattern::Reference),
               document_.state().reference.file != nullptr);
    holder_->setItemText(ByBody, plan.body.empty() ? tr("A body…") : textOf(plan.body.filename()));
    setOffered(*holder_, ByAnotherBody, !plan.body.empty());
    holder_->setCurrentIndex(plan.body.empty() ? ByDesign : ByBody);
    const QSignalBlocker quietPressure(pressure_), quietEdge(edge_);
    pressure_->setValue(plan.settings.pressure);
    edge_->setValue(plan.settings.edge);
    gravity_->setChecked(plan.settings.hasGravity);
    touching_->setChecked(plan.settings.touchesItself);
    cloth_->setText(fabricName(document_.fabric()));
}

}  // namespace toile::app
