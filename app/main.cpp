// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <iostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#ifdef TOILE_GUI
#include "app/cli/project_input.h"
#include "app/run_render.h"
#include "app/run_window.h"
#endif

namespace {

/// Ends the command line at once. OpenBLAS starts workers when it is loaded, and its own end waits
/// for them: for ever, where they found no memory. What has been printed is out by then.
int end(int status) {
    std::cout.flush();
    std::cerr.flush();
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    std::_Exit(status);
#endif
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    const toile::Arguments arguments = toile::parseArguments(argc, argv);
#ifdef TOILE_GUI
    if (arguments.command == toile::Arguments::Command::Window) {
        if (const auto refusal = toile::refusalOfProject(arguments)) {
            return end(toile::runCommand(*refusal));
        }
        return toile::runWindow(argc, argv,
                                {.files = arguments.inputs,
                                 .load = arguments.load,
                                 .seams = arguments.seams,
                                 .screenshot = arguments.screenshot,
                                 .overlay = arguments.overlay,
                                 .flattening = arguments.options,
                                 .panel = arguments.panel});
    }
    if (arguments.command == toile::Arguments::Command::Render) {
        return toile::runRender(argc, argv, arguments);
    }
#endif
    return end(toile::runCommand(arguments));
}
