// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/random_piece.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/core/support/generator.h"

namespace toile::test {
namespace {

using Face = std::array<int, 3>;
constexpr double kTurn = 2 * std::numbers::pi;

/// The distance of the outline from the middle as a function of the direction: a few waves.
class StarShape {
public:
    explicit StarShape(Generator& random) {
        const double strength = random.between(0, 0.8);
        for (int k = 0; k < 4; ++k) {
            waves_.push_back({static_cast<double>(random.whole(1, 3 + 2 * k)),
                              random.between(0, kTurn), strength * random.between(0, 0.5)});
        }
    }

    double radius(double angle) const {
        double r = 1;
        for (const auto& [times, phase, height] : waves_) {
            r += height * std::cos(times * angle + phase);
        }
        return std::max(r, 0.15);
    }

private:
    std::vector<std::array<double, 3>> waves_;
};

/// A mesh in the plane, in a square of about two by two.
struct FlatMesh {
    std::vector<Eigen::RowVector2d> points;
    std::vector<Face> faces;
};

/// Of some triangles those that make a disk around a first one: a triangle joins where it keeps
/// what is there a disk.
class DiskGrower {
public:
    explicit DiskGrower(const std::vector<Face>& faces) : faces_(faces) {}

    std::vector<Face> grow(const std::vector<bool>& wanted, std::size_t first) {
        std::vector<bool> taken(faces_.size(), false);
        take(faces_[first]);
        taken[first] = true;
        for (bool grew = true; grew;) {
            grew = false;
            for (std::size_t f = 0; f < faces_.size(); ++f) {
                if (wanted[f] && !taken[f] && fits(faces_[f])) {
                    take(faces_[f]);
                    taken[f] = grew = true;
                }
            }
        }
        std::vector<Face> disk;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            if (taken[f]) {
                disk.push_back(faces_[f]);
            }
        }
        return disk;
    }

private:
    bool fits(const Face& face) const {
        int shared = 0;
        int loose = -1;  // the corner opposite to a shared side
        for (int k = 0; k < 3; ++k) {
            if (uses_.contains(std::minmax(face[k], face[(k + 1) % 3]))) {
                ++shared;
                loose = face[(k + 2) % 3];
            }
        }
        return shared == 2 || (shared == 1 && !corners_.contains(loose));
    }

    void take(const Face& face) {
        for (int k = 0; k < 3; ++k) {
            ++uses_[std::minmax(face[k], face[(k + 1) % 3])];
            ++corners_[face[k]];
        }
    }

    const std::vector<Face>& faces_;
    std::map<std::pair<int, int>, int> uses_;
    std::map<int, int> corners_;
};

/// A grid with jittered points, from whose middle a disk grows up to the star's outline.
FlatMesh gridMesh(Generator& random) {
    const int columns = random.whole(6, 26);
    const int rows = random.whole(6, 26);
    const double jitter = random.between(0, 0.45);
    const StarShape star(random);
    FlatMesh mesh;
    for (int r = 0; r <= rows; ++r) {
        for (int c = 0; c <= columns; ++c) {
            mesh.points.emplace_back(-1.4 + 2.8 * (c + jitter * random.between(-1, 1)) / columns,
                                     -1.4 + 2.8 * (r + jitter * random.between(-1, 1)) / rows);
        }
    }
    std::vector<Face> all;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const int a = r * (columns + 1) + c;
            const int d = a + columns + 1;
            if (random.chance(0.5)) {
                all.push_back({a, a + 1, d});
                all.push_back({a + 1, d + 1, d});
            } else {
                all.push_back({a, a + 1, d + 1});
                all.push_back({a, d + 1, d});
            }
        }
    }
    std::vector<bool> wanted;
    std::size_t innermost = 0;
    double nearest = 1e9;
    for (const Face& face : all) {
        const Eigen::RowVector2d middle =
            (mesh.points[face[0]] + mesh.points[face[1]] + mesh.points[face[2]]) / 3;
        if (middle.norm() < nearest) {
            nearest = middle.norm();
            innermost = wanted.size();
        }
        wanted.push_back(middle.norm() < star.radius(std::atan2(middle.y(), middle.x())));
    }
    mesh.faces = DiskGrower(all).grow(wanted, innermost);
    return mesh;
}

/// Rings of random radii and counts around a middle point, zipped to each other.
FlatMesh ringMesh(Generator& random) {
    const int rings = random.whole(2, 8);
    const StarShape star(random);
    const double jitter = random.between(0, 0.4);
    FlatMesh mesh;
    mesh.points.emplace_back(0, 0);
    std::vector<int> before{0};
    std::vector<double> anglesBefore{0};
    double share = 0;
    for (int ring = 1; ring <= rings; ++ring) {
        share += random.between(0.3, 1.7);
        const int count = random.whole(4 + 2 * ring, 6 + 6 * ring);
        std::vector<int> here;
        std::vector<double> angles;
        for (int k = 0; k < count; ++k) {
            angles.push_back(kTurn * (k + jitter * random.between(-1, 1) + 0.5) / count);
            here.push_back(static_cast<int>(mesh.points.size()));
            mesh.points.push_back(
                share * star.radius(angles.back()) *
                Eigen::RowVector2d(std::cos(angles.back()), std::sin(angles.back())));
        }
        if (ring == 1) {
            for (int k = 0; k < count; ++k) {
                mesh.faces.push_back({0, here[k], here[(k + 1) % count]});
            }
        } else {
            const auto inner = static_cast<int>(before.size());
            int i = 0;
            int j = 0;
            while (i < inner || j < count) {  // the side that is behind takes the next step
                const double nextInner =
                    i < inner ? anglesBefore[(i + 1) % inner] + (i + 1 == inner ? kTurn : 0) : 1e9;
                const double nextOuter =
                    j < count ? angles[(j + 1) % count] + (j + 1 == count ? kTurn : 0) : 1e9;
                if (nextInner < nextOuter) {
                    mesh.faces.push_back(
                        {before[i % inner], here[j % count], before[(i + 1) % inner]});
                    ++i;
                } else {
                    mesh.faces.push_back(
                        {before[i % inner], here[j % count], here[(j + 1) % count]});
                    ++j;
                }
            }
        }
        before = here;
        anglesBefore = angles;
    }
    for (Eigen::RowVector2d& p : mesh.points) {
        p /= share;
    }
    return mesh;
}

/// Heights over the plane: waves and bumps.
class Relief {
public:
    explicit Relief(Generator& random) {
        const double strength = std::pow(10, random.between(-1.5, 0.6));
        for (int k = 0; k < 3; ++k) {
            waves_.push_back({random.between(-4, 4), random.between(-4, 4),
                              random.between(0, kTurn), strength * random.between(0, 0.4)});
            bumps_.push_back({random.between(-1, 1), random.between(-1, 1),
                              random.between(0.2, 0.8), strength * random.between(-1, 1)});
        }
    }

    double height(const Eigen::RowVector2d& p) const {
        double z = 0;
        for (const auto& [x, y, phase, height] : waves_) {
            z += height * std::sin(x * p.x() + y * p.y() + phase);
        }
        for (const auto& [x, y, width, height] : bumps_) {
            z += height * std::exp(-(p - Eigen::RowVector2d(x, y)).squaredNorm() / (width * width));
        }
        return z;
    }

private:
    std::vector<std::array<double, 4>> waves_, bumps_;
};

}  // namespace

MeshArrays randomPiece(unsigned seed) {
    Generator random(seed);
    const FlatMesh flat = random.chance(0.6) ? gridMesh(random) : ringMesh(random);
    const Relief relief(random);
    const double edge = 2 / std::sqrt(0.5 * static_cast<double>(flat.faces.size()) + 1);
    const double noise = random.chance(0.35) ? edge * random.between(0, 0.8) : 0;
    const double scale = std::pow(10, random.between(-3, 3));
    MeshArrays mesh{{}, Triangles(static_cast<int>(flat.faces.size()), 3)};
    std::map<int, int> index;  // vertices that are used, in order of use
    std::vector<Eigen::RowVector3d> V;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const Eigen::RowVector2d& p = flat.points[flat.faces[f][k]];
            const auto [it, isNew] = index.emplace(flat.faces[f][k], static_cast<int>(V.size()));
            if (isNew) {
                const double x = p.x() + noise * random.between(-1, 1);
                const double y = p.y() + noise * random.between(-1, 1);
                V.emplace_back(x, y, relief.height(p) + noise * random.between(-1, 1));
            }
            mesh.F(f, k) = it->second;
        }
    }
    mesh.V.resize(static_cast<int>(V.size()), 3);
    for (std::size_t v = 0; v < V.size(); ++v) {
        mesh.V.row(static_cast<int>(v)) = scale * V[v];
    }
    return mesh;
}

}  // namespace toile::test
