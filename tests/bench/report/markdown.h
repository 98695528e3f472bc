// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace toile::bench {

/// A table as Markdown: its first column to the left, figures to the right. Without rows it is
/// nothing.
class MarkdownTable {
public:
    explicit MarkdownTable(std::vector<std::string> heads) : heads_(std::move(heads)) {}

    /// As many cells as heads.
    void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
    bool empty() const { return rows_.empty(); }
    /// With a blank line after it.
    std::string text() const;

private:
    std::vector<std::string> heads_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace toile::bench
