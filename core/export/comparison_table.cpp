// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/export/comparison_writer.h"

namespace toile {
namespace {

constexpr double kMillisecondsPerSecond = 1000;
/// Above this an energy says only that the map is bad, and how many digits of it there are.
constexpr double kLongNumber = 1000;

std::string cell(const std::optional<double>& value, int decimals) {
    if (!value) {
        return "-";
    }
    return *value < kLongNumber ? fixed(*value, decimals) : scientific(*value, 1);
}

bool nothingFlat(const ComparedFigures& figures) {
    return figures.failed == figures.pieces;
}

std::string count(const ComparedFigures& figures, int ComparedFigures::*member) {
    return nothingFlat(figures) ? "-" : std::to_string(figures.*member);
}

struct Column {
    const char* head;
    std::string (*cell)(const ComparedFigures& figures);
    bool (*isNeeded)(const ComparedFigures& figures);  ///< by one row at least
};

bool always(const ComparedFigures& /*figures*/) {
    return true;
}

constexpr Column kColumns[] = {
    {"time ms",
     [](const ComparedFigures& f) {
         return nothingFlat(f) ? "-" : fixed(kMillisecondsPerSecond * f.seconds, 1);
     },
     always},
    {"Pi_theta", [](const ComparedFigures& f) { return cell(f.piTheta, 4); }, always},
    {"Pi_E", [](const ComparedFigures& f) { return cell(f.piE, 4); }, always},
    {"Pi_A", [](const ComparedFigures& f) { return cell(f.piA, 4); }, always},
    {"SD", [](const ComparedFigures& f) { return cell(f.symmetricDirichlet, 4); }, always},
    {"length error",
     [](const ComparedFigures& f) {
         return f.maxBoundaryLengthError ? scientific(*f.maxBoundaryLengthError, 1) : "-";
     },
     always},
    {"flips", [](const ComparedFigures& f) { return count(f, &ComparedFigures::flippedTriangles); },
     always},
    {"crossings",
     [](const ComparedFigures& f) { return count(f, &ComparedFigures::outlineCrossings); }, always},
    {"seam mm", [](const ComparedFigures& f) { return cell(f.seamMismatch, 2); },
     [](const ComparedFigures& f) { return f.seamMismatch.has_value(); }},
    {"rms mm", [](const ComparedFigures& f) { return cell(f.referenceRms, 2); },
     [](const ComparedFigures& f) { return f.referenceRms.has_value(); }},
    {"failed", [](const ComparedFigures& f) { return std::to_string(f.failed); },
     [](const ComparedFigures& f) { return f.failed > 0; }},
};

/// @param figures  of one method, for the table wanted
template <class Figures>
ComparisonTable makeTable(std::string title, const Comparison& comparison, const Figures& figures) {
    ComparisonTable table{std::move(title), {"method"}, {}};
    for (const ComparedMethod& method : comparison.methods) {
        table.rows.push_back({std::string(name(method.method))});
    }
    for (const Column& column : kColumns) {
        bool needed = false;
        for (const ComparedMethod& method : comparison.methods) {
            needed = needed || column.isNeeded(figures(method));
        }
        if (!needed) {
            continue;
        }
        table.head.emplace_back(column.head);
        for (std::size_t k = 0; k < comparison.methods.size(); ++k) {
            table.rows[k].push_back(column.cell(figures(comparison.methods[k])));
        }
    }
    return table;
}

std::string titleOf(const Garment& garment) {
    std::string title;
    for (const auto& file : garment.files) {
        title += (title.empty() ? "" : ", ") + file->path.filename().string();
    }
    long long triangles = 0;
    for (const auto& piece : garment.pieces) {
        triangles += piece->mesh.F.rows();
    }
    long long seams = 0;
    for (const Seam& seam : garment.seams.seams) {
        seams += seam.kind == SeamKind::Free ? 0 : 1;
    }
    title += ": " + counted(static_cast<long long>(garment.pieces.size()), "piece") + ", " +
             counted(triangles, "triangle");
    return seams > 0 ? title + ", " + counted(seams, "seam") : title;
}

/// A bar would end the cell; line ends would end the table.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '|') {
            out += '\\';
        }
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return out;
}

void appendRow(std::string& out, const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) {
        out += "| " + cell + " ";
    }
    out += "|\n";
}

void appendTable(std::string& out, const ComparisonTable& table) {
    out += escaped(table.title) + "\n\n";
    appendRow(out, table.head);
    out += "|---|";
    for (std::size_t k = 1; k < table.head.size(); ++k) {
        out += "--:|";
    }
    out += "\n";
    for (std::vector<std::string> row : table.rows) {
        row.front() = "`" + row.front() + "`";
        appendRow(out, row);
    }
}

}  // namespace

ComparisonTable comparisonTable(const Garment& garment, const Comparison& comparison) {
    return makeTable(
        titleOf(garment), comparison,
        [](const ComparedMethod& method) -> const ComparedFigures& { return method.figures; });
}

std::vector<ComparisonTable> pieceComparisonTables(const Garment& garment,
                                                   const Comparison& comparison) {
    std::vector<ComparisonTable> tables;
    for (std::size_t k = 0; k < garment.pieces.size(); ++k) {
        const Piece& piece = *garment.pieces[k];
        tables.push_back(makeTable(piece.name + ": " + counted(piece.mesh.F.rows(), "triangle"),
                                   comparison,
                                   [k](const ComparedMethod& method) -> const ComparedFigures& {
                                       return method.pieceFigures[k];
                                   }));
    }
    return tables;
}

std::string nearerSentence(const Comparison& comparison) {
    const auto nearer = nearerThanLengthKeeping(comparison);
    if (!nearer) {
        return "";
    }
    const ComparedMethod& kept = comparison.methods[nearer->lengthKeeping];
    std::string sentence = "nearer to the given panels than any method that keeps seam lengths: ";
    for (const std::size_t k : nearer->freeOutline) {
        const ComparedMethod& method = comparison.methods[k];
        const bool isFirst = k == nearer->freeOutline.front();
        sentence += (isFirst ? "" : ", ") + std::string(name(method.method)) + " (" +
                    cell(method.figures.referenceRms, 2);
        sentence += isFirst ? " mm against " + cell(kept.figures.referenceRms, 2) + " of " +
                                  std::string(name(kept.method)) + ")"
                            : " mm)";
    }
    return sentence;
}

std::string writeComparisonMarkdown(const Garment& garment, const Comparison& comparison,
                                    bool perPiece) {
    std::string out;
    appendTable(out, comparisonTable(garment, comparison));
    std::string sentence = nearerSentence(comparison);
    if (!sentence.empty()) {
        sentence.front() = 'N';
        out += "\n" + sentence + ".\n";
    }
    if (perPiece) {
        for (const ComparisonTable& table : pieceComparisonTables(garment, comparison)) {
            out += "\n";
            appendTable(out, table);
        }
    }
    return out;
}

}  // namespace toile
