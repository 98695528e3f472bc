// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/position_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/actions/action_registry.h"
#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/document/names.h"
#include "app/document/piece_edits.h"
#include "app/widgets/number_edits.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

constexpr double kFarthest = 1e6;    // mm, a kilometre
constexpr double kVarious = -360;    // degrees: stands for angles that differ
constexpr double kSameAngle = 1e-6;  // radians
constexpr double kSamePlace = 1e-5;  // mm: what the fields' digits leave out is less

/// The one angle that all have; nothing where they differ.
template <class AngleOf>
std::optional<double> common(const std::vector<int>& pieces, const AngleOf& angleOf) {
    const double first = angleOf(pieces.front());
    for (const int piece : pieces) {
        if (std::abs(wrappedAngle(angleOf(piece) - first)) > kSameAngle) {
            return std::nullopt;
        }
    }
    return first;
}

void showValue(QDoubleSpinBox& field, double value) {
    const QSignalBlocker quiet(field);
    field.setValue(value);
}

}  // namespace

PositionPanel::PositionPanel(Document& document, const ActionRegistry& actions, QWidget* parent)
    : QWidget(parent),
      document_(document),
      fieldGuard_(new FieldGuard(this)),
      title_(new QLabel(this)),
      x_(makeField<LengthEdit>("positionX", tr("Left edge"))),
      y_(makeField<LengthEdit>("positionY", tr("Lower edge"))),
      angle_(makeField<AngleEdit>("positionAngle", tr("Angle"))),
      grain_(makeField<AngleEdit>("positionGrain", tr("Grain"))),
      material_(makeField<QComboBox>("pieceMaterial", tr("Material"))),
      mirrored_(new QCheckBox(tr("Wrong side up"), this)),
      grainNote_(new QLabel(this)) {
    x_->setToolTip(tr("From the sheet's origin to the left edge of what is selected"));
    y_->setToolTip(tr("From the sheet's origin up to the lower edge of what is selected"));
    angle_->setToolTip(tr("How far the piece is turned anti-clockwise, about its middle"));
    grain_->setToolTip(tr("Direction of the warp on the sheet: 90° runs upwards"));
    mirrored_->setObjectName("positionMirrored");
    mirrored_->setToolTip(tr("Mirrored: the wrong side of the fabric faces you"));
    for (LengthEdit* place : {x_, y_}) {
        place->setRange(-kFarthest, kFarthest);
        connect(place, &QDoubleSpinBox::valueChanged, this, &PositionPanel::movePieces);
    }
    for (AngleEdit* angle : {angle_, grain_}) {
        angle->setRange(kVarious, -kVarious);
        angle->setSpecialValueText(tr("various"));
        angle->setWrapping(false);
    }
    connect(angle_, &QDoubleSpinBox::valueChanged, this, &PositionPanel::turnPieces);
    connect(grain_, &QDoubleSpinBox::valueChanged, this, &PositionPanel::turnGrain);
    material_->setEditable(true);
    material_->setInsertPolicy(QComboBox::NoInsert);
    material_->setToolTip(
        tr("What is selected is cut from this; empty: from the garment's own fabric"));
    connect(material_, &QComboBox::activated, this,
            [this] { setMaterial(document_, pieces_, material_->currentText()); });
    connect(material_->lineEdit(), &QLineEdit::editingFinished, this, &PositionPanel::takeMaterial);
    connect(mirrored_, &QCheckBox::clicked, this, &PositionPanel::mirrorPieces);
    makeLayout(actions);
    connect(&document_, &Document::changed, this, &PositionPanel::onChanged);
    refresh();
}

QWidget& PositionPanel::firstField() const {
    return *x_;
}

template <class Field>
Field* PositionPanel::makeField(const char* name, const QString& label) {
    auto* field = new Field(this);
    field->setObjectName(name);
    field->setAccessibleName(label);
    field->setFocusPolicy(Qt::StrongFocus);
    field->setMinimumWidth(96);
    fieldGuard_->install(*field);
    return field;
}

void PositionPanel::makeLayout(const ActionRegistry& actions) {
    QFont strong = title_->font();
    strong.setWeight(QFont::DemiBold);
    title_->setFont(strong);
    title_->setObjectName("positionTitle");
    title_->setMinimumWidth(60);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    grainNote_->setObjectName("positionGrainNote");
    grainNote_->setEnabled(false);  // in the colour of what is faint
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(10, 6, 10, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(5);
    grid->addWidget(title_, 0, 0, 1, 2);
    const std::pair<QString, QWidget*> rows[] = {{tr("&Left edge"), x_},
                                                 {tr("Lo&wer edge"), y_},
                                                 {tr("&Angle"), angle_},
                                                 {tr("&Grain"), grain_}};
    int row = 1;
    for (const auto& [text, field] : rows) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row++, 1);
    }
    grainButtons_ = new QWidget(this);
    QSizePolicy keepsItsPlace = grainButtons_->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    grainButtons_->setSizePolicy(keepsItsPlace);
    auto* buttons = new QHBoxLayout(grainButtons_);
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->setSpacing(4);
    for (const ActionId id : {ActionId::VerticalGrain, ActionId::BestGrain, ActionId::ResetGrain}) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(&actions[id]);
        button->setText(actions[id].iconText());
        buttons->addWidget(button);
    }
    buttons->addWidget(grainNote_, 1);
    grid->addWidget(grainButtons_, row++, 1);
    grid->addWidget(mirrored_, row++, 1);
    auto* material = new QLabel(tr("&Material"), this);
    material->setBuddy(material_);
    grid->addWidget(material, row, 0);
    grid->addWidget(material_, row++, 1);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(row, 1);
}

void PositionPanel::onChanged(DocumentChanges what) {
    if (what & (DocumentChange::Garment | DocumentChange::Results | DocumentChange::Selection |
                DocumentChange::Settings | DocumentChange::Fabric)) {
        refresh();
    }
}

void PositionPanel::refresh() {
    const std::vector<int> before = std::exchange(pieces_, selectedFlat(document_));
    const bool any = !pieces_.empty();
    for (QWidget* field :
         std::initializer_list<QWidget*>{x_, y_, angle_, grain_, material_, mirrored_}) {
        field->setEnabled(any);
    }
    showMaterial(pieces_ != before);
    // Without a selection the actions behind them are about the whole garment.
    grainButtons_->setVisible(any);
    if (!any) {
        title_->setText(tr("No flat piece selected"));
        grainNote_->clear();
        for (QDoubleSpinBox* field :
             std::initializer_list<QDoubleSpinBox*>{x_, y_, angle_, grain_}) {
            showValue(*field, 0);
        }
        mirrored_->setTristate(false);
        mirrored_->setChecked(false);
        return;
    }
    title_->setText(nameOfPieces(document_, pieces_));
    const Eigen::AlignedBox2d box = boxOnSheet(document_, pieces_);
    showValue(*x_, box.min().x());
    showValue(*y_, box.min().y());
    const auto degrees = [](std::optional<double> angle) {
        return angle ? wrappedAngle(*angle) / kDegree : kVarious;
    };
    showValue(*angle_, degrees(common(pieces_, [this](int piece) -> double {
        return placementOf(document_, piece).turn;
    })));
    showValue(*grain_, degrees(common(pieces_, [this](int piece) -> double {
        return directionOnSheet(placementOf(document_, piece),
                                grainOf(document_.settings()[std::size_t(piece)]));
    })));
    const auto mirrored = std::ranges::count_if(
        pieces_, [this](int piece) { return placementOf(document_, piece).mirrored; });
    const bool mixed = mirrored > 0 && mirrored < static_cast<std::ptrdiff_t>(pieces_.size());
    mirrored_->setTristate(mixed);
    mirrored_->setCheckState(mixed          ? Qt::PartiallyChecked
                             : mirrored > 0 ? Qt::Checked
                                            : Qt::Unchecked);
    const bool stated = std::ranges::all_of(pieces_, [this](int piece) {
        return document_.settings()[std::size_t(piece)].grain.has_value();
    });
    grainNote_->setText(stated ? QString() : tr("grain not set"));
}

void PositionPanel::showMaterial(bool isOther) {
    if (!isOther && material_->lineEdit()->hasFocus() && material_->lineEdit()->isModified()) {
        return;
    }
    const QSignalBlocker quiet(material_);
    QStringList names = QStringList(QString()) + proposedMaterials();
    for (const Material& material : document_.state().materials) {
        names << QString::fromStdString(material.name);
    }
    names.removeDuplicates();
    QStringList listed;
    for (int i = 0; i < material_->count(); ++i) {
        listed << material_->itemText(i);
    }
    if (names != listed) {
        material_->clear();
        material_->addItems(names);
    }
    std::set<std::string> materials;
    for (const int piece : pieces_) {
        materials.insert(document_.settings()[std::size_t(piece)].material);
    }
    const bool isMixed = materials.size() > 1;
    shownMaterial_ = materials.size() == 1 ? QString::fromStdString(*materials.begin()) : QString();
    material_->setCurrentIndex(material_->findText(shownMaterial_, Qt::MatchExactly));
    material_->setEditText(shownMaterial_);
    material_->lineEdit()->setPlaceholderText(isMixed           ? tr("various")
                                              : pieces_.empty() ? QString()
                                                                : tr("as the garment"));
}

void PositionPanel::takeMaterial() {
    const QString typed = material_->currentText().simplified();
    // A field that was only left says nothing, of pieces that differ either.
    material_->lineEdit()->setModified(false);
    if (typed != shownMaterial_) {
        setMaterial(document_, pieces_, typed);
    } else {
        showMaterial(true);
    }
}

void PositionPanel::movePieces() {
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

void PositionPanel::turnPieces(double degrees) {
    PiecePlacements placements;
    for (const int piece : pieces_) {
        const Placement before = placementOf(document_, piece);
        placements[piece] = turnedAbout(before, boxOnSheet(document_, piece).center(),
                                        degrees * kDegree - before.turn);
    }
    place(document_, tr("Turn %1"), placements);
    refresh();
}

void PositionPanel::turnGrain(double degrees) {
    PieceGrains grains;
    for (const int piece : pieces_) {
        grains[piece] = directionOnPiece(placementOf(document_, piece), degrees * kDegree);
    }
    setGrain(document_, tr("Grain of %1"), grains);
    refresh();
}

void PositionPanel::mirrorPieces(bool) {
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
