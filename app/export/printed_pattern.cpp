// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/printed_pattern.h"

#include <QFile>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPrinter>
#include <algorithm>
#include <iterator>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "app/export/paint_drawing.h"
#include "core/base/characters.h"
#include "core/formats/drawing/sheet_drawing.h"
#include "core/formats/pdf/pdf_writer.h"
#include "core/formats/pdf/sheets.h"

namespace toile::app {
namespace {

QPointF pointOf(const Eigen::Vector2d& point) {
    return {point.x(), point.y()};
}

QRectF rectOf(const Eigen::AlignedBox2d& box) {
    return {pointOf(box.min()), pointOf(box.max())};
}

/// Widens a pen, keeping the length of its dashes.
QPen asWide(QPen pen, double thinnest) {
    const double width = pen.widthF();
    if (width >= thinnest) {
        return pen;
    }
    QList<qreal> dashes = pen.dashPattern();
    for (qreal& length : dashes) {
        length *= width / thinnest;
    }
    pen.setWidthF(thinnest);
    if (pen.style() == Qt::CustomDashLine) {
        pen.setDashPattern(dashes);
    }
    return pen;
}

constexpr double kPaperRounding = 0.5;  // mm, tolerance between papers of one name

QSizeF pageOf(const QPrinter& printer) {
    return printer.pageLayout().fullRect(QPageLayout::Millimeter).size();
}

/// Position of the sheet's upper left corner on the page.
QPointF cornerOf(const QSizeF& page, const QSizeF& paper) {
    return {0.5 * (page.width() - paper.width()), 0.5 * (page.height() - paper.height())};
}

struct Range {
    int first = 0, last = -1;  ///< sheets
};

Range rangeOf(const QPrinter& printer, int count) {
    if (printer.printRange() == QPrinter::PageRange && printer.fromPage() > 0) {
        return {printer.fromPage() - 1, std::min(printer.toPage(), count) - 1};
    }
    return {0, count - 1};
}

/// Sheet indices in print order, repeated for copies.
std::vector<int> sheetsFor(const QPrinter& printer, int count) {
    const Range range = rangeOf(printer, count);
    std::vector<int> once;
    for (int sheet = range.first; sheet <= range.last; ++sheet) {
        once.push_back(sheet);
    }
    if (printer.pageOrder() == QPrinter::LastPageFirst) {
        std::ranges::reverse(once);
    }
    std::vector<int> sheets;
    const int copies = printer.supportsMultipleCopies() ? 1 : std::max(1, printer.copyCount());
    for (int copy = 0; copy < copies; ++copy) {
        sheets.insert(sheets.end(), once.begin(), once.end());
    }
    return sheets;
}

void paintSheet(QPainter& painter, const QPrinter& printer, const PrintedPattern& pattern,
                int sheet) {
    const double scale = printer.resolution() / kMillimetresPerInch;
    painter.save();
    painter.scale(scale, scale);
    painter.translate(cornerOf(pageOf(printer), pattern.paper(sheet)));
    pattern.paint(painter, sheet);
    painter.restore();
}

}  // namespace

void InkCanvas::restore() {
    state_ = std::move(kept_.back());
    kept_.pop_back();
}

void InkCanvas::transform(double a, double b, double c, double d, const Eigen::Vector2d& move) {
    state_.place = QTransform(a, b, c, d, move.x(), move.y()) * state_.place;
}

void InkCanvas::clip(const Eigen::AlignedBox2d& box) {
    const QRectF placed = state_.place.mapRect(rectOf(box));
    state_.clip = state_.clip ? *state_.clip & placed : placed;
}

void InkCanvas::drawing() {
    for (const Ink& drawn : pattern_) {
        Ink ink = drawn;
        ink.path = state_.place.map(drawn.path);
        ink.clip = state_.clip;
        const double edge = ink.pen.widthF();
        const QRectF reach = ink.path.controlPointRect().adjusted(-edge, -edge, edge, edge);
        if (!ink.clip || ink.clip->intersects(reach)) {
            inks_.push_back(std::move(ink));
        }
    }
}

void InkCanvas::setGrey(double grey) {
    state_.pen.setColor(QColor::fromRgbF(static_cast<float>(grey), static_cast<float>(grey),
                                         static_cast<float>(grey)));
}

void InkCanvas::setRoundEnds() {
    state_.pen.setCapStyle(Qt::RoundCap);
    state_.pen.setJoinStyle(Qt::RoundJoin);
}

void InkCanvas::stroke(const QPainterPath& path) {
    QPen pen = state_.pen;
    if (!state_.dashes.isEmpty()) {
        QList<qreal> inWidths;
        for (const qreal length : state_.dashes) {
            inWidths << length / pen.widthF();
        }
        pen.setDashPattern(inWidths);
    }
    inks_.push_back({state_.place.map(path), pen, {}, state_.clip});
}

void InkCanvas::line(const Points2& points, bool closed) {
    QPainterPath path;
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        const QPointF point(points(k, 0), points(k, 1));
        k == 0 ? path.moveTo(point) : path.lineTo(point);
    }
    if (closed) {
        path.closeSubpath();
    }
    stroke(path);
}

void InkCanvas::curves(const std::vector<CubicCurve>& curves, bool closed) {
    QPainterPath path;
    path.moveTo(pointOf(curves.front().start));
    for (const CubicCurve& curve : curves) {
        if (curve.isLine) {
            path.lineTo(pointOf(curve.end));
        } else {
            path.cubicTo(pointOf(curve.startHandle), pointOf(curve.endHandle), pointOf(curve.end));
        }
    }
    if (closed) {
        path.closeSubpath();
    }
    stroke(path);
}

void InkCanvas::box(const Eigen::AlignedBox2d& box) {
    QPainterPath path;
    path.addRect(rectOf(box));
    stroke(path);
}

void InkCanvas::segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    QPainterPath path;
    path.moveTo(pointOf(from));
    path.lineTo(pointOf(to));
    stroke(path);
}

double InkCanvas::text(std::string_view text, const Eigen::Vector2d& position, double height,
                       TextStart start, double angle, double most) {
    const Letters letters = lettersOf(cleanText(text), height);
    if (!(letters.width > 0)) {
        return 0;
    }
    const double scale = most > 0 ? std::min(1.0, most / letters.width) : 1;
    QTransform place;
    place.translate(position.x(), position.y());
    place.rotateRadians(angle);
    place.scale(scale, -scale);  // letters have y down
    place.translate(start == TextStart::Middle ? -0.5 * letters.width : 0, 0);
    inks_.push_back({(place * state_.place).map(letters.path), QPen(Qt::NoPen), state_.pen.color(),
                     state_.clip});
    return scale * letters.width;
}

void paintInks(QPainter& painter, const std::vector<Ink>& inks, double height, double thinnest) {
    painter.save();
    painter.translate(0, height);
    painter.scale(1, -1);
    for (const Ink& ink : inks) {
        painter.save();
        if (ink.clip) {
            painter.setClipRect(*ink.clip, Qt::IntersectClip);
        }
        if (ink.pen.style() == Qt::NoPen) {
            painter.fillPath(ink.path, ink.colour);
        } else {
            painter.strokePath(ink.path, asWide(ink.pen, thinnest));
        }
        painter.restore();
    }
    painter.restore();
}

std::shared_ptr<const InkedPattern> inked(std::shared_ptr<const DrawnPattern> pattern) {
    auto made = std::make_shared<InkedPattern>();
    InkCanvas out;
    drawPattern(out, pattern->drawing, pattern->pattern, pdfLayers(pattern->drawing, true));
    made->inks = out.take();
    made->checkFrom = made->inks.size();
    InkCanvas check;
    drawPattern(check, pattern->drawing, pattern->pattern, {LayerKind::Check});
    std::ranges::move(check.take(), std::back_inserter(made->inks));
    made->pattern = std::move(pattern);
    return made;
}

PrintedPattern::PrintedPattern(std::shared_ptr<const InkedPattern> pattern, PdfPlan plan)
    : pattern_(std::move(pattern)), plan_(std::move(plan)) {}

Result<PrintedPattern> PrintedPattern::on(std::shared_ptr<const InkedPattern> pattern,
                                          const PdfOptions& options) {
    Result<PdfPlan> plan = planPdf(pattern->pattern->drawing, options);
    if (!plan) {
        return plan.error();
    }
    return PrintedPattern(std::move(pattern), std::move(plan).value());
}

QString PrintedPattern::title() const {
    return QString::fromStdString(drawing().title);
}

int PrintedPattern::count() const {
    return static_cast<int>(sheetCount(plan_));
}

QSizeF PrintedPattern::paper(int sheet) const {
    const Eigen::Vector2d paper = sheetPaper(plan_, static_cast<std::size_t>(sheet));
    return {paper.x(), paper.y()};
}

void PrintedPattern::paint(QPainter& painter, int sheet, double thinnest) const {
    const std::span<const Ink> inks(pattern_->inks);
    InkCanvas out(plan_.isTiled ? inks.first(pattern_->checkFrom) : inks);
    drawSheet(out, drawing(), plan_, static_cast<std::size_t>(sheet));
    paintInks(painter, out.take(), paper(sheet).height(), thinnest);
}

void choosePaper(QPrinter& printer, const QSizeF& paper) {
    const bool isLying = paper.width() > paper.height();
    const QPageSize size(isLying ? paper.transposed() : paper, QPageSize::Millimeter, QString(),
                         QPageSize::FuzzyOrientationMatch);
    printer.setFullPage(true);
    printer.setPageSize(size);
    printer.setPageOrientation(isLying ? QPageLayout::Landscape : QPageLayout::Portrait);
}

std::optional<RoomLacking> roomLacking(const QPrinter& printer, const PrintedPattern& pattern) {
    const QSizeF page = pageOf(printer);
    QPageLayout printable = printer.pageLayout();
    printable.setMode(QPageLayout::StandardMode);
    printable.setMargins(printable.minimumMargins());
    const QRectF room =
        printable.paintRect(QPageLayout::Millimeter)
            .adjusted(-kPaperRounding, -kPaperRounding, kPaperRounding, kPaperRounding);
    for (int sheet = 0; sheet < pattern.count(); ++sheet) {
        const QSizeF paper = pattern.paper(sheet);
        const QRectF shown = QRectF(cornerOf(page, paper), paper)
                                 .adjusted(kPageMargin, kPageMargin, -kPageMargin, -kPageMargin);
        const bool isLarger = paper.width() > page.width() + kPaperRounding ||
                              paper.height() > page.height() + kPaperRounding;
        if (isLarger || !room.contains(shown)) {
            return RoomLacking{paper, page, !isLarger};
        }
    }
    return {};
}

Result<bool> print(QPrinter& printer, const PrintedPattern& pattern, Progress& progress) {
    const std::vector<int> sheets = sheetsFor(printer, pattern.count());
    QPainter painter;
    if (sheets.empty() || !painter.begin(&printer)) {
        return false;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    progress.start(static_cast<double>(sheets.size()));
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        if (progress.isCancelled()) {
            printer.abort();
            painter.end();
            if (!printer.outputFileName().isEmpty()) {
                QFile::remove(printer.outputFileName());  // incomplete
            }
            return Error{ErrorCode::Cancelled};
        }
        if (k > 0 && !printer.newPage()) {
            return false;
        }
        paintSheet(painter, printer, pattern, sheets[k]);
        progress.advance(1);
    }
    return painter.end() && printer.printerState() != QPrinter::Error;
}

}  // namespace toile::app
