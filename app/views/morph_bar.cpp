// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/morph_bar.h"

#include <QEvent>
#include <QHBoxLayout>
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

#include "app/document/document.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/views/garment_view.h"

namespace toile::app {

namespace {

constexpr int kSteps = 1000;
constexpr int kMilliseconds = 2600;  ///< for the whole way
constexpr int kWidth = 300, kMargin = 12;
/// To the right of the axis cross.
constexpr int kLeft = 92;

/// A slider that goes to where its groove is pressed, whatever the desktop's habit, and can be
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
        if (event->button() == Qt::LeftButton && !handle.contains(at)) {
            const bool lies = orientation() == Qt::Horizontal;
            const int size = lies ? handle.width() : handle.height();
            const int place = (lies ? at.x() - groove.left() : at.y() - groove.top()) - size / 2;
            const int room = (lies ? groove.width() : groove.height()) - size;
            setValue(QStyle::sliderValueFromPosition(minimum(), maximum(), place, room,
                                                     option.upsideDown));
        }
        QSlider::mousePressEvent(event);  // on the handle now
    }
};

QLabel* end(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 0.88);
    label->setFont(font);
    return label;
}

}  // namespace

MorphBar::MorphBar(Document& document, GarmentView& view)
    : QWidget(&view),
      document_(document),
      view_(view),
      slider_(new JumpSlider(Qt::Horizontal, this)),
      button_(new QToolButton(this)),
      animation_(new QVariantAnimation(this)) {
    setObjectName("morphBar");
    setCursor(Qt::ArrowCursor);
    slider_->setObjectName("morphSlider");
    slider_->setRange(0, kSteps);
    slider_->setSingleStep(kSteps / 50);
    slider_->setPageStep(kSteps / 10);
    slider_->setAccessibleName(tr("From the garment to the pattern"));
    slider_->setToolTip(
        tr("Shows what flattening does: the garment on the left, flat on the right"));
    button_->setObjectName("morphPlay");
    button_->setArrowType(Qt::RightArrow);
    button_->setAutoRaise(true);
    button_->setAccessibleName(tr("Play"));
    button_->setToolTip(tr("Play the way from the garment to the pattern and back"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 10, 2);
    row->setSpacing(6);
    row->addWidget(button_);
    row->addWidget(end(tr("Worn"), this));
    row->addWidget(slider_, 1);
    row->addWidget(end(tr("Flat"), this));

    connect(slider_, &QSlider::valueChanged, &view_,
            [this](int value) { view_.setMorph(static_cast<double>(value) / kSteps); });
    connect(slider_, &QSlider::sliderPressed, animation_, &QVariantAnimation::stop);
    connect(button_, &QToolButton::clicked, this, &MorphBar::play);
    connect(animation_, &QVariantAnimation::valueChanged, slider_,
            [this](const QVariant& value) { slider_->setValue(value.toInt()); });
    connect(&document_, &Document::changed, this, [this](DocumentChanges what) {
        if (what.testFlag(DocumentChange::Opened)) {
            animation_->stop();
            slider_->setValue(0);
        }
        if (what & (DocumentChange::Results | DocumentChange::Garment)) {
            showOrHide();
        }
    });
    view_.installEventFilter(this);
    showOrHide();
}

void MorphBar::showOrHide() {
    const Scene* scene = document_.scene().get();
    const bool anyFlat =
        scene && std::ranges::any_of(scene->pieces,
                                     [](const PieceScene& piece) -> bool { return piece.flat; });
    if (!anyFlat) {
        animation_->stop();
        slider_->setValue(0);
    }
    setVisible(anyFlat);
    place();
}

void MorphBar::play() {
    if (isHidden()) {
        return;
    }
    if (animation_->state() == QAbstractAnimation::Running) {
        animation_->stop();
        return;
    }
    const int from = slider_->value(), to = from < kSteps / 2 ? kSteps : 0;
    animation_->setStartValue(from);
    animation_->setEndValue(to);
    animation_->setDuration(kMilliseconds * std::abs(to - from) / kSteps);
    animation_->start();
}

void MorphBar::place() {
    const int room = view_.width() - kLeft - kMargin;
    const int width = std::min(kWidth, room);
    const int height = sizeHint().height();
    // In the middle of the foot, unless the axis cross is in the way.
    const int left = std::max(kLeft, (view_.width() - width) / 2);
    setGeometry(left, view_.height() - height - kMargin, width, height);
}

bool MorphBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &view_ && event->type() == QEvent::Resize) {
        place();
    }
    return QWidget::eventFilter(watched, event);
}

void MorphBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(renderStyle(palette()).labelFill);
    painter.drawRoundedRect(rect(), 7, 7);
}

}  // namespace toile::app
