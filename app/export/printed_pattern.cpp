// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/printed_pattern.h"

#include <QFile>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPrinter>
#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "app/export/paint_drawing.h"
#include "core/export/pdf_writer.h"
#include "core/export/sheet_drawing.h"
#include "core/export/sheets.h"

namespace toile::app {

namespace {

constexpr double kPaperRounding = 0.5;  // mm, by which papers of one name differ

QSizeF pageOf(const QPrinter& printer) {
    return printer.pageLayout().fullRect(QPageLayout::Millimeter).size();
}

/// Where on the page the sheet's upper left corner is.
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

/// In the order in which they come out, as often as is wanted.
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
                QFile::remove(printer.outputFileName());  // half of it is of no use
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
