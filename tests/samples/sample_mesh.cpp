// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_mesh.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace toile::samples {

namespace {

using Direction = std::array<double, 3>;

Direction from(const Place& a, const Place& b) {
    constexpr double kMillimetre = 1e-4;
    Direction d{};
    for (std::size_t k = 0; k < 3; ++k) {
        d[k] = static_cast<double>(b[k] - a[k]) * kMillimetre;
    }
    return d;
}

double dot(const Direction& a, const Direction& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// "-12.3456" as -123456.
long long readFourDecimals(const std::string& text) {
    const std::size_t point = text.find('.');
    const bool negative = text.front() == '-';
    if (point == std::string::npos || text.size() != point + 5 || text == "-0.0000") {
        throw std::runtime_error("not a number with four decimals: " + text);
    }
    std::string digits = text;
    digits.erase(point, 1);
    digits.erase(0, negative ? 1 : 0);
    if (digits.find_first_not_of("0123456789") != std::string::npos) {
        throw std::runtime_error("not a number with four decimals: " + text);
    }
    return (negative ? -1 : 1) * std::stoll(digits);
}

}  // namespace

std::string readBytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw std::runtime_error("cannot read " + path.string());
    }
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

std::vector<SamplePiece> readSample(const std::filesystem::path& path) {
    std::istringstream text(readBytes(path));
    std::vector<SamplePiece> pieces;
    int before = 0;  // vertices of earlier pieces
    std::string line;
    while (std::getline(text, line)) {
        std::istringstream words(line);
        std::string kind;
        std::array<std::string, 3> word;
        words >> kind >> word[0];
        if (kind == "#") {
            continue;
        }
        if (kind == "o") {
            before += pieces.empty() ? 0 : static_cast<int>(pieces.back().vertices.size());
            pieces.push_back({word[0], {}, {}});
            continue;
        }
        words >> word[1] >> word[2];
        if (!words || pieces.empty() || line.back() == '\r' || !(words >> std::ws).eof()) {
            throw std::runtime_error("unexpected line: " + line);
        }
        SamplePiece& piece = pieces.back();
        if (kind == "v") {
            piece.vertices.push_back(
                {readFourDecimals(word[0]), readFourDecimals(word[1]), readFourDecimals(word[2])});
        } else if (kind == "f") {
            std::array<int, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k] = std::stoi(word[k]) - 1 - before;
                if (corners[k] < 0 || corners[k] >= static_cast<int>(piece.vertices.size())) {
                    throw std::runtime_error("face leaves its piece: " + line);
                }
            }
            piece.triangles.push_back(corners);
        } else {
            throw std::runtime_error("unexpected line: " + line);
        }
    }
    return pieces;
}

std::vector<SamplePiece> loadSample(const std::string& name) {
    return readSample(std::filesystem::path(TOILE_SAMPLES_DIR) / (name + ".obj"));
}

const SamplePiece& pieceNamed(const std::vector<SamplePiece>& pieces, const std::string& name) {
    for (const SamplePiece& piece : pieces) {
        if (piece.name == name) {
            return piece;
        }
    }
    throw std::runtime_error("no piece named " + name);
}

std::vector<std::string> sampleNames() {
    return {"tshirt", "bodice", "trousers", "cap", "skirt"};
}

std::string otherSide(std::string name) {
    const std::string left = "_left";
    const std::string right = "_right";
    if (name.ends_with(left)) {
        name.replace(name.size() - left.size(), left.size(), right);
    } else if (name.ends_with(right)) {
        name.replace(name.size() - right.size(), right.size(), left);
    }
    return name;
}

double distanceBetween(const Place& a, const Place& b) {
    const Direction d = from(a, b);
    return std::sqrt(dot(d, d));
}

double angleAt(const Place& a, const Place& b, const Place& c) {
    const Direction u = from(a, b);
    const Direction v = from(a, c);
    const Direction normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                           u[0] * v[1] - u[1] * v[0]};
    return std::atan2(std::sqrt(dot(normal, normal)), dot(u, v));
}

std::map<Side, int> countSides(const SamplePiece& piece) {
    std::map<Side, int> sides;
    for (const auto& [a, b, c] : piece.triangles) {
        ++sides[{a, b}];
        ++sides[{b, c}];
        ++sides[{c, a}];
    }
    return sides;
}

std::vector<Side> outlineSides(const SamplePiece& piece) {
    const std::map<Side, int> sides = countSides(piece);
    std::vector<Side> outline;
    for (const auto& [side, count] : sides) {
        if (!sides.contains({side.second, side.first})) {
            outline.push_back(side);
        }
    }
    return outline;
}

}  // namespace toile::samples
