// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QStringList>
#include <functional>

class QPrinter;
class QWidget;

namespace toile::app {

/// What becomes of unsaved changes.
enum class SaveAnswer { Save, Discard, Cancel };

/// What becomes of a file that another program has changed.
enum class OverwriteAnswer { SaveAnyway, SaveAs, Cancel };

/// Asking for files and printers. Replaceable, so that tests answer without a dialog on the screen.
struct FileDialogs {
    Q_DECLARE_TR_FUNCTIONS(FileDialogs)

public:
    /// Files to open as one garment; empty where the person thought better of it.
    std::function<QStringList(QWidget* parent, const QString& folder)> open;
    /// A seams file to read; empty where the person thought better of it.
    std::function<QString(QWidget* parent, const QString& folder)> openSeams;
    /// A pattern to compare with; empty where the person thought better of it.
    std::function<QString(QWidget* parent, const QString& folder)> openPattern;
    /// A mesh to wear a pattern on; empty where the person thought better of it.
    std::function<QString(QWidget* parent, const QString& folder)> openBody;
    /// Drawings of hides to lay a pattern on; empty where the person thought better of it.
    std::function<QStringList(QWidget* parent, const QString& folder)> openHides;
    /// File to write; empty where the person thought better of it. The suggestion is a full path
    /// whose ending is the format's.
    std::function<QString(QWidget* parent, const QString& suggestion, const QString& filter)> save;
    /// A report to write, likewise.
    std::function<QString(QWidget* parent, const QString& suggestion, const QString& filter)>
        saveReport;
    /// Whether a file that is there may be replaced.
    std::function<bool(QWidget* parent, const QString& path)> mayReplace;
    /// Shows a folder as the desktop shows folders.
    std::function<void(const QString& folder)> showFolder;
    /// Project file to write; empty where the person thought better of it.
    std::function<QString(QWidget* parent, const QString& suggestion)> saveProject;
    /// Where a mesh of a project is, that is not where it was; empty where that is not known.
    std::function<QString(QWidget* parent, const QString& folder, const QString& name)> findMesh;
    /// Whether the changes to the project of this name are to be saved before it is closed; where
    /// it is none yet, the pattern that was made from the garment of this name.
    std::function<SaveAnswer(QWidget* parent, const QString& name)> askToSave;

    /// Whether the project of this name is to be saved over what another program has put there.
    std::function<OverwriteAnswer(QWidget* parent, const QString& name)> askToOverwrite;

    /// Whether there is a printer to choose.
    std::function<bool()> hasPrinter;
    /// Which printer, which pages of so many, and how; false where the person thought better of it.
    std::function<bool(QWidget* parent, QPrinter& printer, int pages)> choosePrinter;

    /// The desktop's own dialogs.
    static FileDialogs native();
};

/// Endings of mesh and project files that can be opened, lower case with the dot.
QStringList openableSuffixes();
bool isOpenable(const QString& path);

}  // namespace toile::app
