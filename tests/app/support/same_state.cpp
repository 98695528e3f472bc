// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/same_state.h"

#include <cstring>

#include "app/render/scene.h"

namespace toile::test {

namespace {

template <class Value>
bool sameBytes(const std::vector<Value>& one, const std::vector<Value>& other) {
    return one.size() == other.size() &&
           (one.empty() || std::memcmp(one.data(), other.data(), one.size() * sizeof(Value)) == 0);
}

bool sameResult(const PieceResult* one, const PieceResult* other) {
    if (!one || !other) {
        return one == other;
    }
    if (one->piece != other->piece || !(one->options == other->options) ||
        one->flat.has_value() != other->flat.has_value() ||
        one->error.has_value() != other->error.has_value()) {
        return false;
    }
    if (one->error && one->error->code != other->error->code) {
        return false;
    }
    return !one->flat || (one->flat->Q.rows() == other->flat->Q.rows() &&
                          std::memcmp(one->flat->Q.data(), other->flat->Q.data(),
                                      sizeof(double) * std::size_t(one->flat->Q.size())) == 0);
}

bool sameScene(const Scene& one, const Scene& other) {
    return one.origin == other.origin && sameBytes(one.garment.vertices, other.garment.vertices) &&
           sameBytes(one.garment.triangles, other.garment.triangles) &&
           sameBytes(one.pattern.vertices, other.pattern.vertices) &&
           sameBytes(one.pattern.triangles, other.pattern.triangles) &&
           sameBytes(one.garmentLines.vertices, other.garmentLines.vertices) &&
           sameBytes(one.patternLines.vertices, other.patternLines.vertices) &&
           sameBytes(one.faces, other.faces);
}

}  // namespace

QString difference(const DocumentState& one, const DocumentState& other) {
    if (one.garment != other.garment) {
        return "garment";
    }
    if (!(one.loading == other.loading)) {
        return "loading";
    }
    if (!(one.options == other.options)) {
        return "options";
    }
    if (!(one.fabric == other.fabric)) {
        return "fabric";
    }
    if (one.results.size() != other.results.size()) {
        return "number of results";
    }
    for (std::size_t i = 0; i < one.results.size(); ++i) {
        if (!sameResult(one.results[i].get(), other.results[i].get())) {
            return QString("result %1").arg(i);
        }
    }
    if (one.settings != other.settings) {
        return "settings";
    }
    if ((one.scene == nullptr) != (other.scene == nullptr)) {
        return "no scene";
    }
    return one.scene == other.scene || sameScene(*one.scene, *other.scene) ? QString() : "scene";
}

}  // namespace toile::test
