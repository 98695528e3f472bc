// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/pattern/fair_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/segment.h"
#include "tests/core/support/generator.h"

namespace toile::test {
namespace {

using Eigen::Vector2d;

Vector2d stepOf(const Points2& points, Eigen::Index j) {
    const Eigen::Index n = points.rows(), at = (j + n) % n;
    return points.row((at + 1) % n) - points.row(at);
}

double turnAt(const Points2& points, Eigen::Index j) {
    return geometry::turnBetween(stepOf(points, j - 1), stepOf(points, j));
}

}  // namespace

Outline rectangle(double width, double height) {
    return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

Outline noisy(const Outline& outline, double noise, unsigned seed) {
    Generator random(seed);
    Outline moved = outline;
    for (Vector2d& point : moved) {
        point.x() += random.between(-noise, noise);
        point.y() += random.between(-noise, noise);
    }
    return moved;
}

Outline divided(const Outline& outline, double step, std::vector<int>& corners) {
    Outline points;
    corners.clear();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d& from = outline[i];
        const Vector2d way = outline[(i + 1) % outline.size()] - from;
        const int parts = std::max(1, static_cast<int>(std::ceil(way.norm() / step - 1e-9)));
        corners.push_back(static_cast<int>(points.size()));
        for (int k = 0; k < parts; ++k) {
            points.push_back(from + way * k / parts);
        }
    }
    return points;
}

FairProblem fairProblem(const Outline& outline, const std::vector<int>& corners, double tolerance) {
    const Eigen::Index n = static_cast<Eigen::Index>(outline.size());
    FairProblem problem;
    problem.reference.resize(n, 2);
    for (Eigen::Index j = 0; j < n; ++j) {
        problem.reference.row(j) = outline[static_cast<std::size_t>(j)];
    }
    problem.steps.resize(n);
    for (Eigen::Index j = 0; j < n; ++j) {
        problem.steps[j] = stepOf(problem.reference, j).norm();
    }
    problem.tolerance = Eigen::VectorXd::Constant(n, tolerance);
    for (const int corner : corners) {
        problem.corners.push_back({corner, turnAt(problem.reference, corner)});
    }
    return problem;
}

FairProblem polygon(const Outline& outline, double tolerance) {
    std::vector<int> corners;
    const Outline points = divided(outline, 2, corners);
    return fairProblem(points, corners, tolerance);
}

FairProblem noisyPolygon(const Outline& outline, double noise, unsigned seed) {
    std::vector<int> corners, nodes;
    const Outline edges = noisy(divided(outline, 10, corners), noise, seed);
    const Outline points = divided(edges, 2, nodes);
    for (int& corner : corners) {
        corner = nodes[static_cast<std::size_t>(corner)];
    }
    return fairProblem(points, corners, 1);
}

FairProblem noisyCircle(double radius, double noise, unsigned seed) {
    Generator random(seed);
    Outline points;
    const int count = static_cast<int>(std::numbers::pi * radius);
    for (int j = 0; j < count; ++j) {
        const double angle = 2 * std::numbers::pi * j / count;
        const double r = radius + (j % 5 == 0 ? random.between(-noise, noise) : 0);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return fairProblem(points, {}, 1);
}

double variation(const Points2& points, const FairProblem& problem) {
    const Eigen::Index n = points.rows();
    std::vector<char> isCorner(static_cast<std::size_t>(n), 0);
    for (const FairProblem::Corner& corner : problem.corners) {
        isCorner[static_cast<std::size_t>(corner.node)] = 1;
    }
    const auto kappa = [&](Eigen::Index j) {
        return 2 * turnAt(points, j) / (stepOf(points, j - 1).norm() + stepOf(points, j).norm());
    };
    double sum = 0;
    for (Eigen::Index j = 0; j < n; ++j) {
        const Eigen::Index k = (j + 1) % n;
        if (isCorner[static_cast<std::size_t>(j)] == 0 &&
            isCorner[static_cast<std::size_t>(k)] == 0) {
            sum += std::abs(kappa(k) - kappa(j));
        }
    }
    return sum;
}

double largestLengthError(const FairLine& line, const FairProblem& problem) {
    double largest = 0;
    for (Eigen::Index j = 0; j < line.points.rows(); ++j) {
        const Vector2d step = stepOf(line.points, j);
        const double phi = line.directions[j];
        largest =
            std::max({largest, std::abs(step.norm() - problem.steps[j]),
                      (step - problem.steps[j] * Vector2d(std::cos(phi), std::sin(phi))).norm()});
    }
    return largest;
}

double largestCornerError(const FairLine& line, const FairProblem& problem) {
    const Eigen::Index n = line.directions.size();
    double largest = 0;
    for (const FairProblem::Corner& corner : problem.corners) {
        const double turn =
            line.directions[corner.node] - line.directions[(corner.node + n - 1) % n];
        largest =
            std::max(largest, std::abs(std::remainder(turn - corner.turn, 2 * std::numbers::pi)));
    }
    return largest;
}

}  // namespace toile::test
