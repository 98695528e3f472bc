// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/strip_rows.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <algorithm>

#include "app/document/allowance_edits.h"
#include "app/document/document.h"
#include "app/document/mirrored_edits.h"
#include "app/document/strip_edits.h"
#include "app/widgets/number_edits.h"

namespace toile::app {

namespace {

constexpr int kWidestStrip = 160;  // logical pixels, of a field

/// 0 is none, and what is less than the least the least.
std::optional<double> stripOf(double typed) {
    return typed > 0 ? std::optional(std::max(typed, kMinStrip)) : std::nullopt;
}

}  // namespace

StripRows::StripRows(Document& document, FieldGuard& guard, QWidget* form)
    : QObject(form),
      document_(document),
      extension_(new LengthEdit(form)),
      facing_(new LengthEdit(form)) {
    extension_->setObjectName("segmentExtension");
    extension_->setToolTip(
        tr("Draw a free edge out parallel by so much, as a button stand or a turn-up; the edges "
           "beside it run on"));
    facing_->setObjectName("segmentFacing");
    facing_->setToolTip(
        tr("Copy a strip of this width along the segment as a piece of its own, a facing or a "
           "lining; neighbouring segments with a facing share it"));
    for (LengthEdit* field : {extension_, facing_}) {
        field->setRange(0, kMaxStrip);
        field->setSpecialValueText(tr("none"));
        field->setFocusPolicy(Qt::StrongFocus);
        field->setMinimumWidth(86);
        field->setMaximumWidth(kWidestStrip);
        field->installEventFilter(this);
        guard.install(*field);
    }
    connect(extension_, &QDoubleSpinBox::valueChanged, this,
            [this](double width) { setExtension(stripOf(width)); });
    connect(facing_, &QDoubleSpinBox::valueChanged, this,
            [this](double width) { setFacing(stripOf(width)); });
    clear();
}

int StripRows::addTo(QGridLayout& grid, int row) {
    const auto addField = [&](const QString& text, LengthEdit* field) {
        auto* label = new QLabel(text, field->parentWidget());
        label->setBuddy(field);
        field->setAccessibleName(label->text().remove('&'));
        grid.addWidget(label, row, 0);
        grid.addWidget(field, row++, 1);
    };
    addField(tr("E&xtension"), extension_);
    addField(tr("Fa&cing"), facing_);
    return row;
}

bool StripRows::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        gesture_ = document_.newGesture();
    }
    return QObject::eventFilter(watched, event);
}

void StripRows::clear() {
    facts_ = nullptr;
    for (LengthEdit* field : {extension_, facing_}) {
        showLength(*field, 0, false);
        field->setEnabled(false);
    }
}

void StripRows::show(const LineFacts& facts, const SegmentAt& at) {
    if (!facts_ || !(at == at_)) {
        gesture_ = document_.newGesture();
    }
    facts_ = &facts;
    at_ = at;
    const Segment& segment = facts.at(at);
    const bool isFree =
        segment.seam >= 0 &&
        document_.garment()->seams.seams[static_cast<std::size_t>(segment.seam)].kind ==
            SeamKind::Free;
    const std::optional<double> facing = facingOf(document_.state().lines, segment);
    extension_->setEnabled(segment.place.line && isFree);
    facing_->setEnabled(static_cast<bool>(segment.place.line));
    showLength(*extension_, isFree ? segment.settings.extension.value_or(0) : 0,
               segment.settings.extension.has_value());
    showLength(*facing_, facing.value_or(0), facing.has_value());
}

std::vector<SegmentAt> StripRows::segments() const {
    return alikeSegments(*document_.garment(), *facts_, at_, false, editSymmetry(document_));
}

void StripRows::setExtension(std::optional<double> width) {
    if (facts_) {
        say(withExtension(document_.state().lines, *facts_, segments(), width),
            tr("Extension of an edge"));
    }
}

void StripRows::setFacing(std::optional<double> width) {
    if (facts_) {
        const std::vector<SegmentAt> places = segments();
        std::vector<std::string> names;
        for (const SegmentAt& place : places) {
            const Piece& piece =
                *document_.garment()->pieces[static_cast<std::size_t>(place.piece)];
            const std::string& name = nameOf(document_.state().labels, piece);
            names.push_back(tr("%1, facing").arg(QString::fromStdString(name)).toStdString());
        }
        say(withFacing(document_.state().lines, *facts_, places, width, names),
            tr("Facing of an edge"));
    }
}

void StripRows::say(const LineSettings& lines, const QString& text) {
    if (lines == document_.state().lines) {
        show(*facts_, at_);  // not what was typed
    } else {
        emit wanted(lines, text, gesture_);
    }
}

}  // namespace toile::app
