// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QLineF>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

class QPainter;

namespace toile::app {

struct RenderStyle;

/// A piece to be labelled with its name. Logical pixels.
struct NamedPiece {
    QString name;
    QString note;                   ///< " · wrong side up"; omitted if space is short
    QPointF at;                     ///< preferred place of the name
    QPolygonF outline;              ///< of its cloth, closed; no name lies over it
    QRectF box;                     ///< bounding box of everything drawn for it
    std::optional<QLineF> arrow{};  ///< its grain arrow as drawn
    bool selected = false;

    bool operator==(const NamedPiece&) const = default;
};

struct NameLabel {
    int piece = -1;  ///< index into the list of pieces
    QString text;
    QRectF box{};                    ///< before rotation
    double angle = 0;                ///< about the box's middle, radians, anti-clockwise
    double size = 1;                 ///< scale of the font
    std::optional<QLineF> leader{};  ///< from a label beside the piece onto the cloth

    QRectF bounds() const;  ///< bounding box after rotation
};

/// The view, and other items in it that labels avoid.
struct NameRoom {
    QRectF view;
    std::vector<QRectF> taken{};
    std::vector<QLineF> arrows{};

    bool operator==(const NameRoom&) const = default;
};

/// Font scale on narrow pieces.
inline constexpr double kSmallName = 0.85;

/// Places the names without overlapping an outline, another name, a taken area or an arrow. Tries
/// in this order: at its preferred place or elsewhere on the cloth, possibly smaller or rotated
/// along a narrow piece or its arrow; beside the piece with a leader; the same without the common
/// prefix of all names; shortened in the middle while still unique. A piece whose name does not fit
/// gets no label. Selected and large pieces are placed first. Cost: quadratic in the pieces; if the
/// first place is not free, also that of boxPlace.
std::vector<NameLabel> nameLabels(const QFont& font, const std::vector<NamedPiece>& pieces,
                                  const NameRoom& room);

/// Caches the labels while nothing moves, because every pointer move repaints a view.
class KeptNames {
public:
    /// `nameLabels` of the same arguments. Valid until the next call.
    const std::vector<NameLabel>& of(const QFont& font, std::vector<NamedPiece> pieces,
                                     NameRoom room);

private:
    QFont font_;
    std::vector<NamedPiece> pieces_;
    NameRoom room_{};
    std::vector<NameLabel> labels_;
};

void paintNameLabel(QPainter& painter, const RenderStyle& style, const NameLabel& label,
                    bool selected);

}  // namespace toile::app
