// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/seam_summary.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "app/base/translate.h"
#include "app/text/figures.h"
#include "app/text/seam_fit.h"

namespace toile {

namespace {

struct Tally {
    int seams = 0, measured = 0, nearly = 0, differ = 0;
    double worst = 0;  ///< mm
};

Tally tallyOf(const SeamGraph& graph, const std::vector<std::optional<SeamMeasure>>& measures) {
    Tally tally;
    for (std::size_t i = 0; i < measures.size(); ++i) {
        if (graph.seams[i].kind == SeamKind::Free) {
            continue;
        }
        ++tally.seams;
        if (measures[i]) {
            ++tally.measured;
            tally.worst = std::max(tally.worst, std::abs(measures[i]->errorMm));
        }
        const SeamFit fit = seamFit(graph.seams[i], measures[i]);
        tally.nearly += fit == SeamFit::Nearly;
        tally.differ += fit == SeamFit::Differs;
    }
    return tally;
}

}  // namespace

QString seamSummary(const SeamGraph& graph,
                    const std::vector<std::optional<SeamMeasure>>& measures) {
    const Tally tally = tallyOf(graph, measures);
    if (tally.seams == 0) {
        return {};
    }
    QStringList parts = {tally.seams == 1 ? tr("1 seam") : tr("%1 seams").arg(tally.seams)};
    if (tally.measured == 0) {
        parts << tr("not measured yet");
        return parts.join(QString::fromUtf8(" · "));
    }
    if (tally.differ > 0) {
        parts << (tally.differ == 1 ? tr("1 does not match")
                                    : tr("%1 do not match").arg(tally.differ));
    }
    if (tally.nearly > 0) {
        parts << (tally.nearly == 1 ? tr("1 nearly matches")
                                    : tr("%1 nearly match").arg(tally.nearly));
    }
    parts << tr("worst %1 %2").arg(fineLength(tally.worst), lengthUnit());
    if (tally.measured < tally.seams) {
        parts << tr("%1 not measured: a piece is not flat").arg(tally.seams - tally.measured);
    }
    return parts.join(QString::fromUtf8(" · "));
}

}  // namespace toile
