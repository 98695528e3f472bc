// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/piece_forms.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "app/actions/action_registry.h"
#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/document/piece_edits.h"
#include "app/panels/shared_values.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/widgets/setting_fields.h"
#include "core/base/units.h"

namespace toile::app {
namespace {

constexpr double kFarthest = 1e6;    // mm, a kilometre
constexpr double kNowhere = -2e6;    // mm; shown as blank
constexpr double kSamePlace = 1e-5;  // mm; more than the rounding of the fields

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
    x_->setToolTip(tr("Distance from the origin to the left edge of the selection"));
    y_->setToolTip(tr("Distance from the origin up to the lower edge of the selection"));
    angle_->setToolTip(tr("Anti-clockwise rotation of the piece about its centre"));
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
    // An untouched field holds a rounded value. Only a larger difference was typed.
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

PieceForm::PieceForm(Document& document, const ActionRegistry& actions, QWidget* parent)
    : QWidget(parent),
      document_(document),
      fieldGuard_(new FieldGuard(this)),
      name_(makeField<QLineEdit>(*fieldGuard_, "pieceName", tr("Name"), this)),
      size_(new QLabel(this)),
      quantity_(makeField<QSpinBox>(*fieldGuard_, "pieceQuantity", tr("Quantity"), this)),
      pair_(new QCheckBox(tr("Pair"), this)),
      material_(makeField<QComboBox>(*fieldGuard_, "pieceMaterial", tr("Material"), this)),
      grain_(makeField<AngleEdit>(*fieldGuard_, "positionGrain", tr("Grain"), this)),
      grainNote_(new QLabel(this)) {
    name_->setToolTip(tr("Name of the piece; empty: the name in the file"));
    size_->setObjectName("pieceSize");
    size_->setToolTip(tr("Size of the cut piece: across the grain × along the grain"));
    quantity_->setToolTip(tr("Number of copies to cut"));
    quantity_->setRange(0, kMaxCopies);  // 0: different quantities
    quantity_->setSpecialValueText(variousText());
    quantity_->setKeyboardTracking(false);
    pair_->setObjectName("piecePair");
    pair_->setToolTip(tr("Also cut a mirrored copy of each: left and right"));
    material_->setEditable(true);
    material_->setInsertPolicy(QComboBox::NoInsert);
    material_->setToolTip(tr("Material of the selected pieces; empty: garment's fabric"));
    grain_->setToolTip(tr("Direction of the warp: 90° is upwards"));
    dressAngle(*grain_);
    makeLayout(actions);
    connectFields();
    refresh();
}

void PieceForm::connectFields() {
    connect(name_, &QLineEdit::editingFinished, this, &PieceForm::takeName);
    connect(quantity_, &QSpinBox::valueChanged, this, [this](int quantity) {
        if (quantity > 0) {
            setQuantity(document_, pieces_, quantity);
        }
        refresh();
    });
    connect(pair_, &QCheckBox::clicked, this,
            [this] { setMirroredPair(document_, pieces_, pair_->checkState() != Qt::Unchecked); });
    connect(material_, &QComboBox::activated, this,
            [this] { setMaterial(document_, pieces_, material_->currentText()); });
    connect(material_->lineEdit(), &QLineEdit::editingFinished, this, &PieceForm::takeMaterial);
    connect(grain_, &QDoubleSpinBox::valueChanged, this, &PieceForm::turnGrain);
}

void PieceForm::makeLayout(const ActionRegistry& actions) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(5);
    auto* copies = new QHBoxLayout;
    copies->setSpacing(8);
    copies->addWidget(quantity_, 1);
    copies->addWidget(pair_);
    int row = 0;
    const auto add = [&](const QString& text, QWidget* field) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        grid->addWidget(label, row, 0);
        return row++;
    };
    grid->addWidget(name_, add(tr("&Name"), name_), 1);
    grid->addWidget(size_, add(tr("Size"), nullptr), 1);
    grid->addLayout(copies, add(tr("&Quantity"), quantity_), 1);
    grid->addWidget(material_, add(tr("&Material"), material_), 1);
    grid->addWidget(grain_, add(tr("&Grain"), grain_), 1);
    grid->addWidget(makeGrainRow(actions), row++, 1);
    grid->addWidget(grainNote_, row, 1);
    grid->setColumnStretch(1, 1);
}

QWidget* PieceForm::makeGrainRow(const ActionRegistry& actions) {
    grainNote_->setObjectName("positionGrainNote");
    grainNote_->setEnabled(false);  // for the faint text colour
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
    buttons->addStretch(1);
    return grainButtons_;
}

void PieceForm::refresh() {
    const auto& selection = document_.selection();
    const std::vector<int> before =
        std::exchange(pieces_, std::vector<int>(selection.begin(), selection.end()));
    flat_ = selectedFlat(document_);
    const bool any = !pieces_.empty(), isOther = pieces_ != before;
    for (QWidget* field : std::initializer_list<QWidget*>{quantity_, pair_, material_}) {
        field->setEnabled(any);
    }
    showName(isOther);
    showMaterial(isOther);
    showGrain(isOther);
    const auto said = [this](int piece) -> const PieceSettings& {
        return document_.settings()[std::size_t(piece)];
    };
    const auto quantity =
        sharedValue(pieces_, [&said](int piece) -> int { return said(piece).quantity; });
    const auto pair =
        sharedValue(pieces_, [&said](int piece) -> bool { return said(piece).mirroredPair; });
    if (isOther || !isTypedIn(*quantity_)) {
        const QSignalBlocker quiet(quantity_);
        quantity_->setSpecialValueText(any ? variousText() : QStringLiteral(" "));
        quantity_->setValue(quantity.value_or(0));
    }
    showChecked(*pair_, pair, any);
    const auto size = sharedValue(flat_, [this](int piece) { return sizeText(piece); });
    size_->setText(size ? *size : flat_.size() > 1 ? variousText() : QString(QChar(0x2013)));
    size_->setEnabled(!flat_.empty());
}

QString PieceForm::sizeText(int piece) const {
    const double grain = grainOf(document_.settings()[std::size_t(piece)]);
    Placement upright;
    upright.turn = std::numbers::pi / 2 - grain;
    const Eigen::Vector2d size = outlineBox(cutOutline(document_, piece), upright).sizes();
    return QString("%1 × %2").arg(lengthNumber(size.x()), lengthWithUnit(size.y()));
}

void PieceForm::showName(bool isOther) {
    if (!isOther && isTypedIn(*name_)) {
        return;
    }
    const bool isOne = pieces_.size() == 1;
    const auto at = isOne ? std::size_t(pieces_.front()) : 0;
    name_->setEnabled(isOne);
    name_->setText(isOne ? pieceName(document_, pieces_.front()) : QString());
    name_->setCursorPosition(0);
    name_->setPlaceholderText(isOne ? QString::fromStdString(document_.garment()->pieces[at]->name)
                              : pieces_.empty() ? tr("No piece selected")
                                                : nameOfPieces(document_, pieces_));
}

void PieceForm::takeName() {
    const QString typed = name_->text().simplified();
    name_->setModified(false);
    if (pieces_.size() == 1 && typed != pieceName(document_, pieces_.front())) {
        renamePiece(document_, pieces_.front(), typed);
    }
    showName(true);
}

void PieceForm::showMaterial(bool isOther) {
    if (!isOther && isTypedIn(*material_->lineEdit())) {
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
    const auto shared = sharedValue(pieces_, [this](int piece) -> std::string {
        return document_.settings()[std::size_t(piece)].material;
    });
    shownMaterial_ = QString::fromStdString(shared.value_or(std::string()));
    material_->setCurrentIndex(material_->findText(shownMaterial_, Qt::MatchExactly));
    material_->setEditText(shownMaterial_);
    material_->lineEdit()->setPlaceholderText(pieces_.empty() ? QString()
                                              : shared        ? tr("garment's fabric")
                                                              : variousText());
}

void PieceForm::takeMaterial() {
    const QString typed = material_->currentText().simplified();
    // Leaving the field without typing changes nothing, even if the pieces differ.
    material_->lineEdit()->setModified(false);
    if (typed != shownMaterial_) {
        setMaterial(document_, pieces_, typed);
    } else {
        showMaterial(true);
    }
}

void PieceForm::showGrain(bool isOther) {
    std::vector<double> directions;
    bool stated = true;
    for (const int piece : flat_) {
        const PieceSettings& said = document_.settings()[std::size_t(piece)];
        directions.push_back(directionOnSheet(placementOf(document_, piece), grainOf(said)));
        stated = stated && said.grain.has_value();
    }
    grain_->setEnabled(!flat_.empty());
    if (isOther || !isTypedIn(*grain_)) {
        showAngle(*grain_, sharedAngle(directions), !flat_.empty());
    }
    // Without a selection these actions would apply to the whole garment.
    grainButtons_->setVisible(!flat_.empty());
    grainNote_->setText(stated ? QStringLiteral(" ") : tr("grain not set"));  // keep the height
}

void PieceForm::turnGrain(double degrees) {
    PieceGrains grains;
    for (const int piece : flat_) {
        grains[piece] = directionOnPiece(placementOf(document_, piece), degrees * kDegree);
    }
    setGrain(document_, tr("Set grain of %1"), grains);
    refresh();
}

}  // namespace toile::app
