// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/reading_actions.h"

#include <QAction>
#include <optional>
#include <utility>

#include "app/actions/action_registry.h"
#include "app/actions/workspace.h"

namespace toile {

namespace {

const std::pair<ActionId, std::optional<LengthUnit>> kUnits[] = {
    {ActionId::UnitAuto, std::nullopt},
    {ActionId::UnitMillimetre, LengthUnit::Millimetre},
    {ActionId::UnitCentimetre, LengthUnit::Centimetre},
    {ActionId::UnitMetre, LengthUnit::Metre},
    {ActionId::UnitInch, LengthUnit::Inch},
};

const std::pair<ActionId, std::optional<UpAxis>> kAxes[] = {
    {ActionId::UpAuto, std::nullopt},
    {ActionId::UpY, UpAxis::Y},
    {ActionId::UpZ, UpAxis::Z},
};

constexpr std::pair<ActionId, SplitMode> kDivisions[] = {
    {ActionId::SplitAuto, SplitMode::Auto},
    {ActionId::SplitComponents, SplitMode::Components},
    {ActionId::SplitObjects, SplitMode::Objects},
    {ActionId::SplitGroups, SplitMode::Groups},
    {ActionId::SplitMaterials, SplitMode::Materials},
    {ActionId::SplitUv, SplitMode::Uv},
    {ActionId::SplitSeams, SplitMode::Seams},
};

void updateEnabled(const ActionRegistry& actions, Workspace& workspace) {
    const bool open = workspace.document().garment() != nullptr;
    const SeamsFile seams = workspace.loading().seams;
    actions[ActionId::Reload].setEnabled(open);
    actions[ActionId::SeamsFromFile].setEnabled(open);
    actions[ActionId::SeamsToFile].setEnabled(open && !seams.empty());
    actions[ActionId::SplitSeams].setEnabled(!seams.cuts.empty());
}

void updateChecked(const ActionRegistry& actions, Workspace& workspace) {
    const LoadOptions loading = workspace.loading();
    for (const auto& [id, unit] : kUnits) {
        actions[id].setChecked(loading.unit == unit);
    }
    for (const auto& [id, axis] : kAxes) {
        actions[id].setChecked(loading.up == axis);
    }
    for (const auto& [id, mode] : kDivisions) {
        actions[id].setChecked(loading.split == mode);
    }
    actions[ActionId::AutoCut].setChecked(loading.autoCut);
    actions[ActionId::Weld].setChecked(loading.weld);
    updateEnabled(actions, workspace);
}

}  // namespace

void connectReading(ActionRegistry& actions, Workspace& workspace) {
    actions.on(ActionId::Reload, &workspace, &Workspace::reload);
    for (const auto& [id, unit] : kUnits) {
        actions.on(id, &workspace, [&workspace, unit = unit] { workspace.setUnit(unit); });
    }
    for (const auto& [id, axis] : kAxes) {
        actions.on(id, &workspace, [&workspace, axis = axis] { workspace.setUpAxis(axis); });
    }
    for (const auto& [id, mode] : kDivisions) {
        actions.on(id, &workspace, [&workspace, mode = mode] { workspace.setSplit(mode); });
    }
    actions.on(ActionId::AutoCut, &workspace, &Workspace::setAutoCut);
    actions.on(ActionId::Weld, &workspace, &Workspace::setWeld);
    const auto follow = [&actions, &workspace] { updateChecked(actions, workspace); };
    QObject::connect(&workspace, &Workspace::loadingChanged, &actions, follow);
    QObject::connect(&workspace.document(), &Document::changed, &actions,
                     [&actions, &workspace] { updateEnabled(actions, workspace); });
    follow();
}

}  // namespace toile
