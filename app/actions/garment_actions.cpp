// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/garment_actions.h"

#include <QAction>
#include <QFileInfo>
#include <QLocale>
#include <QPointer>
#include <QWidget>
#include <utility>

#include "app/actions/material_menu.h"
#include "app/actions/own_folders.h"
#include "app/actions/pattern_printing.h"
#include "app/actions/project_actions.h"
#include "app/base/text.h"
#include "app/document/layout.h"
#include "app/document/mirrored_edits.h"
#include "app/document/piece_edits.h"
#include "app/export/export_dialog.h"
#include "app/jobs/garment_jobs.h"
#include "app/session/cut_proposals.h"
#include "app/session/pattern_proof.h"
#include "app/session/workspace.h"
#include "app/settings/preferences.h"
#include "app/text/error_text.h"
#include "core/base/file.h"
#include "core/project/piece_names.h"
#include "core/project/project_file.h"

namespace toile::app {

GarmentActions::GarmentActions(ActionRegistry& actions, Workspace& workspace,
                               Preferences& preferences, QWidget& window)
    : actions_(actions),
      workspace_(workspace),
      preferences_(preferences),
      window_(window),
      project_(new ProjectActions(workspace, preferences, dialogs_, window, this)),
      printing_(new PatternPrinting(workspace, preferences, dialogs_, window, this)),
      materials_(new MaterialMenu(workspace.document(), window, this)) {
    connect(project_, &ProjectActions::failed, this, &GarmentActions::failed);
    connect(printing_, &PatternPrinting::failed, this, &GarmentActions::failed);
    connect(printing_, &PatternPrinting::printed, this, &GarmentActions::done);
    connect(printing_, &PatternPrinting::fileWanted, this,
            [this](bool onlySelected) { askAndExportAs(".pdf", onlySelected); });
    connect(&project_->recent(), &RecentFiles::wanted, this, &GarmentActions::openFiles);
    connect(&workspace_.jobs(), &JobRunner::cancelled, this, [this](const QString&, bool replaced) {
        if (grain_ != 0 && !workspace_.jobs().isUnderWay(grain_)) {
            grain_ = 0;
            if (replaced) {  // by an edit; the user knows of other cancellations
                sayOutdated();
            }
        }
    });
    actions_.connectTo(*this);
    connectState();
}

void GarmentActions::connectState() {
    const auto askWhich = [this] { actions_.followEnabled(workspace_); };
    connect(&workspace_.document(), &Document::changed, this,
            [this](const DocumentChange& what) { follow(&what); });
    for (const JobRunner* jobs : workspace_.runners()) {
        connect(jobs, &JobRunner::started, this, askWhich);
        connect(jobs, &JobRunner::idle, this, askWhich);
    }
    // Undo also reverts moves of proposed cuts.
    for (const auto signal : {&CutProposals::changed, &CutProposals::closed}) {
        connect(&workspace_.proposals(), signal, this, &GarmentActions::updateHistory);
    }
    connect(&workspace_, &Workspace::loadingChanged, this, [this] { follow(); });
    // indexChanged may precede the document's update, so only texts of the history are used.
    connect(&workspace_.document().history(), &QUndoStack::indexChanged, this,
            &GarmentActions::updateHistory);
    updateHistory();
    follow();
}

void GarmentActions::follow(const DocumentChange* what) {
    // What shows in check marks, apart from settings of reading.
    if (!what || what->touches(DocumentChange::View, &DocumentState::options, &DocumentState::lines,
                               &Derived::results, &Derived::symmetry)) {
        actions_.followChecked(workspace_);
    }
    actions_.followEnabled(workspace_, what);
}

void GarmentActions::updateHistory() {
    const QUndoStack& history = workspace_.document().history();
    QAction& undo = actions_[ActionId::Undo];
    QAction& redo = actions_[ActionId::Redo];
    undo.setEnabled(workspace_.canUndo());
    redo.setEnabled(history.canRedo());
    undo.setText(workspace_.proposals().hasMoves() ? tr("&Undo: Move proposed cut")
                 : history.canUndo()               ? tr("&Undo: %1").arg(history.undoText())
                                                   : tr("&Undo"));
    redo.setText(history.canRedo() ? tr("&Redo: %1").arg(history.redoText()) : tr("&Redo"));
}

void GarmentActions::askAndOpen() {
    openFiles(dialogs_.open(&window_, preferences_.openFolder()));
}

void GarmentActions::openFiles(const QStringList& files) {
    if (files.isEmpty()) {
        return;
    }
    project_->leaveThen([this, files] { openNow(files); });
}

void GarmentActions::openNow(const QStringList& files) {
    preferences_.setOpenFolder(QFileInfo(files.front()).absolutePath());
    Workspace::Paths paths;
    bool anyProject = false;
    for (const QString& file : files) {
        paths.emplace_back(pathOf(file));
        anyProject = anyProject || isProjectFile(paths.back());
    }
    if (!anyProject) {
        workspace_.open(std::move(paths));
    } else if (files.size() == 1) {
        project_->open(files.front());
    } else {
        emit failed(
            tr("Projects open one at a time. Choose one project, or the meshes of one garment."));
    }
}

void GarmentActions::askAndReadSeams() {
    const QString path = dialogs_.openSeams(&window_, preferences_.openFolder());
    if (path.isEmpty()) {
        return;
    }
    const auto read = workspace_.cuts().readSeams(pathOf(path));
    for (const Error& said : read ? *read : Problems{read.error()}) {
        emit failed(errorText(said));
    }
}

QString GarmentActions::folderToWriteTo() const {
    return writingFolder(textOf(workspace_.document().garment()->files.front()->path),
                         textOf(project_->session().path()));
}

void GarmentActions::askAndWriteSeams() {
    const auto& source = workspace_.document().garment()->files.front()->path;
    const QFileInfo first(textOf(source));
    const QString path = dialogs_.save(
        &window_, QString("%1/%2.seams.json").arg(folderToWriteTo(), first.completeBaseName()),
        tr("Seams files (*.json)"));
    if (path.isEmpty()) {
        return;
    }
    const auto written = workspace_.cuts().writeSeams(pathOf(path));
    if (!written) {
        emit failed(errorText(written.error()));
    }
}

void GarmentActions::askAndSaveProof() {
    const ShownProof shown = *workspace_.document().proof();
    const QFileInfo first(textOf(shown.ground.garment->files.front()->path));
    const QString path = dialogs_.saveReport(
        &window_, QString("%1/%2.proof.json").arg(folderToWriteTo(), first.completeBaseName()),
        tr("Proof reports (*.json)"));
    if (path.isEmpty()) {
        return;
    }
    const Garment garment = named(*shown.ground.garment, workspace_.document().state().labels);
    const auto written = writeFile(pathOf(path), writeProof(garment, *shown.proof));
    if (written) {
        emit done(tr("Saved %1").arg(QFileInfo(path).fileName()));
    } else {
        emit failed(errorText(written.error()));
    }
}

void GarmentActions::askForBody() {
    const QString path = dialogs_.openBody(&window_, preferences_.openFolder());
    if (!path.isEmpty()) {
        Document& document = workspace_.document();
        ProofPlan plan = document.state().proof;
        plan.body = pathOf(QFileInfo(path).absoluteFilePath());
        plan.bodyUnit.reset();  // that of another file
        document.edit(tr("Use body as dress form"), &DocumentState::proof, std::move(plan));
    }
}

void GarmentActions::askAndOpenReference() {
    const QString path = dialogs_.openPattern(&window_, preferences_.openFolder());
    if (!path.isEmpty()) {
        openReference(path);
    }
}

void GarmentActions::openReference(const QString& file) {
    workspace_.openReference(pathOf(QFileInfo(file).absoluteFilePath()));
}

void GarmentActions::askAndPrint() {
    if (workspace_.canExport()) {
        printing_->ask();
    }
}

void GarmentActions::askAndExport() {
    askAndExportAs(preferences_.exportFormat());
}

void GarmentActions::askAndExportThese() {
    askAndExportAs(preferences_.exportFormat(), true);
}

void GarmentActions::askAndExportAs(const QString& format, bool onlySelected) {
    if (!workspace_.canExport()) {
        return;
    }
    const auto& source = workspace_.document().garment()->files.front()->path;
    const QFileInfo first(textOf(source));
    const QString remembered = preferences_.exportFolder();
    const QString folder = remembered.isEmpty() ? folderToWriteTo() : remembered;
    // "-pattern" keeps an OBJ export from proposing to replace the garment itself.
    const QString name = tr("%1-pattern").arg(first.completeBaseName());
    // Look up dialogs_ at the time of the question, because tests replace it.
    const ExportQuestions questions{
        [this](QWidget* parent, const QString& suggestion, const QString& filter) {
            return dialogs_.save(parent, suggestion, filter);
        },
        [this](QWidget* parent, const QString& path) { return dialogs_.mayReplace(parent, path); }};
    auto* dialog = new ExportDialog(folder + '/' + name, format, preferences_.exportOptions(),
                                    questions, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const std::vector<int> flat = selectedFlat(workspace_.document());
    const Document::Selection selected(flat.begin(), flat.end());
    dialog->offerSelected(static_cast<int>(selected.size()), onlySelected);
    const auto drawing = std::make_shared<JobRunner::Ticket>();
    const auto draw = [this, dialog, drawing, selected] {
        workspace_.writing().drop(*drawing);
        *drawing = workspace_.drawPattern(
            [asked = QPointer(dialog)](const auto& drawn) {
                if (asked) {
                    asked->setPattern(drawn);
                }
            },
            dialog->choice().onlySelected ? selected : Document::Selection{});
    };
    draw();
    connect(dialog, &ExportDialog::piecesChanged, this, draw);
    const auto beginning = std::make_shared<JobRunner::Ticket>();
    connect(dialog, &ExportDialog::textWanted, this,
            [this, dialog, beginning, selected](FormatId of, const ExportOptions& options) {
                workspace_.writing().drop(*beginning);
                *beginning = workspace_.beginFile(
                    of, options, dialog->choice().onlySelected ? selected : Document::Selection{},
                    [of, asked = QPointer(dialog)](const std::string& text) {
                        if (asked) {
                            asked->setText(of, QString::fromStdString(text));
                        }
                    });
            });
    connect(dialog, &QDialog::finished, this,
            [this, dialog, drawing, beginning, selected](int answer) {
                workspace_.writing().drop(*drawing);
                workspace_.writing().drop(*beginning);
                if (answer != QDialog::Accepted) {
                    return;
                }
                const ExportChoice choice = dialog->choice();
                preferences_.setExportFolder(QFileInfo(choice.path).absolutePath());
                preferences_.setExportFormat(choice.format);
                preferences_.setExportOptions(choice.options);
                if (choice.showsFolder) {
                    showOnceWritten(choice.path);
                }
                workspace_.exportTo(pathOf(choice.path), choice.options,
                                    choice.onlySelected ? selected : Document::Selection{});
            });
    dialog->open();
}

void GarmentActions::showOnceWritten(const QString& path) {
    auto* wait = new QObject(this);  // until this or another file is written
    connect(&workspace_, &Workspace::exported, wait, [this, path, wait](const QString& written) {
        if (written == path) {
            dialogs_.showFolder(QFileInfo(path).absolutePath());
        }
        wait->deleteLater();
    });
}

void GarmentActions::selectAll() {
    Document& document = workspace_.document();
    Document::Selection seen = document.everyPiece();
    std::erase_if(seen, [&document](int piece) { return isHidden(document, piece); });
    document.setSelection(std::move(seen));
}

void GarmentActions::selectNone() {
    workspace_.document().selectNothing();
}

void GarmentActions::askForMaterial() {
    materials_->askForNew();
}

void GarmentActions::resetEase() {
    if (const auto seam = workspace_.document().seam()) {
        workspace_.document().setSeamEase(*seam, std::nullopt);
    }
}

void GarmentActions::findGrain(GrainRule rule) {
    const std::vector<int> pieces =
        withoutCounterparts(workspace_.document(), selectedOrAllFlat(workspace_.document()));
    if (pieces.empty()) {
        return;
    }
    grain_ = workspace_.jobs().start(
        grainJob(workspace_.document(), rule, pieces,
                 [this, rule](const PieceGrains& found, bool outdated, const GrainShares& shares) {
                     grain_ = 0;
                     if (outdated) {
                         sayOutdated();
                     } else if (found.empty()) {
                         emit failed(
                             tr("These pieces are horizontal and have no upward direction. Set "
                                "their grain yourself."));
                     }
                     if (!found.empty()) {
                         setGrain(workspace_.document(), tr("Set grain of %1"), found);
                     }
                     if (rule == GrainRule::LeastStrain && !outdated && !found.empty()) {
                         sayWhatIsWon(shares);
                     }
                 }));
}

void GarmentActions::sayWhatIsWon(const GrainShares& shares) {
    const auto percent = [](double share) -> QString {
        return QLocale().toString(100 * share, 'f', 1);
    };
    if (!hasLimits(workspace_.document().fabric()) && shares.before == 0) {
        emit done(tr("Best grain for woven fabric: no fabric is set"));
    } else if (percent(shares.after) == percent(shares.before)) {
        emit done(
            tr("Best grain: turning does not help; %1 % of the cloth exceeds the fabric's limits")
                .arg(percent(shares.after)));
    } else {
        emit done(tr("Best grain: %1 % of the cloth exceeds the fabric's limits, %2 % before")
                      .arg(percent(shares.after), percent(shares.before)));
    }
}

void GarmentActions::sayOutdated() {
    emit failed(
        tr("Pieces or fabric changed while the grain was being computed. Run the command again."));
}

void GarmentActions::resetGrain() {
    PieceGrains grains;
    for (const int piece : selectedOrAllFlat(workspace_.document())) {
        grains[piece] = std::nullopt;
    }
    setGrain(workspace_.document(), tr("Reset grain of %1"), grains);
}

}  // namespace toile::app
