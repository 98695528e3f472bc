// SPDX-License-Identifier: GPL-3.0-or-later
#include "obj_writer.h"

#include <cmath>

namespace toile::samples {

std::string formatDecimal(double value) {
    constexpr long long kScale = 10000;
    constexpr std::size_t kDecimals = 4;
    // Rounding the size, not the signed value, keeps mirrored pieces exact mirror images.
    const long long scaled = std::llround(std::abs(value) * static_cast<double>(kScale));
    const std::string decimals = std::to_string(scaled % kScale);
    std::string text = value < 0.0 && scaled != 0 ? "-" : "";
    text += std::to_string(scaled / kScale);
    text += '.';
    text.append(kDecimals - decimals.size(), '0');
    text += decimals;
    return text;
}

std::string writeObj(const Garment& garment) {
    std::string text = "# " + garment.description + "\n";
    text += "# Units: millimetres. +Y up, +Z front, +X the wearer's left.\n";
    text += "# Made by Toile's sample generator (resources/samples/generator).\n";
    text += "# SPDX-License-Identifier: CC0-1.0\n";
    int base = 1;
    for (const Piece& piece : garment.pieces) {
        text += "o " + piece.name + "\n";
        for (const Vec3 p : piece.vertices) {
            text += "v " + formatDecimal(p.x) + " " + formatDecimal(p.y) + " " +
                    formatDecimal(p.z) + "\n";
        }
        for (const auto [a, b, c] : piece.triangles) {
            text += "f " + std::to_string(base + a) + " " + std::to_string(base + b) + " " +
                    std::to_string(base + c) + "\n";
        }
        base += static_cast<int>(piece.vertices.size());
    }
    return text;
}

}  // namespace toile::samples
