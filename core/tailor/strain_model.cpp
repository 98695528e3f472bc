// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/strain_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/mesh/cotangents.h"

namespace toile {
namespace {

/// Limit of |log|: length factors beyond e^3 are not distinguished.
constexpr double kMaxLog = 3;
/// A vertex with a smaller coupling to others is ignored.
constexpr double kLoose = 1e-9;
/// On garments an isometric map needs about this share of a conformal map's strain.
constexpr double kIsometricPart = 0.45;
constexpr double kPassedOver = 0.001;  ///< of the area

}  // namespace

StrainFigures strainFigures(std::vector<std::pair<double, double>> strainsAndAreas) {
    StrainFigures figures;
    double area = 0;
    for (auto& [strain, around] : strainsAndAreas) {
        strain = std::abs(strain);
        figures.mean += around * strain;
        area += around;
    }
    figures.mean /= area > 0 ? area : 1;
    std::ranges::sort(strainsAndAreas, std::ranges::greater{});
    double above = 0;
    for (const auto& [strain, around] : strainsAndAreas) {
        above += around;
        if (above > kPassedOver * area) {
            figures.most = strain;
            break;
        }
    }
    return figures;
}

StrainModel::StrainModel(const SurfaceLinks& links)
    : curvature_(Eigen::VectorXd::Zero(links.vertexCount())),
      rims_(static_cast<std::size_t>(links.vertexCount()), 0),
      areas_(static_cast<std::size_t>(links.vertexCount()), 0) {
    const MeshArrays& mesh = links.mesh();
    linalg::SymmetricBuilder builder(links.vertexCount());
    const auto connect = [&builder](int a, int b, double weight) {
        builder.add(a, b, -weight);
        builder.add(a, a, weight);
        builder.add(b, b, weight);
    };
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const CornerProducts corners = cornerProducts(mesh, f);
        for (int k = 0; k < 3; ++k) {
            const int v = mesh.F(f, k);
            areas_[static_cast<std::size_t>(v)] += corners.doubledArea / 6;
            curvature_[v] -= std::atan2(corners.doubledArea, corners.at[k]);
            const double weight =
                corners.doubledArea > 0 ? corners.at[k] / (2 * corners.doubledArea) : 0;
            connect(mesh.F(f, (k + 1) % 3), mesh.F(f, (k + 2) % 3), weight);
        }
    }
    for (int v = 0; v < links.vertexCount(); ++v) {
        const bool isInner = !links.cornersAt(v).empty() && links.isInner(v);
        rims_[static_cast<std::size_t>(v)] = isInner ? 0 : 1;
        curvature_[v] = isInner ? curvature_[v] + 2 * std::numbers::pi : 0;
    }
    laplacian_ = builder.build();
}

std::optional<FlatScale> StrainModel::solve(std::vector<char> parted) {
    linalg::SymmetricMatrix system = laplacian_;
    for (int v = 0; v < system.size; ++v) {
        if (system.value[system.columnStart[v]] < kLoose) {  // only in flat triangles
            parted[static_cast<std::size_t>(v)] = 1;
        }
    }
    for (int j = 0; j < system.size; ++j) {
        for (int p = system.columnStart[j]; p < system.columnStart[j + 1]; ++p) {
            if (parted[static_cast<std::size_t>(j)] != 0 ||
                parted[static_cast<std::size_t>(system.row[p])] != 0) {
                system.value[p] = system.row[p] == j ? 1 : 0;
            }
        }
    }
    Eigen::VectorXd sources = -curvature_;
    for (int v = 0; v < system.size; ++v) {
        if (parted[static_cast<std::size_t>(v)] != 0) {
            sources[v] = 0;
        }
    }
    const auto made = isOrdered_ ? factor_.refactorise(system) : factor_.factorise(system);
    if (!made) {
        return std::nullopt;
    }
    isOrdered_ = true;
    const auto solved = factor_.solve(sources);
    if (!solved || !solved->allFinite()) {
        return std::nullopt;
    }
    FlatScale scale;
    scale.log = solved->col(0);
    scale.absorbed = curvature_;
    std::vector<std::pair<double, double>> strains;
    strains.reserve(areas_.size());
    for (int v = 0; v < system.size; ++v) {
        const auto at = static_cast<std::size_t>(v);
        const double log = std::clamp(scale.log[v], -kMaxLog, kMaxLog);
        strains.emplace_back(kIsometricPart * std::expm1(-log), areas_[at]);
        for (int p = laplacian_.columnStart[v]; p < laplacian_.columnStart[v + 1]; ++p) {
            const int other = laplacian_.row[p];
            if (parted[at] != 0) {
                scale.absorbed[v] += laplacian_.value[p] * scale.log[other];
            }
            if (other != v && parted[static_cast<std::size_t>(other)] != 0) {
                scale.absorbed[other] += laplacian_.value[p] * scale.log[v];
            }
        }
    }
    scale.strain = strainFigures(std::move(strains));
    return scale;
}

}  // namespace toile
