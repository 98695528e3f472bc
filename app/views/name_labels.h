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

/// A piece that is to have its name written on it. Logical pixels.
struct NamedPiece {
    QString name;
    QString note;                   ///< " · wrong side up"; may be left out where room is short
    QPointF at;                     ///< where its name belongs
    QPolygonF outline;              ///< of its cloth, closed; no name lies over it
    QRectF box;                     ///< around all that is drawn of it
    std::optional<QLineF> arrow{};  ///< its grain, as it is drawn
    bool selected = false;

    bool operator==(const NamedPiece&) const = default;
};

struct NameLabel {
    int piece = -1;  ///< index into the list of pieces
    QString text;
    QRectF box{};                    ///< before it is turned
    double angle = 0;                ///< about the box's middle, radians, anti-clockwise
    double size = 1;                 ///< of the usual letters
    std::optional<QLineF> leader{};  ///< from a label beside its piece onto the cloth

    QRectF bounds() const;  ///< around it as it stands
};

/// What else the labels share the view with.
struct NameRoom {
    QRectF view;
    std::vector<QRectF> taken{};
    std::vector<QLineF> arrows{};

    bool operator==(const NameRoom&) const = default;
};

/// Smaller letters than usual, where a piece is narrow.
inline constexpr double kSmallName = 0.85;

/// Where the names go: none over an outline, on another, on what is taken nor on an arrow. A name
/// is written where it belongs or elsewhere on its cloth, turned along a narrow piece or its arrow,
/// or a little smaller; else beside the piece, with a leader onto it, where nothing lies; else the
/// same without what all names begin with; else shortened in its middle as long as it can be told
/// from all other names. A piece whose name finds no room has no label. The largest pieces and
/// those that are selected choose first. Cost: quadratic in the pieces; where the first place does
/// not do, that of boxPlace.
std::vector<NameLabel> nameLabels(const QFont& font, const std::vector<NamedPiece>& pieces,
                                  const NameRoom& room);

/// Keeps the labels that it has found for as long as nothing moves: a view is painted for each move
/// of the pointer.
class KeptNames {
public:
    /// `nameLabels` of the same. Valid until the next call.
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
