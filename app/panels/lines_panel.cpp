// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/lines_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "app/document/line_edits.h"
#include "app/panels/line_forms.h"
#include "app/panels/seam_ends_list.h"
#include "app/panels/segment_form.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/widgets/number_edits.h"
#include "app/widgets/scrolled.h"
#include "core/base/units.h"

namespace toile::app {

namespace {

constexpr int kWidestField = 140;  // logical pixels

void setQuietly(QDoubleSpinBox& field, double value) {
    const QSignalBlocker quiet(field);
    field.setValue(value);
}

}  // namespace

LinesPanel::LinesPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      fieldGuard_(new FieldGuard(this)),
      fair_(new QCheckBox(tr("&Fair lines"), this)),
      true_(new QCheckBox(tr("&True seam ends, up to"), this)),
      tolerance_(new LengthEdit(this)),
      smoothing_(new LengthEdit(this)),
      trueBelow_(new AngleEdit(this)),
      straying_(new QLabel(this)),
      allowance_(new AllowanceForm(document, *fieldGuard_, this)),
      label_(new LabelForm(document, this)),
      ends_(new SeamEndsList(this)),
      dart_(new DartForm(document, *fieldGuard_, this)),
      segment_(new SegmentForm(document, *fieldGuard_, this)) {
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(0);
    columns->addWidget(scrolledColumn(*makeSettings(), this), 1);
    auto* added = new QWidget(this);
    auto* rows = new QVBoxLayout(added);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(allowance_);
    rows->addWidget(label_, 1);
    columns->addWidget(scrolledColumn(*added, this), 1);
    columns->addWidget(ends_, 4);
    auto* selected = new QWidget(this);
    auto* forms = new QVBoxLayout(selected);
    forms->setContentsMargins(0, 0, 0, 0);
    forms->setSpacing(0);
    forms->addWidget(dart_);
    forms->addWidget(segment_, 1);
    columns->addWidget(scrolledColumn(*selected, this), 3);
    connect(fair_, &QCheckBox::clicked, this, &LinesPanel::setFair);
    connect(true_, &QCheckBox::clicked, this, &LinesPanel::setTrueing);
    connect(tolerance_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        setFairing(&Fairing::tolerance, value, tr("Distance of fair lines"));
    });
    connect(smoothing_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        setFairing(&Fairing::smoothing, value, tr("Smoothing of lines"));
    });
    connect(trueBelow_, &QDoubleSpinBox::valueChanged, this, &LinesPanel::setTrueBelow);
    connect(ends_, &SeamEndsList::trueingWanted, this, [this](int end, bool trued) {
        const LineSettings lines = withSeamEnd(document_.state().lines, document_.garment()->seams,
                                               facts_.ends[static_cast<std::size_t>(end)], trued);
        document_.setLines(trued ? withFairing(lines) : lines,
                           trued ? tr("Trueing of a seam end") : tr("Kink at a seam end"));
    });
    connect(ends_, &SeamEndsList::seamChosen, &document_, &Document::setSeam);
    connect(allowance_, &AllowanceForm::wanted, &document_, &Document::setLines);
    connect(label_, &LabelForm::wanted, &document_, &Document::setLines);
    connect(dart_, &DartForm::wanted, &document_, &Document::setLines);
    connect(segment_, &SegmentForm::wanted, &document_, &Document::setLines);
    connect(&document_, &Document::changed, this, &LinesPanel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &LinesPanel::refresh);
    refresh();
}

QWidget& LinesPanel::firstField() const {
    return *fair_;
}

QWidget* LinesPanel::makeSettings() {
    auto* settings = new QWidget(this);
    fair_->setObjectName("fairLines");
    fair_->setToolTip(
        tr("Draw every line as a smooth curve of the same length, near the outline "
           "as it was flattened"));
    true_->setObjectName("trueSeamEnds");
    true_->setToolTip(
        tr("Turn the lines at the ends of seams so that they run on into each other "
           "once sewn, where they miss that by no more than this"));
    tolerance_->setObjectName("fairTolerance");
    tolerance_->setToolTip(tr("How far a line may stray from the exact outline"));
    tolerance_->setRange(kMinFairTolerance, kMaxFairTolerance);
    smoothing_->setObjectName("fairSmoothing");
    smoothing_->setToolTip(tr("The larger, the longer the waves that are smoothed out"));
    smoothing_->setRange(kMinSmoothing, kMaxSmoothing);
    setQuietly(*tolerance_, Fairing{}.tolerance);
    setQuietly(*smoothing_, Fairing{}.smoothing);
    trueBelow_->setObjectName("trueBelow");
    trueBelow_->setAccessibleName(tr("True seam ends up to this kink"));
    trueBelow_->setWrapping(false);
    trueBelow_->setRange(0, kMaxKink / kDegree);
    straying_->setObjectName("lineStraying");
    straying_->setWordWrap(true);
    straying_->setForegroundRole(QPalette::PlaceholderText);
    auto* grid = new QGridLayout(settings);
    grid->setContentsMargins(10, 6, 10, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->addWidget(fair_, 0, 0, 1, 2);
    const std::pair<QString, LengthEdit*> rows[] = {{tr("&May stray by"), tolerance_},
                                                    {tr("Smoot&hing length"), smoothing_}};
    int row = 1;
    for (const auto& [text, field] : rows) {
        auto* label = new QLabel(text, settings);
        label->setBuddy(field);
        label->setIndent(18);
        field->setAccessibleName(label->text().remove('&'));
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row++, 1);
    }
    grid->addWidget(true_, row, 0);
    grid->addWidget(trueBelow_, row++, 1);
    grid->addWidget(straying_, row++, 0, 1, 3);
    grid->setColumnStretch(2, 1);
    grid->setRowStretch(row, 1);
    for (QDoubleSpinBox* field :
         std::initializer_list<QDoubleSpinBox*>{tolerance_, smoothing_, trueBelow_}) {
        field->setFocusPolicy(Qt::StrongFocus);
        field->setMinimumWidth(86);
        field->setMaximumWidth(kWidestField);
        fieldGuard_->install(*field);
        field->installEventFilter(this);
    }
    return settings;
}

bool LinesPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        gesture_ = document_.newGesture();
    }
    return QWidget::eventFilter(watched, event);
}

void LinesPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (isStale_) {
        refresh();
    }
}

void LinesPanel::onChanged(DocumentChanges what) {
    if (what & (DocumentChange::Opened | DocumentChange::Garment | DocumentChange::Results |
                DocumentChange::Seams | DocumentChange::Options)) {
        refresh();
    } else if (what & (DocumentChange::Mark | DocumentChange::SeamSelection)) {
        showSelected();
    }
}

void LinesPanel::refresh() {
    isStale_ = !isVisible();
    showSettings();
    if (isStale_ && document_.garment()) {
        return;
    }
    facts_ = document_.garment()
                 ? lineFacts(*document_.garment(), document_.results(), document_.state().lines)
                 : LineFacts{};
    if (document_.garment()) {
        ends_->show(document_, facts_);
    } else {
        ends_->clear();
    }
    showStraying();
    showSelected();
}

void LinesPanel::showSettings() {
    const LineSettings& lines = document_.state().lines;
    const bool open = document_.garment() != nullptr;
    for (QWidget* field :
         std::initializer_list<QWidget*>{fair_, true_, tolerance_, smoothing_, trueBelow_}) {
        field->setEnabled(open);
    }
    allowance_->refresh();
    label_->refresh();
    fair_->setChecked(lines.fairing.has_value());
    true_->setChecked(lines.trueBelow > 0);
    if (lines.fairing) {  // else they say what would be
        setQuietly(*tolerance_, lines.fairing->tolerance);
        setQuietly(*smoothing_, lines.fairing->smoothing);
    }
    setQuietly(*trueBelow_, (lines.trueBelow > 0 ? lines.trueBelow : kProposedTrueing) / kDegree);
}

void LinesPanel::showStraying() {
    if (!document_.garment() || !facts_.drawn) {
        straying_->setText(document_.garment() ? tr("Every line is the exact outline.")
                                               : QString());
        return;
    }
    straying_->setText(
        tr("At most %1 from the exact outline; the largest strain goes from %2 to %3.")
            .arg(fineLength(facts_.farthest) + ' ' + lengthUnit(),
                 tr("%1 %").arg(percent(facts_.exactStrain)),
                 tr("%1 %").arg(percent(facts_.strain))));
}

void LinesPanel::showSelected() {
    if (isStale_ || !isVisible() || !document_.garment()) {
        isStale_ = isStale_ || document_.garment();
        dart_->refresh();
        segment_->clear();
        return;
    }
    ends_->select(document_.seam());
    dart_->refresh();
    segment_->show(facts_);
}

void LinesPanel::setFair(bool fair) {
    LineSettings lines = document_.state().lines;
    lines.fairing =
        fair ? std::optional(Fairing{tolerance_->value(), smoothing_->value()}) : std::nullopt;
    document_.setLines(std::move(lines), fair ? tr("Fair lines") : tr("Exact outlines"));
}

void LinesPanel::setFairing(double Fairing::*field, double value, const QString& text) {
    LineSettings lines = document_.state().lines;
    Fairing fairing = lines.fairing.value_or(Fairing{tolerance_->value(), smoothing_->value()});
    fairing.*field = value;
    fairing.isFixed |= field == &Fairing::tolerance;
    lines.fairing = fairing;
    document_.setLines(std::move(lines), text, gesture_);
}

void LinesPanel::setTrueing(bool trued) {
    LineSettings lines = document_.state().lines;
    lines.trueBelow = trued ? trueBelow_->value() * kDegree : 0;
    document_.setLines(trued ? withFairing(std::move(lines)) : lines,
                       trued ? tr("True seam ends") : tr("Seam ends as they are"));
}

void LinesPanel::setTrueBelow(double degrees) {
    LineSettings lines = document_.state().lines;
    lines.trueBelow = degrees * kDegree;
    document_.setLines(withFairing(std::move(lines)), tr("True seam ends"), gesture_);
}

}  // namespace toile::app
