// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/piece_places.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/document/document.h"
#include "app/document/names.h"
#include "app/render/render_style.h"
#include "app/text/error_text.h"
#include "app/views/tool.h"
#include "core/project/left_out.h"

namespace toile::app {
namespace {

constexpr double kPlaceGap = 40;                      ///< mm, between places and what is flat
constexpr double kPlaceAir = 6, kButtonPadding = 20;  ///< logical pixels

/// Why the piece cannot lie flat; none where it does, or has not been tried yet.
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

/// Side of a square as large as the piece, mm; at least 1, also of what has no finite area.
double sideOf(const Piece& piece) {
    const double side = std::sqrt(wornArea(piece));
    return std::isfinite(side) ? std::max(1.0, side) : 1;
}

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
    // In columns as high as what is flat, or as the largest of them.
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

}  // namespace toile::app
