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
#include "app/widgets/number_edits.h"
#include "app/widgets/stated_edit.h"

namespace toile::app {
namespace {

constexpr double kMicroNewtonMetre = 1e-6;  // N·m

/// What the pattern is held by, in the order of the list.
enum Holder { ByDesign, ByBody, ByAnotherBody };

constexpr int kFirstUnit = 1;           // of the list of units: before it, what the file says
constexpr int kWidestProofField = 190;  // logical pixels

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
        {&StatedStiffness::warp, &ClothStiffness::warp, 1,
         field(kMinStretch, kMaxStretch, perMetre)});
    add(tr("Stretch, weft"), "stretchWeft", tr("The same along the weft. Empty: as the fabric"),
        {&StatedStiffness::weft, &ClothStiffness::weft, 1,
         field(kMinStretch, kMaxStretch, perMetre)});
    add(tr("Shear"), "stiffnessShear",
        tr("What it resists being sheared with, on the bias. Empty: as the fabric"),
        {&StatedStiffness::shear, &ClothStiffness::shear, 1,
         field(kMinShear, kMaxShear, perMetre)});
    add(tr("Bending"), "stiffnessBending",
        tr("What it resists being bent with. Empty: as the fabric"),
        {&StatedStiffness::bending, &ClothStiffness::bending, kMicroNewtonMetre,
         field(0, kMaxBending / kMicroNewtonMetre, bending)});
    add(tr("Weight"), "clothWeight",
        tr("What it weighs, which counts with gravity. Empty: as the fabric"),
        {&StatedStiffness::weight, &ClothStiffness::weight, 1, field(0, kMaxClothWeight, weight)});
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
                               const std::optional<ClothStiffness>& usual) {
    stated_ = stated;
    for (const Row& row : rows_) {
        const auto& number = stated.*row.stated;
        row.field->showStated(number ? std::optional(*number / row.unit) : std::nullopt,
                              usual ? std::optional((*usual).*row.usual / row.unit) : std::nullopt);
    }
}

ProofForm::ProofForm(Document& document, PatternProof& proof, QWidget* parent)
    : QWidget(parent),
      document_(document),
      proof_(proof),
      guard_(new FieldGuard(this)),
      form_(new QFormLayout(this)),
      sewn_(new QComboBox(this)),
      holder_(new QComboBox(this)),
      unit_(new QComboBox(this)),
      pressure_(new QDoubleSpinBox(this)),
      edge_(new LengthEdit(this)),
      thickness_(new LengthEdit(this)),
      gravity_(new QCheckBox(tr("Gravity"), this)),
      touching_(new QCheckBox(tr("Cloth touches itself"), this)),
      cloth_(new QLabel(this)),
      fold_(new QToolButton(this)),
      stiffness_(new StiffnessForm(*guard_, this)) {
    makeFields();
    makeCloth();
    connectFields();
    form_->setContentsMargins(10, 6, 10, 6);
    form_->setHorizontalSpacing(8);
    form_->setVerticalSpacing(4);
    form_->addRow(tr("Sew"), sewn_);
    form_->addRow(tr("Held by"), holder_);
    form_->addRow(tr("Its unit"), unit_);
    form_->addRow(tr("Pressure"), pressure_);
    form_->addRow(tr("Triangles"), edge_);
    form_->addRow(tr("Fabric"), cloth_);
    form_->addRow(gravity_, touching_);
    form_->addRow(tr("Thickness"), thickness_);
    form_->addRow(fold_);
    form_->addRow(stiffness_);
    connect(&proof_, &PatternProof::changed, this, &ProofForm::show);
    connect(&document_, &Document::changed, this, [this](DocumentChanges what) {
        if (what & (DocumentChange::Opened | DocumentChange::Garment | DocumentChange::Fabric |
                    DocumentChange::Reference)) {
            show();
        }
        if (what.testFlag(DocumentChange::Opened)) {
            fold_->setChecked(document_.state().proof.settings.stiffness != StatedStiffness{});
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
    pressure_->setRange(-kMaxPressure, kMaxPressure);
    pressure_->setDecimals(1);
    pressure_->setSuffix(tr(" Pa"));
    pressure_->setKeyboardTracking(false);
    pressure_->setToolTip(
        tr("Presses the cloth onto what holds it; below 0 it is filled as a "
           "cushion is. 10 Pa are 1 g on 10 cm²"));
    edge_->setObjectName("proofEdge");
    edge_->setRange(0, kMaxProofEdge);
    edge_->setSpecialValueText(tr("As the garment has them"));
    edge_->setToolTip(
        tr("Length of the edges of the triangles that are sewn; the shorter, the "
           "finer, and the longer it takes. 0: as the garment has them"));
    gravity_->setObjectName("proofGravity");
    gravity_->setToolTip(tr("Let the cloth hang by its weight"));
    touching_->setObjectName("proofSelfContact");
    touching_->setToolTip(
        tr("Layers of cloth keep off each other; it takes longer. Else cloth goes through cloth"));
    unit_->setObjectName("proofBodyUnit");
    unit_->setToolTip(tr("The unit that the body's file is in"));
    unit_->addItem(tr("As its file says"));
    for (const LengthUnit unit : kLengthUnits) {
        unit_->addItem(QString::fromUtf8(symbol(unit)));
    }
    for (QComboBox* list : {sewn_, holder_, unit_}) {
        list->setMaximumWidth(kWidestProofField);
        guard_->install(*list);
    }
    for (QDoubleSpinBox* field : std::initializer_list<QDoubleSpinBox*>{pressure_, edge_}) {
        field->setMaximumWidth(kWidestProofField);
        field->installEventFilter(this);
        guard_->install(*field);
    }
}

void ProofForm::makeCloth() {
    cloth_->setObjectName("proofFabric");
    thickness_->setObjectName("proofThickness");
    thickness_->setRange(kMinThickness, kMaxThickness);
    thickness_->setToolTip(tr("How far layers of cloth keep off each other"));
    thickness_->setMaximumWidth(kWidestProofField);
    thickness_->installEventFilter(this);
    guard_->install(*thickness_);
    fold_->setObjectName("proofMeasured");
    fold_->setText(tr("Measured cloth"));
    fold_->setToolTip(
        tr("What you have measured of the cloth, in place of what is known of its "
           "fabric"));
    fold_->setCheckable(true);
    fold_->setAutoRaise(true);
    fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    const auto follow = [this](bool open) {
        fold_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        stiffness_->setVisible(open);
    };
    connect(fold_, &QToolButton::toggled, this, follow);
    follow(false);
}

void ProofForm::connectFields() {
    connect(sewn_, &QComboBox::activated, this, [this](int choice) {
        change(tr("Proof of another pattern"),
               [choice](ProofPlan& plan) { plan.sewn = static_cast<SewnPattern>(choice); });
    });
    connect(holder_, &QComboBox::activated, this, &ProofForm::chooseHolder);
    connect(unit_, &QComboBox::activated, this, [this](int choice) {
        const int known = choice - kFirstUnit;
        if (known < static_cast<int>(std::size(kLengthUnits))) {  // else the one that it has
            change(tr("Unit of the body"), [known](ProofPlan& plan) {
                plan.bodyUnit =
                    known < 0 ? std::nullopt : std::optional<FileUnit>(kLengthUnits[known]);
            });
        }
    });
    connect(pressure_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        change(
            tr("Pressure of the proof"),
            [value](ProofPlan& plan) { plan.settings.pressure = value; }, gesture_);
    });
    connect(edge_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        const double edge = value > 0 ? std::max(value, kMinProofEdge) : 0;
        change(
            tr("Triangles of the proof"), [edge](ProofPlan& plan) { plan.settings.edge = edge; },
            gesture_);
        show();  // the least, where less was typed
    });
    connect(thickness_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        change(
            tr("Thickness of the cloth"),
            [value](ProofPlan& plan) { plan.settings.thickness = value; }, gesture_);
    });
    connect(gravity_, &QCheckBox::clicked, this, [this](bool on) {
        change(on ? tr("Proof with gravity") : tr("Proof without gravity"),
               [on](ProofPlan& plan) { plan.settings.hasGravity = on; });
    });
    connect(touching_, &QCheckBox::clicked, this, [this](bool on) {
        change(on ? tr("Cloth touches itself") : tr("Cloth goes through itself"),
               [on](ProofPlan& plan) { plan.settings.touchesItself = on; });
    });
    connect(stiffness_, &StiffnessForm::wanted, this,
            [this](const StatedStiffness& stated, bool isFirst) {
                gesture_ = isFirst ? document_.newGesture() : gesture_;
                change(
                    tr("Measured cloth"),
                    [&stated](ProofPlan& plan) { plan.settings.stiffness = stated; }, gesture_);
                showCloth();  // the least, where less was typed
            });
}

bool ProofForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        gesture_ = document_.newGesture();
    }
    return QWidget::eventFilter(watched, event);
}

template <class Change>
void ProofForm::change(const QString& text, const Change& change, int gesture) {
    ProofPlan plan = document_.state().proof;
    change(plan);
    document_.setProofPlan(std::move(plan), text, gesture);
}

void ProofForm::chooseHolder(int choice) {
    if (choice == ByDesign) {
        change(tr("Proof on the design"), [](ProofPlan& plan) {
            plan.body.clear();
            plan.bodyUnit.reset();
        });
        return;
    }
    if (choice == ByAnotherBody || proof_.plan().body.empty()) {
        emit bodyWanted();
    }
    show();  // whatever came of it
}

void ProofForm::show() {
    const ProofPlan plan = proof_.plan();
    sewn_->setCurrentIndex(static_cast<int>(plan.sewn));
    setOffered(*sewn_, static_cast<int>(SewnPattern::Designer), hasDesignersPanels(document_));
    setOffered(*sewn_, static_cast<int>(SewnPattern::Reference),
               document_.state().reference.file != nullptr);
    holder_->setItemText(ByBody, plan.body.empty() ? tr("A body…") : textOf(plan.body.filename()));
    setOffered(*holder_, ByAnotherBody, !plan.body.empty());
    holder_->setCurrentIndex(plan.body.empty() ? ByDesign : ByBody);
    showUnit(plan);
    const QSignalBlocker quietPressure(pressure_), quietEdge(edge_), quietThickness(thickness_);
    pressure_->setValue(plan.settings.pressure);
    edge_->setValue(plan.settings.edge);
    gravity_->setChecked(plan.settings.hasGravity);
    touching_->setChecked(plan.settings.touchesItself);
    thickness_->setValue(plan.settings.thickness);
    form_->setRowVisible(thickness_, plan.settings.touchesItself);
    showCloth();
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

void ProofForm::showCloth() {
    const StatedStiffness& stated = document_.state().proof.settings.stiffness;
    const bool isOneFabric = document_.state().materials.empty();
    stiffness_->showStated(
        stated, isOneFabric ? std::optional(clothStiffness(document_.fabric())) : std::nullopt);
    const QString fabric = fabricName(document_.fabric());
    const bool isStated = document_.fabric().id != fabricPresets().front().id;
    cloth_->setText(stated == StatedStiffness{} ? fabric
                    : isStated                  ? tr("%1, as measured").arg(fabric)
                                                : tr("as measured"));
}

}  // namespace toile::app
