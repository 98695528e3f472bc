// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/reference_gaps.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "app/document/document.h"
#include "app/render/render_style.h"
#include "app/text/figures.h"
#include "app/views/tool.h"
#include "app/views/view_text.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"

namespace toile::app {
namespace {

constexpr double kStep = 2;        // mm between gaps
constexpr double kSteps = 4000;    // maximum number of gaps along a piece
constexpr double kMinWord = 0.05;  // mm: a tailor ignores smaller differences
constexpr double kFromLine = 8;    // pixels from the gap to its label
constexpr double kMinBand = 6;     // pixels: below this, only the widest gap of a piece has a label
constexpr double kBetweenWords = 140;  // minimum distance of labels on a piece, pixels
constexpr int kMaxTries = 60;          // for labels on one piece
constexpr float kBandStrength = 0.3F;

/// The piece's outline as the pattern draws it; empty if there is none.
Points2 outlineOf(const Scene& scene, int piece) {
    const VertexRun run = scene.patternLines.outlines[static_cast<std::size_t>(piece)];
    Points2 points(run.count > 0 ? run.count - 1 : 0, 2);  // the last point repeats the first
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        points.row(k) =
            flatPoint(scene.lineVertices[run.first + static_cast<std::size_t>(k)]).transpose();
    }
    return points;
}

class GapFinder {
public:
    explicit GapFinder(const Scene& scene) : scene_(scene) {}

    void add(const std::vector<LineVertex>& vertices, const VertexRun& run) {
        const auto piece = run.count > 0 ? static_cast<int>(vertices[run.first].piece) : -1;
        const auto* nearest = run.count > 1 ? onOutline(piece) : nullptr;
        if (!nearest) {
            return;
        }
        const double step = std::max(kStep, geometry::perimeterOf(outlines[piece]) / kSteps);
        const auto addGap = [&](const Eigen::Vector2d& theirs, bool joins) {
            const Eigen::Vector2d ours = (*nearest)(theirs.transpose()).transpose();
            gaps.push_back({piece, theirs, ours, (theirs - ours).norm(), joins});
        };
        Eigen::Vector2d from = flatPoint(vertices[run.first]);
        addGap(from, false);
        for (std::uint32_t k = 1; k < run.count; ++k) {
            const Eigen::Vector2d to = flatPoint(vertices[run.first + k]);
            const int parts = std::max(1, static_cast<int>((to - from).norm() / step));
            for (int part = 1; part <= parts; ++part) {
                addGap(from + (to - from) * part / parts, true);
            }
            from = to;
        }
    }

    std::map<int, Points2> outlines;
    std::vector<ReferenceGaps::Gap> gaps;

private:
    /// Null if the piece has no outline.
    const geometry::NearestOnLine* onOutline(int piece) {
        if (!outlines.contains(piece)) {
            outlines[piece] = outlineOf(scene_, piece);
            if (outlines[piece].rows() > 2) {
                nearest_.emplace(piece, outlines[piece]);
            }
        }
        const auto known = nearest_.find(piece);
        return known != nearest_.end() ? &known->second : nullptr;
    }

    const Scene& scene_;
    std::map<int, geometry::NearestOnLine> nearest_;
};

/// A gap in screen coordinates.
struct Seen {
    QPointF theirs, ours;
};

}  // namespace

std::shared_ptr<const ReferenceLines> referenceLinesOf(const Document& document) {
    static const auto kNone = std::make_shared<const ReferenceLines>();
    if (!document.state().reference.file) {
        return nullptr;
    }
    return document.reference() ? document.reference()->lines : kNone;
}

void ReferenceGaps::follow(const Document& document) {
    const auto lines = referenceLinesOf(document);
    const auto scene = document.view().referencePanels ? document.scene() : nullptr;
    if (scene == scene_ && lines == lines_) {
        return;
    }
    scene_ = scene;
    lines_ = lines;
    gaps_.clear();
    outlines_.clear();
    if (scene) {
        GapFinder finder(*scene);
        const auto& vertices = lines ? lines->vertices : scene->lineVertices;
        for (const VertexRun& run : lines ? lines->runs.reference : scene->patternLines.reference) {
            finder.add(vertices, run);
        }
        outlines_ = std::move(finder.outlines);
        gaps_ = std::move(finder.gaps);
    }
    widestFirst_.resize(gaps_.size());
    std::iota(widestFirst_.begin(), widestFirst_.end(), std::size_t{0});
    std::ranges::stable_sort(widestFirst_, std::greater(),
                             [this](std::size_t k) { return gaps_[k].distance; });
}

std::vector<QRectF> ReferenceGaps::paint(QPainter& painter, const RenderStyle& style,
                                         const SheetMap& onScreen, const SheetPlaces& places,
                                         const QRectF& view,
                                         const std::vector<QRectF>& taken) const {
    std::vector<Seen> seen;
    QPainterPath band;
    band.setFillRule(Qt::WindingFill);
    for (const Gap& gap : gaps_) {
        const SheetPlace place = placeOf(places, gap.piece);
        seen.push_back({onScreen(place.placement.applied(gap.theirs)),
                        onScreen(place.placement.applied(gap.ours))});
        if (gap.joins && !place.hidden) {
            const Seen &to = seen.back(), &from = seen[seen.size() - 2];
            band.addPolygon(QPolygonF({from.theirs, to.theirs, to.ours, from.ours}));
        }
    }
    painter.save();
    QColor fill = style.reference;
    fill.setAlphaF(kBandStrength);
    painter.fillPath(band, fill);

    std::vector<QRectF> words;
    std::map<int, std::vector<QPointF>> worded;
    const auto isFree = [&](const QRectF& box) {
        const auto meets = [&box](const QRectF& other) { return box.intersects(other); };
        return view.contains(box) && std::ranges::none_of(taken, meets) &&
               std::ranges::none_of(words, meets);
    };
    std::map<int, int> tries;
    for (const std::size_t k : widestFirst_) {
        const Gap& gap = gaps_[k];
        const QLineF line(seen[k].ours, seen[k].theirs);
        auto& others = worded[gap.piece];
        const bool isNear = std::ranges::any_of(others, [&line](const QPointF& other) {
            return QLineF(line.p2(), other).length() < kBetweenWords;
        });
        if (gap.distance < kMinWord) {
            break;
        }
        if (placeOf(places, gap.piece).hidden || isNear || !view.contains(line.p2()) ||
            (!others.empty() && line.length() < kMinBand) || ++tries[gap.piece] > kMaxTries) {
            continue;
        }
        // Beyond the outer end, in the direction of the gap.
        const bool inside = geometry::isInside(outlines_.at(gap.piece), gap.theirs);
        const QPointF from = inside ? line.p2() : line.p1(), to = inside ? line.p1() : line.p2();
        const QString text = lengthWithUnit(gap.distance);
        const QSizeF size = labelSize(painter.font(), text, false);
        const QPointF way = (to - from) / std::max(line.length(), 1e-9);
        const double reach =
            (std::abs(way.x()) * size.width() + std::abs(way.y()) * size.height()) / 2 + kFromLine;
        QRectF box(QPointF(), size);
        box.moveCenter(to + reach * way);
        if (!isFree(box)) {
            continue;
        }
        others.push_back(line.p2());
        words.push_back(box);
        painter.setPen(QPen(style.reference, 2));
        painter.drawLine(line);
        paintLabel(painter, style, box, text, false);
    }
    painter.restore();
    return words;
}

}  // namespace toile::app
