// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/piece_settings.h"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

#include "core/flatten/base/match_versions.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

PieceResults withoutLeftOut(PieceResults results, const Garment& garment,
                            const std::vector<PieceSettings>& settings) {
    for (std::size_t i = 0; i < std::min(results.size(), settings.size()); ++i) {
        const bool isOut = results[i] && isLeftOut(*results[i]);
        if (!settings[i].leftOut && isOut) {
            results[i] = nullptr;
        } else if (settings[i].leftOut && results[i] && !isOut) {
            auto out = std::make_shared<PieceResult>();
            out->piece = garment.pieces[i];
            out->options = results[i]->options;
            out->targets = results[i]->targets;
            out->error = Error{ErrorCode::LeftOut, subjectOf(*garment.pieces[i])};
            results[i] = std::move(out);
        }
    }
    return results;
}

double wornArea(const Piece& piece) {
    return surfaceArea(piece.mesh);
}

namespace {

/// The label's colour; negative if it has none.
int colourOf(const PieceLabels& labels, PieceId id) {
    const auto known = labels.find(id);
    return known == labels.end() ? -1 : known->second.colour;
}

/// Another shade of a colour that is not in `taken` yet, and adds it there.
int takeShade(int colour, std::set<int>& taken) {
    do {
        colour += kHueCount;
    } while (!taken.insert(colour).second);
    return colour;
}

/// "skirt 2" for the part "front 2" of a piece that the user named "skirt"; else empty.
std::string inheritedName(const PieceLabels& labels, const Piece& whole, const Piece& part) {
    const std::string& stated = nameOf(labels, whole);
    return stated != whole.name && part.name.starts_with(whole.name)
               ? stated + part.name.substr(whole.name.size())
               : std::string();
}

}  // namespace

PieceLabels withColours(PieceLabels labels, const Garment* before, const Garment& after) {
    std::set<int> present, ever;
    for (const auto& [id, label] : labels) {
        ever.insert(label.colour);
    }
    std::vector<int> colours;
    for (const auto& piece : after.pieces) {
        const int own = colourOf(labels, piece->id);
        colours.push_back(own >= 0 && present.insert(own).second ? own : -1);
    }
    const std::vector<int> was =
        before ? predecessors(before->pieces, after.pieces) : std::vector<int>{};
    int next = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        if (colours[i] < 0 && before && was[i] >= 0) {
            const int old = colourOf(labels, before->pieces[static_cast<std::size_t>(was[i])]->id);
            if (old >= 0) {
                colours[i] = present.insert(old).second ? old : takeShade(old, ever);
            }
        }
        while (colours[i] < 0) {
            colours[i] = ever.insert(next).second ? next : -1;
            ++next;
        }
        const bool isNew = !labels.contains(after.pieces[i]->id);
        PieceLabel& label = labels[after.pieces[i]->id];
        label.colour = colours[i];
        if (isNew && before && was[i] >= 0) {
            label.name = inheritedName(labels, *before->pieces[static_cast<std::size_t>(was[i])],
                                       *after.pieces[i]);
        }
    }
    return labels;
}

std::vector<int> coloursOf(const PieceLabels& labels, const Garment& garment) {
    std::vector<int> colours;
    for (const auto& piece : garment.pieces) {
        const int colour = colourOf(labels, piece->id);
        colours.push_back(colour < 0 ? static_cast<int>(colours.size()) : colour);
    }
    return colours;
}

const std::string& nameOf(const PieceLabels& labels, const Piece& piece) {
    const auto known = labels.find(piece.id);
    return known == labels.end() || known->second.name.empty() ? piece.name : known->second.name;
}

Subject labelled(const PieceLabels& labels, Subject subject) {
    const auto known = labels.find(subject.pieceId());
    if (known != labels.end() && !known->second.name.empty()) {
        subject.name = known->second.name;
    }
    return subject;
}

namespace {

/// At most kMaxAnchors of the anchors, evenly spread over the list.
std::vector<Anchor> thinned(std::vector<Anchor> anchors) {
    const auto count = anchors.size();
    const auto most = static_cast<std::size_t>(kMaxAnchors);
    if (count <= most) {
        return anchors;
    }
    std::vector<Anchor> some;
    for (std::size_t i = 0; i < most; ++i) {
        some.push_back(anchors[i * count / most]);
    }
    return some;
}

/// Anchors of the piece: positions of its vertices in the flat piece before it.
std::vector<Anchor> anchorsOf(const Piece& piece, const Piece& before, const PieceResult* result,
                              const PieceSettings& settings) {
    const std::vector<Anchor>& anchorsBefore = settings.anchors;
    const bool flat = result && result->flat && result->piece.get() == &before &&
                      (settings.flat == 0 || settings.flat == result->fingerprint);
    if (!flat && anchorsBefore.empty()) {
        return {};
    }
    std::unordered_map<int, Eigen::Vector2d> known;
    for (const Anchor& anchor : anchorsBefore) {
        known.emplace(anchor.vertex, anchor.flat);
    }
    const VersionMatch match = matchVersions(piece, before);
    std::vector<Anchor> anchors;
    for (std::size_t v = 0; v < match.vertex.size(); ++v) {
        const int old = match.vertex[v];
        if (old < 0) {
            continue;
        }
        if (flat) {
            anchors.push_back({static_cast<int>(v), result->flat->Q.row(old).transpose()});
        } else if (const auto found = known.find(old); found != known.end()) {
            anchors.push_back({static_cast<int>(v), found->second});
        }
    }
    return thinned(std::move(anchors));
}

}  // namespace

std::vector<CarriedFrom> carriedFrom(const Garment& before,
                                     const std::vector<PieceSettings>& settings,
                                     const PieceResults& results, const Garment& after) {
    const std::vector<int> predecessor = predecessors(before.pieces, after.pieces);
    std::vector<CarriedFrom> carried;
    std::vector<int> heirs(before.pieces.size(), 0);
    for (std::size_t p = 0; p < after.pieces.size(); ++p) {
        const auto& piece = after.pieces[p];
        CarriedFrom& from = carried.emplace_back(CarriedFrom{predecessor[p]});
        from.same = from.piece >= 0 && before.pieces[static_cast<std::size_t>(from.piece)] == piece;
        if (from.piece >= 0 && !from.same) {
            const auto at = static_cast<std::size_t>(from.piece);
            const PieceResult* result = at < results.size() ? results[at].get() : nullptr;
            from.anchors = anchorsOf(*piece, *before.pieces[at], result,
                                     at < settings.size() ? settings[at] : PieceSettings{});
            from.flat = at < settings.size() ? settings[at].flat : 0;
        }
        if (from.piece >= 0) {
            ++heirs[static_cast<std::size_t>(from.piece)];
        }
    }
    for (CarriedFrom& from : carried) {
        const auto at = static_cast<std::size_t>(from.piece);
        if (from.piece >= 0 && at < settings.size() && settings[at].partOf) {
            from.partOf = settings[at].partOf;  // cut again before it was laid out
        } else if (from.piece >= 0 && heirs[at] > 1) {
            from.partOf = before.pieces[at]->id;
        }
    }
    return carried;
}

std::vector<PieceSettings> carriedSettings(const std::vector<CarriedFrom>& from,
                                           const std::vector<PieceSettings>& settings) {
    std::vector<PieceSettings> carried(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (from[i].piece >= 0 && static_cast<std::size_t>(from[i].piece) < settings.size()) {
            carried[i] = settings[static_cast<std::size_t>(from[i].piece)];
            if (!from[i].same) {
                carried[i].flat = 0;
                carried[i].anchors = from[i].anchors;
                carried[i].partOf = from[i].partOf;
            }
        }
    }
    return carried;
}

void carrySettings(SettingsById& settings, const std::vector<PieceSettings>& before,
                   const std::vector<CarriedFrom>& from, const Garment& after) {
    std::vector<PieceSettings> carried = carriedSettings(from, before);
    for (std::size_t p = 0; p < after.pieces.size(); ++p) {
        const auto [stated, isNew] =
            settings.try_emplace(after.pieces[p]->id, std::move(carried[p]));
        if (!isNew && !from[p].anchors.empty() && stated->second.flat == from[p].flat) {
            stated->second.anchors = from[p].anchors;
        }
    }
}

}  // namespace toile
