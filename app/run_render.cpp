// SPDX-License-Identifier: GPL-3.0-or-later
#include <QBuffer>
#include <QFile>
#include <QGuiApplication>
#include <iostream>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/document/document.h"
#include "app/jobs/derivation.h"
#include "app/jobs/file_jobs.h"
#include "app/jobs/proof_job.h"
#include "app/jobs/reference_finder.h"
#include "app/platform_choice.h"
#include "app/render/offscreen.h"
#include "app/run_window.h"
#include "app/settings/language.h"
#include "app/settings/theme.h"
#include "app/views/view_picture.h"
#include "core/base/file.h"
#include "core/toile/garment_flattener.h"

namespace toile::app {

namespace {

int refused(const QString& sentence, Messages& messages) {
    messages.add(sentence.toStdString() + ".");
    return kExitUnreadable;
}

/// The window's font on a desktop without font settings.
QFont pictureFont() {
    return QGuiApplication::platformName() == "offscreen" ? QFont("Sans Serif", 9)
                                                          : QGuiApplication::font();
}

/// Reads the reference pattern of a project. Reports and omits an unreadable one.
void addReference(DocumentState& state, Messages& messages) {
    if (state.reference.path.empty()) {
        return;
    }
    if (auto read = readReference(state.reference.path)) {
        state.reference = std::move(read).value();
    } else {
        messages.add(read.error());
    }
}

/// Whether the fastest method needs about a second at most.
bool isSoonFlat(const Garment& garment) {
    constexpr std::size_t kMaxShownTriangles = 50'000;
    std::size_t triangles = 0;
    for (const auto& piece : garment.pieces) {
        triangles += static_cast<std::size_t>(piece->mesh.F.rows());
    }
    return triangles <= kMaxShownTriangles;
}

/// Opens the document as in the window after flattening. @return whether some piece is not flat
bool openFlattened(Document& document, const Arguments& arguments, Garment read,
                   Messages& messages) {
    Progress progress;
    Derivation made;
    Derived& derived = made.derived;
    derived.inputs.loading = arguments.load;
    derived.garment = std::make_shared<const Garment>(std::move(read));
    DocumentState state;
    state.settings = settingsOfNew(*derived.garment);
    state.materials = materialsInUse(state);
    if (arguments.project) {
        state = stateOf(*arguments.project, derived.inputs, *derived.garment);
        addReference(state, messages);
    }
    state.options = arguments.options;
    state.lines = arguments.lines;
    const bool isThumbnail = arguments.picture.thumbnail > 0;
    if (isThumbnail) {  // a thumbnail shows no more than the colour of flat pieces
        state.options.method = Method::Lscm;
        state.lines = {};
    }
    GarmentFlattener flattener;
    if (!isThumbnail || isSoonFlat(*derived.garment)) {
        flatten(made, state, flattener, progress);
    }
    draw(derived, progress);
    state.settings = settingsAfter(made, state, {});
    const bool failed = reportFailures(derived.results, messages);
    document.open(std::move(state), std::move(derived));
    if (const auto question = referenceQuestion(document)) {
        document.showReference(std::make_shared<const ReferenceMatch>(layReference(*question)));
    }
    return failed;
}

void applyView(Document& document, const Arguments& arguments) {
    ViewState view = document.view();
    if (arguments.project) {
        view = viewOf(arguments.project->view, view);
    }
    const PictureArguments& asked = arguments.picture;
    view.overlay = asked.thumbnail > 0 ? Overlay::None : arguments.overlay.value_or(view.overlay);
    view.wireframe = view.wireframe || asked.wireframe;
    view.seams = asked.seams;
    view.xray = asked.xray;
    document.setView(view);
}

/// Sews the pattern back together like the window. Reports an obstacle; the picture then shows no
/// sewn cloth. @return whether it could be sewn
bool prove(Document& document, Messages& messages) {
    Progress progress;
    const auto job = proofJob(
        document, proofPlanOf(document.state()), nullptr,
        [&](std::shared_ptr<const ShownProof> found) { document.showProof(std::move(found)); });
    const auto sewn = job->process(progress);
    if (sewn) {
        job->finalize();
    } else {
        messages.add(sewn.error());
    }
    return bool(sewn);
}

PictureOptions pictureOptions(const PictureArguments& asked, Overlay overlay) {
    PictureOptions options;
    options.size = QSize(asked.width, asked.height);
    options.views = asked.views;
    options.direction = asked.direction;
    options.morph = asked.morph;
    options.legend = asked.bar.value_or(isMeasured(overlay));
    options.font = pictureFont();
    options.palette = asked.dark ? darkPalette() : lightPalette();
    if (asked.thumbnail > 0) {
        options.size = QSize(asked.thumbnail, asked.thumbnail);
        options.views = ViewsShown::Garment;
        options.plain = true;
    }
    return options;
}

/// Writes a thumbnail into the existing file, which the file manager keeps open.
Result<void> writePicture(const Arguments& arguments, const QByteArray& png) {
    const std::filesystem::path& path = arguments.outputs.front();
    if (arguments.picture.thumbnail == 0) {
        return writeFile(path, std::string_view(png.constData(), std::size_t(png.size())));
    }
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(png) != png.size() || !file.flush()) {
        return Error{ErrorCode::FileUnwritable, Subject::file(path.string()),
                     file.errorString().toStdString()};
    }
    return {};
}

/// In a file manager's sandbox, only the thumbnail's folder is writable. Otherwise Qt would create
/// a runtime folder there.
void leaveNothingBeside(const std::filesystem::path& thumbnail) {
    if (!qEnvironmentVariableIsSet("XDG_RUNTIME_DIR")) {
        const auto folder = std::filesystem::absolute(thumbnail).parent_path();
        qputenv("XDG_RUNTIME_DIR", QByteArray::fromStdString(folder.string()));
    }
}

int render(int argc, char** argv, const Arguments& arguments, Messages& messages) {
    if (arguments.picture.thumbnail > 0) {
        leaveNothingBeside(arguments.outputs.front());
    }
    auto display = std::make_unique<DisplayProbe>();
    if (const QString sentence = choosePicturePlatform(*display); !sentence.isEmpty()) {
        return refused(sentence, messages);
    }
    loadResources();
    quietenQt();
    QGuiApplication application(argc, argv);
    display.reset();
    useLanguage(Language::System);
    QString problem;
    const auto context = makeOffscreenContext(problem);
    if (!context) {
        return refused(problem, messages);
    }
    Progress progress;
    auto garment = readInput(arguments, progress, messages);
    if (!garment) {
        return kExitUnreadable;
    }
    bool failed = reportProblems(*garment, messages);
    Document document;
    failed = openFlattened(document, arguments, std::move(*garment), messages) || failed;
    applyView(document, arguments);
    if (isOfProof(document.view().overlay)) {
        failed = !prove(document, messages) || failed;
    }
    const QImage picture =
        drawViews(document, pictureOptions(arguments.picture, document.view().overlay), problem);
    if (picture.isNull()) {
        return refused(problem, messages);
    }
    QByteArray png;
    QBuffer buffer(&png);
    if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG")) {
        return refused("the picture could not be saved as PNG", messages);
    }
    if (const auto written = writePicture(arguments, png); !written) {
        messages.add(written.error());
        return kExitUnreadable;
    }
    if (arguments.picture.thumbnail > 0) {
        return kExitDone;  // also with pieces that are not flat
    }
    return failed ? kExitSomeFailed : kExitDone;
}

}  // namespace

int runRender(int argc, char** argv, const Arguments& typed) {
    Messages messages(std::cerr);
    try {
        const auto arguments = withProject(typed, messages);
        return arguments ? render(argc, argv, *arguments, messages)
                         : refuse(arguments.refusal(), messages);
    } catch (const std::exception& fault) {  // out of memory, or a bug: still report one sentence
        messages.add(std::string("stopped by an unexpected error (") + fault.what() + ").");
        return kExitUnreadable;
    }
}

}  // namespace toile::app
