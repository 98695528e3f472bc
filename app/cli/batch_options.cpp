// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch_options.h"

#include <algorithm>

#include "app/cli/batch_arguments.h"
#include "app/cli/choice_options.h"
#include "core/formats/formats.h"

namespace toile::app {
namespace {

constexpr double kLongestLimit = 1e6;  // s
constexpr int kMaxMemory = 1 << 24;    // MiB

/// What is of the batch, not of a garment.
constexpr const char* kOfTheBatch[] = {"LIST",     "--output",  "--formats", "--limit",
                                       "--memory", "--threads", "--help"};

/// "svg", "specification.json"...: usual endings without their dot.
std::vector<std::string> formatWords() {
    std::vector<std::string> words;
    for (const Format& format : formats()) {
        words.emplace_back(format.endings.front() + 1);
    }
    return words;
}

}  // namespace

void addBatchOptions(CLI::App& command, BatchArguments& batch) {
    command
        .add_option("LIST", batch.list,
                    "A file with a garment a line: its path, and, each after a tab, the words of "
                    "its own options; -: standard input")
        ->required()
        ->type_name("FILE");
    command
        .add_option("-o,--output", batch.folder, "Folder to write to; made where it is not there")
        ->required()
        ->type_name("DIR");
    const std::vector<std::string> words = formatWords();
    command.add_option("--formats", batch.formats, "What is written of each garment")
        ->type_name(CLI::detail::join(words, ","))
        ->delimiter(',')
        ->check(oneOf(words))
        ->default_str("json,svg")
        ->allow_extra_args(false);
    command
        .add_option("--limit", batch.limitSeconds,
                    "Time that a garment may take by the clock; 0: all it wants")
        ->type_name("SECONDS")
        ->check(within(0.0, kLongestLimit))
        ->capture_default_str();
    command
        .add_option("--memory", batch.memoryMib,
                    "Memory that a garment may take; 0: as much as there is")
        ->type_name("MIB")
        ->check(within(0, kMaxMemory))
        ->capture_default_str();
    command.add_option("--threads", batch.threads, "Threads that work at one garment")
        ->type_name("N")
        ->check(within(1, kMaxThreads))
        ->capture_default_str();
}

std::vector<std::string> flattenWords(const CLI::App& command) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || std::ranges::find(kOfTheBatch, name) != std::end(kOfTheBatch)) {
            continue;
        }
        words.push_back(name);
        if (option->get_items_expected_max() > 0) {  // no switch
            words.push_back(CLI::detail::join(option->results(), ","));
        }
    }
    return words;
}

}  // namespace toile::app
