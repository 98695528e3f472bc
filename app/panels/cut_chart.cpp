// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/cut_chart.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/text/figures.h"

namespace toile::app {

namespace {

constexpr double kPoint = 3.6, kReach = 11;  // pixels
constexpr int kHeight = 130, kWidth = 300;
constexpr double kAir = 1.12;       // range of the axis, per highest strain
constexpr double kMinRange = 0.01;  // of strain

/// Grid step: 1, 2 or 5 times a power of ten, so that three or four fit into the range.
double stepFor(double range) {
    const double rough = range / 3;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double times : {1.0, 2.0, 5.0}) {
        if (times * power >= rough) {
            return times * power;
        }
    }
    return 10 * power;
}

QString strainText(double strain) {
    return CutChart::tr("%1 %").arg(QLocale().toString(100 * strain, 'g', 3));
}

}  // namespace

CutChart::CutChart(QWidget* parent) : QWidget(parent) {
    setObjectName("cutChart");
    setAccessibleName(tr("Strain by length of cuts"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize CutChart::sizeHint() const {
    return {kWidth, kHeight};
}

QSize CutChart::minimumSizeHint() const {
    return {kWidth / 2, kHeight};
}

void CutChart::show(std::vector<Step> steps, std::optional<double> enough) {
    steps_ = std::move(steps);
    enough_ = enough;
    hovered_.reset();
    update();
}

void CutChart::select(std::optional<std::size_t> step) {
    selected_ = step;
    setAccessibleDescription(step && *step < steps_.size() ? steps_[*step].tip : QString());
    update();
}

double CutChart::shownStrain(const Step& step) const {
    return step.solved ? *step.solved : step.predicted;
}

double CutChart::highest() const {
    double most = std::max(kMinRange, enough_.value_or(0));
    for (const Step& step : steps_) {
        most = std::max({most, step.predicted, step.solved.value_or(0)});
    }
    return kAir * most;
}

QRectF CutChart::field() const {
    const int left = fontMetrics().horizontalAdvance(strainText(0.125)) + 8;
    const int below = fontMetrics().height() + 9;
    return QRectF(rect()).adjusted(left, 8, -12, -below);
}

QPointF CutChart::at(double length, double strain) const {
    const QRectF within = field();
    const double all = steps_.empty() ? 0 : steps_.back().length;
    return {within.left() + (all > 0 ? length / all : 0) * within.width(),
            within.bottom() - strain / highest() * within.height()};
}

QPointF CutChart::placeOf(std::size_t step) const {
    return at(steps_[step].length, shownStrain(steps_[step]));
}

std::optional<std::size_t> CutChart::stepAt(const QPointF& place) const {
    std::optional<std::size_t> nearest;
    double least = kReach;
    for (std::size_t k = 1; k < steps_.size(); ++k) {
        const double distance = QLineF(placeOf(k), place).length();
        if (distance < least) {
            least = distance;
            nearest = k;
        }
    }
    return nearest;
}

void CutChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF within = field();
    const QPalette& colours = palette();
    const QColor text = colours.color(QPalette::WindowText);
    QColor faint = text, grid = text;
    faint.setAlpha(150);
    grid.setAlpha(35);
    const double top = highest(), step = stepFor(top);
    for (int k = 0; k * step <= top; ++k) {
        const double strain = k * step;
        const double y = at(0, strain).y();
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(within.left(), y), QPointF(within.right(), y));
        painter.setPen(faint);
        const double half = fontMetrics().height() / 2.0;
        painter.drawText(QRectF(0, y - half, within.left() - 5, 2 * half),
                         Qt::AlignRight | Qt::AlignVCenter, strainText(strain));
    }
    const double all = steps_.empty() ? 0 : steps_.back().length;
    const QRectF below(within.left(), within.bottom() + 7, within.width() + 10,
                       fontMetrics().height());
    painter.setPen(faint);
    painter.drawText(below, Qt::AlignLeft, tr("no cuts"));
    painter.drawText(below, Qt::AlignRight, tr("all: %1").arg(saidLength(all)));
    const QColor accent = colours.color(QPalette::Highlight);
    if (enough_) {
        const double y = at(0, *enough_).y();
        painter.setPen(QPen(accent, 1.2, Qt::DashLine));
        painter.drawLine(QPointF(within.left(), y), QPointF(within.right(), y));
        painter.setPen(faint);
        painter.drawText(QRectF(within.left(), y - fontMetrics().height() - 1, within.width(),
                                fontMetrics().height()),
                         Qt::AlignRight, tr("limit"));
    }
    for (std::size_t k = 1; k < steps_.size(); ++k) {
        const Step &from = steps_[k - 1], &to = steps_[k];
        painter.setPen(QPen(to.isStale ? grid : faint, 1.5));
        painter.drawLine(at(from.length, from.predicted), at(to.length, to.predicted));
    }
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        const Step& one = steps_[k];
        const bool isMarked = k > 0 && (selected_ == k || hovered_ == k);
        painter.setPen(QPen(one.isStale ? grid : faint, 1.5));
        painter.setBrush(colours.color(QPalette::Window));
        painter.drawEllipse(at(one.length, one.predicted), kPoint, kPoint);
        if (one.solved) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(text);
            painter.drawEllipse(at(one.length, *one.solved), kPoint, kPoint);
        }
        if (isMarked) {
            painter.setPen(QPen(accent, 2));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(placeOf(k), kPoint + 3, kPoint + 3);
        }
    }
    if (hasFocus()) {
        painter.setPen(QPen(accent, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    }
}

bool CutChart::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto step = stepAt(help->pos());
        QToolTip::showText(
            help->globalPos(),
            step ? steps_[*step].tip
                 : tr("Mean strain by length of cuts. Line: predicted; filled points: flattened"),
            this);
        return true;
    }
    return QWidget::event(event);
}

void CutChart::mousePressEvent(QMouseEvent* event) {
    if (const auto step = stepAt(event->position())) {
        emit selected(*step);
    }
}

void CutChart::mouseMoveEvent(QMouseEvent* event) {
    const auto now = stepAt(event->position());
    if (std::exchange(hovered_, now) != now) {
        update();
    }
}

void CutChart::leaveEvent(QEvent* event) {
    hovered_.reset();
    update();
    QWidget::leaveEvent(event);
}

void CutChart::keyPressEvent(QKeyEvent* event) {
    const bool isBack = event->key() == Qt::Key_Left, isOn = event->key() == Qt::Key_Right;
    if (!(isBack || isOn) || steps_.size() < 2) {
        QWidget::keyPressEvent(event);
        return;
    }
    const std::size_t last = steps_.size() - 1;
    const std::size_t now = selected_.value_or(isOn ? 0 : last + 1);
    emit selected(std::clamp<std::size_t>(isOn ? now + 1 : now - 1, 1, last));
}

}  // namespace toile::app
