// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pattern_view.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/render/pattern_renderer.h"
#include "app/render/picking.h"
#include "app/settings/length_display.h"
#include "app/views/pattern_text.h"
#include "app/views/rolled_piece.h"
#include "app/views/ruler.h"
#include "app/views/tool.h"

namespace toile::app {

namespace {

/// Room for the bar at the foot, logical pixels.
constexpr double kWalkBar = 72;

}  // namespace

PatternView::PatternView(Document& document, ToolChoice& tools, QWidget* parent)
    : SceneView(document, tools, std::make_unique<PatternRenderer>(), parent) {
    setObjectName("patternView");
    setAccessibleName(tr("Pattern"));
    connect(&document, &Document::changed, this, [this](DocumentChanges what) {
        if (what & (DocumentChange::Opened | DocumentChange::Garment | DocumentChange::Results |
                    DocumentChange::Settings)) {
            follow();
        }
    });
    follow();
}

void PatternView::follow() {
    others_.follow(document_, places());
    old_.follow(document_, places());
    update();
}

void PatternView::setHelp(std::map<int, QString> buttons) {
    others_.setButtons(std::move(buttons));
    update();
}

void PatternView::setCameraViewport(double width, double height) {
    camera_.setViewport(width, height);
}

void PatternView::framePieces(const std::set<int>& pieces) {
    const std::set<int> seen = seenOf(pieces, places());
    Eigen::AlignedBox2d others;
    for (const int piece : seen) {
        others.extend(others_.boxOf(piece));
    }
    framePattern(camera_, *scene(), places(), seen, document_.view().rulers, others);
}

bool PatternView::frameLines(const SeamScene& seam) {
    const Eigen::AlignedBox2d box = placedBox(seam, places());
    if (box.isEmpty()) {
        return false;
    }
    camera_.frame(box, patternMargins(document_.view().rulers));
    return true;
}

void PatternView::frameSpot(const WorstSpot& spot, double radius) {
    const Eigen::Vector2d at = placeOf(places(), spot.piece).placement.applied(spot.flat);
    const Eigen::Vector2d air = Eigen::Vector2d::Constant(radius);
    camera_.frame({at - air, at + air}, patternMargins(document_.view().rulers));
}

void PatternView::setRolled(std::shared_ptr<const RolledPiece> rolled) {
    rolled_ = std::move(rolled);
    update();
}

void PatternView::frameRolled() {
    Camera2D::Margins margins = patternMargins(document_.view().rulers);
    margins.bottom += kWalkBar;
    setCameraViewport(width(), height());
    camera_.frame(rolled_->wayOnSheet(places()), margins);
    stopFollowing();
}

void PatternView::drag(Drag, const QPointF& delta) {
    camera_.pan(delta.x(), delta.y());
}

void PatternView::zoom(const QPointF& at, double factor) {
    camera_.zoomAt(at.x(), at.y(), factor);
}

std::optional<SurfaceHit> PatternView::hitAt(const QPointF& at) const {
    return scene() ? pickPattern(*scene(), places(), camera_.toWorld(at.x(), at.y()))
                   : std::nullopt;
}

std::optional<SeamHit> PatternView::seamHitAt(const QPointF& at, double pixels,
                                              const SeamFilter& counts) const {
    return scene() ? pickPatternSeam(*scene(), places(), onSheet(at),
                                     pixels / camera_.pixelsPerMillimetre(), counts)
                   : std::nullopt;
}

std::optional<QPointF> PatternView::onScreen(int piece, int face,
                                             const Eigen::Vector3d& barycentric) const {
    if (!scene() || !scene()->pieces[static_cast<std::size_t>(piece)].flat) {
        return std::nullopt;
    }
    return placed(piece, patternPoint(*scene(), piece, face, barycentric));
}

std::optional<QPointF> PatternView::pointOnScreen(const LineVertex& vertex) const {
    return placed(static_cast<int>(vertex.piece), flatPoint(vertex));
}

QPointF PatternView::placed(int piece, const Eigen::Vector2d& point) const {
    const Eigen::Vector2d at = camera_.toScreen(placeOf(places(), piece).placement.applied(point));
    return {at.x(), at.y()};
}

Eigen::Vector2d PatternView::onSheet(const QPointF& at) const {
    return camera_.toWorld(at.x(), at.y());
}

void PatternView::paintScene(const RenderStyle& style, int width, int height, double ratio) {
    auto& pattern = static_cast<PatternRenderer&>(renderer());
    pattern.setGridUnit(LengthDisplay::instance().format().unit);
    pattern.paint(camera_, document_.view(), style, width, height, ratio);
}

std::optional<SpotPlace> PatternView::placeNow(const WorstSpot& spot) const {
    return placeOfSpot(spot, camera_, places());
}

void PatternView::paintText(QPainter& painter, const RenderStyle& style) {
    const bool grain = tools().current().id() == ToolId::Grain;
    const SheetMap onScreen(camera_);
    old_.paint(painter, style, onScreen, document_);
    others_.paint(painter, style, onScreen, document_);
    gaps_.follow(document_);
    const bool isElse = !others_.isEmpty() || old_.isAny(document_);
    paintPatternText(
        painter, style,
        {document_, places(), camera_, rect(), spots(), gaps_, names_, covered(), grain, isElse});
    if (rolled_) {
        rolled_->paint(painter, style, camera_, places());
    }
}

bool PatternView::clickOnOverlay(const QPointF& at) {
    const auto hit = others_.hitAt(at, SheetMap(camera_), font());
    if (hit) {
        document_.setSelection({hit->piece});
        if (hit->onButton) {
            emit helpWanted(hit->piece);
        }
    }
    return hit.has_value();
}

}  // namespace toile::app
