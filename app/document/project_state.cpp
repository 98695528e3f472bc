// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/project_state.h"

#include <utility>

namespace toile {
Project projectOf(const DocumentState& state, const ViewState& view) {
    Project project;
    project.files = meshReferences(*state.garment);
    project.loading = state.loading;
    project.loading.known = knownPieces(*state.garment);
    project.options = state.options;
    project.fabric = state.fabric;
    project.pieces = projectPieces(*state.garment, state.settings, state.results);
    project.labels = state.labels;
    project.view = {std::string(wordOf(kOverlayWords, view.overlay)), view.wireframe,
                    view.designerOutline};
    return project;
}

ViewState viewOf(const ProjectView& saved, ViewState view) {
    view.overlay = parseWord(kOverlayWords, saved.overlay).value_or(view.overlay);
    view.wireframe = saved.wireframe;
    view.designerOutline = saved.designerOutline;
    return view;
}

DocumentState stateOf(const Project& project, std::shared_ptr<const Garment> garment,
                      std::shared_ptr<const Scene> scene) {
    DocumentState state;
    state.loading = resolveNames(project.loading, *garment);
    state.options = project.options;
    state.fabric = project.fabric;
    state.settings = settingsFor(project, *garment);
    state.labels = project.labels;
    state.garment = std::move(garment);
    state.scene = std::move(scene);
    return state;
}

}  // namespace toile
