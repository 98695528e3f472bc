// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_window.h"

#include <QApplication>
#include <QIcon>
#include <QImage>
#include <QTimer>
#include <cstdio>
#include <utility>

#include "app/base/text.h"
#include "app/jobs/ready_checker.h"
#include "app/platform_choice.h"
#include "app/render/gl_support.h"
#include "app/session/pattern_proof.h"
#include "app/settings/language.h"
#include "app/settings/preferences.h"
#include "app/settings/theme.h"
#include "app/views/view_area.h"
#include "app/widgets/banner.h"
#include "app/window/main_window.h"
#include "core/base/version.h"

namespace toile::app {

namespace {

constexpr int kPollMilliseconds = 50;
constexpr int kQuietRounds = 6, kMaxRounds = 100;  // a blinking cursor never settles
/// Exit status as in the command line: a file could not be read or written.
constexpr int kUnreadable = 3;

QStringList toStrings(const std::vector<std::filesystem::path>& paths) {
    QStringList list;
    for (const auto& path : paths) {
        list << textOf(path);
    }
    return list;
}

void complain(const QString& sentence) {
    std::fputs(qPrintable("toile: " + sentence + '\n'), stderr);
}

/// Waits until the views show the result, writes the picture and quits the event loop.
class Photographer : public QObject {
public:
    Photographer(MainWindow& window, QString path) : window_(window), path_(std::move(path)) {
        connect(&timer_, &QTimer::timeout, this, [this] { look(); });
        timer_.start(kPollMilliseconds);
    }

private:
    void look() {
        Workspace& workspace = window_.workspace();
        if (workspace.jobs().isBusy() || workspace.proof().isRunning()) {
            return;
        }
        const bool empty = workspace.document().garment() == nullptr;
        if (!window_.banner().isHidden()) {
            if (const QString said = window_.banner().sentence(); said != said_) {
                said_ = said;
                complain(said);
            }
            if (empty) {
                QApplication::exit(kUnreadable);
                return;
            }
        }
        if (!empty && !(window_.views().isUpToDate() && window_.checker().isUpToDate())) {
            return;
        }
        // Layouts, figures and legends are updated later: wait for a stable picture.
        const QImage picture = window_.grab().toImage();
        const Document& document = workspace.document();
        const bool isLaid = !document.state().reference.file || document.reference();
        quietRounds_ = picture == last_ && isLaid ? quietRounds_ + 1 : 0;
        last_ = picture;
        if (quietRounds_ < kQuietRounds && ++rounds_ < kMaxRounds) {
            return;
        }
        timer_.stop();
        const bool written = picture.save(path_);
        if (!written) {
            complain(QApplication::translate("RunWindow", "could not write %1").arg(path_));
        }
        QApplication::exit(written ? 0 : kUnreadable);
    }

    MainWindow& window_;
    QString path_;
    QTimer timer_;
    QString said_;  ///< already printed
    QImage last_;
    int quietRounds_ = 0;  ///< rounds without changes
    int rounds_ = 0;
};

/// Shows the panel when the first garment opens, since that is when the lists appear.
void showOnceOpen(MainWindow& window, Panel panel) {
    QObject::connect(
        &window.workspace().document(), &Document::opened, &window,
        [&window, panel] { window.goTo(panel); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
}

/// Makes the given overlay override that of the first project, which is applied after opening.
void keepOverlay(Document& document, Overlay overlay) {
    document.setOverlay(overlay);
    QObject::connect(
        &document, &Document::opened, &document,
        [&document, overlay] { document.setOverlay(overlay); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
}

/// Proves the first garment's pattern as soon as it is flat.
void proveOnceFlat(Workspace& workspace) {
    QObject::connect(&workspace.jobs(), &JobRunner::idle, &workspace.proof(),
                     [&workspace, begun = false]() mutable {
                         if (!begun && workspace.proof().canProve()) {
                             begun = true;
                             workspace.proof().begin();
                         }
                     });
}

}  // namespace

int runWindow(int argc, char** argv, const WindowOptions& options) {
    auto display = std::make_unique<DisplayProbe>();
    if (const QString problem = windowProblem(*display); !problem.isEmpty()) {
        complain(problem);
        return kUnreadable;
    }
    loadResources();
    QSurfaceFormat::setDefaultFormat(sceneSurfaceFormat());
    QApplication application(argc, argv);
    display.reset();
    QApplication::setApplicationName("Toile");
    QApplication::setApplicationVersion(QString::fromUtf8(version()));
    QApplication::setWindowIcon(QIcon(":/icons/toile.svg"));

    const bool photograph = !options.screenshot.empty();
    // A screenshot must neither depend on the user's settings nor change them.
    Preferences unsaved{QString()};
    Preferences own;
    Preferences& preferences = photograph ? unsaved : own;
    useLanguage(preferences.choices().language);
    applyTheme(preferences.choices().theme);
    MainWindow window(preferences);
    if (photograph) {
        window.resize(options.width, options.height);
        // It must not depend on the pointer's position or the active window either.
        window.setWindowFlags(window.windowFlags() | Qt::WindowTransparentForInput |
                              Qt::WindowDoesNotAcceptFocus);
        window.setAttribute(Qt::WA_ShowWithoutActivating);
    }
    if (!photograph) {
        window.keepRecoveryFiles(Autosave::defaultFolder());
    }
    LoadOptions load = options.load;
    if (!options.seams.empty()) {
        Problems notes;
        auto seams = readSeamsFile(options.seams, &notes);
        for (const Error& said : seams ? notes : Problems{seams.error()}) {
            complain(QString::fromStdString(sentence(said)));
        }
        if (!seams) {
            return kUnreadable;
        }
        load.seams = std::move(*seams);
    }
    window.workspace().setLoading(std::move(load));
    window.workspace().document().setOptions(options.flattening);
    if (options.overlay) {
        keepOverlay(window.workspace().document(), *options.overlay);
        if (isOfProof(*options.overlay)) {
            proveOnceFlat(window.workspace());
        }
    }
    window.show();
    if (!options.files.empty()) {
        window.openFiles(toStrings(options.files));
    }
    if (options.panel) {
        showOnceOpen(window, *options.panel);
    }
    std::optional<Photographer> photographer;
    if (photograph) {
        photographer.emplace(window, textOf(options.screenshot));
    }
    return QApplication::exec();
}

}  // namespace toile::app
