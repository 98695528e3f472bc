// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/moment.h"

#include <utility>

#include "core/pattern/pattern.h"

namespace toile::test {

using namespace app;

void setGarment(Document& document, std::shared_ptr<const Garment> garment,
                std::shared_ptr<const Scene> scene) {
    DocumentState state;
    state.options = document.options();
    state.fabric = document.fabric();
    Derived derived;
    derived.inputs.loading = document.loading();
    derived.garment = std::move(garment);
    derived.scene = std::move(scene);
    document.open(std::move(state), std::move(derived));
}

void setResults(Document& document, PieceResults results, std::shared_ptr<const Scene> scene) {
    Derived derived = document.derived();
    derived.results = std::move(results);
    derived.pattern =
        std::make_shared<const Pattern>(makePattern(*derived.garment, derived.results));
    derived.scene = std::move(scene);
    document.show(std::move(derived), document.state().settings);
}

void editGarment(Document& document, const QString& text, std::shared_ptr<const Garment> garment) {
    DocumentState next = document.state();
    auto& files = next.inputs.files;
    files.push_back({"edited.obj", std::make_shared<const PolygonSoup>()});
    Derived derived;
    derived.inputs = next.inputs;
    derived.garment = std::move(garment);
    document.edit(text, std::move(next));
    document.show(std::move(derived), document.state().settings);
}

PieceSettings& said(DocumentState& state, const Document& document, int piece) {
    const auto at = static_cast<std::size_t>(piece);
    PieceSettings& settings = state.settings[document.garment()->pieces[at]->id];
    settings = document.settings()[at];
    return settings;
}

}  // namespace toile::test
