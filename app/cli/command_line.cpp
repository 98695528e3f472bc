// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include <exception>
#include <iostream>

#include "app/cli/arguments.h"
#include "app/cli/project_input.h"

namespace toile::app {

int runCommand(const Arguments& typed) {
    try {
        const Arguments arguments = withProject(typed, std::cerr);
        switch (arguments.command) {
            case Arguments::Command::Flatten:
                return runFlatten(arguments, std::cout, std::cerr);
            case Arguments::Command::Compare:
                return runCompare(arguments, std::cout, std::cerr);
            case Arguments::Command::Check:
                return runCheck(arguments, std::cout, std::cerr);
            case Arguments::Command::Info:
                return runInfo(arguments, std::cout, std::cerr);
            case Arguments::Command::Message:
                (arguments.status == kExitDone ? std::cout : std::cerr) << arguments.message;
                return arguments.status;
            case Arguments::Command::Render:
                std::cerr << "toile: this build draws no pictures; see toile --help.\n";
                return kExitUsage;
            case Arguments::Command::Window:
                break;
        }
        std::cerr << "toile: this build has no window; see toile --help.\n";
        return kExitUsage;
    } catch (const std::exception& fault) {  // out of memory, or a bug: still one sentence
        std::cerr << "toile: stopped by an unexpected fault (" << fault.what() << ").\n";
        return kExitUnreadable;
    }
}

}  // namespace toile::app
