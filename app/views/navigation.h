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

/// The camera move of a drag with this button in the user's mouse scheme. In Toile's own scheme the
/// left button turns, and pans with Shift, unless a tool takes it. The other schemes leave it to
/// tools. Pure.
CameraMove cameraMove(Navigation navigation, Qt::MouseButton button,
                      Qt::KeyboardModifiers modifiers);

/// For the status bar: "Drag: turn · Shift+drag: move · Wheel: zoom".
/// @param flat  for the pattern view, which cannot turn
QString cameraHint(Navigation navigation, bool flat);

/// Action of a number pad key in the garment view: the sides as in Blender; Ctrl selects the
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

/// On macOS, Qt sets the keypad modifier for every arrow key.
#ifdef Q_OS_MACOS
inline constexpr bool kArrowsAreKeypad = true;
#else
inline constexpr bool kArrowsAreKeypad = false;
#endif

/// Nullopt if the key is not on the number pad or has no action. Pure.
/// @param arrowsAreKeypad  arrow keys carry the keypad modifier wherever they are
std::optional<ViewKey> viewKey(int key, Qt::KeyboardModifiers modifiers,
                               bool arrowsAreKeypad = kArrowsAreKeypad);

}  // namespace toile::app
