// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/docs_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

namespace toile::test {
namespace {

/// Lengths are kept to rounding, which differs from machine to machine: below this they are exact.
constexpr double kExact = 1e-9;
/// Another BLAS rounds otherwise, and an iteration then stops elsewhere.
constexpr double kRelative = 5e-3;
/// A triangle of hardly any area may turn over by that.
constexpr double kOfCounts = 0.02;
/// An energy of this much is that of triangles collapsed to rounding. Which of them count as
/// flipped, and the energy is none then, rounding decides.
constexpr double kCollapsed = 1e12;

/// What stands between the markers now; nothing, with a failure, where the page has no such place.
/// With TOILE_UPDATE_DOCS in the environment the table is written there instead.
std::optional<std::string> tableInDocs(const std::string& page, const std::string& name,
                                       const std::string& table) {
    const auto path = std::filesystem::path(TOILE_SOURCE_DIR) / "docs" / page;
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string opening = "<!-- table: " + name + ", written by a test -->\n";
    const auto begin = text.find(opening);
    const auto end = text.find("<!-- end of table -->\n", begin);
    if (begin == std::string::npos || end == std::string::npos) {
        ADD_FAILURE() << path << " has no place for " << name;
        return std::nullopt;
    }
    const auto start = begin + opening.size();
    if (std::getenv("TOILE_UPDATE_DOCS") != nullptr) {
        std::ofstream(path, std::ios::binary) << text.substr(0, start) << table << text.substr(end);
        return std::nullopt;
    }
    return text.substr(start, end - start);
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);) {
        parts.push_back(part);
    }
    return parts;
}

/// A number as printed: its value and the weight of its last digit; integers have no last digit.
struct Printed {
    double value = 0;
    double lastDigit = 0;
    bool isCount = true;
};

std::optional<Printed> printedNumber(const std::string& text) {
    Printed number;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number.value);
    if (text.empty() || read.ec != std::errc() || read.ptr != end) {
        return std::nullopt;
    }
    const auto power = text.find('e');
    const auto point = text.find('.');
    number.isCount = power == std::string::npos && point == std::string::npos;
    const std::string digits = text.substr(0, power);
    const auto decimals = point == std::string::npos ? 0 : digits.size() - point - 1;
    const int exponent = power == std::string::npos ? 0 : std::stoi(text.substr(power + 1));
    number.lastDigit = std::pow(10.0, exponent - static_cast<int>(decimals));
    return number;
}

bool sameNumber(const Printed& a, const Printed& b, bool inTable) {
    const double difference = std::abs(a.value - b.value);
    const double size = std::max(std::abs(a.value), std::abs(b.value));
    if (a.isCount && b.isCount) {
        const bool none = a.value == 0 || b.value == 0;
        return difference <= (none || !inTable ? 0 : std::max(1.0, kOfCounts * size));
    }
    const double last = 1.01 * std::max(a.lastDigit, b.lastDigit);
    return size < kExact || difference <= kRelative * size + last;
}

/// What a cell holds, without the spaces around it.
std::string firstWord(const std::string& cell) {
    const auto word = cell.find_first_not_of(' ');
    return word == std::string::npos ? "" : cell.substr(word, cell.find(' ', word) - word);
}

bool isCollapsed(const std::string& cell) {
    const std::string word = firstWord(cell);
    const auto number = printedNumber(word);
    return word == "-" || (number && number->value >= kCollapsed);
}

/// Cells of rows with triangles collapsed to rounding: their energies, and their counts.
bool sameCollapsed(const std::string& x, const std::string& y) {
    const auto p = printedNumber(firstWord(x));
    const auto q = printedNumber(firstWord(y));
    return (isCollapsed(x) && isCollapsed(y)) ||
           (p && q && p->isCount && q->isCount && std::abs(p->value - q->value) <= 1);
}

/// Words alike, numbers nearly. Brackets, commas and the full stop at the end are no part of them.
bool sameWords(const std::string& a, const std::string& b, bool inTable) {
    const auto words = [](const std::string& text) {
        std::string plain = text;
        std::erase_if(plain, [](char c) { return c == '(' || c == ')' || c == ','; });
        if (plain.ends_with('.')) {
            plain.pop_back();
        }
        return split(plain, ' ');
    };
    const std::vector<std::string> ours = words(a);
    const std::vector<std::string> theirs = words(b);
    return std::ranges::equal(ours, theirs, [inTable](const auto& x, const auto& y) {
        const auto p = printedNumber(x);
        const auto q = printedNumber(y);
        return p && q ? sameNumber(*p, *q, inTable) : x == y;
    });
}

}  // namespace

void expectTableInDocs(const std::string& page, const std::string& name, const std::string& table) {
    if (const auto present = tableInDocs(page, name, table)) {
        EXPECT_EQ(*present, table) << "update it with TOILE_UPDATE_DOCS=1";
    }
}

void expectFiguresInDocs(const std::string& page, const std::string& name,
                         const std::string& table) {
    if (const auto present = tableInDocs(page, name, table)) {
        EXPECT_EQ(differingFigures(*present, table), "")
            << "in docs/" << page << ", " << name << "; update it with TOILE_UPDATE_DOCS=1";
    }
}

void updateTableInDocs(const std::string& page, const std::string& name, const std::string& table) {
    if (std::getenv("TOILE_UPDATE_DOCS")) {  // NOLINT(concurrency-mt-unsafe)
        tableInDocs(page, name, table);
    }
}

std::string differingFigures(const std::string& ours, const std::string& theirs) {
    const std::vector<std::string> a = split(ours, '\n');
    const std::vector<std::string> b = split(theirs, '\n');
    if (a.size() != b.size()) {
        return "another number of lines";
    }
    std::vector<std::string> head;
    for (std::size_t line = 0; line < a.size(); ++line) {
        const bool inTable = a[line].starts_with("|");
        const std::vector<std::string> x = inTable ? split(a[line], '|') : std::vector{a[line]};
        const std::vector<std::string> y = inTable ? split(b[line], '|') : std::vector{b[line]};
        if (!inTable) {
            head.clear();
        } else if (head.empty()) {
            head = x;
        }
        bool same = x.size() == y.size();
        const bool collapsed =
            inTable && std::ranges::any_of(x, isCollapsed) && std::ranges::any_of(y, isCollapsed);
        for (std::size_t k = 0; same && k < x.size(); ++k) {
            const bool isTime = k < head.size() && head[k].find("time") != std::string::npos;
            same = (isTime && x != head) || sameWords(x[k], y[k], inTable) ||
                   (collapsed && sameCollapsed(x[k], y[k]));
        }
        if (!same) {
            return a[line] + "\n" + b[line] + "\n";
        }
    }
    return "";
}

}  // namespace toile::test
