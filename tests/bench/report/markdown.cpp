// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/markdown.h"

namespace toile::bench {
namespace {

std::string rowOf(const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells) {
        row += " " + cell + " |";
    }
    return row + "\n";
}

}  // namespace

std::string MarkdownTable::text() const {
    if (rows_.empty()) {
        return "";
    }
    std::string text = rowOf(heads_) + "|---|";
    for (std::size_t k = 1; k < heads_.size(); ++k) {
        text += "--:|";
    }
    text += "\n";
    for (const auto& row : rows_) {
        text += rowOf(row);
    }
    return text + "\n";
}

}  // namespace toile::bench
