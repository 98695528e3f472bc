// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/sewn_rows.h"

#include <QEvent>
#include <QFont>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/document/document.h"
#include "app/document/notch_edits.h"
#include "app/widgets/number_edits.h"
#include "core/seam/seam_measure.h"

namespace toile::app {

namespace {

constexpr double kPercent = 0.01;
constexpr double kMostEase = 100, kLeastEase = -50;  // per cent, in the field

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

}  // namespace

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
    ease_->setRange(kLeastEase, kMostEase);
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

}  // namespace toile::app
