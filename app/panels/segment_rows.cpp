// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/segment_rows.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFont>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/document/allowance_edits.h"
#include "app/document/document.h"
#include "app/document/mirrored_edits.h"
#include "app/document/notch_edits.h"
#include "app/document/strip_edits.h"
#include "app/widgets/number_edits.h"
#include "core/seam/seam_measure.h"

namespace toile::app {
namespace {

constexpr int kWidestStrip = 160;  // logical pixels, of a field

/// 0 is none, and what is less than the least the least.
std::optional<double> stripOf(double typed) {
    return typed > 0 ? std::optional(std::max(typed, kMinStrip)) : std::nullopt;
}

constexpr double kPercent = 0.01;
constexpr double kMaxEasePercent = 100, kMinEasePercent = -50;  // per cent, in the field

QToolButton* makeSmallButton(const char* name, const QString& text, const QString& tip,
                             QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    return button;
}

/// The notches of a seam, by share.
std::vector<SeamNotch> notchesAlong(const Document& document, int seam) {
    std::vector<SeamNotch> notches;
    if (const auto& pattern = document.derived().pattern) {
        notches = notchesOf(*pattern);
        std::erase_if(notches, [seam](const SeamNotch& notch) { return notch.seam != seam; });
    }
    return notches;
}

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

SewnRows::SewnRows(Document& document, FieldGuard& guard, QWidget* form)
    : QObject(form),
      document_(document),
      ease_(new PercentEdit(form)),
      asWorn_(makeSmallButton("segmentEaseAsWorn", tr("As in 3D"),
                              tr("Take the stated ease back: as the garment has it"), form)),
      add_(makeSmallButton("segmentNotchAdd", QStringLiteral("+"),
                           tr("Add a notch in the middle of the longest way without one"), form)),
      remove_(makeSmallButton("segmentNotchRemove", QStringLiteral("−"),
                              tr("Take away the notch nearest to the middle"), form)),
      notches_(new QLabel(form)) {
    ease_->setObjectName("segmentEase");
    ease_->setToolTip(
        tr("How much longer the left side of the seam is meant to be. Bold: stated by you"));
    ease_->setRange(kMinEasePercent, kMaxEasePercent);
    ease_->setFocusPolicy(Qt::StrongFocus);
    ease_->installEventFilter(this);
    guard.install(*ease_);
    notches_->setObjectName("segmentNotches");
    add_->setAccessibleName(tr("Add a notch"));
    remove_->setAccessibleName(tr("Take a notch away"));
    connect(ease_, &QDoubleSpinBox::valueChanged, this,
            [this](double percent) { setEase(percent * kPercent); });
    connect(asWorn_, &QToolButton::clicked, this, [this] {
        gesture_ = document_.newGesture();
        setEase(std::nullopt);
    });
    connect(add_, &QToolButton::clicked, this, &SewnRows::addNotch);
    connect(remove_, &QToolButton::clicked, this, &SewnRows::removeNotch);
    clear();
}

int SewnRows::addTo(QGridLayout& grid, int row) {
    auto* label = new QLabel(tr("&Ease"), ease_->parentWidget());
    label->setBuddy(ease_);
    ease_->setAccessibleName(label->text().remove('&'));
    grid.addWidget(label, row, 0);
    grid.addWidget(ease_, row, 1);
    grid.addWidget(asWorn_, row++, 2);
    grid.addWidget(new QLabel(tr("Notches"), ease_->parentWidget()), row, 0);
    grid.addWidget(notches_, row, 1);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    buttons->addWidget(add_);
    buttons->addWidget(remove_);
    buttons->addStretch(1);
    grid.addLayout(buttons, row++, 2);
    return row;
}

bool SewnRows::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        gesture_ = document_.newGesture();
    }
    return QObject::eventFilter(watched, event);
}

void SewnRows::clear() {
    seam_ = -1;
    notches_->clear();
    const QSignalBlocker quiet(ease_);
    ease_->setValue(0);
    for (QWidget* field : std::initializer_list<QWidget*>{ease_, asWorn_, add_, remove_}) {
        field->setEnabled(false);
    }
}

void SewnRows::show(const Segment& segment) {
    const auto& seams = document_.garment()->seams.seams;
    const bool isSewn =
        segment.seam >= 0 && seams[static_cast<std::size_t>(segment.seam)].kind != SeamKind::Free;
    if (!isSewn) {
        clear();
        return;
    }
    if (seam_ != segment.seam) {
        gesture_ = document_.newGesture();
    }
    seam_ = segment.seam;
    const Seam& seam = seams[static_cast<std::size_t>(seam_)];
    {
        const QSignalBlocker quiet(ease_);
        ease_->setValue(easeOf(seam) / kPercent);
    }
    QFont font = ease_->font();
    font.setBold(seam.ease.has_value());
    ease_->setFont(font);
    ease_->setEnabled(true);
    asWorn_->setEnabled(seam.ease.has_value());
    const auto count = notchesAlong(document_, seam_).size();
    notches_->setText(QString::number(count));
    add_->setEnabled(!seam.matches.empty());
    remove_->setEnabled(count > 0);
}

void SewnRows::setEase(std::optional<double> ease) {
    if (seam_ >= 0) {
        document_.setSeamEase(seam_, ease, gesture_);
    }
}

void SewnRows::addNotch() {
    std::vector<double> shares{0};
    for (const SeamNotch& notch : notchesAlong(document_, seam_)) {
        shares.push_back(notch.share);
    }
    shares.push_back(1);
    std::size_t longest = 1;
    for (std::size_t k = 2; k < shares.size(); ++k) {
        if (shares[k] - shares[k - 1] > shares[longest] - shares[longest - 1] + 1e-9) {
            longest = k;
        }
    }
    document_.setView(&ViewState::notches, true);
    document_.setLines(withNotch(document_.state().lines, *document_.garment(),
                                 {seam_, 0.5 * (shares[longest] + shares[longest - 1])}),
                       tr("Notch"));
}

void SewnRows::removeNotch() {
    const std::vector<SeamNotch> notches = notchesAlong(document_, seam_);
    const auto nearest = std::ranges::min_element(
        notches, {}, [](const SeamNotch& notch) { return std::abs(notch.share - 0.5); });
    if (nearest != notches.end()) {
        document_.setLines(withoutNotch(document_.state().lines, *document_.garment(), *nearest,
                                        document_.derived().symmetry.get()),
                           tr("Removal of a notch"));
    }
}

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
