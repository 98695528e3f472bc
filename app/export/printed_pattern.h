// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>
#include <QPen>
#include <QSizeF>
#include <QString>
#include <QTransform>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/drawing/sheet_drawing.h"
#include "core/formats/export_options.h"
#include "core/formats/pdf/pdf_pages.h"

class QPainter;
class QPrinter;

namespace toile::app {

/// A line or an area as it is painted: mm, y up from the lower left corner of a sheet.
struct Ink {
    QPainterPath path;
    QPen pen{Qt::NoPen};           ///< none: an area
    QColor colour{};               ///< of an area
    std::optional<QRectF> clip{};  ///< what is outside is not seen
};

/// Keeps what is drawn on it, to be painted as often and as large as is wanted. Layers and items
/// are passed over: paper has none.
class InkCanvas : public SheetCanvas {
public:
    /// @param pattern  what `drawing` draws; outlives the canvas
    explicit InkCanvas(std::span<const Ink> pattern = {}) : pattern_(pattern) {}

    void save() override { kept_.push_back(state_); }
    void restore() override;
    void transform(double a, double b, double c, double d, const Eigen::Vector2d& move) override;
    void clip(const Eigen::AlignedBox2d& box) override;
    /// Without what the clip hides.
    void drawing() override;

    void beginLayer(int) override {}
    void beginItem(std::string_view, std::string_view) override {}
    void end() override {}

    void setGrey(double grey) override;
    void setWidth(double width) override { state_.pen.setWidthF(width); }
    void setDashes(double line, double gap) override { state_.dashes = {line, gap}; }
    void setRoundEnds() override;

    void line(const Points2& points, bool closed) override;
    void curves(const std::vector<CubicCurve>& curves, bool closed) override;
    void box(const Eigen::AlignedBox2d& box) override;
    void segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) override;
    double text(std::string_view text, const Eigen::Vector2d& position, double height,
                TextStart start, double angle, double most) override;

    std::vector<Ink> take() { return std::move(inks_); }

private:
    struct State {
        QTransform place{};
        std::optional<QRectF> clip{};
        QPen pen{Qt::black, 1, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin};
        QList<qreal> dashes{};  ///< mm
    };

    void stroke(const QPainterPath& path);

    std::span<const Ink> pattern_;
    State state_{};
    std::vector<State> kept_;
    std::vector<Ink> inks_;
};

/// @param painter  in mm with y down, the sheet's upper left corner at the origin
/// @param height   of the sheet  @param thinnest  lines are painted so wide at least, mm
void paintInks(QPainter& painter, const std::vector<Ink>& inks, double height, double thinnest = 0);

/// A pattern as paper has it: what of it is the same on every paper, and takes the time.
struct InkedPattern {
    std::shared_ptr<const DrawnPattern> pattern;
    std::vector<Ink> inks;      ///< of all of it
    std::size_t checkFrom = 0;  ///< the first of its check square, which is not printed in tiles
};

/// Cost: that of `drawPattern`. Any thread.
std::shared_ptr<const InkedPattern> inked(std::shared_ptr<const DrawnPattern> pattern);

/// A pattern on sheets of paper, the same as those of a PDF file: for printers and previews.
class PrintedPattern {
public:
    /// Errors and cost: those of planPages. Any thread.
    static Result<PrintedPattern> on(std::shared_ptr<const InkedPattern> pattern,
                                     const PdfOptions& options);

    QString title() const;
    int count() const;
    QSizeF paper(int sheet) const;  ///< mm
    /// @param painter  in mm with y down, the sheet's upper left corner at the origin
    /// @param sheet     from 0 to count() - 1
    /// @param thinnest  lines are painted so wide at least, mm: to be seen when they are small
    void paint(QPainter& painter, int sheet, double thinnest = 0) const;

private:
    PrintedPattern(std::shared_ptr<const InkedPattern> pattern, PdfPlan plan);

    const Drawing& drawing() const { return pattern_->pattern->drawing; }

    std::shared_ptr<const InkedPattern> pattern_;
    PdfPlan plan_;
};

/// Sets the printer's paper to a sheet's, where it has that, upright or lying. What it has then is
/// its own affair: see `roomLacking`.
void choosePaper(QPrinter& printer, const QSizeF& paper);

/// A sheet that the printer's page has no room for.
struct RoomLacking {
    QSizeF paper, page;     ///< mm, of the sheet and of the printer
    bool isMargin = false;  ///< the page is large enough, but the printer leaves more of it free
};

/// Whether sheets in the middle of the printer's page would lose something; the first that would.
/// Rounding of paper sizes to points or tenths of an inch is none.
std::optional<RoomLacking> roomLacking(const QPrinter& printer, const PrintedPattern& pattern);

/// Prints the sheets that the printer's settings ask for, at true scale, each in the middle of the
/// printer's page. Cancelled, it goes no further: a file is removed, but what some printers have
/// got by then they print.
/// @return false where the printer takes nothing
/// Errors: Cancelled. Any thread, while no other uses the printer.
Result<bool> print(QPrinter& printer, const PrintedPattern& pattern, Progress& progress);

}  // namespace toile::app
