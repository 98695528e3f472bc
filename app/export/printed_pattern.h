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

/// A painted line or area: mm, y up from the lower left corner of a sheet.
struct Ink {
    QPainterPath path;
    QPen pen{Qt::NoPen};           ///< none: an area
    QColor colour{};               ///< of an area
    std::optional<QRectF> clip{};  ///< hides everything outside
};

/// Records drawing commands, to be painted repeatedly at any size. Ignores layers and items, which
/// paper does not have.
class InkCanvas : public SheetCanvas {
public:
    /// @param pattern  content of `drawing`; outlives the canvas
    explicit InkCanvas(std::span<const Ink> pattern = {}) : pattern_(pattern) {}

    void save() override { kept_.push_back(state_); }
    void restore() override;
    void transform(double a, double b, double c, double d, const Eigen::Vector2d& move) override;
    void clip(const Eigen::AlignedBox2d& box) override;
    /// Skips parts outside the clip.
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
/// @param height   of the sheet  @param thinnest  minimum width of lines, mm
void paintInks(QPainter& painter, const std::vector<Ink>& inks, double height, double thinnest = 0);

/// The expensive part of a printed pattern, which does not depend on the paper.
struct InkedPattern {
    std::shared_ptr<const DrawnPattern> pattern;
    std::vector<Ink> inks;      ///< of the whole pattern
    std::size_t checkFrom = 0;  ///< index of its check square's first ink; omitted in tiles
};

/// Cost: see `drawPattern`. Any thread.
std::shared_ptr<const InkedPattern> inked(std::shared_ptr<const DrawnPattern> pattern);

/// A pattern on the same paper sheets as its PDF file, for printers and previews.
class PrintedPattern {
public:
    /// Errors and cost: see planPages. Any thread.
    static Result<PrintedPattern> on(std::shared_ptr<const InkedPattern> pattern,
                                     const PdfOptions& options);

    QString title() const;
    int count() const;
    QSizeF paper(int sheet) const;  ///< mm
    /// @param painter  in mm with y down, the sheet's upper left corner at the origin
    /// @param sheet     from 0 to count() - 1
    /// @param thinnest  minimum width of lines, mm, to keep small sheets legible
    void paint(QPainter& painter, int sheet, double thinnest = 0) const;

private:
    PrintedPattern(std::shared_ptr<const InkedPattern> pattern, PdfPlan plan);

    const Drawing& drawing() const { return pattern_->pattern->drawing; }

    std::shared_ptr<const InkedPattern> pattern_;
    PdfPlan plan_;
};

/// Asks the printer for a sheet's paper, portrait or landscape. The printer may choose another: see
/// `roomLacking`.
void choosePaper(QPrinter& printer, const QSizeF& paper);

/// A sheet that does not fit on the printer's page.
struct RoomLacking {
    QSizeF paper, page;     ///< mm, of the sheet and of the printer
    bool isMargin = false;  ///< the page is large enough, but the printer's margins are too wide
};

/// The first sheet that would be clipped when centred on the printer's page, if any. Tolerates
/// paper sizes rounded to points or tenths of an inch.
std::optional<RoomLacking> roomLacking(const QPrinter& printer, const PrintedPattern& pattern);

/// Prints the requested sheets at true scale, centred on the printer's page. When cancelled, it
/// stops and removes an output file; some printers still print the pages already received.
/// @return false if the printer does not accept data
/// Errors: Cancelled. Any thread that has exclusive use of the printer.
Result<bool> print(QPrinter& printer, const PrintedPattern& pattern, Progress& progress);

}  // namespace toile::app
