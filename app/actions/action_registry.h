// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <map>
#include <utility>
#include <vector>

#include "core/flatten/method.h"

namespace toile {

/// Everything a person can do, by name.
enum class ActionId {
    Open,
    Save,
    SaveAs,
    ExportSvg,
    ExportDxf,
    ExportObj,
    ExportReport,
    ReadyToCut,
    Quit,
    Undo,
    Redo,
    SelectAll,
    SelectNone,
    Frame,
    OverlayNone,
    OverlayChecker,
    OverlayArea,
    OverlayAngle,
    OverlayStrain,
    OverlayWarp,
    OverlayWeft,
    OverlayBias,
    OverlayPrincipal,
    OverlayDirichlet,
    ValuesPerTriangle,
    WorstSpots,
    Wireframe,
    DesignerOutline,
    ShowSeams,
    Xray,
    Shaded,
    PieceColours,
    LookFront,
    LookBack,
    LookRight,
    LookLeft,
    LookTop,
    LookBottom,
    Orthographic,
    PlayMorph,
    MethodIsometric,
    MethodCurvature,
    MethodWang2005,
    MethodStretch,
    MethodConvex,
    MethodNatural,
    MethodLscm,
    MethodAbf,
    QualityDraft,
    QualityStandard,
    QualityFine,
    SolverNewton,
    SolverSlcp,
    CompareMethods,
    ToolSelect,
    ToolCut,
    ToolLoop,
    ToolDart,
    ToolJoin,
    ToolMeasure,
    FlattenAgain,
    AutoFlatten,
    Cancel,
    Reload,
    UnitAuto,
    UnitMillimetre,
    UnitCentimetre,
    UnitMetre,
    UnitInch,
    UpAuto,
    UpY,
    UpZ,
    SplitAuto,
    SplitComponents,
    SplitObjects,
    SplitGroups,
    SplitMaterials,
    SplitUv,
    SplitSeams,
    AutoCut,
    Weld,
    SeamsFromFile,
    SeamsToFile,
    StateEase,
    ForgetEase,
    ToolGrain,
    TurnLeft,
    TurnRight,
    MirrorLeftRight,
    MirrorUpsideDown,
    AlignLeft,
    AlignRight,
    AlignTop,
    AlignBottom,
    AlignCentre,
    AlignMiddle,
    DistributeAcross,
    DistributeUpwards,
    LayOutAgain,
    GrainUpwards,
    BestGrain,
    ForgetGrain,
    Rulers,
    Grid,
    Snapping,
    GoToPosition,
    GoToFabric,
    GoToPieces,
    GoToSeams,
    GoToProblems,
    GoToHistory,
    ResetLayout,
    EditPreferences,
    CommandPalette,
    Shortcuts,
    About,
};

/// The action that chooses a method.
ActionId actionOf(Method method);

/// A menu's text without the mark of its mnemonic: "Save && &close" is "Save & close".
QString withoutMnemonic(const QString& text);

/// The one list of actions behind menus, toolbar, shortcuts, command palette and help. Which menu
/// an action is in says menu_table.h. Holds the actions; what they do is connected elsewhere.
class ActionRegistry : public QObject {
    Q_OBJECT

public:
    explicit ActionRegistry(QObject* parent = nullptr);

    QAction& operator[](ActionId id) const { return *actions_.at(id); }
    /// Does this whenever the action is triggered, for as long as the receiver lives.
    template <class Receiver, class Slot>
    void on(ActionId id, const Receiver* receiver, Slot slot) const {
        connect(&(*this)[id], &QAction::triggered, receiver, std::move(slot));
    }
    /// In the order of the table.
    const std::vector<ActionId>& ids() const { return ids_; }
    std::vector<QAction*> all() const;
    /// What the table calls it, for help and lists: without mnemonic, and without what the present
    /// state adds to the menu's text.
    QString title(ActionId id) const { return titles_.at(id); }

private:
    std::map<ActionId, QAction*> actions_;
    std::map<ActionId, QString> titles_;
    std::vector<ActionId> ids_;
};

}  // namespace toile
