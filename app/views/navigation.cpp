// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/navigation.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/base/text.h"

namespace toile::app {

namespace {

struct DragRow {
    Navigation navigation;
    Qt::MouseButton button;
    Qt::KeyboardModifiers modifiers;
    CameraMove move;
};

constexpr auto kNone = Qt::NoModifier;
constexpr auto kShift = Qt::ShiftModifier;
constexpr auto kCtrl = Qt::ControlModifier;
constexpr auto kAlt = Qt::AltModifier;

/// Combinations not listed do nothing.
const DragRow kDrags[] = {
    {Navigation::Toile, Qt::MiddleButton, kNone, CameraMove::Turn},
    {Navigation::Toile, Qt::MiddleButton, kShift, CameraMove::Pan},
    {Navigation::Toile, Qt::MiddleButton, kCtrl, CameraMove::Zoom},
    {Navigation::Toile, Qt::RightButton, kNone, CameraMove::Turn},
    {Navigation::Toile, Qt::RightButton, kShift, CameraMove::Pan},
    {Navigation::Toile, Qt::RightButton, kCtrl, CameraMove::Zoom},

    {Navigation::Blender, Qt::MiddleButton, kNone, CameraMove::Turn},
    {Navigation::Blender, Qt::MiddleButton, kShift, CameraMove::Pan},
    {Navigation::Blender, Qt::MiddleButton, kCtrl, CameraMove::Zoom},
    // For mice and touchpads without a middle button.
    {Navigation::Blender, Qt::LeftButton, kAlt, CameraMove::Turn},
    {Navigation::Blender, Qt::LeftButton, kAlt | kShift, CameraMove::Pan},
    {Navigation::Blender, Qt::LeftButton, kAlt | kCtrl, CameraMove::Zoom},

    {Navigation::Clo, Qt::RightButton, kNone, CameraMove::Turn},
    {Navigation::Clo, Qt::MiddleButton, kNone, CameraMove::Pan},

    {Navigation::Rhino, Qt::RightButton, kNone, CameraMove::Turn},
    {Navigation::Rhino, Qt::RightButton, kShift, CameraMove::Pan},
    {Navigation::Rhino, Qt::RightButton, kCtrl, CameraMove::Zoom},
    {Navigation::Rhino, Qt::RightButton, kCtrl | kShift, CameraMove::Turn},
};

struct KeyRow {
    int key;
    ViewKey plain, withCtrl;
};

constexpr KeyRow kKeys[] = {
    {Qt::Key_1, ViewKey::Front, ViewKey::Back},
    {Qt::Key_3, ViewKey::Right, ViewKey::Left},
    {Qt::Key_7, ViewKey::Top, ViewKey::Bottom},
    {Qt::Key_9, ViewKey::Opposite, ViewKey::Opposite},
    {Qt::Key_5, ViewKey::Orthographic, ViewKey::Orthographic},
    {Qt::Key_4, ViewKey::TurnLeft, ViewKey::TurnLeft},
    {Qt::Key_6, ViewKey::TurnRight, ViewKey::TurnRight},
    {Qt::Key_8, ViewKey::TurnUp, ViewKey::TurnUp},
    {Qt::Key_2, ViewKey::TurnDown, ViewKey::TurnDown},
};

/// Without Num Lock, Qt reports the number pad's keys as navigation keys.
int withNumLock(int key) {
    constexpr std::pair<int, int> kNames[] = {
        {Qt::Key_End, Qt::Key_1},  {Qt::Key_Down, Qt::Key_2},  {Qt::Key_PageDown, Qt::Key_3},
        {Qt::Key_Left, Qt::Key_4}, {Qt::Key_Clear, Qt::Key_5}, {Qt::Key_Right, Qt::Key_6},
        {Qt::Key_Home, Qt::Key_7}, {Qt::Key_Up, Qt::Key_8},    {Qt::Key_PageUp, Qt::Key_9},
    };
    const auto* found = std::ranges::find(kNames, key, &std::pair<int, int>::first);
    return found == std::end(kNames) ? key : found->second;
}

}  // namespace

CameraMove cameraMove(Navigation navigation, Qt::MouseButton button,
                      Qt::KeyboardModifiers modifiers) {
    const auto* found = std::ranges::find_if(kDrags, [&](const DragRow& row) -> bool {
        return row.navigation == navigation && row.button == button && row.modifiers == modifiers;
    });
    if (found != std::end(kDrags)) {
        return found->move;
    }
    if (navigation == Navigation::Toile && button == Qt::LeftButton &&
        !modifiers.testFlag(Qt::AltModifier)) {
        return modifiers.testFlag(Qt::ShiftModifier) ? CameraMove::Pan : CameraMove::Turn;
    }
    return CameraMove::None;
}

QString cameraHint(Navigation navigation, bool flat) {
    if (flat) {
        return navigation == Navigation::Rhino
                   ? tr("Right drag or Space+drag: move the view · Wheel: zoom")
                   : tr("Middle drag or Space+drag: move the view · Wheel: zoom");
    }
    switch (navigation) {
        case Navigation::Toile:
            return tr("Drag: turn · Shift+drag: move · Wheel: zoom");
        case Navigation::Blender:
            return tr("Middle drag: turn · Shift+middle drag: move · Wheel: zoom");
        case Navigation::Clo:
            return tr("Right drag: turn · Middle drag: move · Wheel: zoom");
        case Navigation::Rhino:
            return tr("Right drag: turn · Shift+right drag: move · Wheel: zoom");
    }
    return {};
}

std::optional<ViewKey> viewKey(int key, Qt::KeyboardModifiers modifiers, bool arrowsAreKeypad) {
    const bool isArrow = key >= Qt::Key_Left && key <= Qt::Key_Down;
    if (!modifiers.testFlag(Qt::KeypadModifier) || (isArrow && arrowsAreKeypad)) {
        return std::nullopt;
    }
    const auto* found = std::ranges::find(kKeys, withNumLock(key), &KeyRow::key);
    if (found == std::end(kKeys)) {
        return std::nullopt;
    }
    return modifiers.testFlag(Qt::ControlModifier) ? found->withCtrl : found->plain;
}

}  // namespace toile::app
