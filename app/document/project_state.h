// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_state.h"
#include "app/document/view_state.h"
#include "core/project/project.h"

namespace toile::app {

/// What is saved of the open document. Requires a garment. Linear in the outlines; thread-safe.
Project projectOf(const DocumentState& state, const Derived& derived, const ViewState& view);

/// What is saved of how the document is shown.
ProjectView savedView(const ViewState& view);

/// How the project was shown; what it does not say is as before.
ViewState viewOf(const ProjectView& saved, ViewState before);

/// What is opened of a project, with the garment made for it. Its reference pattern is not read.
DocumentState stateOf(const Project& project, GarmentInputs inputs, const Garment& garment);

}  // namespace toile::app
