// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/measure_tool.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "app/document/document.h"
#include "app/render/render_style.h"
#include "app/text/figures.h"
#include "app/views/tools/tool_paint.h"

namespace toile::app {
namespace {

/// Half of the last digit shown; smaller differences count as zero.
constexpr double kNoDifference = 0.00005;

QString percentText(double fraction) {
    const QString number = QLocale().toString(100 * std::abs(fraction), 'f', 2);
    if (std::abs(fraction) < kNoDifference) {
        return MeasureTool::tr("the same");
    }
    return fraction > 0 ? MeasureTool::tr("+%1 %").arg(number)
                        : MeasureTool::tr("−%1 %").arg(number);
}

QString line(const QString& what, const MeasuredLength& length) {
    if (!length.flat) {
        return MeasureTool::tr("%1: %2, not flat yet").arg(what, lengthWithUnit(length.onCloth));
    }
    return MeasureTool::tr("%1: %2, flat %3 (%4)")
        .arg(what, lengthWithUnit(length.onCloth), lengthWithUnit(*length.flat),
             percentText(length.difference().value_or(0)));
}

}  // namespace

MeasureTool::MeasureTool(Document& document, PathFinder& finder)
    : document_(document), draft_(finder) {
    connect(&draft_, &PathDraft::changed, this, &Tool::changed);
}

QString MeasureTool::hint(ViewKind) const {
    if (draft_.isEmpty()) {
        return tr(
            "Click: start measuring · Esc: leave the tool · two points on an edge are also "
            "measured along it");
    }
    return isEnded_ ? tr("Click: new measurement · Ctrl+C: copy · Esc: clear it")
                    : tr("Click: next point · Double click or Enter: end here · Backspace: remove "
                         "the last point · Ctrl+C: copy · Esc: clear the measurement");
}

void MeasureTool::click(ToolView& view, const Pointer& pointer) {
    if (!document_.garment()) {
        return;
    }
    if (isEnded_) {
        cancel();
    }
    const auto place = snapper_.find(view, *document_.garment(), pointer.at, draft_.points());
    if (!place) {
        return;
    }
    if (!draft_.isEmpty() && place->piece != draft_.points().front().piece) {
        cancel();
    }
    if (draft_.isEmpty() || !samePlace(place->at, draft_.points().back().at)) {
        draft_.setTip(std::nullopt);
        draft_.add(*place, document_.garment()->pieces[static_cast<std::size_t>(place->piece)]);
    }
    pointer_ = pointer.at;
    pointerView_ = view.kind();
}

void MeasureTool::doubleClick(ToolView&, const Pointer&) {
    isEnded_ = draft_.points().size() > 1;
    draft_.setTip(std::nullopt);
}

void MeasureTool::hover(ToolView& view, const Pointer& pointer) {
    if (!document_.garment() || isEnded_) {
        return;
    }
    under_ = snapper_.find(view, *document_.garment(), pointer.at, draft_.points());
    pointer_ = pointer.at;
    pointerView_ = view.kind();
    const bool goesOn =
        under_ && !draft_.isEmpty() && under_->piece == draft_.points().front().piece;
    draft_.setTip(goesOn ? under_ : std::nullopt);
    view.repaintSoon();  // handle and note appear in this view only
}

void MeasureTool::leave(ToolView& view) {
    under_.reset();
    draft_.setTip(std::nullopt);
    view.repaintSoon();
}

bool MeasureTool::wants(const QKeyEvent& event) const {
    // Take Backspace even if nothing is left, or a held key would reach the window's shortcut.
    if (event.key() == Qt::Key_Escape || event.key() == Qt::Key_Backspace) {
        return true;
    }
    return !draft_.isEmpty() && (event.matches(QKeySequence::Copy) ||
                                 event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter);
}

void MeasureTool::key(ToolView& view, const QKeyEvent& event) {
    if (event.matches(QKeySequence::Copy)) {
        if (!lines().isEmpty()) {
            QGuiApplication::clipboard()->setText(lines().join('\n'));
        }
    } else if (event.key() == Qt::Key_Backspace) {
        isEnded_ = false;
        draft_.removeLast();
    } else if (event.key() != Qt::Key_Escape) {
        doubleClick(view, {});
    } else if (draft_.isEmpty()) {
        emit finished();
    } else {
        cancel();
    }
}

void MeasureTool::cancel() {
    snapper_.keep(document_.garment().get());
    isEnded_ = false;
    under_.reset();
    draft_.clear();
}

std::vector<ClothPoint> MeasureTool::places() const {
    std::vector<ClothPoint> places = draft_.points();
    if (draft_.tip() && !places.empty() && !samePlace(draft_.tip()->at, places.back().at)) {
        places.push_back(*draft_.tip());
    }
    return places;
}

const Points2* MeasureTool::flat() const {
    const PieceResult* result = document_.result(draft_.points().front().piece);
    return result && result->flat && result->piece == draft_.piece() ? &result->flat->Q : nullptr;
}

std::optional<MeasuredLength> MeasureTool::way() const {
    const std::vector<ClothPoint> all = places();
    const auto onCloth = draft_.length();
    if (all.size() < 2 || !onCloth) {
        return std::nullopt;
    }
    MeasuredLength length{*onCloth};
    if (const Points2* Q = flat()) {
        length.flat = 0;
        for (std::size_t i = 1; i < all.size(); ++i) {
            *length.flat += flatDistance(*draft_.piece(), *Q, all[i - 1].at, all[i].at);
        }
    }
    return length;
}

std::optional<MeasuredLength> MeasureTool::outline() const {
    const std::vector<ClothPoint> all = places();
    return all.size() == 2 ? alongOutline(*draft_.piece(), flat(), all[0].at, all[1].at)
                           : std::nullopt;
}

QStringList MeasureTool::lines() const {
    QStringList lines;
    if (draft_.isEmpty()) {
        return lines;
    }
    if (const auto length = way()) {
        lines << line(tr("On the cloth"), *length);
    }
    if (const auto length = outline()) {
        lines << line(tr("Along the edge"), *length);
    }
    return lines;
}

void MeasureTool::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    draft_.paint(view, painter, style, style.seam);
    if (under_ && !isEnded_) {
        paintHandle(view, painter, style, *under_, style.seam, false);
    }
    const std::vector<ClothPoint> all = places();
    if (all.size() < 2) {
        return;
    }
    // In the pattern, show the straight lines that are measured there.
    if (view.kind() == ViewKind::Pattern) {
        for (std::size_t i = 1; i < all.size(); ++i) {
            const auto from =
                view.onScreen(all[i - 1].piece, all[i - 1].at.face, all[i - 1].at.barycentric);
            const auto to = view.onScreen(all[i].piece, all[i].at.face, all[i].at.barycentric);
            if (from && to) {
                paintStraight(painter, style, *from, *to);
            }
        }
    }
    if (view.kind() == pointerView_) {
        paintNote(painter, style, pointer_, lines());
    }
}

namespace {

/// A barycentric weight below this puts a place on the opposite edge.
constexpr double kZero = 1e-9;

Eigen::RowVector2d flatPoint(const Piece& piece, const Points2& Q, const SurfacePoint& at) {
    Eigen::RowVector2d point = Eigen::RowVector2d::Zero();
    for (int k = 0; k < 3; ++k) {
        point += at.barycentric[k] * Q.row(piece.mesh.F(at.face, k));
    }
    return point;
}

/// A place on a loop: at share `part` of the edge that leaves vertex `index`.
struct OnLoop {
    std::size_t index;
    double part;
};

double weightOf(const Piece& piece, const SurfacePoint& at, int vertex) {
    for (int k = 0; k < 3; ++k) {
        if (piece.mesh.F(at.face, k) == vertex) {
            return at.barycentric[k];
        }
    }
    return 0;
}

std::optional<OnLoop> placeOn(const std::vector<int>& loop, const Piece& piece,
                              const SurfacePoint& at) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const double here = weightOf(piece, at, loop[i]);
        const double next = weightOf(piece, at, loop[(i + 1) % loop.size()]);
        if (here > kZero && here + next > 1 - kZero) {
            return OnLoop{i, next};
        }
    }
    return std::nullopt;
}

template <class Points>
double lengthUpTo(const std::vector<int>& loop, const Points& P, const OnLoop& at) {
    double sum = 0;
    for (std::size_t i = 0; i <= at.index; ++i) {
        const double edge = (P.row(loop[(i + 1) % loop.size()]) - P.row(loop[i])).norm();
        sum += i < at.index ? edge : at.part * edge;
    }
    return sum;
}

template <class Points>
double perimeter(const std::vector<int>& loop, const Points& P) {
    return lengthUpTo(loop, P, {loop.size() - 1, 1});
}

std::optional<MeasuredLength> along(const std::vector<int>& loop, const Piece& piece,
                                    const Points2* Q, const SurfacePoint& from,
                                    const SurfacePoint& to) {
    const auto a = placeOn(loop, piece, from), b = placeOn(loop, piece, to);
    if (!a || !b) {
        return std::nullopt;
    }
    const auto between = [&](const auto& P) {
        return std::abs(lengthUpTo(loop, P, *b) - lengthUpTo(loop, P, *a));
    };
    const double direct = between(piece.mesh.V), all = perimeter(loop, piece.mesh.V);
    const bool goesRound = direct > all - direct;
    MeasuredLength length{goesRound ? all - direct : direct};
    if (Q) {
        length.flat = goesRound ? perimeter(loop, *Q) - between(*Q) : between(*Q);
    }
    return length;
}

}  // namespace

double flatDistance(const Piece& piece, const Points2& Q, const SurfacePoint& from,
                    const SurfacePoint& to) {
    return (flatPoint(piece, Q, to) - flatPoint(piece, Q, from)).norm();
}

std::optional<MeasuredLength> alongOutline(const Piece& piece, const Points2* Q,
                                           const SurfacePoint& from, const SurfacePoint& to) {
    if (!piece.boundary.empty()) {
        if (const auto length = along(piece.boundary, piece, Q, from, to)) {
            return length;
        }
    }
    for (const auto& hole : piece.holes) {
        if (const auto length = along(hole, piece, Q, from, to)) {
            return length;
        }
    }
    return std::nullopt;
}

}  // namespace toile::app
