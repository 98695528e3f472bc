// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pattern_view.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/document/document.h"
#include "app/render/pattern_renderer.h"
#include "app/render/picking.h"
#include "app/render/render_style.h"
#include "app/settings/length_display.h"
#include "app/text/error_text.h"
#include "app/views/pattern_text.h"
#include "app/views/rolled_piece.h"
#include "app/views/ruler.h"
#include "app/views/tool.h"
#include "core/project/piece_settings.h"

namespace toile::app {
namespace {

constexpr double kPlaceGap = 40;                      ///< mm, beside the flat pieces
constexpr double kPlaceAir = 6, kButtonPadding = 20;  ///< logical pixels

/// Why the piece is not flat; null if it is, or was not tried yet.
const Error* troubleOf(const Document& document, int piece) {
    const PieceResult* result = document.result(piece);
    if (result && result->flat) {
        return nullptr;
    }
    if (result && result->error) {
        const ErrorCode code = result->error->code;
        return code == ErrorCode::Cancelled || code == ErrorCode::LeftOut ? nullptr
                                                                          : &*result->error;
    }
    const auto& defect = document.garment()->pieces[static_cast<std::size_t>(piece)]->defect;
    return defect ? &*defect : nullptr;
}

/// Side of a square with the piece's area, mm; at least 1, even if the area is not finite.
double sideOf(const Piece& piece) {
    const double side = std::sqrt(wornArea(piece));
    return std::isfinite(side) ? std::max(1.0, side) : 1;
}

/// Translation context.
class OutlineWords {
    Q_DECLARE_TR_FUNCTIONS(OldOutlines)
};

/// Space for the walk bar at the bottom, logical pixels.
constexpr double kWalkBar = 72;

}  // namespace

void PiecePlaces::follow(const Document& document, const SheetPlaces& sheet) {
    const bool isSame = document.garment() == garment_ && document.results() == results_;
    if (!isSame) {
        garment_ = document.garment();
        results_ = document.results();
        all_.clear();
        for (int piece = 0; piece < document.pieceCount() && !results_.empty(); ++piece) {
            if (const Error* trouble = troubleOf(document, piece)) {
                const Piece& of = *garment_->pieces[static_cast<std::size_t>(piece)];
                all_.push_back({piece, sideOf(of), {}, troubleText(*trouble, of)});
            }
        }
    }
    places_.clear();
    for (const Place& place : all_) {
        if (!placeOf(sheet, place.piece).hidden) {
            places_.push_back(place);
            places_.back().name = pieceName(document, place.piece);
        }
    }
    if (places_.empty() || !document.scene()) {
        return;
    }
    // Fill columns of the height of the flat pieces, or of the largest frame.
    Eigen::AlignedBox2d flat = sheetBox(*document.scene(), sheet);
    Eigen::Vector2d corner(0, 0);
    double height = 0;
    for (const Place& place : places_) {
        height = std::max(height, place.side);
    }
    if (!flat.isEmpty()) {
        corner = {flat.max().x() + kPlaceGap, flat.max().y()};
        height = std::max(height, flat.sizes().y());
    }
    double used = 0, widest = 0;
    for (Place& place : places_) {
        if (used > 0 && used + place.side > height) {
            corner.x() += widest + kPlaceGap;
            used = widest = 0;
        }
        const Eigen::Vector2d low(corner.x(), corner.y() - used - place.side);
        place.box = {low, low + Eigen::Vector2d::Constant(place.side)};
        used += place.side + kPlaceGap;
        widest = std::max(widest, place.side);
    }
}

Eigen::AlignedBox2d PiecePlaces::boxOf(int piece) const {
    const auto found = std::ranges::find(places_, piece, &Place::piece);
    return found == places_.end() ? Eigen::AlignedBox2d() : found->box;
}

std::optional<QRectF> PiecePlaces::buttonOf(const Place& place, const QRectF& box,
                                            const QFont& font) const {
    const auto found = buttons_.find(place.piece);
    if (found == buttons_.end()) {
        return std::nullopt;
    }
    const QFontMetricsF metrics(font);
    QRectF button(0, 0, metrics.horizontalAdvance(found->second) + kButtonPadding,
                  metrics.height() + kPlaceAir);
    button.moveCenter(box.center());
    button.moveTop(box.center().y() + metrics.height() + kPlaceAir);
    const bool fits = button.width() <= box.width() && button.bottom() <= box.bottom();
    return fits ? std::optional(button) : std::nullopt;
}

void PiecePlaces::paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                        const Document& document) const {
    const QFontMetricsF metrics(painter.font());
    for (const Place& place : places_) {
        const QRectF box = onScreen(place.box);
        const bool isSelected = document.isSelected(place.piece);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(
            QPen(isSelected ? style.selection : style.faintText, isSelected ? 2 : 1, Qt::DashLine));
        painter.drawRect(box);
        if (box.width() < metrics.averageCharWidth() * 6 || box.height() < metrics.height()) {
            continue;
        }
        const QRectF inner = box.adjusted(kPlaceAir, kPlaceAir, -kPlaceAir, -kPlaceAir);
        const auto line = [&](const QString& text, double above, const QColor& colour) {
            painter.setPen(colour);
            QRectF row(inner.left(), box.center().y() - above, inner.width(), metrics.height());
            painter.drawText(row, Qt::AlignCenter,
                             metrics.elidedText(text, Qt::ElideRight, inner.width()));
        };
        line(place.name, metrics.height(), isSelected ? style.selection : style.text);
        if (box.height() > 3 * metrics.height()) {
            line(place.words, 0, style.faintText);
        }
        if (const auto button = buttonOf(place, box, painter.font())) {
            painter.setPen(QPen(style.text, 1));
            painter.setBrush(style.labelFill);
            painter.drawRoundedRect(*button, 4, 4);
            painter.drawText(*button, Qt::AlignCenter, buttons_.at(place.piece));
        }
    }
}

std::optional<PiecePlaces::Hit> PiecePlaces::hitAt(const QPointF& at, const SheetMap& onScreen,
                                                   const QFont& font) const {
    for (const Place& place : places_) {
        const QRectF box = onScreen(place.box);
        if (box.contains(at)) {
            const auto button = buttonOf(place, box, font);
            return Hit{place.piece, button && button->contains(at)};
        }
    }
    return std::nullopt;
}

void OldOutlines::follow(const Document& document, const SheetPlaces& sheet) {
    if (!document.garment()) {
        outlines_.clear();
        return;
    }
    if (!document.isFlattened()) {
        return;
    }
    outlines_.clear();
    for (int i = 0; i < document.pieceCount(); ++i) {
        const PieceResult* result = document.result(i);
        if (!result || !result->flat || placeOf(sheet, i).hidden) {
            continue;
        }
        const Placement& placement = placeOf(sheet, i).placement;
        Points2 points = result->flat->Q(result->piece->boundary, Eigen::all);
        for (Eigen::Index k = 0; k < points.rows(); ++k) {
            points.row(k) = placement.applied(points.row(k).transpose()).transpose();
        }
        outlines_.push_back({result->piece, std::move(points)});
    }
}

std::vector<const OldOutlines::Outline*> OldOutlines::shown(const Document& document) const {
    std::vector<const Outline*> old;
    if (document.garment() && !document.isFlattened()) {
        for (const Outline& outline : outlines_) {
            if (std::ranges::find(document.garment()->pieces, outline.piece) ==
                document.garment()->pieces.end()) {
                old.push_back(&outline);
            }
        }
    }
    return old;
}

bool OldOutlines::isAny(const Document& document) const {
    return !shown(document).empty();
}

void OldOutlines::paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                        const Document& document) const {
    for (const Outline* outline : shown(document)) {
        QPolygonF line;
        for (Eigen::Index k = 0; k < outline->points.rows(); ++k) {
            line << onScreen(Eigen::Vector2d(outline->points.row(k).transpose()));
        }
        QColor pale = style.faintText;
        pale.setAlphaF(0.5F);
        painter.setPen(QPen(pale, 1));
        pale.setAlphaF(0.08F);
        painter.setBrush(pale);
        painter.drawPolygon(line);
        painter.setPen(style.faintText);
        painter.drawText(
            line.boundingRect(), Qt::AlignCenter,
            OutlineWords::tr("%1\nout of date")
                .arg(QString::fromStdString(nameOf(document.state().labels, *outline->piece))));
    }
}

PatternView::PatternView(Document& document, ToolChoice& tools, QWidget* parent)
    : SceneView(document, tools, std::make_unique<PatternRenderer>(), parent) {
    setObjectName("patternView");
    setAccessibleName(tr("Pattern"));
    connect(&document, &Document::changed, this, [this](const DocumentChange& what) {
        if (what.touchesContent()) {
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

void PatternView::panCamera(const QPointF& delta) {
    camera_.pan(delta.x(), delta.y());
}

void PatternView::zoomCamera(const QPointF& at, double factor) {
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
