// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/shown_value.h"

#include "app/document/document.h"

namespace toile {

std::optional<double> shownValueAt(const Document& document, const SurfacePlace& place) {
    if (!document.scene()) {
        return std::nullopt;
    }
    const Scene& scene = *document.scene();
    const ViewState& view = document.view();
    return valueAt(scene, placesOf(document.settings()), place, view.overlay,
                   overlayScale(scene, view.overlay, document.fabric()), view.valuesPerTriangle);
}

}  // namespace toile
