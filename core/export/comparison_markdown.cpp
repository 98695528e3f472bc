// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/comparison_writer.h"

namespace toile {
namespace {

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
