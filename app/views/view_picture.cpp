// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_picture.h"

#include <QCoreApplication>
#include <QPainter>

#include "app/document/document.h"
#include "app/render/garment_renderer.h"
#include "app/render/offscreen.h"
#include "app/render/overlay_figures.h"
#include "app/render/pattern_renderer.h"
#include "app/render/scene.h"
#include "app/views/colour_legend.h"
#include "app/views/garment_text.h"
#include "app/views/pattern_text.h"
#include "app/views/ruler.h"
#include "app/views/sewn_run.h"

namespace toile::app {

namespace {

/// Translation context.
class PictureWords {
    Q_DECLARE_TR_FUNCTIONS(ViewPicture)
};

/// Draws the views of a document one after another.
class PicturePainter {
public:
    PicturePainter(const Document& document, const PictureOptions& options)
        : document_(document),
          options_(options),
          style_(renderStyle(options.palette)),
          places_(placesOf(document.settings(), document.colours(), document.state().materials)),
          figures_(
              overlayFigures({document.scene(), places_, document.fabric(), document.view().overlay,
                              isOfProof(document.view().overlay) ? sewnOf(document) : nullptr})),
          spots_{figures_.spots, figures_.overlay} {}

    QImage draw();
    const QString& problem() const { return problem_; }

private:
    void drawGarment(QPainter& picture, const QRect& part);
    void drawPattern(QPainter& picture, const QRect& part);
    /// @param paint  draws the scene with the renderer, into a bound framebuffer
    template <class Renderer, class Paint>
    void drawScene(QPainter& picture, const QRect& part, const Paint& paint);
    /// Sets up painting of the text over a view.
    void beginText(QPainter& picture, const QRect& part) const;

    const Document& document_;
    const PictureOptions& options_;
    RenderStyle style_;
    SheetPlaces places_;
    OverlayFigures figures_;
    FlaggedSpots spots_;
    QString problem_;
};

template <class Renderer, class Paint>
void PicturePainter::drawScene(QPainter& picture, const QRect& part, const Paint& paint) {
    Renderer renderer;
    if (problem_ = renderer.initialize(); !problem_.isEmpty()) {
        return;
    }
    renderer.show(contentOf(document_));
    QImage image;
    Framebuffer framebuffer;
    if (framebuffer.make(part.width(), part.height())) {
        paint(renderer);
        image = framebuffer.read();
    }
    renderer.release();
    if (image.isNull()) {
        problem_ = PictureWords::tr(
                       "the graphics driver cannot draw %1 x %2 pixels; choose a smaller size")
                       .arg(part.width())
                       .arg(part.height());
        return;
    }
    picture.drawImage(part.topLeft(), image);
}

void PicturePainter::beginText(QPainter& picture, const QRect& part) const {
    picture.save();
    picture.setClipRect(part);
    picture.translate(part.topLeft());
    picture.setFont(options_.font);
    picture.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
}

void PicturePainter::drawGarment(QPainter& picture, const QRect& part) {
    Camera3D camera;
    camera.setViewport(part.width(), part.height());
    if (!options_.plain) {
        camera.setFreeEdges(Camera3D::kSliderRoom);
    }
    if (options_.direction) {
        camera.setDirection(options_.direction->yaw, options_.direction->pitch);
    }
    if (document_.pieceCount() > 0) {
        frameGarment(camera, *document_.scene(), places_, seenOf(document_.everyPiece(), places_),
                     options_.morph);
    }
    const Morph morph = morphBefore(camera, document_.scene().get(), options_.morph);
    drawScene<GarmentRenderer>(picture, part, [&](GarmentRenderer& renderer) {
        renderer.paint(camera, document_.view(), style_, part.width(), part.height(), 1, morph,
                       options_.sewn);
    });
    if (options_.plain) {
        return;
    }
    beginText(picture, part);
    paintGarmentText(picture, style_,
                     {document_, camera, QRect(QPoint(), part.size()), spots_, options_.morph,
                      sewnOf(document_) ? options_.sewn : 0});
    picture.restore();
}

void PicturePainter::drawPattern(QPainter& picture, const QRect& part) {
    Camera2D camera;
    camera.setViewport(part.width(), part.height());
    if (document_.pieceCount() > 0) {
        framePattern(camera, *document_.scene(), places_, seenOf(document_.everyPiece(), places_),
                     document_.view().rulers);
    }
    drawScene<PatternRenderer>(picture, part, [&](PatternRenderer& renderer) {
        renderer.paint(camera, document_.view(), style_, part.width(), part.height(), 1);
    });
    beginText(picture, part);
    ReferenceGaps gaps;
    gaps.follow(document_);
    KeptNames names;
    paintPatternText(
        picture, style_,
        {document_, places_, camera, QRect(QPoint(), part.size()), spots_, gaps, names});
    picture.restore();
}

QImage PicturePainter::draw() {
    QImage picture(options_.size, QImage::Format_RGB32);
    if (picture.isNull() || !document_.scene()) {
        problem_ = PictureWords::tr("there is not enough memory for a picture of this size");
        return {};
    }
    picture.fill(options_.palette.color(QPalette::Window));
    QPainter painter(&picture);
    QRect views(QPoint(), options_.size);
    if (const int height = options_.legend ? legendHeight(options_.font) : 0;
        height > 0 && height < views.height() / 2) {
        views.setHeight(views.height() - height);
        painter.translate(0, views.height());
        paintLegend(painter, legendOf(figures_), QSize(views.width(), height), options_.font,
                    options_.palette);
        painter.resetTransform();
    }
    const bool both = options_.views == ViewsShown::Both;
    QRect left = views, right = views;
    if (both) {
        left.setWidth(views.width() / 2);
        right.setLeft(left.right() + 1);
    }
    if (options_.views != ViewsShown::Pattern) {
        drawGarment(painter, left);
    }
    if (options_.views != ViewsShown::Garment && problem_.isEmpty()) {
        drawPattern(painter, right);
    }
    painter.end();
    return problem_.isEmpty() ? picture : QImage();
}

}  // namespace

QImage drawViews(const Document& document, const PictureOptions& options, QString& problem) {
    PicturePainter painter(document, options);
    QImage picture = painter.draw();
    problem = painter.problem();
    return picture;
}

}  // namespace toile::app
