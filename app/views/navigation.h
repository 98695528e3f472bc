// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <Qt>
#include <QtGlobal>
#include <optional>

#include "app/settings/choices.h"

namespace toile::app {

/// What a drag does to the camera.
enum class CameraMove { None, Turn, Pan, Zoom };

/// What a drag with this button does in the way a person is used to. In Toile's own the left button
/// turns, and pans with Shift, where no tool wants it; the other programs keep it for their tools.
/// Pure.
CameraMove cameraMove(Navigation navigation, Qt::MouseButton button,
                      Qt::KeyboardModifiers modifiers);

/// For the status bar: "Drag: turn · Shift+drag: move · Wheel: zoom".
/// @param flat in the pattern view, which is moved only
QString cameraHint(Navigation navigation, bool flat);

/// What a key of the number pad does to the garment view: the sides as in Blender, with Ctrl the
/// opposite one.
enum class ViewKey {
    Front,
    Back,
    Right,
    Left,
    Top,
    Bottom,
    Opposite,
    Orthographic,
    TurnLeft,
    TurnRight,
    TurnUp,
    TurnDown,
};

/// On a Mac Qt says of every arrow key that it is of the number pad.
#ifdef Q_OS_MACOS
inline constexpr bool kArrowsAreKeypad = true;
#else
inline constexpr bool kArrowsAreKeypad = false;
#endif

/// Nothing where the key is not of the number pad or means nothing. Pure.
/// @param arrowsAreKeypad  an arrow key says nothing of where it is
std::optional<ViewKey> viewKey(int key, Qt::KeyboardModifiers modifiers,
                               bool arrowsAreKeypad = kArrowsAreKeypad);

}  // namespace toile::app
