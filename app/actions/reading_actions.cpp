// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/reading_actions.h"

#include <QAction>
#include <optional>
#include <utility>

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

}  // namespace

ReadingActions::ReadingActions(ActionRegistry& actions, Workspace& workspace, QObject* parent)
    : QObject(parent), actions_(actions), workspace_(workspace) {
    connectActions();
    connect(&workspace_, &Workspace::loadingChanged, this, &ReadingActions::updateChecked);
    connect(&workspace_.document(), &Document::changed, this, &ReadingActions::updateEnabled);
    updateChecked();
}

void ReadingActions::connectActions() {
    connect(&actions_[ActionId::Reload], &QAction::triggered, &workspace_, &Workspace::reload);
    for (const auto& [id, unit] : kUnits) {
        connect(&actions_[id], &QAction::triggered, this,
                [this, unit = unit] { workspace_.setUnit(unit); });
    }
    for (const auto& [id, axis] : kAxes) {
        connect(&actions_[id], &QAction::triggered, this,
                [this, axis = axis] { workspace_.setUpAxis(axis); });
    }
    for (const auto& [id, mode] : kDivisions) {
        connect(&actions_[id], &QAction::triggered, this,
                [this, mode = mode] { workspace_.setSplit(mode); });
    }
    connect(&actions_[ActionId::AutoCut], &QAction::triggered, &workspace_, &Workspace::setAutoCut);
    connect(&actions_[ActionId::Weld], &QAction::triggered, &workspace_, &Workspace::setWeld);
}

void ReadingActions::updateChecked() {
    const LoadOptions& loading = workspace_.loading();
    for (const auto& [id, unit] : kUnits) {
        actions_[id].setChecked(loading.unit == unit);
    }
    for (const auto& [id, axis] : kAxes) {
        actions_[id].setChecked(loading.up == axis);
    }
    for (const auto& [id, mode] : kDivisions) {
        actions_[id].setChecked(loading.split == mode);
    }
    actions_[ActionId::AutoCut].setChecked(loading.autoCut);
    actions_[ActionId::Weld].setChecked(loading.weld);
    updateEnabled();
}

void ReadingActions::updateEnabled() {
    const bool open = workspace_.document().garment() != nullptr;
    actions_[ActionId::Reload].setEnabled(open);
    actions_[ActionId::SeamsFromFile].setEnabled(open);
    actions_[ActionId::SeamsToFile].setEnabled(open && !workspace_.loading().seams.empty());
    actions_[ActionId::SplitSeams].setEnabled(!workspace_.loading().seams.cuts.empty());
}

}  // namespace toile
