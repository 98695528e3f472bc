// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/sewn_sample.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/geometry/disjoint_sets.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"

namespace toile::test {
namespace {

using Place = std::array<double, 3>;

constexpr double kCentimetre = 10;  // mm

/// The number of every place, in the order of their first vertices.
class Places {
public:
    int of(const Eigen::RowVector3d& p) {
        const auto [at, isNew] = number_.emplace(Place{p.x(), p.y(), p.z()}, count());
        if (isNew) {
            points_.push_back(p);
        }
        return at->second;
    }
    int count() const { return static_cast<int>(points_.size()); }
    const std::vector<Eigen::RowVector3d>& points() const { return points_; }

private:
    std::map<Place, int> number_;
    std::vector<Eigen::RowVector3d> points_;
};

/// An edge of the sewn surface that lies in outlines.
struct OutlineEdge {
    std::vector<int> panels;  ///< one for each side; two where it is sewn
    double length = 0;        ///< mm
};
using OutlineEdges = std::map<std::pair<int, int>, OutlineEdge>;

OutlineEdges outlineEdges(const Garment& garment, Places& places) {
    OutlineEdges edges;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        const Piece& piece = *garment.pieces[p];
        for (std::size_t k = 0; k < piece.boundary.size(); ++k) {
            const auto a = piece.mesh.V.row(piece.boundary[k]);
            const auto b = piece.mesh.V.row(piece.boundary[(k + 1) % piece.boundary.size()]);
            OutlineEdge& edge = edges[std::minmax({places.of(a), places.of(b)})];
            edge.panels.push_back(static_cast<int>(p));
            edge.length = (a - b).norm();
        }
    }
    return edges;
}

/// Runs of sewn edges between the same two panels; they end where other outlines come in.
nlohmann::json seamsOf(const OutlineEdges& edges, int places) {
    std::vector<std::vector<int>> at(static_cast<std::size_t>(places));
    std::vector<const OutlineEdge*> all;
    for (const auto& [ends, edge] : edges) {
        for (const int end : {ends.first, ends.second}) {
            at[static_cast<std::size_t>(end)].push_back(static_cast<int>(all.size()));
        }
        all.push_back(&edge);
    }
    geometry::DisjointSets runs(static_cast<int>(all.size()));
    for (const std::vector<int>& here : at) {
        if (here.size() == 2 && all[here[0]]->panels == all[here[1]]->panels) {
            runs.join(here[0], here[1]);
        }
    }
    std::map<int, nlohmann::json> seams;
    for (std::size_t e = 0; e < all.size(); ++e) {
        if (all[e]->panels.size() == 2) {
            nlohmann::json& seam = seams[runs.root(static_cast<int>(e))];
            seam["panels"] = all[e]->panels;
            seam["length_3d"] = seam.value("length_3d", 0.0) + all[e]->length / kCentimetre;
        }
    }
    nlohmann::json list = nlohmann::json::array();
    for (auto& [root, seam] : seams) {
        list.push_back(std::move(seam));
    }
    return list;
}

std::string line(const char* keyword, std::initializer_list<double> numbers) {
    std::string text = keyword;
    for (const double number : numbers) {
        std::array<char, 32> digits{};
        std::snprintf(digits.data(), digits.size(), " %.17g", number / kCentimetre);
        text += digits.data();
    }
    return text + '\n';
}

/// @param apart  every panel with vertices of its own, and as an object
std::string objOf(const Garment& garment, const PieceResults& flat, Places& places, bool apart) {
    std::string text, faces;
    if (!apart) {
        for (const Eigen::RowVector3d& p : places.points()) {
            text += line("v", {p.x(), p.y(), p.z()});
        }
    }
    int first = 1;      // texture vertex, and vertex where they are apart
    double across = 0;  // mm
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        const MeshArrays& mesh = garment.pieces[p]->mesh;
        const Points2& Q = flat[p]->flat->Q;
        const double shift = across - Q.col(0).minCoeff();
        across += Q.col(0).maxCoeff() - Q.col(0).minCoeff() + kCentimetre;
        for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
            if (apart) {
                text += line("v", {mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
            }
            text += line("vt", {Q(v, 0) + shift, Q(v, 1)});
        }
        faces += apart ? "o " + garment.pieces[p]->name + '\n' : "";
        for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
            faces += 'f';
            for (const int v : mesh.F.row(f)) {
                const int vertex = apart ? first + v : places.of(mesh.V.row(v)) + 1;
                faces += ' ' + std::to_string(vertex) + '/' + std::to_string(first + v);
            }
            faces += '\n';
        }
        first += static_cast<int>(mesh.V.rows());
    }
    return text + faces;
}

void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

std::filesystem::path writeSewnSample(const std::string& name,
                                      const std::filesystem::path& folder) {
    Progress progress;
    const auto garment = loadGarment({dataFile("samples/" + name + ".obj")},
                                     {.unit = LengthUnit::Millimetre}, progress);
    EXPECT_TRUE(garment) << name;
    const PieceResults flat = flattenGarment(*garment, {Method::Curvature}, progress);
    Places places;
    nlohmann::json truth{{"edges_with_more_than_two_faces", 0}};
    for (std::size_t p = 0; p < garment->pieces.size(); ++p) {
        const MeshArrays& mesh = garment->pieces[p]->mesh;
        const Eigen::RowVector3d middle = mesh.V.colwise().mean() / kCentimetre;
        truth["panels"].push_back({{"id", p},
                                   {"name", garment->pieces[p]->name},
                                   {"faces", mesh.F.rows()},
                                   {"centroid_3d", {middle.x(), middle.y(), middle.z()}}});
        for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
            truth["face_panel"].push_back(p);
        }
        for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
            places.of(mesh.V.row(v));
        }
    }
    truth["seams"] = seamsOf(outlineEdges(*garment, places), places.count());
    const std::filesystem::path base = folder / name;
    write(base.string() + ".obj", objOf(*garment, flat, places, false));
    write(base.string() + "_pieces.obj", objOf(*garment, flat, places, true));
    write(base.string() + ".truth.json", truth.dump());
    return base;
}

std::filesystem::path garmentWithTruth(const std::string& name,
                                       const std::filesystem::path& folder) {
    const std::string samples = "samples/";
    return name.starts_with(samples) ? writeSewnSample(name.substr(samples.size()), folder)
                                     : sharedFile("garments/" + name);
}

}  // namespace toile::test
