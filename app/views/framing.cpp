// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/framing.h"

#include "app/views/ruler.h"

namespace toile {

namespace {

/// Room for the caption above and the scale bar below; the rulers come on top of it.
constexpr Camera2D::Margins kMargins{26, 50, 66};

}  // namespace

Morph morphBefore(const Camera3D& camera, const Scene* scene, double way) {
    Morph morph;
    morph.way = way;
    morph.sheetAxes = camera.axes();
    morph.sheetCentre = scene ? scene->box.center() : Eigen::Vector3d::Zero().eval();
    return morph;
}

void frameGarment(Camera3D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, double way) {
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(pieces.size());
    for (const int piece : pieces) {
        boxes.push_back(scene.pieces[static_cast<std::size_t>(piece)].box);
    }
    camera.frame(boxes);
    if (way > 0) {
        const auto all = morphBoxes(scene, places, morphBefore(camera, &scene, 1));
        for (std::size_t i = 0; const int piece : pieces) {
            boxes[i++] = all[static_cast<std::size_t>(piece)];
        }
        Camera3D before = camera;
        before.frame(boxes);
        camera.moveTowards(before, morphBefore(camera, &scene, way).flight());
    }
}

Camera2D::Margins patternMargins(bool rulers) {
    Camera2D::Margins margins = kMargins;
    margins.sides += rulers ? kRulerBreadth : 0;
    margins.top += rulers ? kRulerBreadth : 0;
    return margins;
}

void framePattern(Camera2D& camera, const Scene& scene, const SheetPlaces& places,
                  const std::set<int>& pieces, bool rulers) {
    Eigen::AlignedBox2d box;
    for (const int piece : pieces) {
        box.extend(placedBox(scene.pieces[static_cast<std::size_t>(piece)].flatBox,
                             placeOf(places, piece).placement));
    }
    camera.frame(box, patternMargins(rulers));
}

}  // namespace toile
