// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/garment_view.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "app/document/document.h"
#include "app/render/garment_renderer.h"
#include "app/render/picking.h"
#include "app/views/garment_text.h"
#include "app/views/sewn_run.h"

namespace toile::app {

namespace {

/// Depth tolerance of seams behind the cloth, as a multiple of the pick radius: cloth is bent.
constexpr double kHiddenBehind = 3;

/// Smallest distance of the eye from the cloth when zooming, as a part of the garment's extent.
constexpr double kNearestCloth = 4e-3;

/// Height of the second slider, from the design to sewn cloth, logical pixels.
constexpr double kSecondSlider = 38;

/// Free space below for the visible sliders. The same is left above, so that the garment's centre
/// of rotation stays in the middle.
double roomOfSliders(const Document& document) {
    const auto cloth = sewnOf(document);
    return Camera3D::kSliderRoom + (cloth && cloth->isMeasured ? kSecondSlider : 0);
}

/// Margin around a framed seam, as a part of its extent.
constexpr double kAirAroundSeam = 0.15;

}  // namespace

GarmentView::GarmentView(Document& document, ToolChoice& tools, QWidget* parent)
    : SceneView(document, tools, std::make_unique<GarmentRenderer>(), parent) {
    setObjectName("garmentView");
    setAccessibleName(tr("Garment"));
    camera_.setFreeEdges(Camera3D::kSliderRoom);
    connect(&document, &Document::opened, this, [this] {
        const Camera3D fresh;
        setDirection({fresh.yaw(), fresh.pitch()});
        if (camera_.isOrthographic()) {
            look(ViewKey::Orthographic);
        }
    });
}

void GarmentView::setCameraViewport(double width, double height) {
    camera_.setViewport(width, height);
}

void GarmentView::framePieces(const std::set<int>& pieces) {
    camera_.setFreeEdges(roomOfSliders(document_));
    frameGarment(camera_, *scene(), places(), seenOf(pieces, places()), morph_);
}

bool GarmentView::frameLines(const SeamScene& seam) {
    if (seam.box.isEmpty()) {
        return false;
    }
    // Include cloth around the seam to show which pieces meet there.
    const Eigen::Vector3d air =
        Eigen::Vector3d::Constant(kAirAroundSeam * seam.box.sizes().maxCoeff());
    if (morph_ > 0) {
        return false;  // the box is only valid for the garment
    }
    const Eigen::AlignedBox3d boxes[] = {{seam.box.min() - air, seam.box.max() + air}};
    camera_.setFreeEdges(roomOfSliders(document_));
    camera_.frame(boxes);
    return true;
}

bool GarmentView::isFacing(const WorstSpot& spot) const {
    constexpr double kSlanting = 0.2;  // cosine
    const Eigen::Vector3d toEye = camera_.eye() - spot.position;
    return spot.normal.dot(toEye) >= kSlanting * toEye.norm();
}

bool GarmentView::isHidden(const WorstSpot& spot) const {
    constexpr double kBefore = 1;  // mm
    const Eigen::Vector2d at = camera_.project(spot.position);
    const Ray ray = camera_.ray(at.x(), at.y());
    const auto hit = pickGarment(*scene(), ray, places());
    return hit && hit->distance < (spot.position - ray.origin).norm() - kBefore;
}

void GarmentView::frameSpot(const WorstSpot& spot, double radius) {
    if (morph_ > 0) {
        return;  // the cloth has moved away
    }
    const Eigen::Vector3d air = Eigen::Vector3d::Constant(radius);
    const Eigen::Vector3d place = spotPoint(spot, sewnWay());
    const Eigen::AlignedBox3d boxes[] = {{place - air, place + air}};
    camera_.setFreeEdges(roomOfSliders(document_));
    camera_.frame(boxes);
    if (spot.normal.isZero() || (isFacing(spot) && !isHidden(spot))) {
        return;
    }
    // Look from the right side; if other cloth hides the spot, from the wrong side.
    const Eigen::Vector3d sides[] = {spot.normal, -spot.normal, spot.normal};
    for (const Eigen::Vector3d& side : sides) {
        camera_.setDirection(std::atan2(side.x(), side.z()),
                             std::asin(std::clamp(side.y(), -1.0, 1.0)));
        camera_.frame(boxes);
        if (!isHidden(spot)) {
            return;
        }
    }
}

void GarmentView::turnCamera(const QPointF& delta) {
    camera_.orbit(delta.x(), delta.y());
}

void GarmentView::panCamera(const QPointF& delta) {
    camera_.pan(delta.x(), delta.y());
}

void GarmentView::zoomCamera(const QPointF& at, double factor) {
    const Ray ray = camera_.ray(at.x(), at.y());
    const auto hit = scene() && morph_ == 0 ? pickGarment(*scene(), ray, places()) : std::nullopt;
    if (hit && factor > 1 && !camera_.isOrthographic()) {
        // Nearer, the near plane would clip the cloth: see Camera3D::projection.
        const double nearest = kNearestCloth * scene()->box.diagonal().norm();
        factor = std::max(1.0, std::min(factor, hit->distance / nearest));
    }
    camera_.zoomAt(hit ? Eigen::Vector3d(ray.origin + hit->distance * ray.direction)
                       : camera_.pointAtTargetDepth(at.x(), at.y()),
                   factor);
}

Morph GarmentView::morphState() const {
    return morphBefore(camera_, scene(), morph_);
}

Eigen::Vector2d GarmentView::onStandingSheet(const QPointF& at) const {
    const Morph morph = morphState();
    const Ray ray = camera_.ray(at.x(), at.y());
    const Eigen::Vector3d normal = morph.sheetAxes.col(2);
    const double along = (morph.sheetCentre - ray.origin).dot(normal) / ray.direction.dot(normal);
    const Eigen::Vector3d off = ray.origin + along * ray.direction - morph.sheetCentre;
    return sheetBox(*scene(), places()).center() + morph.sheetAxes.leftCols<2>().transpose() * off;
}

std::optional<SurfaceHit> GarmentView::hitAt(const QPointF& at) const {
    if (!scene() || !answers()) {
        return std::nullopt;
    }
    return morph_ == 1 ? pickPattern(*scene(), places(), onStandingSheet(at))
                       : pickGarment(*scene(), camera_.ray(at.x(), at.y()), places());
}

std::optional<SeamHit> GarmentView::seamHitAt(const QPointF& at, double pixels,
                                              const SeamFilter& counts) const {
    if (!scene() || !answers()) {
        return std::nullopt;
    }
    if (morph_ == 1) {
        return pickPatternSeam(*scene(), places(), onStandingSheet(at),
                               pixels / camera_.pixelsPerMillimetre(), counts);
    }
    const Ray ray = camera_.ray(at.x(), at.y());
    // Without perspective, convert the radius in mm to a slope at the target's depth.
    const double radius = pixels / camera_.pixelsPerMillimetre();
    const double toTarget =
        (camera_.pointAtTargetDepth(at.x(), at.y()) - ray.origin).dot(ray.direction);
    const double slope = radius / toTarget;
    // Ignore seams hidden by the cloth under the pointer, but not those on it.
    const auto hit = pickGarment(*scene(), ray, places());
    const double farthest = !hit || document_.view().xray
                                ? std::numeric_limits<double>::infinity()
                                : hit->distance + kHiddenBehind * slope * hit->distance;
    return pickGarmentSeam(*scene(), ray, slope, farthest, counts, places());
}

const GarmentView::Motions& GarmentView::motions() const {
    const Morph now = morphState();
    if (!motions_ || motions_->scene != document_.scene() || motions_->places != places() ||
        motions_->morph != now) {
        motions_ = Motions{document_.scene(), places(), now, morphMotions(*scene(), places(), now)};
    }
    return *motions_;
}

template <class Flat>
Eigen::Vector3d GarmentView::asDrawn(int piece, const Eigen::Vector3d& worn,
                                     const Flat& flat) const {
    const auto at = static_cast<std::size_t>(piece);
    if (morph_ == 0 || !scene()->pieces[at].flat) {
        return worn;
    }
    const Motions& now = motions();
    return morphed(now.morph, now.ofPieces[at], worn, flat());
}

std::optional<QPointF> GarmentView::projected(const Eigen::Vector3d& point) const {
    if (!camera_.isBefore(point)) {
        return std::nullopt;
    }
    const Eigen::Vector2d at = camera_.project(point);
    return QPointF(at.x(), at.y());
}

std::optional<QPointF> GarmentView::onScreen(int piece, int face,
                                             const Eigen::Vector3d& barycentric) const {
    if (!scene()) {
        return std::nullopt;
    }
    return projected(asDrawn(
        piece, garmentPoint(*scene(), piece, face, barycentric),
        [&]() -> Eigen::Vector2d { return patternPoint(*scene(), piece, face, barycentric); }));
}

std::optional<ToolView::WornPlace> GarmentView::wornPlace(const Eigen::Vector3d& point) const {
    constexpr double kBefore = 3;  // mm: a line between points of bent cloth dips below its surface
    if (!scene() || morph_ > 0) {
        return std::nullopt;
    }
    const Eigen::Vector3d worn = point - scene()->origin;
    const auto at = projected(worn);
    if (!at) {
        return std::nullopt;
    }
    const Ray ray = camera_.ray(at->x(), at->y());
    const auto hit = pickGarment(*scene(), ray, places());
    return WornPlace{*at, hit && hit->distance < (worn - ray.origin).norm() - kBefore};
}

std::optional<QPointF> GarmentView::pointOnScreen(const LineVertex& vertex) const {
    return projected(asDrawn(static_cast<int>(vertex.piece), wornPoint(vertex),
                             [&vertex]() -> Eigen::Vector2d { return flatPoint(vertex); }));
}

void GarmentView::setMorph(double way) {
    way = std::clamp(way, 0.0, 1.0);
    if (way == morph_) {
        return;
    }
    morph_ = way;
    cameraMoved();
}

double GarmentView::sewnWay() const {
    const auto sewn = sewnOf(document_);
    return !sewn || morph_ > 0 ? 0 : sewn->isMeasured ? sewnWay_ : 1;
}

void GarmentView::setSewnWay(double way) {
    sewnWay_ = std::clamp(way, 0.0, 1.0);
    update();
}

void GarmentView::setDirection(const ViewDirection& direction) {
    camera_.setDirection(direction.yaw, direction.pitch);
    cameraMoved();
}

void GarmentView::look(ViewKey key) {
    constexpr double kStep = std::numbers::pi / 12;
    // In the order of ViewKey, which starts with these sides.
    static constexpr std::array kSides{kFrontView, kBackView, kRightView,
                                       kLeftView,  kTopView,  kBottomView};
    const double yaw = camera_.yaw(), pitch = camera_.pitch();
    switch (key) {
        case ViewKey::Opposite:
            return setDirection({yaw + std::numbers::pi, -pitch});
        case ViewKey::TurnLeft:
            return setDirection({yaw - kStep, pitch});
        case ViewKey::TurnRight:
            return setDirection({yaw + kStep, pitch});
        case ViewKey::TurnUp:
            return setDirection({yaw, pitch + kStep});
        case ViewKey::TurnDown:
            return setDirection({yaw, pitch - kStep});
        case ViewKey::Orthographic:
            camera_.setOrthographic(!camera_.isOrthographic());
            cameraMoved();
            emit orthographicChanged(camera_.isOrthographic());
            return;
        default:
            return setDirection(kSides.at(static_cast<std::size_t>(key)));
    }
}

void GarmentView::keyPressEvent(QKeyEvent* event) {
    if (const auto key = viewKey(event->key(), event->modifiers())) {
        look(*key);
        event->accept();
    } else {
        SceneView::keyPressEvent(event);
    }
}

bool GarmentView::event(QEvent* event) {
    // Otherwise a digit shortcut would take the key: shortcuts ignore where a key is.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (viewKey(key.key(), key.modifiers())) {
            event->accept();
            return true;
        }
    }
    return SceneView::event(event);
}

bool GarmentView::clickOnOverlay(const QPointF& at) {
    const auto key = axisCrossKeyAt(axisCrossPlace(rect()), camera_, at);
    if (key) {
        look(*key);
    }
    return key.has_value();
}

Eigen::Vector2d GarmentView::onSheet(const QPointF&) const {
    return Eigen::Vector2d::Zero();
}

void GarmentView::paintScene(const RenderStyle& style, int width, int height, double ratio) {
    static_cast<GarmentRenderer&>(renderer())
        .paint(camera_, document_.view(), style, width, height, ratio, morphState(), sewnWay());
}

std::optional<SpotPlace> GarmentView::placeNow(const WorstSpot& spot) const {
    return morph_ == 0 ? placeOfSpot(spot, camera_, sewnWay())
                       : std::nullopt;  // the cloth has moved during the morph
}

void GarmentView::paintText(QPainter& painter, const RenderStyle& style) {
    paintGarmentText(painter, style,
                     {document_, camera_, rect(), spots(), morph_, sewnWay(), covered()});
}

}  // namespace toile::app
