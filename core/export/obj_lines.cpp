// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/export/writers.h"

namespace toile {
namespace {

/// The layers of a drawing that are added to a UV map, with their names there.
constexpr std::array kObjLayers{std::pair(LayerKind::Cut, "pattern_cut"),
                                std::pair(LayerKind::Sew, "pattern_sew"),
                                std::pair(LayerKind::Notches, "pattern_notches"),
                                std::pair(LayerKind::Internal, "pattern_internal")};

void appendPath(std::string& out, const DrawnPath& path, double unit) {
    const Eigen::Index count = path.points.rows();
    for (Eigen::Index k = 0; k < count; ++k) {
        out += "v ";
        appendShortest(out, (path.points(k, 0) - kDrawingMargin) / unit);
        out += ' ';
        appendShortest(out, (path.points(k, 1) - kDrawingMargin) / unit);
        out += " 0\n";
    }
    out += 'l';  // counted back from here
    for (Eigen::Index k = count; k > 0; --k) {
        out += " -" + std::to_string(k);
    }
    out += path.closed ? " -" + std::to_string(count) + "\n" : "\n";
}

}  // namespace

std::string writeObjLines(const Drawing& drawing, double unit) {
    std::string out =
        "# the lines of the pattern, where its UV map lies, in the unit of the mesh\n";
    for (const auto& [layer, name] : kObjLayers) {
        if (!hasLayer(drawing, layer)) {
            continue;
        }
        out += std::string("o ") + name + "\n";
        for (const DrawnPath& path : drawing.paths) {
            if (path.layer == layer) {
                appendPath(out, path, unit);
            }
        }
    }
    return out;
}

}  // namespace toile
