// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/garment_text.h"

#include <QCoreApplication>
#include <QPainter>

#include "app/document/document.h"
#include "app/render/picking.h"
#include "app/render/scene.h"
#include "app/views/axis_cross.h"
#include "app/views/feature_text.h"
#include "app/views/flags.h"
#include "app/views/view_text.h"

namespace toile {

namespace {

/// The context of the translations.
class GarmentWords {
    Q_DECLARE_TR_FUNCTIONS(GarmentView)
};

QString noteOf(const Document& document) {
    if (QString marked = markedText(document); !marked.isEmpty()) {
        return marked;
    }
    const auto seam = document.seam();
    return seam ? GarmentWords::tr("seam %1: %2")
                      .arg(*seam + 1)
                      .arg(QString::fromStdString(
                          document.garment()->seams.seams[static_cast<std::size_t>(*seam)].name))
                : QString();
}

/// Whether any cloth lies under a part of the view; on its way to the pattern it may.
bool isOnCloth(const GarmentText& text, const QRectF& part) {
    const Scene* scene = text.document.scene().get();
    return scene && (text.way > 0 || anyPointIn(part, [&](double x, double y) -> bool {
                         return pickGarment(*scene, text.camera.ray(x, y)).has_value();
                     }));
}

}  // namespace

void paintGarmentText(QPainter& painter, const RenderStyle& style, const GarmentText& text) {
    const QString title = GarmentWords::tr("Garment"), note = noteOf(text.document);
    const QRectF caption = captionPlate(painter.font(), {}, title, note);
    if (text.way == 0) {
        FlagRoom room{QRectF(text.view), text.covered};
        room.taken.push_back(caption);
        paintSpotFlags(painter, style, room, text.document, text.spots,
                       [&text](const WorstSpot& spot) { return placeOfSpot(spot, text.camera); });
    }
    paintCaption(painter, style, {}, title, note, isOnCloth(text, caption));
    paintAxisCross(painter, style, axisCrossPlace(text.view), text.camera);
}

}  // namespace toile
