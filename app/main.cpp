// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "core/linalg/blas_kernels.h"
#ifdef TOILE_GUI
#include "app/run_window.h"
#include "core/base/heap.h"
#endif

int main(int argc, char** argv) {
    toile::chooseBlasKernels();
    const toile::Arguments arguments = toile::parseArguments(argc, argv);
#ifdef TOILE_GUI
    if (arguments.command == toile::Arguments::Command::Window) {
        toile::keepFreedMemory();
        return toile::runWindow(argc, argv,
                                {.files = arguments.inputs,
                                 .load = arguments.load,
                                 .seams = arguments.seams,
                                 .screenshot = arguments.screenshot,
                                 .overlay = arguments.overlay,
                                 .flattening = arguments.options,
                                 .panel = arguments.panel});
    }
#endif
    return toile::runCommand(arguments);
}
