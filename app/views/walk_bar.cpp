// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/walk_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/document/document.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/views/garment_view.h"
#include "app/views/pattern_view.h"
#include "app/views/rolled_piece.h"

namespace toile::app {

namespace {

constexpr int kWalkMilliseconds = 6000;
constexpr int kWalkWidth = 420, kAirBesideText = 16;
/// Keeps the bar above the scale bar.
constexpr int kAboveFoot = 50;
/// In slider steps: half a step plus rounding.
constexpr double kNear = 0.5 + 1e-6;
constexpr auto kBetween = " · ";

bool isEscape(const QEvent& event) {
    return (event.type() == QEvent::KeyPress || event.type() == QEvent::ShortcutOverride) &&
           static_cast<const QKeyEvent&>(event).key() == Qt::Key_Escape;
}

}  // namespace

QString WalkBar::notchText(const std::vector<double>& notches, double share) {
    const auto passed = std::ranges::count_if(notches, [&](double at) { return at <= share; });
    if (passed == 0) {
        return tr("before notch 1 of %1").arg(notches.size());
    }
    const bool isThere = notches[static_cast<std::size_t>(passed - 1)] == share;
    return (isThere ? tr("at notch %1 of %2") : tr("past notch %1 of %2"))
        .arg(passed)
        .arg(notches.size());
}

WalkBar::WalkBar(Document& document, PatternView& pattern, GarmentView& garment)
    : PlayBar(pattern, "walk", kWalkMilliseconds, {.width = kWalkWidth, .foot = kAboveFoot}),
      document_(document),
      pattern_(pattern),
      garment_(garment),
      reading_(makeLabel({})) {
    slider().setAccessibleName(tr("Position along the seam"));
    slider().setToolTip(tr("Roll one piece along the seam of the other"));
    button().setToolTip(tr("Play the walk forwards and back"));
    reading_->setObjectName("walkReading");
    reading_->setAlignment(Qt::AlignCenter);
    auto* close = new QToolButton(this);
    close->setObjectName("walkClose");
    close->setAutoRaise(true);
    close->setText(QString(QChar(0x00d7)));
    close->setAccessibleName(tr("Close"));
    close->setToolTip(tr("End the walk (Esc)"));
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(&button());
    row->addWidget(&slider(), 1);
    row->addWidget(close);
    auto* lines = new QVBoxLayout(this);
    lines->setContentsMargins(4, 2, 4, 5);
    lines->setSpacing(0);
    lines->addLayout(row);
    lines->addWidget(reading_);

    connect(this, &PlayBar::moved, this, &WalkBar::roll);
    connect(close, &QToolButton::clicked, this, &WalkBar::end);
    connect(&document_, &Document::changed, this, [this] {
        if (rolled_) {
            follow();
        }
    });
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, [this] {
        if (rolled_) {
            showNow();
        }
    });
    setVisible(false);
}

WalkBar::~WalkBar() = default;

void WalkBar::begin() {
    rewind();
    rolled_ = nullptr;
    place();
    follow();
    if (rolled_) {
        pattern_.frameRolled();
        place();  // the text has set the height now
        setVisible(true);
        raise();
        slider().setFocus();
    }
}

void WalkBar::end() {
    const bool hadFocus = isAncestorOf(focusWidget());
    stop();
    rolled_ = nullptr;
    showNow();
    setVisible(false);
    if (hadFocus) {
        pattern_.setFocus();
    }
}

void WalkBar::follow() {
    const int before = rolled_ ? rolled_->seam() : -1;
    auto rolled = document_.seam() ? RolledPiece::of(document_, *document_.seam()) : std::nullopt;
    if (!rolled) {
        end();
        return;
    }
    rolled_ = std::make_shared<RolledPiece>(std::move(*rolled));
    setStops(rolled_->notches());
    if (before >= 0 && before != rolled_->seam()) {
        rewind();
    }
    roll(share());
}

void WalkBar::roll(double share) {
    if (!rolled_) {
        return;
    }
    // Snap to a notch, even if its share lies between two slider steps.
    const auto awayFrom = [share](double at) { return std::abs(at - share); };
    const auto notch = std::ranges::min_element(rolled_->notches(), {}, awayFrom);
    const bool isThere = notch != rolled_->notches().end() && awayFrom(*notch) <= kNear * step();
    rolled_->rollTo(isThere ? *notch : share);
    showNow();
}

void WalkBar::showNow() {
    pattern_.setRolled(rolled_);
    garment_.setSeamDot(rolled_ ? std::optional(SeamDot{rolled_->seam(), rolled_->along()})
                                : std::nullopt);
    reading_->setText(rolled_ ? reading() : QString());
}

QString WalkBar::reading() const {
    const WalkedLengths& walked = rolled_->now().walked;
    const QString rolling = QString::fromStdString(rolled_->rolling().name);
    QStringList parts{
        rolled_->isItself()
            ? tr("%1 on itself").arg(rolling)
            : tr("%1 on %2").arg(rolling, QString::fromStdString(rolled_->lying().name)),
        tr("%1 of %2").arg(lengthNumber(walked.left), lengthWithUnit(rolled_->whole().left))};
    const QString way = reading_->fontMetrics().elidedText(parts.join(kBetween), Qt::ElideMiddle,
                                                           width() - kAirBesideText);
    parts.clear();
    if (!rolled_->notches().empty()) {
        parts << notchText(rolled_->notches(), rolled_->share());
    }
    parts << tr("difference %1 %2 (ease %3)")
                 .arg(signedFineLength(walked.left - walked.right), lengthUnit(),
                      signedFineLength(walked.ease));
    return way + '\n' + parts.join(kBetween);
}

bool WalkBar::eventFilter(QObject* watched, QEvent* event) {
    // Handle Escape before the tool, which would deselect the seam.
    if (watched == &pattern_ && rolled_ && isEscape(*event)) {
        event->accept();
        if (event->type() == QEvent::KeyPress) {
            end();
        }
        return true;
    }
    return PlayBar::eventFilter(watched, event);
}

void WalkBar::resizeEvent(QResizeEvent* event) {
    PlayBar::resizeEvent(event);
    if (rolled_) {
        showNow();
    }
}

bool WalkBar::event(QEvent* event) {
    if (isEscape(*event)) {  // keys from widgets inside the bar
        event->accept();
        if (event->type() == QEvent::KeyPress) {
            end();
        }
        return true;
    }
    return PlayBar::event(event);
}

}  // namespace toile::app
