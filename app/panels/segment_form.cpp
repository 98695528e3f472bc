// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/segment_form.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "app/document/line_edits.h"
#include "app/document/names.h"
#include "app/panels/segment_rows.h"
#include "app/text/figures.h"
#include "app/widgets/number_edits.h"
#include "core/seam/seam_measure.h"

namespace toile::app {

namespace {

/// Lengths that can be typed, as parts of the one in 3D: what is beyond is a slip of the keys.
constexpr double kShortest = 0.2, kLongest = 5;
constexpr int kWidest = 160;      // logical pixels, of a field
constexpr double kAsWorn = 1e-5;  // mm: what the field's digits leave out is less

QToolButton* makeButton(const char* name, const QString& text, const QString& tip,
                        QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    return button;
}

QString nameOf(const Document& document, const Segment& segment) {
    const QString piece = pieceName(document, segment.at.piece);
    if (segment.seam < 0) {
        return SegmentForm::tr("%1: free edge").arg(piece);
    }
    const Seam& seam = document.garment()->seams.seams[static_cast<std::size_t>(segment.seam)];
    const QString name = seamName(document, segment.seam);
    return seam.kind == SeamKind::Free ? name : SegmentForm::tr("%1: %2").arg(piece, name);
}

}  // namespace

SegmentForm::SegmentForm(Document& document, FieldGuard& guard, QWidget* parent)
    : QWidget(parent),
      document_(document),
      title_(new QLabel(this)),
      lengths_(new QLabel(this)),
      kinks_(new QLabel(this)),
      length_(new LengthEdit(this)),
      tolerance_(new LengthEdit(this)),
      asWorn_(makeButton("segmentAsWorn", tr("As in 3D"),
                         tr("Take the typed length back: as long as on the garment"), this)),
      asOthers_(makeButton("segmentAsOthers", tr("As the others"),
                           tr("Take the typed distance back: as for all other lines"), this)),
      addPoint_(makeButton("addTurnPoint", tr("Add turn point"),
                           tr("Let the line turn at the selected vertex: a segment ends there"),
                           this)),
      removePoint_(makeButton("removeTurnPoint", tr("Remove turn point"),
                              tr("Let the line run on smoothly at the selected vertex"), this)),
      straight_(new QCheckBox(tr("Straight"), this)),
      allowance_(new AllowanceRows(document, guard, this)),
      strips_(new StripRows(document, guard, this)),
      sewn_(new SewnRows(document, guard, this)) {
    makeRows(guard);
    connect(allowance_, &AllowanceRows::wanted, this, &SegmentForm::wanted);
    connect(strips_, &StripRows::wanted, this, &SegmentForm::wanted);
    connect(length_, &QDoubleSpinBox::valueChanged, this, [this](double length) {
        const bool isWorn = std::abs(length - shown_.length()) < kAsWorn;
        setLength(isWorn ? std::nullopt : std::optional(length));
    });
    connect(tolerance_, &QDoubleSpinBox::valueChanged, this,
            [this](double tolerance) { setTolerance(tolerance); });
    connect(asWorn_, &QToolButton::clicked, this, [this] {
        gesture_ = document_.newGesture();
        setLength(std::nullopt);
    });
    connect(asOthers_, &QToolButton::clicked, this, [this] {
        gesture_ = document_.newGesture();
        setTolerance(std::nullopt);
    });
    connect(straight_, &QCheckBox::clicked, this, &SegmentForm::setStraight);
    connect(addPoint_, &QToolButton::clicked, this, [this] { setTurnPoint(true); });
    connect(removePoint_, &QToolButton::clicked, this, [this] { setTurnPoint(false); });
    clear();
}

void SegmentForm::makeRows(FieldGuard& guard) {
    QFont strong = title_->font();
    strong.setWeight(QFont::DemiBold);
    title_->setFont(strong);
    title_->setObjectName("segmentTitle");
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    lengths_->setObjectName("segmentLengths");
    lengths_->setForegroundRole(QPalette::PlaceholderText);
    kinks_->setObjectName("segmentKinks");
    kinks_->setForegroundRole(QPalette::PlaceholderText);
    kinks_->setToolTip(
        tr("A kink is what two lines that are sewn together lack to run on into "
           "each other; else by how much the outline turns"));
    straight_->setObjectName("segmentStraight");
    straight_->setToolTip(tr("Draw the segment as one straight line; lines are made fair for it"));
    length_->setObjectName("segmentLength");
    length_->setToolTip(tr("Length in the pattern, on both sides of a seam. Bold: typed by you"));
    tolerance_->setObjectName("segmentTolerance");
    tolerance_->setToolTip(
        tr("How far the line of this segment may stray from the exact outline; "
           "lines are made fair for it. Bold: typed by you"));
    tolerance_->setRange(kMinFairTolerance, kMaxFairTolerance);
    for (LengthEdit* field : {length_, tolerance_}) {
        field->setFocusPolicy(Qt::StrongFocus);
        field->setMinimumWidth(96);
        field->setMaximumWidth(kWidest);
        guard.install(*field);
        field->installEventFilter(this);
    }
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(10, 6, 10, 6);
    columns->setSpacing(12);
    auto* grid = new QGridLayout;
    auto* added = new QGridLayout;  // what is added to the segment, beside what it is
    for (QGridLayout* column : {grid, added}) {
        columns->addLayout(column);
        column->setHorizontalSpacing(8);
        column->setVerticalSpacing(4);
    }
    columns->addStretch(1);
    grid->addWidget(title_, 0, 0, 1, 4);
    grid->addWidget(lengths_, 1, 0, 1, 4);
    const std::tuple<QString, LengthEdit*, QToolButton*> rows[] = {
        {tr("Len&gth"), length_, asWorn_}, {tr("May &stray by"), tolerance_, asOthers_}};
    int row = 2;
    for (const auto& [text, field, button] : rows) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        field->setAccessibleName(label->text().remove('&'));
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row, 1);
        grid->addWidget(button, row++, 2);
    }
    row = allowance_->addTo(*grid, row);
    added->setRowMinimumHeight(0, title_->sizeHint().height());
    added->setRowMinimumHeight(1, lengths_->sizeHint().height());
    const int last = sewn_->addTo(*added, strips_->addTo(*added, 2));
    added->setRowStretch(last, 1);
    grid->addWidget(straight_, 2, 3);
    grid->addWidget(kinks_, row++, 0, 1, 4);
    auto* points = new QHBoxLayout;
    points->setSpacing(4);
    points->addWidget(addPoint_);
    points->addWidget(removePoint_);
    points->addStretch(1);
    grid->addLayout(points, row++, 0, 1, 4);
    grid->setColumnStretch(3, 1);
    grid->setRowStretch(row, 1);
}

bool SegmentForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        gesture_ = document_.newGesture();
    }
    return QWidget::eventFilter(watched, event);
}

void SegmentForm::setFieldsEnabled(bool enabled) {
    for (QWidget* field : std::initializer_list<QWidget*>{length_, tolerance_, straight_}) {
        field->setEnabled(enabled);
    }
}

void SegmentForm::clear() {
    at_.reset();
    partner_.reset();
    vertex_.reset();
    allowance_->clear();
    strips_->clear();
    sewn_->clear();
    title_->setText(tr("Segment"));
    lengths_->setText(tr("Select a seam, or a stretch of outline by a double click."));
    kinks_->clear();
    setFieldsEnabled(false);
    for (QWidget* button : {asWorn_, asOthers_, addPoint_, removePoint_}) {
        button->setEnabled(false);
    }
    straight_->setChecked(false);
}

std::optional<SegmentAt> SegmentForm::selected(const LineFacts& facts) const {
    const Garment& garment = *document_.garment();
    if (document_.mark()) {
        return segmentAt(garment, facts, *document_.mark());
    }
    const std::optional<int> seam = document_.seam();
    return seam ? segmentOfSeam(facts, garment.seams.seams[static_cast<std::size_t>(*seam)])
                : std::nullopt;
}

void SegmentForm::show(const LineFacts& facts) {
    const std::optional<SegmentAt> at = selected(facts);
    if (at != at_) {
        gesture_ = document_.newGesture();
    }
    if (!at) {
        clear();
        showTurnPoint(facts);
        return;
    }
    at_ = at;
    shown_ = facts.at(*at);
    partner_.reset();
    if (const auto partner = partnerOf(*document_.garment(), facts, *at)) {
        const Segment& other = facts.at(*partner);
        partner_ = other.place;
        if (!shown_.settings.length) {
            shown_.settings.length = other.settings.length;
        }
    }
    const SegmentSettings& said = shown_.settings;
    const Fairing usual = document_.state().lines.fairing.value_or(Fairing{});
    title_->setText(nameOf(document_, shown_));
    title_->setToolTip(title_->text());
    setFieldsEnabled(static_cast<bool>(shown_.place.line));
    showLengths(facts, shown_);
    showLength(*tolerance_, said.tolerance.value_or(usual.tolerance), said.tolerance.has_value());
    straight_->setChecked(said.straight);
    const auto& around = facts.segments[static_cast<std::size_t>(at->piece)].segments;
    const auto index = static_cast<std::size_t>(at->segment);
    allowance_->show(facts, *at,
                     nameOf(document_, around[(index + around.size() - 1) % around.size()]));
    strips_->show(facts, *at);
    sewn_->show(shown_);
    asWorn_->setEnabled(said.length.has_value());
    asOthers_->setEnabled(said.tolerance.has_value());
    showKinks(facts, *at);
    showTurnPoint(facts);
}

void SegmentForm::showLengths(const LineFacts&, const Segment& segment) {
    const double worn = segment.length();
    const PieceResult* result = document_.result(segment.at.piece);
    const Piece& piece = *document_.garment()->pieces[static_cast<std::size_t>(segment.at.piece)];
    const QString inSpace = lengthWithUnit(worn);
    lengths_->setText(
        result && result->flat
            ? tr("%1 in 3D, %2 in the pattern")
                  .arg(inSpace, lengthWithUnit(flatLength(segment.at, piece, *result->flat)))
            : tr("%1 in 3D").arg(inSpace));
    {
        const QSignalBlocker quiet(length_);
        length_->setRange(std::max(kMinSegmentLength, kShortest * worn),
                          std::min(kMaxSegmentLength, kLongest * worn));
    }
    showLength(*length_, segment.settings.length.value_or(worn),
               segment.settings.length.has_value());
}

void SegmentForm::showKinks(const LineFacts& facts, const SegmentAt& at) {
    const OutlineSegments& of = facts.segments[static_cast<std::size_t>(at.piece)];
    if (of.turnPoints.empty()) {
        kinks_->clear();
        return;
    }
    const auto textAt = [&](int point) -> QString {
        for (std::size_t k = 0; k < facts.ends.size(); ++k) {
            for (const OutlineCorner& corner : {facts.ends[k].left, facts.ends[k].right}) {
                if (corner.piece == at.piece && corner.point == point) {
                    return tr("kink %1").arg(angleWithUnit(facts.kept[k]));
                }
            }
        }
        return tr("turn %1").arg(
            angleWithUnit(of.turnPoints[static_cast<std::size_t>(point)].turn));
    };
    const auto count = static_cast<int>(of.turnPoints.size());
    kinks_->setText(tr("Ends: %1, %2").arg(textAt(at.segment), textAt((at.segment + 1) % count)));
}

void SegmentForm::showTurnPoint(const LineFacts& facts) {
    vertex_.reset();
    const TurnPoint* there = nullptr;
    if (const auto& mark = document_.mark(); mark && mark->kind == Feature::Kind::Vertex) {
        const auto at = static_cast<std::size_t>(mark->piece);
        const Piece& piece = *document_.garment()->pieces[at];
        const auto vertex = boundaryIndex(piece, mark->vertex);
        if (vertex && !facts.segments[at].segments.empty()) {
            vertex_ = turnPointAt(piece, *vertex);
            there = turnPointOf(piece, facts.segments[at], *vertex);
        }
    }
    addPoint_->setEnabled(vertex_ && !(there && there->isCorner));
    removePoint_->setEnabled(vertex_ && there && keepsTurn(*there));
}

void SegmentForm::setLength(std::optional<double> length) {
    LineSettings lines = document_.state().lines;
    if (partner_) {
        lines = withoutLength(std::move(lines), *partner_);  // one of the two sides says it
    }
    SegmentSettings said = shown_.settings;
    said.length = length;
    emit wanted(withSegment(std::move(lines), said), tr("Length of a segment"), gesture_);
}

void SegmentForm::setTolerance(std::optional<double> tolerance) {
    SegmentSettings said = shown_.settings;
    said.tolerance = tolerance;
    LineSettings lines = withSegment(document_.state().lines, said);
    emit wanted(tolerance ? withFairing(std::move(lines)) : lines, tr("Distance of a segment"),
                gesture_);
}

void SegmentForm::setStraight(bool straight) {
    SegmentSettings said = shown_.settings;
    said.straight = straight;
    LineSettings lines = withSegment(document_.state().lines, said);
    emit wanted(straight ? withFairing(std::move(lines)) : lines,
                straight ? tr("Straight segment") : tr("Segment no longer straight"), -1);
}

void SegmentForm::setTurnPoint(bool turns) {
    if (vertex_) {
        vertex_->turns = turns;
        emit wanted(withTurnPoint(document_.state().lines, *vertex_),
                    turns ? tr("Turn point") : tr("Removal of a turn point"), -1);
    }
}

}  // namespace toile::app
