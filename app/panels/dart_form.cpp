// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dart_form.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "app/document/document.h"
#include "app/document/line_edits.h"
#include "app/document/mirrored_edits.h"
#include "app/text/figures.h"
#include "core/base/units.h"
#include "core/geometry/line.h"
#include "core/pattern/darts.h"
#include "core/pattern/line_fields.h"
#include "core/pattern/outline_reference.h"
#include "core/pattern/piece_marks.h"

namespace toile::app {
namespace {

constexpr double kWidestAngle = 180;  // degrees

}  // namespace

DartForm::DartForm(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      fields_(
          *this, [this] { return document_.newGesture(); },
          [this](const SettingChange& change) { take(change); }),
      title_(makeHeading({}, this)),
      legs_(makeNote("dartLegs", this)),
      refusal_(new QLabel(this)),
      angle_(new AngleEdit(this)) {
    fields_.make<DartSettings>(kDartFields, "dart");
    fields_.setRange("intake", 0, kMaxIntake);  // flat cloth has an intake of 0
    fields_.dress(*angle_, "dartAngle", tr("Angle"),
                  tr("Intake as the angle between the legs at the tip."));
    angle_->setWrapping(false);
    angle_->setRange(0, kWidestAngle);
    connect(angle_, &QDoubleSpinBox::valueChanged, this,
            [this](double degrees) { setIntake(intakeOf(drawn_, degrees * kDegree)); });
    makeLayout();
    hide();
}

void DartForm::makeLayout() {
    title_->setObjectName("dartTitle");
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    refusal_->setObjectName("dartRefusal");
    refusal_->setWordWrap(true);
    refusal_->hide();
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(10, 6, 10, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->addWidget(title_, 0, 0, 1, 4);
    grid->addWidget(legs_, 1, 0, 1, 4);
    fields_.addRow(*grid, "intake", 2);
    auto* label = new QLabel(tr("Ang&le"), this);
    label->setBuddy(angle_);
    grid->addWidget(label, 3, 0);
    grid->addWidget(angle_, 3, 1);
    fields_.addRow(*grid, "lay", 4);
    grid->addWidget(refusal_, 5, 0, 1, 4);
    grid->setColumnStretch(3, 1);
}

std::optional<double> DartForm::drawnIntake() const {
    const PieceResult* result = document_.result(place_.piece);
    if (!result || !result->flat) {
        return std::nullopt;
    }
    const Piece& piece = *result->piece;
    const auto outline =
        geometry::Line::closed(result->flat->Q(piece.boundary, Eigen::all), outlineArc(piece));
    return (outline.pointAt(place_.to) - outline.pointAt(place_.from)).norm();
}

DartPlace DartForm::asDrawn() const {
    const PieceResult* result = document_.result(place_.piece);
    const auto piece = static_cast<std::size_t>(place_.piece);
    if (!result || !result->flat || result->piece != document_.garment()->pieces[piece]) {
        return place_;
    }
    const PieceResult& exact = exactOf(*result);
    const OutlineReference reference = referenceOf(*exact.piece, *exact.flat);
    const ExactOutline outline(reference);
    DartPlace drawn = place_;
    drawn.from = outline.flatAt(place_.from);
    drawn.tip = outline.flatAt(place_.tip);
    drawn.to = outline.flatAt(place_.to);
    return drawn;
}

void DartForm::refresh() {
    const std::optional<int> seam = document_.seam();
    const auto place = seam && document_.garment() && !document_.mark()
                           ? dartPlace(*document_.garment(), *seam)
                           : std::nullopt;
    refusal_->hide();
    setVisible(place.has_value());
    if (!place) {
        dart_ = -1;
        return;
    }
    if (dart_ != *seam) {
        fields_.startGesture();
    }
    dart_ = *seam;
    place_ = *place;
    drawn_ = asDrawn();
    title_->setText(seamName(document_, dart_));
    title_->setToolTip(title_->text());
    legs_->setText(tr("Legs %1 long").arg(lengthWithUnit(drawn_.firstLeg())));
    showSettings();
}

void DartForm::showSettings() {
    const DartSettings settings =
        dartSettings(*document_.garment(), document_.state().lines, dart_);
    DartSettings usual;
    usual.intake = drawnIntake().value_or(0);
    fields_.show(kDartFields, settings, usual);
    const QSignalBlocker quiet(angle_);
    angle_->setValue(angleOf(drawn_, settings.intake.value_or(*usual.intake)) / kDegree);
}

void DartForm::take(const SettingChange& change) {
    if (dart_ < 0) {
        return;
    }
    const LineSettings& lines = document_.state().lines;
    const Garment& garment = *document_.garment();
    const DartSettings settings =
        fields_.changed(kDartFields, dartSettings(garment, lines, dart_), change);
    if (change.path == "intake") {
        setIntake(settings.intake);
    } else {
        document_.setLines(withLay(lines, garment, dart_, settings.lay, editSymmetry(document_)),
                           change.text);
    }
}

void DartForm::setIntake(std::optional<double> intake) {
    if (dart_ < 0) {
        return;
    }
    refusal_->hide();
    if (intake) {
        intake = std::clamp(*intake, kMinIntake, kMaxIntake);
        const QString why = refusalOf(*intake);
        refusal_->setText(why);
        refusal_->setVisible(!why.isEmpty());
    }
    const LineSettings& before = document_.state().lines;
    const LineSettings lines =
        withIntake(before, *document_.garment(), dart_, intake, editSymmetry(document_));
    if (!refusal_->isHidden() || lines == before) {
        showSettings();  // restore the field
    } else {
        document_.setLines(lines, fields_.at("intake").accessibleName(), fields_.gesture());
    }
}

QString DartForm::refusalOf(double intake) const {
    const double reach = drawn_.firstLeg() + drawn_.secondLeg();
    const double apart = std::abs(drawn_.firstLeg() - drawn_.secondLeg());
    if (!(intake < reach)) {
        return tr("The legs are too short for this intake. Set it below %1.")
            .arg(lengthWithUnit(reach));
    }
    if (!(intake > apart)) {
        return tr("The legs differ in length. Set the intake above %1.").arg(lengthWithUnit(apart));
    }
    if (!(angleOf(drawn_, intake) < kWidestDart)) {
        return tr("A dart must open by less than 60°. Set the intake below %1.")
            .arg(lengthWithUnit(intakeOf(drawn_, kWidestDart)));
    }
    return {};
}

}  // namespace toile::app
