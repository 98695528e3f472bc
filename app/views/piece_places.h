// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "app/render/scene.h"
#include "core/garment/garment.h"

class QPainter;

namespace toile::app {

class Document;
class SheetMap;
struct RenderStyle;

/// The dashed places of pieces that cannot lie flat, right of those that do: as large as their
/// cloth, with the name, what is the matter and a button for what helps.
class PiecePlaces {
public:
    /// Brings the places to what the document shows. Cost: linear in the triangles of such pieces,
    /// once for each garment.
    void follow(const Document& document, const SheetPlaces& sheet);
    /// What a piece's button says; pieces without one have none.
    void setButtons(std::map<int, QString> buttons) { buttons_ = std::move(buttons); }
    bool isEmpty() const { return places_.empty(); }
    /// On the sheet, mm; empty where the piece has none.
    Eigen::AlignedBox2d boxOf(int piece) const;
    void paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
               const Document& document) const;

    struct Hit {
        int piece = -1;
        bool onButton = false;
    };
    std::optional<Hit> hitAt(const QPointF& at, const SheetMap& onScreen, const QFont& font) const;

private:
    struct Place {
        int piece = -1;
        double side = 0;  ///< mm
        QString name, words;
        Eigen::AlignedBox2d box{};
    };

    /// Of the place's button, logical pixels; none where it has none or is too small for it.
    std::optional<QRectF> buttonOf(const Place& place, const QRectF& box, const QFont& font) const;

    std::shared_ptr<const Garment> garment_;
    PieceResults results_;
    std::vector<Place> all_;     ///< without names and boxes
    std::vector<Place> places_;  ///< that are seen
    std::map<int, QString> buttons_;
};

}  // namespace toile::app
