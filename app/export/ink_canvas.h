// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>
#include <QPen>
#include <QTransform>
#include <optional>
#include <span>
#include <vector>

#include "core/export/sheet_canvas.h"

class QPainter;

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

}  // namespace toile::app
