// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/allowance_rows.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <iterator>
#include <utility>

#include "app/document/allowance_edits.h"
#include "app/document/document.h"
#include "app/document/mirrored_edits.h"
#include "app/widgets/number_edits.h"

namespace toile::app {

namespace {

constexpr int kWidestWidth = 160;  // logical pixels, of a field

/// In the order of the list of corners, after "by itself".
constexpr CornerRule kCornerRows[] = {CornerRule::Mitre,           CornerRule::Square,
                                      CornerRule::RightAngleFirst, CornerRule::RightAngleSecond,
                                      CornerRule::MirrorFirst,     CornerRule::MirrorSecond,
                                      CornerRule::Stepped};

QStringList cornerTexts() {
    return {AllowanceRows::tr("By itself"),
            AllowanceRows::tr("Mitred"),
            AllowanceRows::tr("Square"),
            AllowanceRows::tr("Right angle to the one before"),
            AllowanceRows::tr("Right angle to this one"),
            AllowanceRows::tr("Mirrored, the one before"),
            AllowanceRows::tr("Mirrored, this one"),
            AllowanceRows::tr("Stepped")};
}

int rowOf(std::optional<CornerRule> rule) {
    const auto found = std::ranges::find_if(
        kCornerRows, [&rule](CornerRule known) { return rule && known == *rule; });
    return found == std::end(kCornerRows) ? 0 : static_cast<int>(found - kCornerRows) + 1;
}

}  // namespace

AllowanceRows::AllowanceRows(Document& document, FieldGuard& guard, QWidget* form)
    : QObject(form),
      document_(document),
      width_(new LengthEdit(form)),
      asKind_(new QToolButton(form)),
      bothSides_(new QCheckBox(tr("On both sides"), form)),
      corner_(new QComboBox(form)) {
    width_->setObjectName("segmentAllowance");
    width_->setToolTip(
        tr("How much cloth is left beyond the line. Bold: typed by you, else that of its kind, "
           "seam or hem"));
    width_->setRange(0, kMaxAllowance);
    width_->setFocusPolicy(Qt::StrongFocus);
    width_->setMinimumWidth(96);
    width_->setMaximumWidth(kWidestWidth);
    width_->installEventFilter(this);
    guard.install(*width_);
    asKind_->setObjectName("segmentAllowanceAsKind");
    asKind_->setText(tr("As its kind"));
    asKind_->setToolTip(tr("Take the typed width back: as for all seams, or all hems"));
    bothSides_->setObjectName("segmentBothSides");
    bothSides_->setToolTip(tr("The width holds for what is sewn to the segment too"));
    bothSides_->setChecked(true);
    corner_->setObjectName("segmentCorner");
    corner_->addItems(cornerTexts());
    corner_->setFocusPolicy(Qt::StrongFocus);
    guard.install(*corner_);
    connect(width_, &QDoubleSpinBox::valueChanged, this, [this](double width) { setWidth(width); });
    connect(asKind_, &QToolButton::clicked, this, [this] {
        gesture_ = document_.newGesture();
        setWidth(std::nullopt);
    });
    connect(bothSides_, &QCheckBox::clicked, this,
            [this] { gesture_ = document_.newGesture(); });  // what comes is said of others
    connect(corner_, &QComboBox::activated, this, &AllowanceRows::setCorner);
    clear();
}

int AllowanceRows::addTo(QGridLayout& grid, int row) {
    const auto addLabel = [&](const QString& text, QWidget* field) {
        auto* label = new QLabel(text, field->parentWidget());
        label->setBuddy(field);
        field->setAccessibleName(label->text().remove('&'));
        grid.addWidget(label, row, 0);
    };
    addLabel(tr("Allo&wance"), width_);
    grid.addWidget(width_, row, 1);
    grid.addWidget(asKind_, row, 2);
    grid.addWidget(bothSides_, row++, 3);
    addLabel(tr("Corner at its &start"), corner_);
    grid.addWidget(corner_, row, 1, 1, 2);
    return row + 1;
}

bool AllowanceRows::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        gesture_ = document_.newGesture();
    }
    return QObject::eventFilter(watched, event);
}

void AllowanceRows::setEnabled(bool enabled) {
    for (QWidget* field : std::initializer_list<QWidget*>{width_, asKind_, bothSides_, corner_}) {
        field->setEnabled(enabled);
    }
}

void AllowanceRows::clear() {
    facts_ = nullptr;
    setEnabled(false);
    corner_->setCurrentIndex(0);
}

void AllowanceRows::show(const LineFacts& facts, const SegmentAt& at, const QString& before) {
    if (!facts_ || !(at == at_)) {
        gesture_ = document_.newGesture();
    }
    facts_ = &facts;
    at_ = at;
    const Segment& segment = facts.at(at);
    setEnabled(static_cast<bool>(segment.place.line));
    showLength(*width_, allowanceOf(*document_.garment(), segment, document_.state().lines),
               segment.settings.allowance.has_value());
    asKind_->setEnabled(segment.settings.allowance.has_value());
    bothSides_->setEnabled(segment.place.line &&
                           partnerOf(*document_.garment(), facts, at).has_value());
    corner_->setCurrentIndex(rowOf(segment.settings.corner));
    corner_->setToolTip(
        tr("How the allowances meet where the segment begins, anti-clockwise round the piece. The "
           "one before is %1")
            .arg(before));
}

void AllowanceRows::setWidth(std::optional<double> width) {
    if (facts_) {
        const auto segments = alikeSegments(*document_.garment(), *facts_, at_,
                                            bothSides_->isChecked(), editSymmetry(document_));
        emit wanted(withAllowance(document_.state().lines, *facts_, segments, width),
                    tr("Allowance of a segment"), gesture_);
    }
}

void AllowanceRows::setCorner(int row) {
    if (facts_) {
        const Symmetry* symmetry = editSymmetry(document_);
        const auto image =
            symmetry ? mirrorOf(*document_.garment(), *facts_, *symmetry, at_) : std::nullopt;
        const auto rule =
            row > 0 ? std::optional(kCornerRows[static_cast<std::size_t>(row) - 1]) : std::nullopt;
        emit wanted(withCorner(document_.state().lines, *facts_, at_, image, rule),
                    tr("Corner of an allowance"), -1);
    }
}

}  // namespace toile::app
