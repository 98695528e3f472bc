// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/plt_writer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/text.h"
#include "core/export/placed_text.h"
#include "core/export/plotter_line.h"

namespace toile {
namespace {

constexpr int kCutPen = 1, kLinePen = 2, kLetterPen = 3;
constexpr Eigen::Index kMaxInList = 64;  // points: buffer size of old plotters
constexpr int kPerLetterCurve = 4;       // points

class PltWriter {
public:
    PltWriter(const Drawing& drawing, const PltOptions& options)
        : drawing_(drawing), options_(options) {}

    std::string write() {
        bytes_ = "IN;PA;";
        for (const DrawnText& text : drawing_.texts) {
            for (const std::vector<CubicCurve>& contour : placedOutlines(text)) {
                add(kLetterPen, letterLine(contour));
            }
        }
        for (const DrawnPath& path : drawing_.paths) {
            if (path.layer != LayerKind::Cut) {
                add(kLinePen, plotterLine(placed(path.points), path.closed));
            }
        }
        // Reverse order: a piece's holes come after its outline in the drawing.
        for (auto path = drawing_.paths.rbegin(); path != drawing_.paths.rend(); ++path) {
            if (path->layer == LayerKind::Cut) {
                add(kCutPen, plotterLine(placed(path->points), path->closed));
            }
        }
        return bytes_ + "PU0,0;SP0;";
    }

private:
    Points2 placed(const Points2& line) const {
        Points2 moved = line;
        if (options_.turned) {
            moved.col(0) = drawing_.height - line.col(1).array();
            moved.col(1) = line.col(0);
        }
        return moved.cwiseMax(0);  // for letters that extend beyond the page
    }

    /// The line of a letter, whose length is irrelevant: rounded, without repeated points.
    Points2 letterLine(const std::vector<CubicCurve>& contour) const {
        Points2 units(static_cast<Eigen::Index>(contour.size()) * (kPerLetterCurve + 1), 2);
        Eigen::Index count = 0;
        for (const CubicCurve& curve : contour) {
            const int points = curve.isLine ? 1 : kPerLetterCurve;
            const Points2 line = placed(sampled({curve}, points));
            for (Eigen::Index k = 0; k <= points; ++k) {
                units.row(count) = (kPlotterUnits * line.row(k)).array().round();
                const bool isNew = count == 0 || units.row(count) != units.row(count - 1);
                count += isNew ? 1 : 0;
            }
        }
        return units.topRows(count);
    }

    void add(int pen, const Points2& units) {
        if (units.rows() == 0) {
            return;
        }
        if (pen != pen_) {
            bytes_ += "SP" + std::to_string(pen) + ';';
            pen_ = pen;
        }
        bytes_ += "PU";
        append(units, 0);
        for (Eigen::Index k = 1; k < units.rows(); ++k) {
            bytes_ += k % kMaxInList == 1 ? ";PD" : ",";
            append(units, k);
        }
        bytes_ += ";PU;";
    }

    void append(const Points2& units, Eigen::Index k) {
        appendFixed(bytes_, units(k, 0), 0);
        bytes_ += ',';
        appendFixed(bytes_, units(k, 1), 0);
    }

    const Drawing& drawing_;
    const PltOptions& options_;
    std::string bytes_;
    int pen_ = 0;
};

}  // namespace

std::string writePlt(const Drawing& drawing, const PltOptions& options) {
    return PltWriter(drawing, options).write();
}

}  // namespace toile
