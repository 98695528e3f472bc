// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/layout_actions.h"

#include <QAction>
#include <algorithm>
#include <numbers>
#include <utility>

#include "app/actions/workspace.h"
#include "app/document/layout.h"
#include "app/jobs/garment_jobs.h"

namespace toile {

namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

constexpr std::pair<ActionId, Alignment> kAlignments[] = {
    {ActionId::AlignLeft, Alignment::Left},     {ActionId::AlignRight, Alignment::Right},
    {ActionId::AlignTop, Alignment::Top},       {ActionId::AlignBottom, Alignment::Bottom},
    {ActionId::AlignCentre, Alignment::Centre}, {ActionId::AlignMiddle, Alignment::Middle},
};

constexpr std::pair<ActionId, Direction> kDirections[] = {
    {ActionId::DistributeAcross, Direction::Across},
    {ActionId::DistributeUpwards, Direction::Upwards},
};

}  // namespace

LayoutActions::LayoutActions(ActionRegistry& actions, Workspace& workspace, QObject* parent)
    : QObject(parent), actions_(actions), workspace_(workspace) {
    connectArranging();
    connectGrain();
    connect(&workspace_.document(), &Document::changed, this, &LayoutActions::update);
    update();
}

void LayoutActions::onSelected(ActionId id, std::function<void(const std::vector<int>&)> change) {
    actions_.on(id, this, [this, change = std::move(change)] {
        if (const std::vector<int> pieces = selectedFlat(workspace_.document()); !pieces.empty()) {
            change(pieces);
        }
    });
}

std::vector<int> LayoutActions::chosen() const {
    std::vector<int> pieces = selectedFlat(workspace_.document());
    return pieces.empty() ? allFlat(workspace_.document()) : pieces;
}

void LayoutActions::connectArranging() {
    Document& document = workspace_.document();
    onSelected(ActionId::TurnLeft, [&document](const std::vector<int>& pieces) {
        turnTogether(document, tr("Turn"), pieces, kRightAngle);
    });
    onSelected(ActionId::TurnRight, [&document](const std::vector<int>& pieces) {
        turnTogether(document, tr("Turn"), pieces, -kRightAngle);
    });
    onSelected(ActionId::MirrorLeftRight, [&document](const std::vector<int>& pieces) {
        mirrorTogether(document, tr("Mirroring"), pieces, Mirroring::LeftRight);
    });
    onSelected(ActionId::MirrorUpsideDown, [&document](const std::vector<int>& pieces) {
        mirrorTogether(document, tr("Mirroring"), pieces, Mirroring::UpsideDown);
    });
    for (const auto& [id, alignment] : kAlignments) {
        onSelected(id, [&document, alignment = alignment](const std::vector<int>& pieces) {
            align(document, pieces, alignment);
        });
    }
    for (const auto& [id, direction] : kDirections) {
        onSelected(id, [&document, direction = direction](const std::vector<int>& pieces) {
            distribute(document, pieces, direction);
        });
    }
    actions_.on(ActionId::LayOutAgain, this,
                [this, &document] { layOutAgain(document, chosen()); });
}

void LayoutActions::connectGrain() {
    Document& document = workspace_.document();
    actions_.on(ActionId::GrainUpwards, this,
                [this, &document] { turnGrainUpwards(document, chosen()); });
    actions_.on(ActionId::BestGrain, this, &LayoutActions::lookForBestGrain);
    connect(&workspace_.jobs(), &JobRunner::cancelled, this, [this](const QString&, bool replaced) {
        if (grain_ != 0 && !workspace_.jobs().isUnderWay(grain_)) {
            grain_ = 0;
            if (replaced) {  // by an edit; who cancels it knows
                sayOutdated();
            }
        }
    });
    actions_.on(ActionId::ForgetGrain, this, [this, &document] {
        PieceGrains grains;
        for (const int piece : chosen()) {
            grains[piece] = std::nullopt;
        }
        setGrain(document, tr("Grain"), grains);
    });
}

void LayoutActions::lookForBestGrain() {
    const std::vector<int> pieces = chosen();
    if (pieces.empty()) {
        return;
    }
    grain_ = workspace_.jobs().start(
        grainJob(workspace_.document(), pieces, [this](const PieceGrains& found, bool outdated) {
            grain_ = 0;
            if (outdated) {
                sayOutdated();
            } else if (found.empty()) {
                emit failed(
                    tr("No grain is better than another here: the cloth is strained alike in all "
                       "directions, or not at all. Say yourself how the grain runs."));
            }
            if (!found.empty()) {
                setGrain(workspace_.document(), tr("Best grain"), found);
            }
        }));
}

void LayoutActions::sayOutdated() {
    emit failed(
        tr("Pieces were flattened anew, or the fabric was changed, while their best "
           "grain was looked for. Ask for it once more."));
}

void LayoutActions::update() {
    const Document& document = workspace_.document();
    const std::size_t selected = selectedFlat(document).size();
    for (const ActionId id : {ActionId::TurnLeft, ActionId::TurnRight, ActionId::MirrorLeftRight,
                              ActionId::MirrorUpsideDown}) {
        actions_[id].setEnabled(selected > 0);
    }
    for (const auto& [id, alignment] : kAlignments) {
        actions_[id].setEnabled(selected > 1);
    }
    for (const auto& [id, direction] : kDirections) {
        actions_[id].setEnabled(selected > 2);
    }
    const std::vector<int> all = allFlat(document);
    for (const ActionId id : {ActionId::LayOutAgain, ActionId::GrainUpwards, ActionId::BestGrain}) {
        actions_[id].setEnabled(!all.empty());
    }
    const bool stated = std::ranges::any_of(chosen(), [&](int piece) {
        return document.settings()[static_cast<std::size_t>(piece)].grain.has_value();
    });
    actions_[ActionId::ForgetGrain].setEnabled(stated);
    for (const ActionId id :
         {ActionId::Rulers, ActionId::Grid, ActionId::Snapping, ActionId::GoToPosition,
          ActionId::GoToFabric, ActionId::ToolSelect, ActionId::ToolGrain}) {
        actions_[id].setEnabled(document.garment() != nullptr);
    }
}

}  // namespace toile
