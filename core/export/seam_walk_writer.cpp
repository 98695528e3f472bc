// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/seam_walk_writer.h"

#include <algorithm>

#include "core/base/version.h"
#include "core/export/json.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

constexpr int kWalkVersion = 1;  // increased when a field changes its meaning or is removed

Json notchJson(const Notch& notch) {
    return {{"reason", text(wordOf(kNotchReasonWords, notch.reason))},
            {"count", notch.count},
            {"share", number(notch.share)},
            {"on_left", notch.onLeft},
            {"on_right", notch.onRight},
            {"place_2d_left", number(notch.flat.left)},
            {"place_2d_right", number(notch.flat.right)}};
}

}  // namespace

std::string_view stationWord(const SeamWalk& walk, std::size_t station) {
    return station == 0 ? "start" : station + 1 == walk.stations.size() ? "end" : "notch";
}

std::string writeWalk(const Garment& garment, const std::vector<std::vector<Notch>>& notches,
                      const std::vector<SeamWalk>& walks) {
    Json json{{"version", kWalkVersion}, {"toile", text(version())}};
    double largest = 0;
    Json seams = Json::array();
    for (const SeamWalk& walk : walks) {
        const Seam& seam = garment.seams.seams[static_cast<std::size_t>(walk.seam)];
        Json stations = Json::array();
        for (std::size_t k = 0; k < walk.stations.size(); ++k) {
            const WalkStation& at = walk.stations[k];
            const Json notch = at.notch < 0
                                   ? Json(nullptr)
                                   : notchJson(notches[static_cast<std::size_t>(walk.seam)]
                                                      [static_cast<std::size_t>(at.notch)]);
            stations.push_back({{"station", text(stationWord(walk, k))},
                                {"notch", notch},
                                {"length_2d_left", number(at.left)},
                                {"length_2d_right", number(at.right)},
                                {"ease_mm", number(at.ease)},
                                {"error_mm", number(at.error())},
                                {"kink", number(at.kink)}});
        }
        largest = std::max(largest, walk.largestError());
        seams.push_back({{"name", seam.name},
                         {"kind", text(name(seam.kind))},
                         {"pieces",
                          {garment.pieces[static_cast<std::size_t>(seam.left.piece)]->name,
                           garment.pieces[static_cast<std::size_t>(seam.right.piece)]->name}},
                         {"stations", std::move(stations)}});
    }
    json["largest_error_mm"] = number(largest);
    json["seams"] = std::move(seams);
    return jsonText(json);
}

}  // namespace toile
