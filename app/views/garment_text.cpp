// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/garment_text.h"

#include <QCoreApplication>
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <array>

#include "app/document/document.h"
#include "app/render/picking.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/views/callouts.h"
#include "app/views/feature_text.h"
#include "app/views/view_text.h"

namespace toile::app {

namespace {

constexpr double kArm = 24, kBall = 7.5, kSmallBall = 4.5, kCrossMargin = 14;

struct End {
    ViewKey key;
    int axis;
    bool positive;
    QPointF offset{};  ///< from the middle, pixels
    double depth = 0;  ///< towards the eye, -1 to 1
};

/// From back to front, the painting order.
std::array<End, 6> endsOf(const Camera3D& camera) {
    std::array<End, 6> ends = {{{ViewKey::Right, 0, true},
                                {ViewKey::Left, 0, false},
                                {ViewKey::Top, 1, true},
                                {ViewKey::Bottom, 1, false},
                                {ViewKey::Front, 2, true},
                                {ViewKey::Back, 2, false}}};
    const Eigen::Matrix3d axes = camera.axes();
    for (End& end : ends) {
        const double sign = end.positive ? 1 : -1;
        end.offset = sign * kArm * QPointF(axes(end.axis, 0), -axes(end.axis, 1));
        end.depth = sign * axes(end.axis, 2);
    }
    std::ranges::stable_sort(ends, {}, &End::depth);
    return ends;
}

QColor axisColour(int axis) {
    constexpr std::array<QRgb, 3> kColours = {qRgb(214, 66, 60), qRgb(78, 152, 44),
                                              qRgb(52, 112, 214)};
    return QColor(kColours[static_cast<std::size_t>(axis)]);
}

/// Translation context.
class GarmentWords {
    Q_DECLARE_TR_FUNCTIONS(GarmentView)
};

QString noteOf(const Document& document) {
    if (QString marked = markedText(document); !marked.isEmpty()) {
        return marked;
    }
    const auto seam = document.seam();
    return seam ? GarmentWords::tr("seam %1: %2").arg(*seam + 1).arg(seamName(document, *seam))
                : QString();
}

/// Whether any cloth lies under a part of the view. Assumes so during the morph to the pattern.
bool isOnCloth(const GarmentText& text, const QRectF& part) {
    const Scene* scene = text.document.scene().get();
    return scene && (text.way > 0 || anyPointIn(part, [&](double x, double y) -> bool {
                         return pickGarment(*scene, text.camera.ray(x, y)).has_value();
                     }));
}

}  // namespace

QPointF axisCrossPlace(const QRect& view) {
    const double radius = kArm + kBall;
    return {kCrossMargin + radius, view.height() - kCrossMargin - radius};
}

void paintAxisCross(QPainter& painter, const RenderStyle& style, const QPointF& middle,
                    const Camera3D& camera) {
    constexpr std::array<const char*, 3> kLetters = {"X", "Y", "Z"};
    painter.save();
    QFont font = painter.font();
    font.setPixelSize(10);
    font.setBold(true);
    painter.setFont(font);
    for (const End& end : endsOf(camera)) {
        const QColor colour = axisColour(end.axis);
        const QPointF at = middle + end.offset;
        if (end.positive) {
            painter.setPen(QPen(colour, 2));
            painter.drawLine(middle, at);
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            painter.drawEllipse(at, kBall, kBall);
            painter.setPen(Qt::white);
            const QRectF ball(at - QPointF(kBall, kBall), QSizeF(2 * kBall, 2 * kBall));
            painter.drawText(ball, Qt::AlignCenter, kLetters[static_cast<std::size_t>(end.axis)]);
        } else {
            painter.setPen(QPen(colour, 1.5));
            painter.setBrush(style.labelFill);
            painter.drawEllipse(at, kSmallBall, kSmallBall);
        }
    }
    painter.restore();
}

std::optional<ViewKey> axisCrossKeyAt(const QPointF& middle, const Camera3D& camera,
                                      const QPointF& at) {
    std::optional<ViewKey> key;
    for (const End& end : endsOf(camera)) {
        if (QLineF(middle + end.offset, at).length() <= (end.positive ? kBall : kSmallBall) + 1) {
            key = end.key;  // the last match is in front
        }
    }
    return key;
}

void paintGarmentText(QPainter& painter, const RenderStyle& style, const GarmentText& text) {
    const QString title = GarmentWords::tr("Garment"), note = noteOf(text.document);
    const QRectF caption = captionBox(painter.font(), {}, title, note);
    if (text.way == 0) {
        CalloutRoom room{QRectF(text.view), text.covered};
        room.taken.push_back(caption);
        paintSpotCallouts(painter, style, room, text.document, text.spots,
                          [&text](const WorstSpot& spot) {
                              return placeOfSpot(spot, text.camera, text.sewnWay);
                          });
    }
    paintCaption(painter, style, {}, title, note, isOnCloth(text, caption));
    paintAxisCross(painter, style, axisCrossPlace(text.view), text.camera);
}

}  // namespace toile::app
