// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QStringList>
#include <functional>

class QPrinter;
class QWidget;

namespace toile::app {

/// What to do with unsaved changes.
enum class SaveAnswer { Save, Discard, Cancel };

/// What to do with a file that another program has changed.
enum class OverwriteAnswer { SaveAnyway, SaveAs, Cancel };

/// Asks for files and printers. Replaceable, so that tests answer without a dialog on the screen.
/// Without further note, a function returns an empty value if the user cancels.
struct FileDialogs {
    Q_DECLARE_TR_FUNCTIONS(FileDialogs)

public:
    /// Files of a garment to open.
    std::function<QStringList(QWidget* parent, const QString& folder)> open;
    /// A seams file to read.
    std::function<QString(QWidget* parent, const QString& folder)> openSeams;
    /// A pattern to compare with.
    std::function<QString(QWidget* parent, const QString& folder)> openPattern;
    /// A mesh to wear a pattern on.
    std::function<QString(QWidget* parent, const QString& folder)> openBody;
    /// Drawings of hides to lay a pattern on.
    std::function<QStringList(QWidget* parent, const QString& folder)> openHides;
    /// A file to write. The suggestion is a full path with the format's extension.
    std::function<QString(QWidget* parent, const QString& suggestion, const QString& filter)> save;
    /// A report to write, likewise.
    std::function<QString(QWidget* parent, const QString& suggestion, const QString& filter)>
        saveReport;
    /// Whether an existing file may be replaced.
    std::function<bool(QWidget* parent, const QString& path)> mayReplace;
    /// Shows a folder in the desktop's file manager.
    std::function<void(const QString& folder)> showFolder;
    /// A project file to write.
    std::function<QString(QWidget* parent, const QString& suggestion)> saveProject;
    /// A mesh of a project that is no longer at its stored path.
    std::function<QString(QWidget* parent, const QString& folder, const QString& name)> findMesh;
    /// Whether to save the changes before closing. `name` is that of the project, or of the garment
    /// if there is no project file yet.
    std::function<SaveAnswer(QWidget* parent, const QString& name)> askToSave;

    /// Whether to overwrite changes by another program in the project of this name.
    std::function<OverwriteAnswer(QWidget* parent, const QString& name)> askToOverwrite;

    /// Whether any printer is available.
    std::function<bool()> hasPrinter;
    /// Sets up the printer for so many pages; false if the user cancels.
    std::function<bool(QWidget* parent, QPrinter& printer, int pages)> choosePrinter;

    /// The desktop's native dialogs.
    static FileDialogs native();
};

/// Extensions of mesh and project files that can be opened, in lower case with the dot.
QStringList openableSuffixes();
bool isOpenable(const QString& path);

}  // namespace toile::app
