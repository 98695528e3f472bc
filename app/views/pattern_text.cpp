// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pattern_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>
#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/document/names.h"
#include "app/render/picking.h"
#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/text/error_text.h"
#include "app/views/callouts.h"
#include "app/views/fold_line.h"
#include "app/views/grain_arrow.h"
#include "app/views/ruler.h"
#include "app/views/tool.h"
#include "app/views/view_text.h"
#include "core/geometry/segment.h"

namespace toile::app {
namespace {

/// The context of the translations.
class PatternWords {
    Q_DECLARE_TR_FUNCTIONS(PatternView)
};

QString emptyText(const Document& document) {
    if (document.pieceCount() == 0) {
        return {};
    }
    if (document.results().empty()) {
        return PatternWords::tr("The flat pieces appear here.");
    }
    if (std::ranges::find(document.results(), nullptr) != document.results().end()) {
        return PatternWords::tr("The pieces have changed and wait to be flattened.");
    }
    return PatternWords::tr("None of the pieces could be flattened. The list of pieces says why.");
}

void paintNames(QPainter& painter, const RenderStyle& style, const PatternText& text,
                std::vector<QRectF> taken, const std::vector<QLineF>& arrows) {
    const Scene& scene = *text.document.scene();
    const SheetMap onScreen(text.camera);
    const DrawingWords words = drawingWords();
    std::vector<NamedPiece> pieces;
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        const PieceScene& piece = scene.pieces[i];
        if (!piece.flat || placeOf(text.places, static_cast<int>(i)).hidden) {
            continue;
        }
        const Placement& placement = placeOf(text.places, static_cast<int>(i)).placement;
        const QString name = pieceName(text.document, static_cast<int>(i));
        QString whole =
            placement.mirrored ? PatternWords::tr("%1 · wrong side up").arg(name) : name;
        if (cutAsOf(text.document, static_cast<int>(i)) == CutAs::Image) {
            const int other = text.document.patternPiece(static_cast<int>(i))->mirror.counterpart;
            whole =
                PatternWords::tr("%1 · cut with %2").arg(whole, pieceName(text.document, other));
        }
        // Where files have its name, as it lies.
        const PieceMarks& marks =
            text.document.marks().of(text.document, static_cast<int>(i), words);
        pieces.push_back({name, whole.mid(name.size()),
                          onScreen(placement.offset + marks.label.position),
                          onScreen(placedBox(piece.flatBox, placement)),
                          text.document.isSelected(static_cast<int>(i))});
    }
    for (const NameLabel& name : nameLabels(painter.font(), pieces, std::move(taken), arrows)) {
        paintLabel(painter, style, name.box, name.text,
                   pieces[static_cast<std::size_t>(name.piece)].selected);
    }
}

/// Whether any cloth lies under a part of the view.
bool isOnCloth(const PatternText& text, const QRectF& part) {
    return anyPointIn(part, [&text](double x, double y) -> bool {
        return pickPattern(*text.document.scene(), text.places, text.camera.toWorld(x, y))
            .has_value();
    });
}

}  // namespace

void paintPatternText(QPainter& painter, const RenderStyle& style, const PatternText& text) {
    const Document& document = text.document;
    const int ruler = document.view().rulers ? kRulerBreadth : 0;
    const QPointF corner(ruler, ruler);
    const QString title = PatternWords::tr("Pattern");
    const bool isCut = document.scene() && document.view().cuttingLine &&
                       !document.scene()->patternLines.cutting.empty();
    const QString note =
        isCut ? PatternWords::tr("right side of the fabric up, cutting and seam lines")
              : PatternWords::tr("right side of the fabric up, seam lines");
    if (!document.scene() || sheetBox(*document.scene(), text.places).isEmpty()) {
        paintCaption(painter, style, corner, title, note, false);
        painter.setPen(style.faintText);
        if (!text.isElse) {
            painter.drawText(text.view.adjusted(24, 24, -24, -24),
                             Qt::AlignCenter | Qt::TextWordWrap, emptyText(document));
        }
        return;
    }
    const SheetMap onScreen(text.camera);
    const double scale = text.camera.pixelsPerMillimetre();
    const QRectF caption = captionBox(painter.font(), corner, title, note);
    const std::vector<QRectF> taken{caption, scaleBarBox(painter.font(), text.view, scale, ruler)};
    std::vector<QRectF> words = paintFolds(painter, style, onScreen, document);
    words.insert(words.end(), taken.begin(), taken.end());
    const QRectF free(text.view.adjusted(ruler, ruler, 0, 0));
    std::ranges::copy(text.gaps.paint(painter, style, onScreen, text.places, free, words),
                      std::back_inserter(words));
    std::vector<QLineF> arrows;
    if (document.view().grain || text.strongGrain) {
        arrows = paintGrainArrows(painter, style, onScreen, document, text.strongGrain);
    }
    if (document.view().labels) {
        paintNames(painter, style, text, std::move(words), arrows);
    }
    paintSpotCallouts(
        painter, style, {free, taken}, document, text.spots,
        [&text](const WorstSpot& spot) { return placeOfSpot(spot, text.camera, text.places); });
    paintCaption(painter, style, corner, title, note, isOnCloth(text, caption));
    paintScaleBar(painter, style, text.view, scale, ruler);
    if (document.view().rulers) {
        paintRulers(painter, style, text.view, onScreen, text.camera.visible(), scale,
                    boxOnSheet(document, selectedFlat(document)));
    }
}

namespace {

/// Of its piece's width: a label in the middle still lies on its own piece by half.
constexpr double kRoom = 2;
/// Letters that a shortened name must keep.
constexpr int kMinLetters = 4;
constexpr double kAir = 2;     ///< pixels between labels
constexpr double kMinBox = 6;  ///< smaller pieces are dots

bool meetsAny(const QRectF& box, const std::vector<QRectF>& others) {
    return std::ranges::any_of(
        others, [&box](const QRectF& other) -> bool { return box.intersects(other); });
}

/// How many letters all names begin with, up to the end of a word: "panel 5", "panel 15".
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

class Layout {
public:
    Layout(const QFont& font, const std::vector<NamedPiece>& pieces, std::vector<QRectF> taken,
           const std::vector<QLineF>& arrows)
        : font_(font),
          pieces_(pieces),
          taken_(std::move(taken)),
          arrows_(arrows),
          common_(commonBeginning(pieces)) {}

    std::optional<NameLabel> place(int index) {
        const NamedPiece& piece = pieces_[static_cast<std::size_t>(index)];
        if (std::max(piece.box.width(), piece.box.height()) < kMinBox) {
            return std::nullopt;
        }
        QStringList texts{piece.name + piece.note, piece.name, piece.name.mid(common_)};
        if (const QString shortened = shortenedName(index); !shortened.isEmpty()) {
            texts << shortened;
        }
        texts.removeDuplicates();
        for (const QString& text : std::as_const(texts)) {
            if (const auto box = boxFor(index, text)) {
                taken_.push_back(box->adjusted(-kAir, -kAir, kAir, kAir));
                return NameLabel{index, *box, text};
            }
        }
        return std::nullopt;
    }

private:
    /// Empty where nothing is left that tells it from the others.
    QString shortenedName(int index) const {
        const NamedPiece& piece = pieces_[static_cast<std::size_t>(index)];
        const QFontMetricsF metrics(labelFont(font_, piece.selected));
        const double padding = labelSize(font_, QString(), piece.selected).width();
        const QString text =
            metrics.elidedText(piece.name, Qt::ElideMiddle, kRoom * piece.box.width() - padding);
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

    bool isFree(int index, const QRectF& box) const {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (static_cast<int>(i) != index && box.intersects(pieces_[i].box)) {
                return false;
            }
        }
        return true;
    }

    bool meetsArrow(const QRectF& box) const {
        return std::ranges::any_of(arrows_, [&box](const QLineF& arrow) -> bool {
            const Eigen::Vector2d from(arrow.x1(), arrow.y1()), way(arrow.dx(), arrow.dy());
            const auto share = geometry::shareInBox<Eigen::Vector2d>(
                from, way, {box.left(), box.top()}, {box.right(), box.bottom()});
            return share.first <= share.last;
        });
    }

    /// Near where it belongs, best on no arrow.
    std::optional<QRectF> boxFor(int index, const QString& text) const {
        const NamedPiece& piece = pieces_[static_cast<std::size_t>(index)];
        const QSizeF size = labelSize(font_, text, piece.selected);
        std::optional<QRectF> onArrow;
        for (const double sideways : {0.0, 0.6, -0.6}) {
            for (const int step : {0, 1, -1, 2, -2}) {
                QRectF box(QPointF(), size);
                box.moveCenter(piece.at +
                               QPointF(sideways * size.width(), step * (size.height() + kAir)));
                const bool onPiece =
                    (step == 0 ||
                     (box.top() >= piece.box.top() && box.bottom() <= piece.box.bottom())) &&
                    (sideways == 0 ||
                     (box.left() >= piece.box.left() && box.right() <= piece.box.right()));
                const bool fits = size.width() <= kRoom * piece.box.width() || isFree(index, box);
                if (!onPiece || !fits || meetsAny(box, taken_)) {
                    continue;
                }
                if (!meetsArrow(box)) {
                    return box;
                }
                onArrow = onArrow ? onArrow : box;
            }
        }
        return onArrow;
    }

    const QFont& font_;
    const std::vector<NamedPiece>& pieces_;
    std::vector<QRectF> taken_;
    const std::vector<QLineF>& arrows_;
    int common_;
};

}  // namespace

std::vector<NameLabel> nameLabels(const QFont& font, const std::vector<NamedPiece>& pieces,
                                  std::vector<QRectF> taken, const std::vector<QLineF>& arrows) {
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
    Layout layout(font, pieces, std::move(taken), arrows);
    std::vector<NameLabel> boxes;
    for (const int index : order) {
        if (const auto box = layout.place(index)) {
            boxes.push_back(*box);
        }
    }
    return boxes;
}

}  // namespace toile::app
