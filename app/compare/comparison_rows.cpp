// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/comparison_rows.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "app/text/figures.h"

namespace toile {

namespace {

constexpr double kMillisecond = 1e-3;
constexpr QChar kDash(0x2013);

/// The context of the translations.
class Comparison {
    Q_DECLARE_TR_FUNCTIONS(toile::Comparison)
};

const PieceQuality* qualityOf(const ComparedPiece& piece) {
    return piece.result && piece.result->flat && piece.result->quality ? &*piece.result->quality
                                                                       : nullptr;
}

/// A figure of the piece's quality as it stands there.
template <auto Member>
std::optional<double> quality(const ComparedPiece& piece) {
    const PieceQuality* found = qualityOf(piece);
    return found ? std::optional<double>(found->*Member) : std::nullopt;
}

template <auto Member>
QString wholeNumber(const ComparedPiece& piece) {
    return QLocale().toString(qualityOf(piece)->*Member);
}

std::optional<double> stretch(const ComparedPiece& piece) {
    const PieceQuality* found = qualityOf(piece);
    return found && found->strainMax ? std::optional(std::max(0.0, *found->strainMax))
                                     : std::nullopt;
}

std::optional<double> surplus(const ComparedPiece& piece) {
    const PieceQuality* found = qualityOf(piece);
    return found && found->strainMin ? std::optional(std::max(0.0, -*found->strainMin))
                                     : std::nullopt;
}

std::optional<double> meanStrain(const ComparedPiece& piece) {
    const PieceQuality* found = qualityOf(piece);
    return found ? found->strainMeanAbs : std::nullopt;
}

std::optional<double> seconds(const ComparedPiece& piece) {
    return qualityOf(piece) ? std::optional(piece.figures.seconds) : std::nullopt;
}

QString milliseconds(const ComparedPiece& piece) {
    const double value = piece.figures.seconds / kMillisecond;
    return QLocale().toString(value, 'f', value < 100 ? 1 : 0);
}

std::vector<ComparisonRow> strainRows() {
    return {
        {Comparison::tr("Mean strain, %"),
         Comparison::tr("How far the cloth must stretch or gather, on the mean of all edges of the "
                        "mesh"),
         meanStrain,
         [](const ComparedPiece& piece) -> QString { return percent(*meanStrain(piece)); }},
        {Comparison::tr("Most stretch, %"),
         Comparison::tr("The edge of the mesh that must stretch most to take its worn shape"),
         stretch,
         [](const ComparedPiece& piece) -> QString {
             return signedPercent(*qualityOf(piece)->strainMax);
         }},
        {Comparison::tr("Most surplus, %"),
         Comparison::tr("The edge of the mesh that must gather most to take its worn shape"),
         surplus,
         [](const ComparedPiece& piece) -> QString {
             return signedPercent(*qualityOf(piece)->strainMin);
         }},
    };
}

std::vector<ComparisonRow> outlineRows() {
    return {
        {Comparison::tr("Seam Δ, %1").arg(lengthUnit()),
         Comparison::tr("The worst seam of this piece: by how much its two flat sides miss each "
                        "other, the ease taken out"),
         [](const ComparedPiece& piece) -> std::optional<double> {
             return piece.figures.seamMismatch;
         },
         [](const ComparedPiece& piece) -> QString {
             return fineLength(*piece.figures.seamMismatch);
         }},
        {Comparison::tr("Outline length error, %"),
         Comparison::tr("The edge of the outline whose length has changed most"),
         quality<&PieceQuality::maxBoundaryLengthError>,
         [](const ComparedPiece& piece) -> QString {
             return boundaryError(qualityOf(piece)->maxBoundaryLengthError);
         }},
        {Comparison::tr("Area error, %"),
         Comparison::tr("How much of the area has gone to other triangles: 0 where each has its "
                        "share of the whole, as in the garment"),
         quality<&PieceQuality::piA>,
         [](const ComparedPiece& piece) -> QString { return percent(qualityOf(piece)->piA); }},
    };
}

std::vector<ComparisonRow> otherRows() {
    return {
        {Comparison::tr("Flipped triangles"),
         Comparison::tr("Triangles that are turned over: cloth cannot do that"),
         quality<&PieceQuality::flippedTriangles>, wholeNumber<&PieceQuality::flippedTriangles>},
        {Comparison::tr("Outline crossings"), Comparison::tr("Where the outline crosses itself"),
         quality<&PieceQuality::outlineCrossings>, wholeNumber<&PieceQuality::outlineCrossings>},
        {Comparison::tr("Time, ms"),
         Comparison::tr("What the solver took for this piece, when it solved it last"), seconds,
         milliseconds},
    };
}

ComparisonRow designerRow() {
    return {Comparison::tr("To the designer’s panel, %1").arg(lengthUnit()),
            Comparison::tr("Distance to the panel that the file carries, laid on each other as "
                           "well as may be; root mean square"),
            [](const ComparedPiece& piece) -> std::optional<double> {
                return piece.figures.referenceRms;
            },
            [](const ComparedPiece& piece) -> QString {
                return fineLength(*piece.figures.referenceRms);
            }};
}

}  // namespace

std::vector<ComparisonRow> comparisonRows(bool withDesigner) {
    std::vector<ComparisonRow> rows;
    for (const std::vector<ComparisonRow>& group : {strainRows(), outlineRows()}) {
        rows.insert(rows.end(), group.begin(), group.end());
    }
    if (withDesigner) {
        rows.push_back(designerRow());
    }
    const std::vector<ComparisonRow> others = otherRows();
    rows.insert(rows.end(), others.begin(), others.end());
    return rows;
}

QString comparisonText(const ComparisonRow& row, const ComparedPiece& piece) {
    const std::optional<double> badness = row.badness(piece);
    return badness && std::isfinite(*badness) ? row.text(piece) : QString(kDash);
}

std::vector<bool> bestOf(const ComparisonRow& row,
                         const std::vector<const ComparedPiece*>& pieces) {
    const ComparedPiece* best = nullptr;
    for (const ComparedPiece* piece : pieces) {
        const auto badness = piece ? row.badness(*piece) : std::nullopt;
        if (badness && std::isfinite(*badness) && (!best || *badness < *row.badness(*best))) {
            best = piece;
        }
    }
    std::vector<bool> marks(pieces.size(), false);
    if (!best) {
        return marks;
    }
    const QString text = comparisonText(row, *best);
    bool others = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i]) {
            marks[i] = comparisonText(row, *pieces[i]) == text;
            others = others || !marks[i];
        }
    }
    return others ? marks : std::vector<bool>(pieces.size(), false);
}

}  // namespace toile
