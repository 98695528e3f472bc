// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/play_bar.h"

#include <QEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QToolButton>
#include <QVariantAnimation>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/render/render_style.h"

namespace toile::app {

namespace {

constexpr int kSliderSteps = 1000;
constexpr int kAirAround = 12;
constexpr int kCatch = 5;      ///< logical pixels; a drag within this distance snaps to a stop
constexpr int kMinFill = 238;  ///< of 255: hides the drawing below

/// A slider that jumps to a click on its groove, whatever the desktop style does, and can be
/// dragged on from there.
class JumpSlider : public QSlider {
public:
    using QSlider::QSlider;

protected:
    void mousePressEvent(QMouseEvent* event) override {
        QStyleOptionSlider option;
        initStyleOption(&option);
        const auto partOf = [&](QStyle::SubControl part) -> QRect {
            return style()->subControlRect(QStyle::CC_Slider, &option, part, this);
        };
        const QRect handle = partOf(QStyle::SC_SliderHandle),
                    groove = partOf(QStyle::SC_SliderGroove);
        const QPoint at = event->position().toPoint();
        const bool jumps = event->button() == Qt::LeftButton && !handle.contains(at);
        if (jumps) {
            const bool lies = orientation() == Qt::Horizontal;
            const int size = lies ? handle.width() : handle.height();
            const int place = (lies ? at.x() - groove.left() : at.y() - groove.top()) - size / 2;
            const int room = (lies ? groove.width() : groove.height()) - size;
            setValue(QStyle::sliderValueFromPosition(minimum(), maximum(), place, room,
                                                     option.upsideDown));
        }
        QSlider::mousePressEvent(event);  // the handle is under the pointer now
        if (jumps && isSliderDown()) {
            triggerAction(SliderMove);  // as a drag would do
        }
    }
};

}  // namespace

PlayBar::PlayBar(QWidget& view, const QString& name, int milliseconds, Room room)
    : QWidget(&view),
      view_(view),
      milliseconds_(milliseconds),
      room_(room),
      slider_(new JumpSlider(Qt::Horizontal, this)),
      button_(new QToolButton(this)),
      animation_(new QVariantAnimation(this)) {
    setObjectName(name + "Bar");
    setCursor(Qt::ArrowCursor);
    setAttribute(Qt::WA_NoMousePropagation);  // a click beside the slider must not reach the view
    slider_->setObjectName(name + "Slider");
    slider_->setRange(0, kSliderSteps);
    slider_->setSingleStep(kSliderSteps / 50);
    slider_->setPageStep(kSliderSteps / 10);
    button_->setObjectName(name + "Play");
    button_->setArrowType(Qt::RightArrow);
    button_->setAutoRaise(true);
    button_->setAccessibleName(tr("Play"));
    connect(slider_, &QSlider::valueChanged, this, [this] { emit moved(share()); });
    connect(slider_, &QSlider::actionTriggered, this, &PlayBar::stopOnTheWay);
    connect(slider_, &QSlider::sliderPressed, animation_, &QVariantAnimation::stop);
    connect(button_, &QToolButton::clicked, this, &PlayBar::play);
    connect(animation_, &QVariantAnimation::valueChanged, slider_,
            [this](const QVariant& value) { slider_->setValue(value.toInt()); });
    view_.installEventFilter(this);
}

double PlayBar::share() const {
    return static_cast<double>(slider_->value()) / kSliderSteps;
}

double PlayBar::step() {
    return 1.0 / kSliderSteps;
}

void PlayBar::setStops(const std::vector<double>& shares) {
    stops_.clear();
    for (const double at : shares) {
        stops_.push_back(qRound(at * kSliderSteps));
    }
}

void PlayBar::stopOnTheWay(int action) {
    animation_->stop();  // a key press overrides it
    const int from = slider_->value(), to = slider_->sliderPosition();
    if (action == QAbstractSlider::SliderToMinimum || action == QAbstractSlider::SliderToMaximum) {
        return;
    }
    const bool isDragged = slider_->isSliderDown();
    const int reach = kCatch * kSliderSteps / std::max(slider_->width(), 1);
    std::optional<int> nearest;
    for (const int stop : stops_) {
        const bool isPassed = from < to ? stop > from && stop < to : stop < from && stop > to;
        const int origin = isDragged ? to : from;
        if ((isDragged ? std::abs(stop - to) <= reach : isPassed) &&
            (!nearest || std::abs(stop - origin) < std::abs(*nearest - origin))) {
            nearest = stop;
        }
    }
    if (nearest) {
        slider_->setSliderPosition(*nearest);
    }
}

QLabel* PlayBar::makeLabel(const QString& text) {
    auto* label = new QLabel(text, this);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 0.88);
    label->setFont(font);
    return label;
}

void PlayBar::play() {
    if (isHidden()) {
        return;
    }
    if (animation_->state() == QAbstractAnimation::Running) {
        animation_->stop();
        return;
    }
    const int from = slider_->value(), to = from < kSliderSteps / 2 ? kSliderSteps : 0;
    animation_->setStartValue(from);
    animation_->setEndValue(to);
    animation_->setDuration(milliseconds_ * std::abs(to - from) / kSliderSteps);
    animation_->start();
}

void PlayBar::stop() {
    animation_->stop();
}

void PlayBar::rewind() {
    animation_->stop();
    slider_->setValue(0);
}

void PlayBar::place() {
    const int width = std::min(room_.width, view_.width() - room_.left - kAirAround);
    const int height = sizeHint().height();
    const int left = std::max(room_.left, (view_.width() - width) / 2);
    setGeometry(left, view_.height() - height - room_.foot, width, height);
}

bool PlayBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &view_ && event->type() == QEvent::Resize) {
        place();
    }
    return QWidget::eventFilter(watched, event);
}

void PlayBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    QColor fill = renderStyle(palette()).labelFill;
    fill.setAlpha(std::max(fill.alpha(), kMinFill));
    painter.setBrush(fill);
    painter.drawRoundedRect(rect(), 7, 7);
}

}  // namespace toile::app
