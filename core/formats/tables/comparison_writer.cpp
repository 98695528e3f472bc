// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/tables/comparison_writer.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/base/version.h"
#include "core/formats/json.h"

namespace toile {
namespace {

constexpr int kComparisonVersion = 1;  // increased when a field changes its meaning or is removed

/// The figures that garments and pieces have in common; null if there are none.
void addFigures(Json& json, const ComparedFigures& figures) {
    for (const CriterionTraits& criterion : allCriteria()) {
        if (!criterion.key.empty()) {
            const std::optional<double>& value = figures[criterion.criterion];
            const bool isCount = value && criterion.format == FigureFormat::Count;
            json[std::string(criterion.key)] =
                isCount ? Json(static_cast<int>(*value)) : number(value);
        }
    }
}

Json pieceJson(const PieceResult& result, const ComparedFigures& figures) {
    Json json{{"name", result.piece->name},
              {"status", text(statusOf(result))},
              {"error", result.error ? errorJson(*result.error) : Json(nullptr)},
              {"triangles", result.piece->mesh.F.rows()}};
    addFigures(json, figures);
    return json;
}

Json methodJson(const ComparedMethod& method) {
    Json json{{"method", text(name(method.method))},
              {"keeps_lengths", traits(method.method).keepsLengths},
              {"pieces_flat", method.figures.pieces - method.figures.failed},
              {"failed", method.figures.failed},
              {"pieces_with_reference", method.figures.referencedPieces}};
    addFigures(json, method.figures);
    json["pieces"] = Json::array();
    for (std::size_t k = 0; k < method.results.size(); ++k) {
        json["pieces"].push_back(pieceJson(*method.results[k], method.pieceFigures[k]));
    }
    return json;
}

}  // namespace

std::string writeComparison(const Garment& garment, const Comparison& comparison) {
    Json json{{"version", kComparisonVersion}, {"toile", text(version())}};
    json["files"] = filesJson(garment, {});
    json["methods"] = Json::array();
    for (const ComparedMethod& method : comparison.methods) {
        json["methods"].push_back(methodJson(method));
    }
    json["nearer_than_length_keeping"] = Json::array();
    if (const auto nearer = nearerThanLengthKeeping(comparison)) {
        for (const std::size_t k : nearer->freeOutline) {
            json["nearer_than_length_keeping"].push_back(text(name(comparison.methods[k].method)));
        }
    }
    json["problems"] = problemsJson(garment);
    return jsonText(json);
}

namespace {

constexpr double kMillisecondsPerSecond = 1000;
/// Above this an energy only shows that the map is bad; its order of magnitude is enough.
constexpr double kLongNumber = 1000;

std::string decimal(double value, int decimals) {
    return value < kLongNumber ? fixed(value, decimals) : scientific(value, 1);
}

std::string cell(const CriterionTraits& criterion, const ComparedFigures& figures) {
    const std::optional<double>& value = figures[criterion.criterion];
    if (!value) {
        return "-";
    }
    switch (criterion.format) {
        case FigureFormat::Seconds:
            return fixed(kMillisecondsPerSecond * *value, 1);
        case FigureFormat::LengthError:
            return scientific(*value, 1);
        case FigureFormat::Count:
            return std::to_string(static_cast<int>(*value));
        case FigureFormat::Millimetres:
            return decimal(*value, 2);
        case FigureFormat::Ratio:
        case FigureFormat::SignedRatio:
            break;
    }
    return decimal(*value, 4);
}

/// @param rows  the figures of each method, for the table wanted
ComparisonTable makeTable(std::string title, const Comparison& comparison,
                          const std::vector<const ComparedFigures*>& rows) {
    ComparisonTable table{std::move(title), {"method"}, {}};
    for (const ComparedMethod& method : comparison.methods) {
        table.rows.push_back({std::string(name(method.method))});
    }
    const auto addColumn = [&](std::string_view head, const auto& cellOf) {
        table.head.emplace_back(head);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            table.rows[k].push_back(cellOf(*rows[k]));
        }
    };
    for (const CriterionTraits& criterion : allCriteria()) {
        const bool isKnown = std::ranges::any_of(rows, [&](const ComparedFigures* row) {
            return (*row)[criterion.criterion].has_value();
        });
        if (!criterion.head.empty() && (isKnown || !criterion.isOptional)) {
            addColumn(criterion.head,
                      [&](const ComparedFigures& row) { return cell(criterion, row); });
        }
    }
    if (std::ranges::any_of(rows, [](const ComparedFigures* row) { return row->failed > 0; })) {
        addColumn("failed", [](const ComparedFigures& row) { return std::to_string(row.failed); });
    }
    return table;
}

/// Whether the user excluded the piece, so there are no figures for it.
bool isLeftOut(const Comparison& comparison, std::size_t piece) {
    return std::ranges::any_of(comparison.methods, [piece](const ComparedMethod& method) {
        return toile::isLeftOut(*method.results[piece]);
    });
}

std::string titleOf(const Garment& garment, const Comparison& comparison) {
    std::string title;
    for (const auto& file : garment.files) {
        title += (title.empty() ? "" : ", ") + file->path.filename().string();
    }
    long long triangles = 0, pieces = 0;
    for (std::size_t k = 0; k < garment.pieces.size(); ++k) {
        if (!isLeftOut(comparison, k)) {
            ++pieces;
            triangles += garment.pieces[k]->mesh.F.rows();
        }
    }
    long long seams = 0;
    for (const Seam& seam : garment.seams.seams) {
        seams += seam.kind == SeamKind::Free ? 0 : 1;
    }
    title += ": " + counted(pieces, "piece") + ", " + counted(triangles, "triangle");
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

std::vector<ComparisonTable> comparisonTables(const Garment& garment, const Comparison& comparison,
                                              bool perPiece) {
    std::vector<const ComparedFigures*> rows;
    for (const ComparedMethod& method : comparison.methods) {
        rows.push_back(&method.figures);
    }
    std::vector<ComparisonTable> tables{makeTable(titleOf(garment, comparison), comparison, rows)};
    for (std::size_t k = 0; perPiece && k < garment.pieces.size(); ++k) {
        if (isLeftOut(comparison, k)) {
            continue;
        }
        const Piece& piece = *garment.pieces[k];
        for (std::size_t m = 0; m < rows.size(); ++m) {
            rows[m] = &comparison.methods[m].pieceFigures[k];
        }
        tables.push_back(makeTable(piece.name + ": " + counted(piece.mesh.F.rows(), "triangle"),
                                   comparison, rows));
    }
    return tables;
}

std::string nearerSentence(const Comparison& comparison) {
    const auto nearer = nearerThanLengthKeeping(comparison);
    if (!nearer) {
        return "";
    }
    const auto rms = [](const ComparedMethod& method) {
        return cell(traits(Criterion::ReferenceRms), method.figures);
    };
    const ComparedMethod& kept = comparison.methods[nearer->lengthKeeping];
    std::string sentence = "closer to the given panels than any method that keeps seam lengths: ";
    for (const std::size_t k : nearer->freeOutline) {
        const ComparedMethod& method = comparison.methods[k];
        const bool isFirst = k == nearer->freeOutline.front();
        sentence += (isFirst ? "" : ", ") + std::string(name(method.method)) + " (" + rms(method);
        sentence += isFirst
                        ? " mm against " + rms(kept) + " of " + std::string(name(kept.method)) + ")"
                        : " mm)";
    }
    return sentence;
}

std::string writeComparisonMarkdown(const Garment& garment, const Comparison& comparison,
                                    bool perPiece) {
    std::string sentence = nearerSentence(comparison);
    if (!sentence.empty()) {
        sentence.front() = 'C';
        sentence = "\n" + sentence + ".\n";
    }
    std::string out;
    for (const ComparisonTable& table : comparisonTables(garment, comparison, perPiece)) {
        out += out.empty() ? "" : "\n";
        appendTable(out, table);
        out += std::exchange(sentence, "");  // below the first table
    }
    return out;
}

}  // namespace toile
