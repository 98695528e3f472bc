// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace toile::app {

/// Registers shaders and icons: the linker drops unused resources of a static library. Call before
/// creating the first window; repeated calls are harmless.
void loadResources();

/// For the command line: suppresses all Qt messages that are not critical.
void quietenQt();

/// Call these before creating the application. Qt aborts if it finds no display or lacks the plugin
/// for it.

/// Tests whether an X display answers. Keep it alive until Qt is connected: an X server may reset
/// when its last client disconnects, and is unreachable meanwhile.
class DisplayProbe {
public:
    DisplayProbe();
    ~DisplayProbe();
    DisplayProbe(const DisplayProbe&) = delete;
    DisplayProbe& operator=(const DisplayProbe&) = delete;

    bool answers() const { return answers_; }

private:
    void* connection_ = nullptr;
    bool answers_ = false;
};

/// Why no window can be opened, if that can be detected in advance; otherwise empty.
QString windowProblem(const DisplayProbe& display);

/// Chooses Qt's platform for drawing pictures: the X display if one answers, else one without a
/// screen. Does nothing on systems other than Linux.
/// @return a message if neither is available; else empty
QString choosePicturePlatform(const DisplayProbe& display);

}  // namespace toile::app
