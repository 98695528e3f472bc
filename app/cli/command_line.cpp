// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <ostream>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/proof_order.h"
#include "app/cli/serve_command.h"
#include "core/linalg/blas_call.h"
#include "core/project/project_file.h"

namespace toile::app {

int runCommand(const Arguments& typed) {
    try {
        const Arguments arguments = withProject(typed, std::cerr);
        switch (arguments.command) {
            case Arguments::Command::Flatten:
                return runFlatten(arguments, std::cout, std::cerr);
            case Arguments::Command::Batch:
                linalg::useOneBlasThread();  // before it forks: else each child starts threads
                return runBatch(arguments, std::cout, std::cerr);
            case Arguments::Command::Compare:
                return runCompare(arguments, std::cout, std::cerr);
            case Arguments::Command::Check:
                return runCheck(arguments, std::cout, std::cerr);
            case Arguments::Command::Info:
                return runInfo(arguments, std::cout, std::cerr);
            case Arguments::Command::Walk:
                return runWalk(arguments, std::cout, std::cerr);
            case Arguments::Command::Marker:
                return runMarker(arguments, std::cout, std::cerr);
            case Arguments::Command::Prove:
                return runProve(arguments, std::cout, std::cerr);
            case Arguments::Command::Serve:
                return runServe(std::cin, std::cout);
            case Arguments::Command::Message:
                (arguments.status == kExitDone ? std::cout : std::cerr) << arguments.message;
                return arguments.status;
            case Arguments::Command::Render:
                std::cerr << "toile: this build cannot draw pictures; see toile --help.\n";
                return kExitUsage;
            case Arguments::Command::Window:
                break;
        }
        std::cerr << "toile: this build has no window; see toile --help.\n";
        return kExitUsage;
    } catch (const std::exception& fault) {  // out of memory, or a bug: still one sentence
        std::cerr << "toile: stopped by an unexpected error (" << fault.what() << ").\n";
        return kExitUnreadable;
    }
}

namespace {

namespace fs = std::filesystem;

Arguments refused(const std::string& sentence, int status) {
    Arguments message;
    message.command = Arguments::Command::Message;
    message.message = "toile: " + sentence + "\n";
    message.status = status;
    return message;
}

Arguments refused(const Error& error) {
    Arguments message = refused(sentence(error), kExitUnreadable);
    message.error = error;
    return message;
}

}  // namespace

std::optional<Arguments> refusalOfProject(const Arguments& arguments) {
    const auto project = std::ranges::find_if(arguments.inputs, isProjectFile);
    if (project == arguments.inputs.end()) {
        return std::nullopt;
    }
    if (arguments.inputs.size() > 1) {
        return refused("a project must be the only input: \"" + project->string() + "\".",
                       kExitUsage);
    }
    if (!(arguments.load == Arguments{}.load) || !arguments.seams.empty()) {
        return refused(
            "a project sets how its files are read and cut; leave out those options, or open its "
            "meshes instead.",
            kExitUsage);
    }
    if (arguments.command == Arguments::Command::Window && !(arguments.stated == StatedOptions{})) {
        return refused(
            "a project sets how its pieces are flattened; leave out those options, and change them "
            "in the window.",
            kExitUsage);
    }
    return std::nullopt;
}

Arguments withProject(Arguments arguments, std::ostream& err) {
    const auto project = std::ranges::find_if(arguments.inputs, isProjectFile);
    if (arguments.command == Arguments::Command::Message || project == arguments.inputs.end()) {
        return arguments;
    }
    if (auto refusal = refusalOfProject(arguments)) {
        return *std::move(refusal);
    }
    auto read = readProject(*project);
    if (!read) {
        return refused(read.error());
    }
    for (const Error& note : read->notes) {
        err << "toile: " << sentence(note) << '\n';
    }
    const auto missing = locateMeshes(read->project);
    if (!missing.empty()) {
        return refused({ErrorCode::FileUnreadable, Subject::file(missing.front().string()),
                        "the project needs this file, which does not exist"});
    }
    arguments.inputs.clear();
    for (const FileReference& file : read->project.files) {
        arguments.inputs.push_back(file.path);
    }
    std::vector<fs::path> meshes = arguments.inputs;
    meshes.push_back(read->project.proof.body);
    for (const fs::path& output : arguments.outputs) {
        for (const fs::path& mesh : meshes) {
            std::error_code ignored;
            if (fs::equivalent(mesh, output, ignored)) {
                return refused("\"" + output.string() +
                                   "\" is a mesh of the project and would be overwritten.",
                               kExitUsage);
            }
        }
    }
    arguments.load = read->project.loading;
    arguments.options = arguments.stated.over(read->project.options);
    arguments.lines = arguments.stated.over(read->project.lines);
    if (!arguments.fabric) {
        arguments.fabric = read->project.fabric;
    }
    arguments.project = std::move(read->project);
    return arguments;
}

PatternOrder orderOf(const Arguments& arguments, const Garment& garment) {
    PatternOrder order{.flattening = arguments.options,
                       .lines = arguments.lines,
                       .fabric = arguments.fabric.value_or(fabricPresets().front()),
                       .byHalf = arguments.stated.byHalf,
                       .threads = arguments.threads};
    if (arguments.project) {
        order.materials = arguments.project->materials;
        order.pieces = settingsFor(*arguments.project, garment);
    }
    return order;
}

FinishedPattern finished(const Arguments& arguments, const Garment& garment,
                         const PieceResults& results) {
    return makePattern(garment, results, orderOf(arguments, garment));
}

void printDifferences(const Arguments& arguments, const Garment& garment, std::ostream& err) {
    if (arguments.project) {
        for (const Error& difference : differencesTo(*arguments.project, garment)) {
            err << "toile: " << sentence(difference) << '\n';
        }
    }
}

}  // namespace toile::app
