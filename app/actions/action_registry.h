// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <vector>

#include "core/flatten/method.h"

class QAction;

namespace toile {

/// Everything a person can do, by name.
enum class ActionId {
    Open,
    ExportSvg,
    ExportDxf,
    ExportObj,
    ExportReport,
    Quit,
    SelectAll,
    SelectNone,
    Frame,
    OverlayNone,
    OverlayChecker,
    OverlayArea,
    OverlayAngle,
    OverlayStrain,
    Wireframe,
    DesignerOutline,
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
    FlattenAgain,
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
    GoToPieces,
    GoToSeams,
    GoToMessages,
    About,
};

/// The action that chooses a method.
ActionId actionOf(Method method);

/// The one list of actions behind menus, toolbar, shortcuts and help. Holds the actions; what they
/// do is connected elsewhere.
class ActionRegistry : public QObject {
    Q_OBJECT

public:
    explicit ActionRegistry(QObject* parent = nullptr);

    QAction& operator[](ActionId id) const { return *actions_.at(id); }
    /// In the order of the table.
    std::vector<QAction*> all() const;

private:
    std::map<ActionId, QAction*> actions_;
};

}  // namespace toile
