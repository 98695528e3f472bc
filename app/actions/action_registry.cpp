// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/action_registry.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QKeySequence>

#include "app/widgets/icon.h"

namespace toile {

namespace {

/// Actions of one group exclude each other; those of Toggle stand alone.
enum class Group { None, Toggle, Overlay, Method, Quality, Solver, Unit, UpAxis, Split };

struct ActionSpec {
    ActionId id;
    const char* name;  ///< object name, for tests and settings
    const char* text;
    const char* shortcut;
    const char* tip;
    const char* icon = "";
    const char* shortText = "";  ///< for the toolbar
    Group group = Group::None;
};

#define TR(text) QT_TRANSLATE_NOOP("Actions", text)

constexpr ActionSpec kActions[] = {
    {ActionId::Open, "open", TR("&Open…"), "Ctrl+O",
     TR("Open a garment: one file, or several that belong together"), "open", TR("Open")},
    {ActionId::ExportSvg, "exportSvg", TR("As &SVG drawing…"), "Ctrl+E",
     TR("Write the pattern at true scale for printing and drawing programs")},
    {ActionId::ExportDxf, "exportDxf", TR("As &DXF drawing…"), "",
     TR("Write the pattern at true scale for pattern and cutting programs")},
    {ActionId::ExportObj, "exportObj", TR("As &OBJ with UV map…"), "",
     TR("Write the garment again with the pattern as its UV map")},
    {ActionId::ExportReport, "exportReport", TR("&Report (JSON)…"), "",
     TR("Write every figure of every piece for other programs")},
    {ActionId::Quit, "quit", TR("&Quit"), "Ctrl+Q", TR("Close the window")},
    {ActionId::SelectAll, "selectAll", TR("Select &all"), "Ctrl+A", TR("Select every piece")},
    {ActionId::SelectNone, "selectNone", TR("Select &none"), "Ctrl+Shift+A",
     TR("Clear the selection of pieces and seams")},
    {ActionId::Frame, "frame", TR("&Frame"), "F",
     TR("Show the selected pieces or seam, or everything where none is selected"), "frame",
     TR("Frame")},
    {ActionId::OverlayNone, "overlayNone", TR("Piece &colours"), "1",
     TR("Every piece in its own colour"), "overlay-none", TR("Plain"), Group::Overlay},
    {ActionId::OverlayChecker, "overlayChecker", TR("Check&erboard"), "2",
     TR("True-scale squares of 1 cm on the cloth"), "overlay-checker", TR("Checker"),
     Group::Overlay},
    {ActionId::OverlayArea, "overlayArea", TR("&Area change"), "3",
     TR("How much area the flat piece has gained or lost"), "overlay-area", TR("Area"),
     Group::Overlay},
    {ActionId::OverlayAngle, "overlayAngle", TR("An&gle change"), "4",
     TR("How much the corners of the cloth have turned"), "overlay-angle", TR("Angle"),
     Group::Overlay},
    {ActionId::OverlayStrain, "overlayStrain", TR("Edge &strain"), "5",
     TR("How far the cloth must stretch or gather to take its shape"), "overlay-strain",
     TR("Strain"), Group::Overlay},
    {ActionId::Wireframe, "wireframe", TR("Show &wireframe"), "W",
     TR("Draw the triangles of the cloth"), "wireframe", TR("Wireframe"), Group::Toggle},
    {ActionId::DesignerOutline, "designerOutline", TR("&Designer's outline"), "D",
     TR("Draw the designer's own panels over the flat pieces, where the file carries them"), "", "",
     Group::Toggle},
    {ActionId::MethodIsometric, "methodIsometric", TR("Least &distortion"), "",
     TR("Seam lines keep their exact length; the cloth between them stretches as little as that "
        "allows, and no triangle is turned over"),
     "", "", Group::Method},
    {ActionId::MethodCurvature, "methodCurvature", TR("Angles follow the c&urvature"), "",
     TR("Seam lines keep their exact length; the outline turns where the garment is curved"), "",
     "", Group::Method},
    {ActionId::MethodWang2005, "methodWang2005", TR("Angles spread &evenly (Wang 2005)"), "",
     TR("Seam lines keep their exact length; the outline gives way alike all around"), "", "",
     Group::Method},
    {ActionId::MethodStretch, "methodStretch", TR("Least &stretch on a circle (Yoshizawa 2004)"),
     "",
     TR("Seam lines keep their exact length on a round outline; the cloth inside is moved until it "
        "stretches least"),
     "", "", Group::Method},
    {ActionId::MethodConvex, "methodConvex", TR("On a ci&rcle (Floater 2003)"), "",
     TR("Seam lines keep their exact length on a round outline: no triangle is ever turned over, "
        "but it is no pattern"),
     "", "", Group::Method},
    {ActionId::MethodNatural, "methodNatural", TR("&Free outline (Desbrun 2002)"), "",
     TR("The cloth keeps its angles as well as it can; seam lines change their length"), "", "",
     Group::Method},
    {ActionId::MethodLscm, "methodLscm", TR("Free outline, least squares (Lé&vy 2002)"), "",
     TR("Nearly the same by another way; seam lines change their length"), "", "", Group::Method},
    {ActionId::MethodAbf, "methodAbf", TR("Free outline, by an&gles (Sheffer 2005)"), "",
     TR("Every triangle keeps its angles as well as it can; seam lines change their length"), "",
     "", Group::Method},
    {ActionId::QualityDraft, "qualityDraft", TR("&Draft"), "",
     TR("Quick: within some percent of the least distortion"), "", "", Group::Quality},
    {ActionId::QualityStandard, "qualityStandard", TR("&Standard"), "",
     TR("Within about a thousandth of the least distortion"), "", "", Group::Quality},
    {ActionId::QualityFine, "qualityFine", TR("&Fine"), "",
     TR("To the last digits: takes its time"), "", "", Group::Quality},
    {ActionId::SolverNewton, "solverNewton", TR("Outline by &Newton steps"), "",
     TR("The fast way to the outline"), "", "", Group::Solver},
    {ActionId::SolverSlcp, "solverSlcp", TR("Outline by &linearly constrained steps"), "",
     TR("The published way to the same outline"), "", "", Group::Solver},
    {ActionId::FlattenAgain, "flattenAgain", TR("Flatten &again"), "Ctrl+F5",
     TR("Flatten every piece again"), "flatten", TR("Flatten")},
    {ActionId::Cancel, "cancel", TR("&Cancel"), "Esc", TR("Stop what is running"), "cancel"},
    {ActionId::Reload, "reload", TR("&Reload"), "F5",
     TR("Read the garment's files again as they are now")},
    {ActionId::UnitAuto, "unitAuto", TR("&Automatic"), "",
     TR("Choose the unit that gives a garment of human size"), "", "", Group::Unit},
    {ActionId::UnitMillimetre, "unitMillimetre", TR("&Millimetres"), "",
     TR("Read the file's numbers as millimetres"), "", "", Group::Unit},
    {ActionId::UnitCentimetre, "unitCentimetre", TR("&Centimetres"), "",
     TR("Read the file's numbers as centimetres"), "", "", Group::Unit},
    {ActionId::UnitMetre, "unitMetre", TR("M&etres"), "", TR("Read the file's numbers as metres"),
     "", "", Group::Unit},
    {ActionId::UnitInch, "unitInch", TR("&Inches"), "", TR("Read the file's numbers as inches"), "",
     "", Group::Unit},
    {ActionId::UpAuto, "upAuto", TR("&Automatic"), "",
     TR("Choose the axis along which a garment would stand upright"), "", "", Group::UpAxis},
    {ActionId::UpY, "upY", TR("&Y points up"), "", TR("The garment stands along the file's y axis"),
     "", "", Group::UpAxis},
    {ActionId::UpZ, "upZ", TR("&Z points up"), "", TR("The garment stands along the file's z axis"),
     "", "", Group::UpAxis},
    {ActionId::SplitAuto, "splitAuto", TR("&Automatic"), "",
     TR("Divide the garment into pieces by what the file has"), "", "", Group::Split},
    {ActionId::SplitComponents, "splitComponents", TR("&Parts"), "",
     TR("Whatever hangs together is one piece"), "", "", Group::Split},
    {ActionId::SplitObjects, "splitObjects", TR("&Objects"), "",
     TR("Each object of the file is one piece"), "", "", Group::Split},
    {ActionId::SplitGroups, "splitGroups", TR("&Groups"), "",
     TR("Each group of the file is one piece"), "", "", Group::Split},
    {ActionId::SplitMaterials, "splitMaterials", TR("&Materials"), "",
     TR("Each material of the file is one piece"), "", "", Group::Split},
    {ActionId::SplitUv, "splitUv", TR("&UV islands"), "",
     TR("Each island of the file's UV map is one piece"), "", "", Group::Split},
    {ActionId::SplitSeams, "splitSeams", TR("&Cuts only"), "",
     TR("One piece until a cut of the seams file parts it"), "", "", Group::Split},
    {ActionId::AutoCut, "autoCut", TR("&Cut open automatically"), "",
     TR("Cut open every piece that cannot lie flat as it is"), "", "", Group::Toggle},
    {ActionId::Weld, "weld", TR("&Weld vertices"), "",
     TR("Join vertices of an object that lie on each other"), "", "", Group::Toggle},
    {ActionId::SeamsFromFile, "seamsFromFile", TR("&Seams from file…"), "",
     TR("Take cuts and ease from a seams file (JSON)")},
    {ActionId::SeamsToFile, "seamsToFile", TR("Save sea&ms file…"), "",
     TR("Write the cuts and the ease that were stated to a seams file (JSON)")},
    {ActionId::StateEase, "stateEase", TR("State the &ease…"), "F2",
     TR("Say how much longer the left edge of the selected seam is meant to be")},
    {ActionId::ForgetEase, "forgetEase", TR("Ease &from the garment"), "Del",
     TR("Take the ease of the selected seam from its 3D lengths again")},
    {ActionId::GoToPieces, "goToPieces", TR("Go to &pieces"), "Ctrl+1",
     TR("Show the list of pieces and move the keyboard there")},
    {ActionId::GoToSeams, "goToSeams", TR("Go &to seams"), "Ctrl+2",
     TR("Show the list of seams and move the keyboard there")},
    {ActionId::GoToMessages, "goToMessages", TR("Go to &messages"), "Ctrl+3",
     TR("Show the messages and move the keyboard there")},
    {ActionId::About, "about", TR("&About Toile"), "", TR("Version, licence, and what Toile does")},
};

#undef TR

QString translated(const char* text) {
    return *text ? QCoreApplication::translate("Actions", text) : QString();
}

}  // namespace

ActionId actionOf(Method method) {
    switch (method) {
        case Method::Isometric:
            return ActionId::MethodIsometric;
        case Method::Curvature:
            return ActionId::MethodCurvature;
        case Method::Wang2005:
            return ActionId::MethodWang2005;
        case Method::Stretch:
            return ActionId::MethodStretch;
        case Method::Natural:
            return ActionId::MethodNatural;
        case Method::Lscm:
            return ActionId::MethodLscm;
        case Method::Abf:
            return ActionId::MethodAbf;
        case Method::Convex:
            return ActionId::MethodConvex;
    }
    return ActionId::MethodIsometric;
}

ActionRegistry::ActionRegistry(QObject* parent) : QObject(parent) {
    std::map<Group, QActionGroup*> groups;
    for (const ActionSpec& spec : kActions) {
        auto* action = new QAction(translated(spec.text), this);
        action->setObjectName(spec.name);
        const QKeySequence shortcut(QString::fromLatin1(spec.shortcut));
        action->setShortcut(shortcut);
        const QString tip = translated(spec.tip);
        action->setStatusTip(tip);
        action->setToolTip(
            shortcut.isEmpty()
                ? tip
                : QString("%1 (%2)").arg(tip, shortcut.toString(QKeySequence::NativeText)));
        if (*spec.icon) {
            action->setIcon(themedIcon(spec.icon));
        }
        if (*spec.shortText) {
            action->setIconText(translated(spec.shortText));
        }
        action->setCheckable(spec.group != Group::None);
        if (spec.group > Group::Toggle) {
            QActionGroup*& group = groups[spec.group];
            if (!group) {
                group = new QActionGroup(this);
            }
            group->addAction(action);
        }
        actions_.emplace(spec.id, action);
    }
    actions_.at(ActionId::ForgetEase)->setShortcuts({Qt::Key_Delete, Qt::Key_Backspace});
    actions_.at(ActionId::Quit)->setMenuRole(QAction::QuitRole);
    actions_.at(ActionId::About)->setMenuRole(QAction::AboutRole);
}

std::vector<QAction*> ActionRegistry::all() const {
    std::vector<QAction*> list;
    for (const auto& [id, action] : actions_) {
        list.push_back(action);
    }
    return list;
}

}  // namespace toile
