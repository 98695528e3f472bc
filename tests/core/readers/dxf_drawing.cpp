// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/dxf_drawing.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/formats/dxf/dxf_curve.h"

namespace toile {
namespace {

std::optional<double> scaled(std::optional<double> value, double by) {
    return value ? std::optional(*value * by) : std::nullopt;
}

void addSaid(DxfGroupOfEntities& group, std::string_view text) {
    group.texts.push_back(text);
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos) {
        std::string key(trimmed(text.substr(0, colon)));
        std::ranges::transform(key, key.begin(), lowered);
        group.said.emplace(std::move(key), trimmed(text.substr(colon + 1)));
    }
}

void addEntity(DxfGroupOfEntities& group, const DxfEntity& entity, double unit) {
    if (auto line = dxfCurve(entity, unit)) {
        (entity.kind == "LINE" ? group.lines : group.polylines)
            .push_back({entity.layer, line->points * unit, line->closed});
    } else if (entity.kind == "TEXT") {
        addSaid(group, entity.text(1));
    } else if (const auto point = entity.point(); !point) {
        return;
    } else if (entity.kind == "POINT") {
        group.records.push_back({entity.layer, *point * unit, scaled(entity.number(30), unit),
                                 scaled(entity.number(39), unit),
                                 scaled(entity.number(50), kDegree)});
    } else if (entity.kind == "INSERT") {
        group.inserts.emplace_back(entity.text(2), *point * unit);
    }
}

}  // namespace

DxfDrawing dxfDrawing(const DxfDocument& document, double unit) {
    DxfDrawing drawing;
    for (const DxfBlock& block : document.blocks) {
        DxfGroupOfEntities& group = drawing.blocks.emplace_back();
        group.name = block.name;
        for (const DxfEntity& entity : block.entities) {
            addEntity(group, entity, unit);
        }
    }
    for (const DxfEntity& entity : document.entities) {
        addEntity(drawing.page, entity, unit);
    }
    return drawing;
}

}  // namespace toile
