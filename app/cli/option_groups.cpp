// SPDX-License-Identifier: GPL-3.0-or-later
// Includes CLI11 as `arguments.cpp` does; both are compiled together.
#include "app/cli/option_groups.h"

#include <algorithm>

#include <CLI/CLI.hpp>

namespace toile::app {

void areAbout(OptionGroup group, const CLI::App& command, OptionGroups& groups) {
    for (const CLI::Option* option : command.get_options()) {
        groups.emplace(option, group);
    }
}

std::string outOfPlace(const std::string& option, unsigned group) {
    struct Says {
        unsigned group;
        const char* what;
        const char* place;
    };
    static constexpr Says kSays[] = {
        {kReading, "how files are read and cut", "where the garment is loaded"},
        {kFlattening, "how pieces are flattened and drawn", "where the garment is flattened"},
        {kThreads, "how many threads work", "where the whole run is asked for"},
        {kOutputFiles, "which files are written", "where files are written"},
        {kExporting, "how files are written", "where files are written"}};
    const auto* says = std::ranges::find(kSays, group, &Says::group);
    return says == std::end(kSays)
               ? option + " is for a terminal and does nothing here; leave it out"
               : option + " says " + says->what + "; leave it out here, it belongs " + says->place;
}

std::string wordNotTaken(const CLI::App& app, const OptionGroups& groups, unsigned taken) {
    if (taken == kEveryOption) {
        return {};
    }
    for (const CLI::App* command : app.get_subcommands()) {
        for (const CLI::Option* option : command->get_options()) {
            const auto found = groups.find(option);
            const unsigned group = found == groups.end() ? kForTerminal : found->second;
            if (option->count() > 0 && group != kInputFiles && (group & taken) == 0) {
                return outOfPlace(option->get_name(), group);
            }
        }
    }
    return {};
}

}  // namespace toile::app
