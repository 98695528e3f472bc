// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/line_forms.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDate>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "app/document/dart_edits.h"
#include "app/document/document.h"
#include "app/document/mirrored_edits.h"
#include "app/document/names.h"
#include "app/text/figures.h"
#include "app/widgets/number_edits.h"
#include "core/base/units.h"
#include "core/geometry/line.h"
#include "core/pattern/darts.h"
#include "core/pattern/outline_reference.h"
#include "core/pattern/piece_marks.h"

namespace toile::app {
namespace {

constexpr int kWidestAllowance = 140;  // logical pixels

constexpr int kWidestText = 140;  // logical pixels

constexpr int kWidestDartField = 160;  // logical pixels
constexpr double kWidestAngle = 180;   // degrees

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

DartForm::DartForm(Document& document, FieldGuard& guard, QWidget* parent)
    : QWidget(parent),
      document_(document),
      title_(new QLabel(this)),
      legs_(new QLabel(this)),
      refusal_(new QLabel(this)),
      intake_(new LengthEdit(this)),
      angle_(new AngleEdit(this)),
      asItLies_(new QToolButton(this)),
      lay_(new QComboBox(this)) {
    makeRows(guard);
    connect(intake_, &QDoubleSpinBox::valueChanged, this,
            [this](double intake) { setIntake(intake); });
    connect(angle_, &QDoubleSpinBox::valueChanged, this,
            [this](double degrees) { setIntake(intakeOf(drawn_, degrees * kDegree)); });
    connect(asItLies_, &QToolButton::clicked, this, [this] {
        gesture_ = document_.newGesture();
        setIntake(std::nullopt);
    });
    connect(lay_, &QComboBox::activated, this, &DartForm::setLay);
    hide();
}

void DartForm::makeRows(FieldGuard& guard) {
    QFont strong = title_->font();
    strong.setWeight(QFont::DemiBold);
    title_->setFont(strong);
    title_->setObjectName("dartTitle");
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    legs_->setObjectName("dartLegs");
    legs_->setForegroundRole(QPalette::PlaceholderText);
    refusal_->setObjectName("dartRefusal");
    refusal_->setWordWrap(true);
    refusal_->hide();
    intake_->setObjectName("dartIntake");
    intake_->setToolTip(
        tr("How far the legs are apart at the mouth, in the pattern; the legs stay as long as they "
           "are. Bold: typed by you"));
    intake_->setRange(0, kMaxIntake);  // cloth that is flat has none
    angle_->setObjectName("dartAngle");
    angle_->setToolTip(tr("The same as the angle between the legs at the tip"));
    angle_->setWrapping(false);
    angle_->setRange(0, kWidestAngle);
    asItLies_->setObjectName("dartAsItLies");
    asItLies_->setText(tr("As the cloth lies"));
    asItLies_->setToolTip(tr("Take the typed intake back: as wide as the dart lies flat"));
    lay_->setObjectName("dartLay");
    lay_->addItems({tr("By convention"), tr("Over the first leg"), tr("Over the second leg")});
    lay_->setToolTip(
        tr("Over which leg the closed dart is laid. The first is met first, anti-clockwise round "
           "the piece; by convention it is laid towards the centre, or downwards"));
    lay_->setFocusPolicy(Qt::StrongFocus);
    guard.install(*lay_);
    for (QDoubleSpinBox* field : std::initializer_list<QDoubleSpinBox*>{intake_, angle_}) {
        field->setFocusPolicy(Qt::StrongFocus);
        field->setMinimumWidth(96);
        field->setMaximumWidth(kWidestDartField);
        guard.install(*field);
        field->installEventFilter(this);
    }
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(10, 6, 10, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->addWidget(title_, 0, 0, 1, 4);
    grid->addWidget(legs_, 1, 0, 1, 4);
    const std::pair<QString, QWidget*> rows[] = {
        {tr("&Intake"), intake_}, {tr("Ang&le"), angle_}, {tr("Lai&d"), lay_}};
    int row = 2;
    for (const auto& [text, field] : rows) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        field->setAccessibleName(label->text().remove('&'));
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row++, 1);
    }
    grid->addWidget(asItLies_, 2, 2);
    grid->addWidget(refusal_, row, 0, 1, 4);
    grid->setColumnStretch(3, 1);
}

bool DartForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        gesture_ = document_.newGesture();
    }
    return QWidget::eventFilter(watched, event);
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
        gesture_ = document_.newGesture();
    }
    dart_ = *seam;
    place_ = *place;
    drawn_ = asDrawn();
    title_->setText(seamName(document_, dart_));
    title_->setToolTip(title_->text());
    legs_->setText(tr("Legs %1 long").arg(lengthWithUnit(drawn_.firstLeg())));
    showSaid();
}

void DartForm::showSaid() {
    const DartSettings said = saidOfDart(*document_.garment(), document_.state().lines, dart_);
    const double intake = said.intake.value_or(drawnIntake().value_or(0));
    showLength(*intake_, intake, said.intake.has_value());
    {
        const QSignalBlocker quiet(angle_);
        angle_->setValue(angleOf(drawn_, intake) / kDegree);
    }
    asItLies_->setEnabled(said.intake.has_value());
    lay_->setCurrentIndex(!said.lay ? 0 : *said.lay == DartLay::First ? 1 : 2);
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
        showSaid();  // not what was typed
    } else {
        emit wanted(lines, tr("Intake of a dart"), gesture_);
    }
}

QString DartForm::refusalOf(double intake) const {
    const double reach = drawn_.firstLeg() + drawn_.secondLeg();
    const double apart = std::abs(drawn_.firstLeg() - drawn_.secondLeg());
    if (!(intake < reach)) {
        return tr("The legs do not reach so far: the intake must be below %1.")
            .arg(lengthWithUnit(reach));
    }
    if (!(intake > apart)) {
        return tr("One leg is longer than the other: the intake must be above %1.")
            .arg(lengthWithUnit(apart));
    }
    if (!(angleOf(drawn_, intake) < kWidestDart)) {
        return tr("What opens by 60° or more is a corner and no dart: the intake must be below %1.")
            .arg(lengthWithUnit(intakeOf(drawn_, kWidestDart)));
    }
    return {};
}

void DartForm::setLay(int row) {
    if (dart_ >= 0) {
        const auto lay = row == 0   ? std::nullopt
                         : row == 1 ? std::optional(DartLay::First)
                                    : std::optional(DartLay::Second);
        emit wanted(withLay(document_.state().lines, *document_.garment(), dart_, lay,
                            editSymmetry(document_)),
                    tr("Lay of a dart"), -1);
    }
}

}  // namespace toile::app
