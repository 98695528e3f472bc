// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "tests/app/support/window_fixture.h"

namespace toile::test {

using namespace app;

/// A script of steps in the window, one sentence per line:
///
///     Press **Ctrl+O** and open `a/file.obj`.
///     Press **Ctrl+S** and save as `name.toile`.
///     Choose **File ▸ Export pattern ▸ As SVG drawing…** and save as `name.svg`.
///     Choose **Jersey** for **Preset**.
///     Click **front** in the pattern.          (or: in the garment, in the list, in the window)
///     Drag **back** in the pattern 200 mm to the right.
///     Drag from the lower edge of **front** to its middle in the pattern.
///     You see “5 pieces”.                      (or: … in the list)
///     Picture path/of/it.png
///
/// Lines that start with # are comments.
struct GuideStep {
    enum class Kind { Do, Picture };
    Kind kind;
    int line;      ///< of the script, from 1
    QString text;  ///< the sentence, or the picture's path
};

std::vector<GuideStep> readGuide(const QString& path);

/// Follows a script in a window as a user does: with keys, menus and the mouse.
class GuideWalker {
public:
    /// @param source  folder of the script's file names
    GuideWalker(WindowFixture& fixture, QString source)
        : fixture_(fixture), source_(std::move(source)) {}

    /// Does one step. @return the problem, or empty
    QString follow(const QString& sentence);

private:
    /// Does something that saves a file.
    QString saving(const QString& name, const std::function<QString()>& act);
    QString press(const QString& keys);
    QString choose(const QString& path);
    QString chooseFor(const QString& choice, const QString& label);
    QString click(const QString& what, const QString& where);
    QString dragPiece(const QString& piece, double right);
    QString dragFromEdge(const QString& piece);
    QString see(const QString& text, bool inList);
    /// Answers the next file dialogs.
    void answerWith(const QString& opened, const QString& saved);
    void settle();

    WindowFixture& fixture_;
    QString source_;
};

}  // namespace toile::test
