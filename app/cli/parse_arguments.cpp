// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CLI11, which takes seconds to compile. It assigns the words to the
// options of `OptionArchive` and prints the help.
#include <algorithm>
#include <numeric>
#include <sstream>
#include <system_error>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/version.h"

namespace toile::app {
namespace {

constexpr const char* kHelpNames = "-h,--help";

/// Levenshtein distance: the insertions, deletions and substitutions between two words.
std::size_t lettersApart(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t k = 0; k < b.size(); ++k) {
            const std::size_t kept = diagonal + (lowered(a[i]) == b[k] ? 0 : 1);
            diagonal = row[k + 1];
            row[k + 1] = std::min({kept, diagonal + 1, row[k] + 1});
        }
    }
    return row.back();
}

/// The command within a typing error or two; empty if there is none.
std::string commandMeant(const std::string& word, const Words& commands) {
    constexpr std::size_t kLettersPerError = 3;
    std::string meant;
    std::size_t least = word.size() / kLettersPerError + 1;
    for (const std::string& command : commands) {
        if (const std::size_t apart = lettersApart(word, command); apart < least) {
            least = apart;
            meant = command;
        }
    }
    return meant;
}

/// The message about a first word that is neither an option, a command nor a garment (by extension
/// or because the file exists). Empty if it is valid. Accesses the disk at most once.
std::string unknownFirstWord(const Words& words) {
    const std::string word = words.empty() ? "" : words.front();
    Words known{"help"};
    for (const CommandRow& row : commandRows()) {
        known.emplace_back(row.word);
    }
    std::error_code ignored;
    if (word.empty() || word.starts_with('-') || looksLikeGarment(word) ||
        std::ranges::find(known, word) != known.end() || std::filesystem::exists(word, ignored)) {
        return {};
    }
    const std::string meant = commandMeant(word, known);
    return "there is no command or file \"" + shownText(word, kMaxOfPlace) + '"' +
           (meant.empty() ? "" : " (did you mean " + meant + "?)");
}

/// The message about a word before the command, which must be the first. Empty if there is none.
std::string wordBeforeCommand(const Words& words) {
    const auto isCommand = [](const std::string& word) {
        return !word.empty() && std::ranges::find(commandRows(), word, &CommandRow::word) !=
                                    std::ranges::end(commandRows());
    };
    const auto command = std::ranges::find_if(words, isCommand);
    return command == words.end() || command == words.begin()
               ? std::string()
               : '"' + shownText(words.front(), kMaxOfPlace) + "\" stands before the command \"" +
                     *command + "\"; type the command first";
}

/// The words after the program's name. `help` is `--help`, and `help flatten` is
/// `flatten --help`.
Words wordsAfterProgram(int argc, const char* const* argv) {
    Words words(argv + std::min(argc, 1), argv + argc);
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        words.resize(std::min<std::size_t>(words.size(), 1));
        std::erase_if(
            words, [](const std::string& word) { return word == "help" || word.starts_with('-'); });
        words.emplace_back("--help");
    }
    return words;
}

/// Also accepts "nan", which every option then rejects.
bool isNumber(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

/// In reverse, as CLI11 expects. `--fair` has an optional value: the next word is taken only if it
/// looks like a number.
Words reversedWords(const Words& typed) {
    Words words;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        words.push_back(typed[i]);
        const std::string next = i + 1 < typed.size() ? typed[i + 1] : "";
        if (typed[i] == "--fair" && next != kFairAlone && !isNumber(partsOf(next, ',').front())) {
            words.emplace_back(kFairAlone);
        }
    }
    std::ranges::reverse(words);
    return words;
}

/// Formatted like rows of options, because the manual page parses them, too.
std::string exitStatusHelp() {
    constexpr std::size_t kColumn = 30;
    std::string text = "\nExit status:\n";
    for (const auto& [status, meaning] : exitMeanings()) {
        std::string row = std::string("  ") + status;
        row.resize(kColumn, ' ');
        text += row + meaning + '\n';
    }
    text.pop_back();
    return text;
}

std::string footerOf(const CommandRow& row) {
    if (*row.word == '\0') {
        return exitStatusHelp();
    }
    const std::string notes = *row.notes == '\0' ? "" : std::string("\n") + row.notes + '\n';
    return notes + "\nExample:\n  " + row.example;
}

/// "Seam allowance (0 to 500) [10]"
std::string helpOf(const Option& option) {
    std::string help = option.help;
    help += option.range ? " (" + textOf(*option.range) + ')' : std::string();
    return option.otherwise.empty() ? help : help + " [" + option.otherwise + ']';
}

/// A command in CLI11, with its options in the order of the archive.
struct BuiltCommand {
    const CommandRow* row;
    CLI::App* app;
    OptionArchive options{};
    std::vector<std::vector<CLI::Option*>> added{};  ///< per row, including its older name

    std::size_t countOf(std::size_t k) const {
        return std::accumulate(
            added[k].begin(), added[k].end(), std::size_t{0},
            [](std::size_t sum, const CLI::Option* option) { return sum + option->count(); });
    }
};

CLI::Option* addOption(CLI::App& app, const Option& option, const std::string& names) {
    const std::string help = helpOf(option);
    CLI::Option* added = option.isFlag() ? app.add_flag(names, help) : app.add_option(names, help);
    if (option.isFlag()) {
        return added->disable_flag_override();  // otherwise "--auto-cut=no" would be accepted
    }
    added->type_name(option.value)->required(option.isRequired);
    if (option.isRepeated) {
        added->expected(CLI::detail::expected_max_vector_size);
        added->allow_extra_args(!names.starts_with('-'));  // false lets inputs follow an option
    }
    return added;
}

void addOptions(BuiltCommand& command) {
    CLI::App& app = *command.app;
    app.set_help_flag();
    for (const Option& option : command.options.rows()) {
        auto& added = command.added.emplace_back();
        added.push_back(addOption(app, option, option.names)->group(option.heading));
        if (option.oldName != nullptr) {
            added.push_back(addOption(app, option, option.oldName)->group(""));
        }
    }
    for (const Option& option : command.options.rows()) {
        for (const char* other : option.excluded) {
            app.get_option(option.key())->excludes(app.get_option(other));
        }
        for (const char* other : option.needed) {
            app.get_option(option.key())->needs(app.get_option(other));
        }
    }
    if (*command.row->word == '\0') {
        app.set_version_flag("--version", "toile " + std::string(version()), "Print the version")
            ->group("Help");
    }
    app.set_help_flag(kHelpNames, "Print this help")->group("Help");
    app.footer(footerOf(*command.row));
}

/// Why a caller does not accept an option.
std::string outOfPlace(const std::string& option, unsigned group) {
    struct Place {
        unsigned group;
        const char* what;
        const char* place;
    };
    static constexpr Place kPlaces[] = {
        {kReading, "how files are read and cut", "where the garment is loaded"},
        {kFlattening, "how pieces are flattened and drawn", "where the garment is flattened"},
        {kThreads, "how many threads work", "where the whole run is asked for"},
        {kOutputFiles, "which files are written", "where files are written"},
        {kExporting, "how files are written", "where files are written"}};
    const auto* found = std::ranges::find(kPlaces, group, &Place::group);
    return found == std::end(kPlaces)
               ? option + " is for a terminal and does nothing here; leave it out"
               : option + " sets " + found->what + "; leave it out here, it belongs " +
                     found->place;
}

/// One sentence, like every error.
Refusal wrongUsage(const CommandRow& row, const std::string& what) {
    Refusal refusal = usageRefusal(what);
    refusal.help = std::string("toile") + (*row.word == '\0' ? "" : " ") + row.word;
    return refusal;
}

/// CLI11's message for most usage errors, and our own if CLI11's exposes internals.
std::string sentenceOf(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream ignored, err;
    app.exit(error, ignored, err);
    const std::string text = err.str().substr(0, err.str().find('\n'));
    constexpr std::string_view kFlagWithValue = " was given a disallowed flag override";
    if (text.ends_with(kFlagWithValue)) {
        return "--" + text.substr(0, text.size() - kFlagWithValue.size()) + " takes no value";
    }
    const std::size_t twice = text.find(": At Most 1 required");
    return twice == std::string::npos
               ? text
               : text.substr(0, twice) + " is given more than once; give it once";
}

/// Collects the typed options of a command. @return the fault; empty: all are valid
std::string collect(const BuiltCommand& command, unsigned taken, TypedWords& typed) {
    for (std::size_t k = 0; k < command.added.size(); ++k) {
        const Option& option = command.options.rows()[k];
        if (command.countOf(k) == 0) {
            continue;
        }
        if (option.group != kInputFiles && taken != kEveryOption && (option.group & taken) == 0) {
            return outOfPlace(option.key(), option.group);
        }
        Words& words = typed[option.key()];
        for (const CLI::Option* added : command.added[k]) {
            if (!option.isFlag() && added->count() > 0) {
                words.insert(words.end(), added->results().begin(), added->results().end());
            }
        }
        if (words.size() > 1 && !option.isRepeated) {
            return option.key() + " is given more than once; give it once";
        }
    }
    return {};
}

}  // namespace

Answer<Arguments> parseArguments(int argc, const char* const* argv, unsigned taken) {
    CLI::App app{
        "Toile: sewing patterns from 3D garments.\n"
        "Without a command it opens the window: toile dress.obj --unit cm\n"};
    app.name("toile");
    app.require_subcommand(0, 1);
    Arguments arguments;
    std::deque<BuiltCommand> commands;
    for (const CommandRow& row : commandRows()) {
        const bool isWindow = *row.word == '\0';
        commands.push_back({&row, isWindow ? &app : app.add_subcommand(row.word, row.help)});
        row.describe(commands.back().options, arguments);
        addOptions(commands.back());
    }
    const BuiltCommand& window = commands.front();
    const Words words = wordsAfterProgram(argc, argv);
    if (const std::string wrong = unknownFirstWord(words); !wrong.empty()) {
        return wrongUsage(*window.row, wrong);
    }
    const auto chosen = [&]() -> const BuiltCommand& {
        const auto parsed = app.get_subcommands();
        return parsed.empty() ? window
                              : *std::ranges::find(commands, parsed.front(), &BuiltCommand::app);
    };
    try {
        app.parse(reversedWords(words));
    } catch (const CLI::ParseError& error) {
        const bool isHelp = error.get_exit_code() == 0;
        if (!isHelp || taken != kEveryOption) {
            const std::string misplaced = isHelp ? std::string() : wordBeforeCommand(words);
            return wrongUsage(*chosen().row, isHelp ? outOfPlace("--help", kForTerminal)
                                             : misplaced.empty() ? sentenceOf(app, error)
                                                                 : misplaced);
        }
        std::ostringstream help;
        app.exit(error, help, help);
        arguments.command = Arguments::Command::Message;
        arguments.message = help.str();
        return arguments;
    }
    const BuiltCommand& command = chosen();
    for (std::size_t k = 0; &command != &window && k < window.added.size(); ++k) {
        if (window.countOf(k) > 0) {
            return wrongUsage(*command.row, wordBeforeCommand(words));
        }
    }
    arguments.command = command.row->command;
    if (arguments.command == Arguments::Command::Marker) {  // for places of pieces
        arguments.exporting.dxf.profile = DxfProfile::Plain;
    }
    std::string wrong = collect(command, taken, arguments.typed);
    wrong = wrong.empty() ? command.options.read(arguments.typed) : wrong;
    if (arguments.methods.empty()) {
        for (const MethodTraits& method : allMethods()) {
            arguments.methods.push_back(method.method);
        }
    }
    arguments.batch.words =
        command.options.wordsOf(arguments.typed, kReading | kFlattening | kExporting);
    wrong = wrong.empty() ? wrongIn(arguments) : wrong;
    return wrong.empty() ? Answer<Arguments>(std::move(arguments))
                         : wrongUsage(*command.row, wrong);
}

Answer<Arguments> typedWords(const char* command, const std::vector<std::string>& files,
                             const Words& words, unsigned taken) {
    Words typed{"toile", command};
    for (const std::string& file : files) {
        typed.push_back(file.starts_with('-') ? "./" + file : file);
    }
    typed.insert(typed.end(), words.begin(), words.end());
    std::vector<const char*> pointers;
    pointers.reserve(typed.size());
    for (const std::string& word : typed) {
        if (word.find('\0') != std::string::npos) {  // the C string would end there
            return usageRefusal('"' + shownText(word, kMaxOfPlace) +
                                "\" contains a zero byte, which is not allowed.");
        }
        pointers.push_back(word.c_str());
    }
    auto arguments = parseArguments(static_cast<int>(pointers.size()), pointers.data(), taken);
    if (arguments && (taken & kInputFiles) == 0 && arguments->inputs.size() > files.size()) {
        return usageRefusal('"' + shownText(arguments->inputs.back().string(), kMaxOfPlace) +
                            "\" is an input file, which is not used here; leave it out.");
    }
    return arguments;
}

}  // namespace toile::app
