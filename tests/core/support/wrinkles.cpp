// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/wrinkles.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace toile::test {
namespace {

constexpr double kSpacing = 60, kLowest = 5, kHighest = 7.5;  // mm
/// Standard deviation of a bump's Gaussian, mm, from the narrowest one to the widest. At half its
/// height a bump is 2.35 times as wide.
constexpr double kNarrowest = 12, kWidest = 20;

/// In [0, 1), the same for the same number everywhere.
double share(unsigned number) {
    number = (number ^ 61U) ^ (number >> 16U);
    number *= 9U;
    number ^= number >> 4U;
    number *= 0x27d4eb2dU;
    number ^= number >> 15U;
    return static_cast<double>(number) / 4294967296.0;
}

struct Bump {
    Eigen::Vector3d at;
    double height = 0, width = 0;
};

}  // namespace

std::filesystem::path writeWrinkled(const std::filesystem::path& obj, double millimetres,
                                    const std::filesystem::path& folder, double widening) {
    std::vector<std::string> lines;
    std::vector<Eigen::Vector3d> points;
    std::ifstream in(obj);
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("v ")) {
            std::istringstream numbers(line.substr(2));
            Eigen::Vector3d& point = points.emplace_back();
            numbers >> point.x() >> point.y() >> point.z();
            point *= millimetres;
        }
        lines.push_back(std::move(line));
    }
    std::vector<Eigen::Vector3d> normals(points.size(), Eigen::Vector3d::Zero());
    for (const std::string& line : lines) {
        if (!line.starts_with("f ")) {
            continue;
        }
        std::istringstream words(line.substr(2));
        std::vector<std::size_t> face;
        for (std::string word; words >> word;) {
            face.push_back(static_cast<std::size_t>(std::stol(word)) - 1);
        }
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            const Eigen::Vector3d normal =
                (points[face[k]] - points[face[0]]).cross(points[face[k + 1]] - points[face[0]]);
            for (const std::size_t corner : {face[0], face[k], face[k + 1]}) {
                normals[corner] += normal;
            }
        }
    }
    std::vector<Bump> bumps;
    for (const Eigen::Vector3d& point : points) {
        bool isFree = true;
        for (const Bump& bump : bumps) {
            isFree = isFree && (bump.at - point).norm() > kSpacing;
        }
        if (isFree) {
            const auto number = static_cast<unsigned>(bumps.size());
            const double height = kLowest + (kHighest - kLowest) * share(2 * number);
            bumps.push_back(
                {point, number % 2 == 0 ? height : -height,
                 widening * (kNarrowest + (kWidest - kNarrowest) * share(2 * number + 1))});
        }
    }
    const std::filesystem::path made = folder / obj.filename();
    std::ofstream out(made);
    std::size_t v = 0;
    for (const std::string& line : lines) {
        if (!line.starts_with("v ")) {
            out << line << '\n';
            continue;
        }
        double height = 0;
        for (const Bump& bump : bumps) {
            const double away = (points[v] - bump.at).norm() / bump.width;
            height += away < 6 ? bump.height * std::exp(-0.5 * away * away) : 0;
        }
        const Eigen::Vector3d moved = (points[v] + height * normals[v].normalized()) / millimetres;
        std::array<char, 96> text{};
        std::snprintf(text.data(), text.size(), "v %.9g %.9g %.9g\n", moved.x(), moved.y(),
                      moved.z());
        out << text.data();
        ++v;
    }
    return made;
}

}  // namespace toile::test
