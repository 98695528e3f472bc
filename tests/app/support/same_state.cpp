// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/same_state.h"

#include <algorithm>
#include <cstring>

#include "app/render/scene.h"

namespace toile::test {

using namespace app;

namespace {

template <class Value>
bool sameBytes(const std::vector<Value>& one, const std::vector<Value>& other) {
    return one.size() == other.size() &&
           (one.empty() || std::memcmp(one.data(), other.data(), one.size() * sizeof(Value)) == 0);
}

bool samePiece(const Piece& one, const Piece& other) {
    return one.id == other.id && one.name == other.name &&
           one.mesh.V.rows() == other.mesh.V.rows() && one.mesh.V == other.mesh.V &&
           one.mesh.F.rows() == other.mesh.F.rows() && one.mesh.F == other.mesh.F;
}

/// Empty where they are the same.
QString resultDifference(const PieceResult* one, const PieceResult* other) {
    if (!one || !other) {
        return one == other ? "" : "not there";
    }
    if (!samePiece(*one->piece, *other->piece)) {
        return "piece";
    }
    if (!(one->options == other->options)) {
        return "options";
    }
    if (one->flat.has_value() != other->flat.has_value()) {
        return "flat";
    }
    if (one->error.has_value() != other->error.has_value() ||
        (one->error && one->error->code != other->error->code)) {
        return "error";
    }
    const bool same = !one->flat || (one->flat->Q.rows() == other->flat->Q.rows() &&
                                     one->flat->Q == other->flat->Q);
    return same ? "" : one->flat->warm || other->flat->warm ? "points, warm" : "points";
}

bool sameRuns(const LineRuns& one, const LineRuns& other) {
    return sameBytes(one.seams, other.seams) && sameBytes(one.reference, other.reference) &&
           sameBytes(one.outlines, other.outlines) && sameBytes(one.exact, other.exact) &&
           one.boundaryAt == other.boundaryAt;
}

bool sameScene(const Scene& one, const Scene& other) {
    return one.origin == other.origin && sameBytes(one.vertices, other.vertices) &&
           sameBytes(one.garment.triangles, other.garment.triangles) &&
           sameBytes(one.pattern.triangles, other.pattern.triangles) &&
           sameRuns(one.garmentLines, other.garmentLines) &&
           sameRuns(one.patternLines, other.patternLines) &&
           sameBytes(one.lineVertices, other.lineVertices) && sameBytes(one.faces, other.faces);
}

}  // namespace

QString pointsDifference(const PieceResults& one, const PieceResults& other) {
    if (one.size() != other.size()) {
        return "number of results";
    }
    for (std::size_t i = 0; i < one.size(); ++i) {
        const QString what = resultDifference(one[i].get(), other[i].get());
        if (!what.isEmpty()) {
            return QString("result %1: %2").arg(i).arg(what);
        }
    }
    return {};
}

QString difference(const Moment& one, const Moment& other) {
    if (!(one.state.inputs == other.state.inputs)) {
        return "inputs";
    }
    if (!(one.state.options == other.state.options)) {
        return "options";
    }
    if (!(one.state.lines == other.state.lines)) {
        return "lines";
    }
    if (!(one.state.fabric == other.state.fabric) || one.state.materials != other.state.materials) {
        return "fabric";
    }
    if (one.state.reference.path != other.state.reference.path) {
        return "reference";
    }
    if (!(one.state.proof == other.state.proof)) {
        return "proof";
    }
    for (const auto& [id, said] : one.state.settings) {
        const auto found = other.state.settings.find(id);
        if (found == other.state.settings.end()) {
            return "settings: not there";
        }
        if (const PieceSettings& now = found->second; !(now == said)) {
            return now.placement != said.placement ? "settings: placement"
                   : now.flat != said.flat         ? "settings: flat"
                   : now.anchors != said.anchors   ? "settings: anchors"
                                                   : "settings";
        }
    }
    if (one.state.settings.size() != other.state.settings.size()) {
        return "number of settings";
    }
    const Derived &first = one.derived, &second = other.derived;
    const auto& pieces = first.garment->pieces;
    if (!std::ranges::equal(pieces, second.garment->pieces,
                            [](const auto& a, const auto& b) { return samePiece(*a, *b); })) {
        return "pieces";
    }
    if (const QString what = pointsDifference(first.results, second.results); !what.isEmpty()) {
        return what;
    }
    if ((first.scene == nullptr) != (second.scene == nullptr)) {
        return "no scene";
    }
    return first.scene == second.scene || sameScene(*first.scene, *second.scene) ? QString()
                                                                                 : "scene";
}

}  // namespace toile::test
