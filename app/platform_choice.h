// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace toile::app {

/// Makes shaders and icons known: a static library's resources are left out by the linker unless
/// asked for. To be called before the first window is made; again does no harm.
void loadResources();

/// For the command line: of what Qt says of its surroundings only what is critical is worth a
/// person's attention there.
void quietenQt();

/// Before the application is made: Qt ends the program with a signal where it finds no display, or
/// its part for it is not installed.

/// Asks whether an X display answers. The connection stays open as long as this lives: until Qt has
/// its own, since a display that the last one leaves may begin anew, and answers nobody meanwhile.
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

/// Why no window can be opened, as far as that can be told before; empty where nothing is known
/// against it.
QString windowProblem(const DisplayProbe& display);

/// Chooses Qt's platform for drawing pictures: that of the X display where one answers, else one
/// without a screen. Elsewhere than on Linux it is left as it is.
/// @return a sentence where there is neither; else empty
QString choosePicturePlatform(const DisplayProbe& display);

}  // namespace toile::app
