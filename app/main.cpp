// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <iostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "core/base/sanitized.h"
#ifdef TOILE_GUI
#include "app/export/paint_drawing.h"
#include "app/report_pictures.h"
#include "app/run_window.h"
#endif

namespace {

/// Exits at once. OpenBLAS starts worker threads when loaded and waits for them at exit, forever if
/// they found no memory. Flushes the output first.
int end(int status) {
    std::cout.flush();
    std::cerr.flush();
    if (!toile::isSanitized()) {  // sanitizers report at exit
        std::_Exit(status);
    }
    return status;
}

#ifdef TOILE_GUI
std::string drawnProof(const toile::ExportSource& source,
                       const std::shared_ptr<const toile::Proof>& proof,
                       const toile::app::Arguments& asked) {
    toile::app::ProofPicture wanted;
    wanted.overlay = asked.overlay.value_or(wanted.overlay);
    wanted.sewn = asked.prove.sewn;
    wanted.width = asked.picture.width;
    wanted.height = asked.picture.height;
    wanted.views = asked.picture.views;
    wanted.direction = asked.picture.direction;
    wanted.dark = asked.picture.dark;
    return toile::app::proofPicture(source, proof, wanted);
}
#endif

}  // namespace

int main(int argc, char** argv) {
#ifdef TOILE_GUI
    toile::app::provideWriters();
    toile::provideReportPictures(toile::app::reportPictures);
    toile::app::provideProofPictures(drawnProof);
#endif
    const auto typed = toile::app::parseArguments(argc, argv);
#ifdef TOILE_GUI
    if (typed && typed->command == toile::app::Arguments::Command::Window) {
        const toile::app::Arguments& arguments = *typed;
        if (const auto refusal = toile::app::refusalOfProject(arguments)) {
            return end(toile::app::runCommand(*refusal));
        }
        return toile::app::runWindow(argc, argv,
                                     {.files = arguments.inputs,
                                      .load = arguments.load,
                                      .seams = arguments.seams,
                                      .screenshot = arguments.screenshot,
                                      .overlay = arguments.overlay,
                                      .flattening = arguments.options,
                                      .panel = arguments.panel});
    }
    if (typed && typed->command == toile::app::Arguments::Command::Render) {
        return toile::app::runRender(argc, argv, *typed);
    }
#endif
    return end(toile::app::runCommand(typed));
}
