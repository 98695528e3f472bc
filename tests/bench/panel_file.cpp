// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/panel_file.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/base/file.h"
#include "core/base/text.h"
#include "tests/bench/bench_pieces.h"

namespace toile::bench {
namespace {

constexpr int kCells = 330;  // along each side, two triangles each

void appendNumbers(std::string& text, const char* keyword, std::initializer_list<double> numbers) {
    text += keyword;
    for (const double number : numbers) {
        text += ' ';
        appendFixed(text, number, 6);
    }
    text += '\n';
}

void appendFace(std::string& text, int a, int b, int c) {
    text += 'f';
    for (const int corner : {a, b, c}) {
        const std::string index = std::to_string(corner + 1);
        text.append(" ").append(index).append("/").append(index);
    }
    text += '\n';
}

/// A square of cloth of 1 m, in centimetres, hanging in folds.
std::string panelText() {
    std::string text = "# a panel\nmtllib panel.mtl\no panel\ng panel\n";
    const auto part = [](int index) { return static_cast<double>(index) / kCells; };
    for (int row = 0; row <= kCells; ++row) {
        for (int column = 0; column <= kCells; ++column) {
            const double x = part(column), y = part(row);
            appendNumbers(text, "v", {100 * x - 50, 120 - 100 * y, 4 * y * std::sin(40 * x + y)});
        }
    }
    for (int row = 0; row <= kCells; ++row) {
        for (int column = 0; column <= kCells; ++column) {
            appendNumbers(text, "vt", {part(column), part(row)});
        }
    }
    text += "usemtl cotton\ns 1\n";
    for (int row = 0; row < kCells; ++row) {
        for (int column = 0; column < kCells; ++column) {
            const int a = row * (kCells + 1) + column, b = a + kCells + 1;
            appendFace(text, a, b, b + 1);
            appendFace(text, a, b + 1, a + 1);
        }
    }
    return text;
}

}  // namespace

PanelFile::PanelFile() : path_(temporaryFolder() / "folded_panel.obj") {
    if (const Result<void> written = writeFile(path_, panelText()); !written) {
        throw std::runtime_error(sentence(written.error()));
    }
}

}  // namespace toile::bench
