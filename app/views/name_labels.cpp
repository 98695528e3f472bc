// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/name_labels.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>
#include <QTransform>
#include <algorithm>
#include <iterator>
#include <numbers>
#include <numeric>
#include <utility>

#include "app/render/render_style.h"
#include "app/views/name_cloth.h"
#include "app/views/view_text.h"

namespace toile::app {
namespace {

/// Minimum letters of a shortened name.
constexpr int kMinLetters = 4;
constexpr double kAir = 2;         ///< pixels between labels
constexpr double kMinBox = 6;      ///< smaller pieces appear as dots
constexpr double kOnArrow = 60;    ///< pixels of extra leader length accepted to avoid an arrow
constexpr double kOverName = 200;  ///< the same to avoid crossing a name
constexpr double kBeside = 7;      ///< pixels between a piece and a name beside it

bool meetsAny(const QRectF& box, const std::vector<QRectF>& others) {
    return std::ranges::any_of(
        others, [&box](const QRectF& other) -> bool { return box.intersects(other); });
}

/// Length of the common prefix of all names, up to a word end: "panel 5", "panel 15".
int commonBeginning(const std::vector<NamedPiece>& pieces) {
    if (pieces.size() < 2) {
        return 0;
    }
    const QString& first = pieces.front().name;
    qsizetype common = first.size();
    for (const NamedPiece& piece : pieces) {
        const auto ends = std::ranges::mismatch(first, piece.name);
        common = std::min<qsizetype>(common, ends.in1 - first.begin());
    }
    while (common > 0 && first[common - 1].isLetterOrNumber()) {
        --common;
    }
    const bool leavesAll = std::ranges::all_of(
        pieces, [common](const NamedPiece& piece) -> bool { return piece.name.size() > common; });
    return leavesAll ? static_cast<int>(common) : 0;
}

class NameLayout {
public:
    NameLayout(const QFont& font, const std::vector<NamedPiece>& pieces, const NameRoom& room)
        : font_(font), pieces_(pieces), room_(room), common_(commonBeginning(pieces)) {}

    std::optional<NameLabel> place(int index) {
        const NamedPiece& piece = pieces_[static_cast<std::size_t>(index)];
        if (std::max(piece.box.width(), piece.box.height()) < kMinBox ||
            !piece.box.intersects(room_.view)) {
            return std::nullopt;
        }
        const NameCloth cloth(piece.outline, piece.arrow, room_.arrows, room_.taken);
        std::optional<NameLabel> label;
        if (!piece.note.isEmpty()) {
            label = onCloth(index, cloth, piece.name + piece.note);
        }
        label = label ? label : onCloth(index, cloth, piece.name);
        label = label ? label : beside(index, cloth, piece.name);
        if (common_ > 0) {
            const QString brief = piece.name.mid(common_);
            label = label ? label : onCloth(index, cloth, brief);
            label = label ? label : beside(index, cloth, brief);
        }
        if (const QString shortened = label ? QString() : shortenedName(index);
            !shortened.isEmpty()) {
            label = onCloth(index, cloth, shortened);
        }
        if (label) {
            room_.taken.push_back(label->bounds().adjusted(-kAir, -kAir, kAir, kAir));
            if (label->leader) {
                room_.taken.push_back(QRectF(label->leader->p1(), label->leader->p2())
                                          .normalized()
                                          .adjusted(-kAir, -kAir, kAir, kAir));
            }
        }
        return label;
    }

private:
    NameLabel made(int index, const QString& text, const QPointF& middle, double angle,
                   double size) const {
        const bool isSelected = pieces_[static_cast<std::size_t>(index)].selected;
        QRectF box(QPointF(), labelSize(font_, text, isSelected, size));
        box.moveCenter(middle);
        return {index, text, box, angle, size};
    }

    /// Horizontal, preferably where it belongs; rotated only if the piece is too narrow.
    std::optional<NameLabel> onCloth(int index, const NameCloth& cloth, const QString& text) const {
        for (const double size : {1.0, kSmallName}) {
            auto label = nearItsPlace(index, cloth, text, size);
            label = label ? label : whereRoomIs(index, cloth, text, 0, size);
            if (label) {
                return label;
            }
        }
        for (const double size : {1.0, kSmallName}) {
            for (const double angle : cloth.ways()) {
                if (auto label = whereRoomIs(index, cloth, text, angle, size)) {
                    return label;
                }
            }
        }
        return std::nullopt;
    }

    std::optional<NameLabel> nearItsPlace(int index, const NameCloth& cloth, const QString& text,
                                          double size) const {
        const QPointF at = pieces_[static_cast<std::size_t>(index)].at;
        NameLabel label = made(index, text, at, 0, size);
        const QRectF there = label.box;
        for (const double sideways : {0.0, 0.6, -0.6}) {
            for (const int step : {0, 1, -1}) {
                label.box =
                    there.translated(sideways * there.width(), step * (there.height() + kAir));
                if (cloth.holds(label.box) && !meetsAny(label.box, room_.taken)) {
                    return label;
                }
            }
        }
        return std::nullopt;
    }

    std::optional<NameLabel> whereRoomIs(int index, const NameCloth& cloth, const QString& text,
                                         double angle, double size) const {
        NameLabel label = made(index, text, {}, angle, size);
        const auto middle = cloth.placeFor(label.box.size(), angle);
        if (!middle) {
            return std::nullopt;
        }
        label.box.moveCenter(*middle);
        const bool isOpen =
            room_.view.contains(label.bounds()) && !meetsAny(label.bounds(), room_.taken);
        return isOpen ? std::optional(label) : std::nullopt;
    }

    bool isFree(int index, const QRectF& box) const {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (static_cast<int>(i) != index && box.intersects(pieces_[i].box)) {
                return false;
            }
        }
        return room_.view.contains(box) && !meetsAny(box, room_.taken);
    }

    bool crossesAny(const QLineF& leader) const {
        return std::ranges::any_of(
            room_.taken, [&leader](const QRectF& other) -> bool { return crosses(leader, other); });
    }

    /// Places the name beside its piece with the shortest leader. Avoids crossing a name or ending
    /// at an arrow.
    std::optional<NameLabel> beside(int index, const NameCloth& cloth, const QString& text) const {
        const NamedPiece& piece = pieces_[static_cast<std::size_t>(index)];
        NameLabel label = made(index, text, {}, 0, 1);
        std::optional<NameLabel> best;
        double least = 0;
        for (const QPointF& way : {QPointF(0, -1), QPointF(0, 1), QPointF(-1, 0), QPointF(1, 0)}) {
            const bool isPlumb = way.x() == 0;
            const double off = kBeside + 0.5 * (isPlumb ? label.box.height() : label.box.width());
            for (const double share : {0.5, 0.25, 0.75}) {
                QPointF middle =
                    piece.box.topLeft() + share * QPointF(piece.box.width(), piece.box.height());
                if (isPlumb) {
                    middle.setY((way.y() < 0 ? piece.box.bottom() : piece.box.top()) -
                                off * way.y());
                } else {
                    middle.setX((way.x() < 0 ? piece.box.right() : piece.box.left()) -
                                off * way.x());
                }
                label.box.moveCenter(middle);
                const QPointF from = middle + (off - kBeside) * way;
                const auto end = cloth.onto(from, way);
                if (!end || !isFree(index, label.box)) {
                    continue;
                }
                label.leader = QLineF(from, *end);
                const double price = label.leader->length() +
                                     (cloth.isOnArrow(*end) ? kOnArrow : 0) +
                                     (crossesAny(*label.leader) ? kOverName : 0);
                if (!best || price < least - 1) {
                    best = label;
                    least = price;
                }
            }
        }
        return best;
    }

    /// Empty if a shortened name would be ambiguous.
    QString shortenedName(int index) const {
        const NamedPiece& piece = pieces_[static_cast<std::size_t>(index)];
        const QFontMetricsF metrics(labelFont(font_, piece.selected, kSmallName));
        const double padding = labelSize(font_, QString(), piece.selected, kSmallName).width();
        const double room = std::max(piece.box.width(), piece.box.height());
        const QString text = metrics.elidedText(piece.name, Qt::ElideMiddle, room - padding);
        const qsizetype gap = text.indexOf(QChar(0x2026));
        if (gap < 0 || text.size() - 1 < kMinLetters) {
            return {};
        }
        const QString head = text.left(gap), tail = text.mid(gap + 1);
        const auto same = std::ranges::count_if(pieces_, [&](const NamedPiece& other) -> bool {
            return other.name.startsWith(head) && other.name.endsWith(tail);
        });
        return same == 1 ? text : QString();
    }

    const QFont& font_;
    const std::vector<NamedPiece>& pieces_;
    NameRoom room_;
    int common_;
};

constexpr double kLeaderWidth = 1, kLeaderHalo = 2.2, kLeaderDot = 2;  // pixels

}  // namespace

QRectF NameLabel::bounds() const {
    QTransform turn;
    turn.translate(box.center().x(), box.center().y());
    turn.rotateRadians(-angle);
    turn.translate(-box.center().x(), -box.center().y());
    return turn.mapRect(box);
}

std::vector<NameLabel> nameLabels(const QFont& font, const std::vector<NamedPiece>& pieces,
                                  const NameRoom& room) {
    std::vector<int> order(pieces.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, [&pieces](int a, int b) -> bool {
        const NamedPiece& one = pieces[static_cast<std::size_t>(a)];
        const NamedPiece& other = pieces[static_cast<std::size_t>(b)];
        if (one.selected != other.selected) {
            return one.selected;
        }
        return one.box.width() * one.box.height() > other.box.width() * other.box.height();
    });
    NameLayout layout(font, pieces, room);
    std::vector<NameLabel> labels;
    for (const int index : order) {
        if (auto label = layout.place(index)) {
            labels.push_back(std::move(*label));
        }
    }
    return labels;
}

const std::vector<NameLabel>& KeptNames::of(const QFont& font, std::vector<NamedPiece> pieces,
                                            NameRoom room) {
    if (font != font_ || pieces != pieces_ || room != room_) {
        font_ = font;
        pieces_ = std::move(pieces);
        room_ = std::move(room);
        labels_ = nameLabels(font_, pieces_, room_);
    }
    return labels_;
}

void paintNameLabel(QPainter& painter, const RenderStyle& style, const NameLabel& label,
                    bool selected) {
    painter.save();
    if (label.leader) {
        painter.setPen(QPen(style.labelFill, kLeaderWidth + kLeaderHalo));
        painter.drawLine(*label.leader);
        painter.setPen(QPen(style.text, kLeaderWidth));
        painter.drawLine(*label.leader);
        painter.setBrush(style.text);
        painter.drawEllipse(label.leader->p2(), kLeaderDot, kLeaderDot);
    }
    painter.translate(label.box.center());
    painter.rotate(-label.angle * 180 / std::numbers::pi);
    paintLabel(painter, style, label.box.translated(-label.box.center()), label.text, selected,
               label.size);
    painter.restore();
}

}  // namespace toile::app
