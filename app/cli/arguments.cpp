// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>
#include <system_error>
#include <utility>

#include "app/cli/batch_options.h"
#include "app/cli/check_arguments.h"
#include "app/cli/choice_options.h"
#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "app/cli/exit_status.h"
#include "app/cli/flattening_options.h"
#include "app/cli/input.h"
#include "app/cli/picture_options.h"
#include "app/cli/reading_options.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/base/version.h"
#include "core/formats/formats.h"

// The parser and its refusals. CLI11 takes seconds to compile: only this and what is compiled with
// it (CMakeLists.txt) include it.

namespace toile::app {
namespace {

const std::map<std::string, ViewDirection> kLooks = {
    {"front", kFrontView}, {"back", kBackView}, {"left", kLeftView},
    {"right", kRightView}, {"top", kTopView},   {"bottom", kBottomView}};

/// The numbers between separators, all of the text; none where it is anything else.
std::optional<std::array<double, 2>> twoNumbers(const std::string& text, char separator) {
    std::array<double, 2> numbers{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0 && (at == end || *at++ != separator)) {
            return std::nullopt;
        }
        const auto [next, fault] = std::from_chars(at, end, numbers[i]);
        if (fault != std::errc() || !std::isfinite(numbers[i])) {
            return std::nullopt;
        }
        at = next;
    }
    return at == end ? std::optional(numbers) : std::nullopt;
}

/// How many letters are to be added, left out or exchanged for others to make one word the other.
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

/// The command that is a slip or two away; empty where none is. More would be another word.
std::string commandMeant(const std::string& word, const std::vector<std::string>& commands) {
    constexpr std::size_t kLettersOfASlip = 3;
    std::string meant;
    std::size_t least = word.size() / kLettersOfASlip + 1;
    for (const std::string& command : commands) {
        if (const std::size_t apart = lettersApart(word, command); apart < least) {
            least = apart;
            meant = command;
        }
    }
    return meant;
}

/// The words after the program's name, with those who ask for help as they ask of other programs
/// led to it: `help` is `--help`, and `help flatten` is `flatten --help`.
std::vector<std::string> wordsAfterProgram(int argc, const char* const* argv) {
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        words.resize(std::min<std::size_t>(words.size(), 1));
        std::erase_if(
            words, [](const std::string& word) { return word == "help" || word.starts_with('-'); });
        words.emplace_back("--help");
    }
    return words;
}

/// The message about a first word that is neither an option nor a command nor a garment (by its
/// ending, or because such a file exists). It names the command that is probably meant, and has no
/// full stop. Empty if the word is valid. Looks at the disk once at most.
std::string unknownFirstWord(const std::vector<std::string>& words,
                             const std::vector<std::string>& commands) {
    const std::string word = words.empty() ? "" : words.front();
    std::error_code ignored;
    if (word.empty() || word.starts_with('-') || looksLikeGarment(word) ||
        std::ranges::find(commands, word) != commands.end() ||
        std::filesystem::exists(word, ignored)) {
        return {};
    }
    std::vector<std::string> known = commands;
    known.emplace_back("help");
    const std::string meant = commandMeant(word, known);
    return "there is no command or file \"" + shownText(word, kMaxOfPlace) + '"' +
           (meant.empty() ? "" : " (did you mean " + meant + "?)");
}

constexpr Word<Panel> kPanelWords[] = {
    {Panel::Pieces, "pieces"},   {Panel::Seams, "seams"}, {Panel::ProblemList, "problems"},
    {Panel::History, "history"}, {Panel::Lines, "lines"}, {Panel::Symmetry, "symmetry"},
    {Panel::Proof, "proof"}};

bool isNumber(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

/// Whether a word is `--fair` without a value: the next word is none unless it begins as a number.
bool isFairAlone(const std::vector<std::string>& typed, std::size_t word) {
    const std::string next = word + 1 < typed.size() ? typed[word + 1] : "";
    return typed[word] == "--fair" && (next.empty() || !isNumber(next.substr(0, next.find(','))));
}

/// As CLI11 takes them, last first, with the value that `--fair` alone stands for.
std::vector<std::string> reversedWords(const std::vector<std::string>& typed) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        words.push_back(typed[i]);
        if (isFairAlone(typed, i)) {
            words.emplace_back(shortest(Fairing{}.tolerance));
        }
    }
    std::ranges::reverse(words);
    return words;
}

/// Wrinkles may widen the usual tolerance of fair lines, but no typed one.
void fixTypedTolerance(StatedOptions& stated, const std::vector<std::string>& words) {
    if (stated.fairing) {
        stated.fairing->isFixed = true;
        for (std::size_t i = 0; i < words.size(); ++i) {
            stated.fairing->isFixed &= !isFairAlone(words, i);
        }
    }
}

/// Each once, in the order typed; all of them where none was.
std::vector<Method> methodsOf(const TypedOptions& typed) {
    std::vector<Method> methods;
    for (const std::string& word : typed.methods.empty() ? methodNames() : typed.methods) {
        const auto method = parseMethod(word);
        if (method && std::ranges::find(methods, *method) == methods.end()) {
            methods.push_back(*method);
        }
    }
    return methods;
}

/// Rows as those of options, which the manual page reads too.
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

Arguments message(std::string text, int status) {
    Arguments arguments;
    arguments.command = Arguments::Command::Message;
    arguments.message = std::move(text);
    arguments.status = status;
    return arguments;
}

std::vector<std::string> namesOfCommands(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

/// One sentence, as every error; it ends with where the command that was typed is explained.
Arguments wrongUsage(const CLI::App& app, const std::string& what) {
    const auto typed = app.get_subcommands();
    const std::string command = typed.empty() ? "" : typed.front()->get_name() + " ";
    return message("toile: " + what + "; see toile " + command + "--help.\n", kExitUsage);
}

/// "--split: At Most 1 required but received 2", as whoever typed it sees it.
std::string saidTwice(const std::string& said) {
    const std::size_t end = said.find(": At Most 1 required");
    return end == std::string::npos ? said
                                    : said.substr(0, end) + " is said more than once; say it once";
}

/// CLI11's own wording for help, version and most usage errors.
Arguments fromParseError(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(error, out, err) == 0) {
        return message(out.str(), kExitDone);
    }
    std::string said = err.str().substr(0, err.str().find('\n'));
    constexpr std::string_view kFlagWithValue = " was given a disallowed flag override";
    if (said.ends_with(kFlagWithValue)) {
        said = "--" + said.substr(0, said.size() - kFlagWithValue.size()) +
               " takes no value: it is said or left out";
    }
    return wrongUsage(app, saidTwice(said));
}

/// "--auto-cut=yes" would be read, and so would "--auto-cut=no" and "--auto-cut=7".
void refuseValuesOfFlags(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) {
        if (option->get_items_expected_max() == 0) {
            option->disable_flag_override();
        }
    }
    for (CLI::App* command : app.get_subcommands({})) {
        refuseValuesOfFlags(*command);
    }
}

}  // namespace

std::string readPictureSize(const std::string& typed, PictureArguments& picture) {
    if (typed.empty()) {
        return {};
    }
    const auto size = twoNumbers(typed, 'x');
    const auto fits = [](double side) -> bool {
        return side >= kMinPicture && side <= kMaxPicture && side == std::floor(side);
    };
    if (!size || !fits((*size)[0]) || !fits((*size)[1])) {
        return "--size must be width and height in whole pixels, such as 1600x800, each from " +
               std::to_string(kMinPicture) + " to " + std::to_string(kMaxPicture);
    }
    picture.width = static_cast<int>((*size)[0]);
    picture.height = static_cast<int>((*size)[1]);
    return {};
}

std::string readPictureLook(const std::string& typed, PictureArguments& picture) {
    if (const auto side = kLooks.find(typed); side != kLooks.end()) {
        picture.direction = side->second;
    } else if (!typed.empty()) {
        const auto degrees = twoNumbers(typed, ',');
        if (!degrees || std::abs((*degrees)[0]) > 360 || std::abs((*degrees)[1]) > 90) {
            return "--look must be a side, or two angles in degrees such as 30,10: around from the "
                   "front within 360, upwards within 90";
        }
        picture.direction = ViewDirection{(*degrees)[0] * kDegree, (*degrees)[1] * kDegree};
    }
    return {};
}

FlattenOptions StatedOptions::over(FlattenOptions options) const {
    options.method = method.value_or(options.method);
    options.quality = quality.value_or(options.quality);
    options.boundarySolver = boundarySolver.value_or(options.boundarySolver);
    options.freeBoundary = freeBoundary.value_or(options.freeBoundary);
    options.stretchOutline = stretchOutline.value_or(options.stretchOutline);
    options.authalic = authalic.value_or(options.authalic);
    return options;
}

LineSettings StatedOptions::over(LineSettings lines) const {
    if (fairing || (trueSeams && !lines.fairing)) {
        lines.fairing = fairing.value_or(Fairing{});
    }
    lines.trueBelow = trueSeams ? kProposedTrueing : lines.trueBelow;
    const bool asksForMirror = byHalf && lines.mirror == Mirror::None;
    lines.mirror = asksForMirror ? Mirror::Close : lines.mirror;
    if (pattern) {
        lines = withPattern(std::move(lines));
    }
    lines.mirror = mirror.value_or(lines.mirror);
    lines.grain = grain ? grain : lines.grain;
    lines.label.size = size.value_or(lines.label.size);
    lines.label.date = date.value_or(lines.label.date);
    if (allowance || hem) {
        const AllowanceWidths before = lines.allowance.value_or(AllowanceWidths{});
        lines.allowance = {allowance.value_or(before.seam), hem.value_or(before.hem)};
    }
    if (notches) {
        lines.notches =
            *notches ? lines.notches.value_or(NotchRules{}) : std::optional<NotchRules>();
        if (lines.notches) {
            lines.notches->automatic = true;
        }
    }
    return lines;
}

Arguments parseArguments(int argc, const char* const* argv, unsigned taken) {
    CLI::App app{
        "Toile: sewing patterns from 3D garments.\n"
        "Without a command it opens the window.\n"};
    app.name("toile");
    app.set_version_flag("--version", "toile " + std::string(version()));
    app.footer(exitStatusHelp());
    app.require_subcommand(0, 1);

    TypedOptions typed;
    Arguments arguments;
    addFlatten(app, typed, arguments);
    addBatch(app, typed, arguments);
    addCompare(app, typed, arguments);
    addCheck(app, arguments);
    addWalk(app, arguments);
    addMarker(app, typed, arguments);
    addProve(app, typed, arguments);
    addInfo(app, typed, arguments);
    addRender(app, typed, arguments);
    addServe(app, arguments);
    // A window's files stand where a command could: `toile dress.obj`.
    app.add_option("FILE", typed.windowFiles, "Garment or project to open in the window")
        ->type_name("FILE...");
    app.add_option("--screenshot", arguments.screenshot,
                   "Open the window, save a picture of it as PNG and end")
        ->type_name("FILE.png");
    addChoice(app, "--overlay", arguments.overlay, kOverlayWords,
              "What the window paints on the cloth at first [what the project says, else checker]");
    addChoice(app, "--panel", arguments.panel, kPanelWords,
              "The list that the window shows in front at first");
    addMethodOptions(app, arguments.stated);
    addReading(app, arguments);
    refuseValuesOfFlags(app);
    const std::vector<std::string> words = wordsAfterProgram(argc, argv);
    if (const std::string wrong = unknownFirstWord(words, namesOfCommands(app)); !wrong.empty()) {
        return wrongUsage(app, wrong);
    }
    try {
        app.parse(reversedWords(words));
    } catch (const CLI::CallForHelp& help) {
        return taken == kEveryOption ? fromParseError(app, help)
                                     : wrongUsage(app, outOfPlace("--help", kForTerminal));
    } catch (const CLI::ParseError& error) {
        return fromParseError(app, error);
    }
    if (const std::string wrong = wordNotTaken(app, typed.groups, taken); !wrong.empty()) {
        return wrongUsage(app, wrong);
    }
    fixTypedTolerance(arguments.stated, words);

    if (arguments.command == Arguments::Command::Window) {
        arguments.inputs = typed.windowFiles;
    } else if (!typed.windowFiles.empty()) {
        return wrongUsage(
            app, "\"" + typed.windowFiles.front().string() + "\" stands before the command");
    }
    if (arguments.command == Arguments::Command::Marker) {  // places of pieces, and no blocks
        arguments.exporting.dxf.profile = DxfProfile::Plain;
    }
    for (const FormatOption& row : formatOptions()) {
        const auto value = typed.exporting.find(row.name);
        if (value != typed.exporting.end() && !row.set(arguments.exporting, value->second)) {
            return wrongUsage(app, std::string("--") + row.name + " takes a number from " +
                                       shortest(row.least) + " to " + shortest(row.most));
        }
    }
    for (const std::string& wrong : {readPictureSize(typed.size, arguments.picture),
                                     readPictureLook(typed.look, arguments.picture)}) {
        if (!wrong.empty()) {
            return wrongUsage(app, wrong);
        }
    }
    if (const std::string wrong = wrongWithoutPicture(app, arguments); !wrong.empty()) {
        return wrongUsage(app, wrong);
    }
    arguments.options = arguments.stated.over(FlattenOptions{});
    arguments.lines = arguments.stated.over(LineSettings{});
    arguments.methods = methodsOf(typed);
    if (arguments.command == Arguments::Command::Batch) {
        arguments.batch.words = flattenWords(*app.get_subcommand("batch"));
    }
    for (const std::string& output : {typed.picture, typed.report}) {
        if (!output.empty()) {
            arguments.outputs.emplace_back(output);
        }
    }
    if (!typed.report.empty() && !typed.report.ends_with(".json") &&
        !typed.report.ends_with(".JSON")) {
        return wrongUsage(app, "the report's name must end in .json, not \"" + typed.report + "\"");
    }
    if (const std::string wrong = wrongIn(arguments); !wrong.empty()) {
        return wrongUsage(app, wrong);
    }
    return arguments;
}

}  // namespace toile::app
