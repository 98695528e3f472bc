// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/garment_view.h"

#include <QPainter>

#include "app/document/document.h"
#include "app/render/garment_renderer.h"
#include "app/render/picking.h"
#include "app/views/view_text.h"

namespace toile {

namespace {

/// Room left around a framed seam, as a part of its extent.
constexpr double kAirAroundSeam = 0.15;

}  // namespace

GarmentView::GarmentView(Document& document, QWidget* parent)
    : SceneView(document, std::make_unique<GarmentRenderer>(), parent) {
    setObjectName("garmentView");
}

void GarmentView::setCameraViewport(double width, double height) {
    camera_.setViewport(width, height);
}

void GarmentView::framePieces(const std::set<int>& pieces) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const int piece : pieces) {
        boxes.push_back(scene()->pieces[static_cast<std::size_t>(piece)].box);
    }
    camera_.frame(boxes);
}

bool GarmentView::frameLines(const SeamScene& seam) {
    if (seam.box.isEmpty()) {
        return false;
    }
    // With the cloth around it, that one sees what is sewn to what.
    const Eigen::Vector3d air =
        Eigen::Vector3d::Constant(kAirAroundSeam * seam.box.sizes().maxCoeff());
    const Eigen::AlignedBox3d boxes[] = {{seam.box.min() - air, seam.box.max() + air}};
    camera_.frame(boxes);
    return true;
}

void GarmentView::drag(Drag kind, const QPointF& delta) {
    if (kind == Drag::Turn) {
        camera_.orbit(delta.x(), delta.y());
    } else {
        camera_.pan(delta.x(), delta.y());
    }
}

void GarmentView::zoom(const QPointF& at, double factor) {
    const Ray ray = camera_.ray(at.x(), at.y());
    const auto hit = scene() ? pickGarment(*scene(), ray) : std::nullopt;
    camera_.zoomAt(hit ? Eigen::Vector3d(ray.origin + hit->distance * ray.direction)
                       : camera_.pointAtTargetDepth(at.x(), at.y()),
                   factor);
}

std::optional<int> GarmentView::pieceAt(const QPointF& at) const {
    if (!scene()) {
        return std::nullopt;
    }
    const auto hit = pickGarment(*scene(), camera_.ray(at.x(), at.y()));
    return hit ? std::optional(hit->piece) : std::nullopt;
}

void GarmentView::paintScene(const RenderStyle& style, int width, int height, double ratio) {
    static_cast<GarmentRenderer&>(renderer())
        .paint(camera_, document_.view(), style, width, height, ratio);
}

void GarmentView::paintText(QPainter& painter, const RenderStyle& style) {
    QString note;
    if (const auto seam = document_.seam()) {
        note = tr("seam %1: %2")
                   .arg(*seam + 1)
                   .arg(QString::fromStdString(
                       document_.garment()->seams.seams[static_cast<std::size_t>(*seam)].name));
    }
    paintCaption(painter, style, tr("Garment"), note);
}

}  // namespace toile
