// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/project_state.h"

#include <utility>

namespace toile::app {
Project projectOf(const DocumentState& state, const Derived& derived, const ViewState& view) {
    const Garment& garment = *derived.garment;
    Project project;
    project.files = meshReferences(garment);
    project.loading = state.inputs.loading;
    project.loading.known = knownPieces(garment);
    project.options = state.options;
    project.lines = state.lines;
    project.fabric = state.fabric;
    project.materials = state.materials;
    std::vector<PieceSettings> settings;
    for (const auto& piece : garment.pieces) {
        const auto said = state.settings.find(piece->id);
        settings.push_back(said == state.settings.end() ? PieceSettings{} : said->second);
    }
    project.pieces = projectPieces(garment, std::move(settings), derived.results);
    project.labels = state.labels;
    project.markers = state.markers.all();
    project.proof = state.proof;
    if (const auto& path = state.reference.path; !path.empty()) {
        project.reference = FileReference{.path = path};
    }
    project.view = savedView(view);
    return project;
}

ProjectView savedView(const ViewState& view) {
    return {std::string(wordOf(kOverlayWords, view.overlay)),
            view.wireframe,
            view.referencePanels,
            view.exactOutline,
            view.cuttingLine,
            view.notches,
            view.internalLines,
            view.grain,
            view.labels};
}

ViewState viewOf(const ProjectView& saved, ViewState view) {
    view.overlay = parseWord(kOverlayWords, saved.overlay).value_or(view.overlay);
    view.wireframe = saved.wireframe;
    view.referencePanels = saved.referencePanels;
    view.exactOutline = saved.exactOutline;
    view.cuttingLine = saved.cuttingLine;
    view.notches = saved.notches;
    view.internalLines = saved.internalLines;
    view.grain = saved.grain;
    view.labels = saved.labels;
    return view;
}

DocumentState stateOf(const Project& project, GarmentInputs inputs, const Garment& garment) {
    DocumentState state;
    state.inputs = std::move(inputs);
    state.options = project.options;
    state.lines = project.lines;
    state.fabric = project.fabric;
    state.materials = project.materials;
    state.labels = project.labels;
    state.markers = ClothPlans(project.markers);
    state.proof = project.proof;
    if (project.reference) {
        state.reference.path = project.reference->path;
    }
    std::vector<PieceSettings> settings = settingsFor(project, garment);
    for (std::size_t i = 0; i < settings.size(); ++i) {
        state.settings.emplace(garment.pieces[i]->id, std::move(settings[i]));
    }
    return state;
}

}  // namespace toile::app
