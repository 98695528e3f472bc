// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "app/cli/command_line.h"
#include "tests/cli/docs_table.h"

namespace toile::app {
namespace {

using Command = Arguments::Command;

Answer<Arguments> answerTo(std::vector<const char*> typed) {
    typed.insert(typed.begin(), "toile");
    return parseArguments(static_cast<int>(typed.size()), typed.data());
}

/// Of valid words.
Arguments parse(const std::vector<const char*>& typed) {
    const auto answer = answerTo(typed);
    EXPECT_TRUE(answer) << (answer ? "" : answer.refusal().message);
    return answer ? *answer : Arguments{};
}

/// The refusal of wrong words as a terminal shows it, and the exit status.
struct Shown {
    std::string message;
    int status = 0;
};
Shown refused(const std::vector<const char*>& typed) {
    const auto answer = answerTo(typed);
    std::ostringstream err;
    Messages messages(err);
    Shown shown;
    shown.status = answer ? kExitDone : refuse(answer.refusal(), messages);
    shown.message = err.str();
    return shown;
}

TEST(Arguments, NothingOrAFileOpensTheWindow) {
    EXPECT_EQ(parse({}).command, Command::Window);
    const Arguments file = parse({"dress.obj", "belt.obj", "--unit", "cm"});
    EXPECT_EQ(file.command, Command::Window);
    EXPECT_EQ(file.inputs.size(), 2U);
    EXPECT_EQ(file.load.unit, LengthUnit::Centimetre);
    EXPECT_EQ(parse({"info", "a.obj", "--unit", "dm"}).load.unit, LengthUnit::Decimetre);
    EXPECT_EQ(parse({"info", "a.obj", "--unit", "12.5mm"}).load.unit,
              FileUnit::ofMillimetres(12.5));
    EXPECT_EQ(parse({"dress.obj", "--screenshot", "a.png"}).screenshot, "a.png");
    EXPECT_EQ(parse({"dress.obj", "--overlay", "strain"}).overlay, Overlay::Strain);
    EXPECT_EQ(parse({"dress.obj", "--overlay", "principal"}).overlay, Overlay::Principal);
    EXPECT_EQ(parse({"dress.obj", "--overlay", "bias"}).overlay, Overlay::Bias);
    EXPECT_EQ(parse({"dress.obj", "--overlay", "dirichlet"}).overlay, Overlay::Dirichlet);
    EXPECT_EQ(refused({"dress.obj", "--overlay", "stretch"}).status, kExitUsage);
    EXPECT_FALSE(parse({}).overlay);  // so that a project may say
    EXPECT_EQ(parse({"dress.obj", "--panel", "seams"}).panel, Panel::Seams);
    EXPECT_EQ(parse({"dress.obj", "--panel", "lines"}).panel, Panel::Lines);
    EXPECT_EQ(parse({"dress.obj", "--panel", "symmetry"}).panel, Panel::Symmetry);
    EXPECT_FALSE(parse({"dress.obj"}).panel);
    EXPECT_EQ(parse({"dress.obj", "--method", "natural"}).options.method, Method::Natural);
}

TEST(Arguments, FlattenTakesManyInputsAndOutputs) {
    const Arguments a =
        parse({"flatten", "a.obj", "b.ply", "-o", "x.svg", "-o", "x.DXF", "--method", "natural",
               "--boundary-solver", "slcp", "--report", "r.json"});
    EXPECT_EQ(a.command, Command::Flatten);
    EXPECT_EQ(a.inputs.size(), 2U);
    ASSERT_EQ(a.outputs.size(), 3U);
    EXPECT_EQ(a.outputs[2], "r.json");
    EXPECT_EQ(a.options.method, Method::Natural);
    EXPECT_EQ(a.options.boundarySolver, BoundarySolver::Slcp);
    EXPECT_FALSE(a.load.unit);
    EXPECT_EQ(a.load.split, SplitMode::Auto);
    EXPECT_EQ(parse({"flatten", "a.obj", "--split", "uv"}).load.split, SplitMode::Uv);
    EXPECT_TRUE(parse({"info", "a.obj", "--strict"}).load.strict);
}

TEST(Arguments, WhatIsNotTakenIsWrongUsage) {
    const char* typed[] = {"toile", "flatten", "a.obj", "--weld", "--method", "lscm"};
    const auto parsed = [&typed](unsigned taken) {
        return parseArguments(std::size(typed), typed, taken);
    };
    EXPECT_EQ(parsed(kEveryOption)->options.method, Method::Lscm);
    EXPECT_EQ(parsed(kReading | kFlattening)->options.method, Method::Lscm);
    EXPECT_EQ(parsed(kReading).refusal().code, kWrongUsage);
    EXPECT_NE(parsed(kReading).refusal().message.find("--method sets how pieces"),
              std::string::npos);
    EXPECT_NE(parsed(kFlattening).refusal().message.find("--weld sets how files"),
              std::string::npos);
    EXPECT_FALSE(parsed(kExporting));
}

TEST(Arguments, AnOutputMayComeBeforeTheInput) {
    const Arguments a = parse({"flatten", "-o", "x.svg", "a.obj", "b.obj"});
    EXPECT_EQ(a.inputs.size(), 2U);
    EXPECT_EQ(a.outputs.size(), 1U);
}

TEST(Arguments, DefaultsAreThoseOfTheLibrary) {
    for (const std::vector<const char*>& typed :
         {std::vector{"flatten", "a.obj"}, std::vector{"compare", "a.obj"}, std::vector{"a.obj"}}) {
        const Arguments a = parse(typed);
        EXPECT_TRUE(a.options == FlattenOptions{});
        EXPECT_TRUE(a.outputs.empty());
    }
}

TEST(Arguments, PiecesAreMirroredOnRequest) {
    EXPECT_EQ(parse({"flatten", "a.obj"}).lines.mirror, Mirror::None);
    EXPECT_EQ(parse({"flatten", "a.obj", "--mirror", "auto"}).lines.mirror, Mirror::Close);
    EXPECT_EQ(parse({"flatten", "a.obj", "--mirror", "equal"}).lines.mirror, Mirror::Mean);
    EXPECT_EQ(parse({"flatten", "a.obj", "--mirror", "none"}).lines.mirror, Mirror::None);
    EXPECT_EQ(parse({"flatten", "a.obj", "--half"}).lines.mirror, Mirror::Close);
    EXPECT_EQ(parse({"flatten", "a.obj", "--half", "--mirror", "none"}).lines.mirror, Mirror::None);
    EXPECT_TRUE(parse({"flatten", "a.obj", "--half"}).byHalf);
    EXPECT_FALSE(parse({"flatten", "a.obj", "--mirror", "auto"}).byHalf);
    EXPECT_EQ(refused({"flatten", "a.obj", "--mirror", "left"}).status, kExitUsage);
    Project project;
    project.lines.mirror = Mirror::First;
    const auto mirrorOf = [&project](const std::vector<const char*>& typed) {
        return withSettingsOf(project, parse(typed)).lines.mirror;
    };
    EXPECT_EQ(mirrorOf({"flatten", "a.obj"}), Mirror::First);
    EXPECT_EQ(mirrorOf({"flatten", "a.obj", "--half", "--pattern"}), Mirror::First);
    EXPECT_EQ(mirrorOf({"flatten", "a.obj", "--pattern", "--mirror", "none"}), Mirror::None);
}

TEST(Arguments, EveryMethodAndItsOptionsCanBeNamedEverywhere) {
    for (const MethodTraits& method : allMethods()) {
        const std::string name(method.name);
        EXPECT_EQ(parse({"flatten", "a.obj", "--method", name.c_str()}).options.method,
                  method.method);
        EXPECT_EQ(parse({"a.obj", "--method", name.c_str()}).options.method, method.method);
        EXPECT_NE(parse({"flatten", "--help"}).message.find(name), std::string::npos);
    }
    for (const char* command : {"flatten", "compare", ""}) {
        std::vector<const char*> typed{
            "a.obj", "--quality",         "fine", "--free-boundary",   "spectral", "--authalic",
            "0.25",  "--boundary-solver", "slcp", "--stretch-outline", "curvature"};
        if (*command != '\0') {
            typed.insert(typed.begin(), command);
        }
        const Arguments a = parse(typed);
        EXPECT_EQ(a.options.quality, Quality::Fine);
        EXPECT_EQ(a.options.freeBoundary, FreeBoundary::Spectral);
        EXPECT_EQ(a.options.authalic, 0.25);
        EXPECT_EQ(a.options.stretchOutline, StretchOutline::Curvature);
        EXPECT_EQ(a.options.boundarySolver, BoundarySolver::Slcp);
    }
}

TEST(Arguments, CompareTakesMethodsInTheOrderTyped) {
    const Arguments all = parse({"compare", "a.obj", "b.obj"});
    EXPECT_EQ(all.command, Command::Compare);
    EXPECT_EQ(all.inputs.size(), 2U);
    EXPECT_EQ(all.methods.size(), allMethods().size());
    const Arguments some = parse({"compare", "--methods", "natural,wang2005,natural", "a.obj",
                                  "--split", "uv", "--auto-cut", "--per-piece", "--markdown"});
    ASSERT_EQ(some.command, Command::Compare);
    EXPECT_EQ(some.methods, (std::vector{Method::Natural, Method::Wang2005}));
    EXPECT_EQ(some.inputs.size(), 1U);
    EXPECT_EQ(some.load.split, SplitMode::Uv);
    EXPECT_TRUE(some.load.autoCut && some.perPiece && some.markdown);
    EXPECT_TRUE(parse({"compare", "a.obj", "--json"}).json);
}

TEST(Arguments, CheckTakesAFabricAndReadsAsTheOthersDo) {
    const Arguments plain = parse({"check", "a.toile"});
    EXPECT_EQ(plain.command, Command::Check);
    EXPECT_FALSE(plain.fabric || plain.json);
    const Arguments all = parse(
        {"check", "a.obj", "--fabric", "jersey", "--method", "natural", "--unit", "cm", "--json"});
    ASSERT_EQ(all.command, Command::Check);
    EXPECT_EQ(all.fabric, *fabricPreset("jersey"));
    EXPECT_EQ(all.options.method, Method::Natural);
    EXPECT_EQ(all.load.unit, LengthUnit::Centimetre);
    EXPECT_TRUE(all.json);
    EXPECT_EQ(refused({"check"}).status, kExitUsage);
}

TEST(Arguments, TheWindowReadsFilesAsTheCommandsDo) {
    for (const bool window : {true, false}) {
        std::vector<const char*> typed{
            "a.obj", "--split", "seams",  "--seams", "a.json",   "--auto-cut",   "--weld",
            "--up",  "z",       "--unit", "in",      "--strict", "--close-slits"};
        if (!window) {
            typed.insert(typed.begin(), "info");
        }
        const Arguments a = parse(typed);
        EXPECT_EQ(a.command, window ? Command::Window : Command::Info);
        EXPECT_EQ(a.load.split, SplitMode::Seams);
        EXPECT_EQ(a.seams, "a.json");
        EXPECT_EQ(a.load.up, UpAxis::Z);
        EXPECT_EQ(a.load.unit, LengthUnit::Inch);
        EXPECT_TRUE(a.load.autoCut && a.load.weld && a.load.closeSlits && a.load.strict);
    }
}

TEST(Arguments, CutsAreTailorsUnlessOneSaysOtherwise) {
    EXPECT_EQ(parse({"info", "a.obj"}).load.cutStyle, CutStyle::Auto);
    EXPECT_EQ(parse({"a.obj"}).load.cutStyle, CutStyle::Auto);
    const Arguments said = parse({"info", "a.obj", "--auto-cut", "--cut-style", "topology",
                                  "--swap-front", "--enough", "2.5"});
    ASSERT_EQ(said.command, Command::Info);
    EXPECT_EQ(said.load.cutStyle, CutStyle::Topology);
    EXPECT_TRUE(said.load.isFrontSwapped);
    EXPECT_EQ(said.load.enoughStrain, 0.025);
    EXPECT_EQ(refused({"info", "a.obj", "--enough", "0"}).status, kExitUsage);
}

TEST(Arguments, WhatIsDoneWithAFileGoesWithWhatItIs) {
    const Arguments scan = parse({"info", "a.obj", "--as", "scan", "--remesh", "8", "--smooth",
                                  "0.5", "--close-holes", "0", "--keep-debris"});
    ASSERT_EQ(scan.command, Command::Info);
    EXPECT_EQ(scan.load.preparing, (Preparation{.as = FileKind::Scan, .scan = {false, 0, 0.5, 8}}));
    EXPECT_EQ(parse({"a.obj", "--surface", "inner"}).load.preparing.surface, ShellSurface::Inner);
    EXPECT_EQ(parse({"a.obj", "--as", "soup", "--weld-within", "2"}).load.preparing.weldDistance,
              2);
    EXPECT_TRUE(parse({"a.obj", "--complete-half"}).load.preparing.isHalf);
    for (const std::vector<const char*>& odd :
         {std::vector<const char*>{"info", "a.obj", "--remesh", "8"},
          {"info", "a.obj", "--as", "sheet", "--remesh", "8"},
          {"info", "a.obj", "--as", "scan", "--weld-within", "2"},
          {"info", "a.obj", "--as", "scan", "--surface", "inner"},
          {"a.obj", "--keep-debris"}}) {
        EXPECT_EQ(refused(odd).status, kExitUsage) << odd.back();
    }
}

TEST(Arguments, RenderSaysWhatAPictureShows) {
    const Arguments plain = parse({"render", "a.obj", "-o", "a.png"});
    ASSERT_EQ(plain.command, Command::Render);
    EXPECT_EQ(plain.picture.width, 1600);
    EXPECT_EQ(plain.picture.height, 800);
    EXPECT_EQ(plain.picture.views, ViewsShown::Both);
    EXPECT_FALSE(plain.picture.direction || plain.picture.bar || plain.overlay);
    const Arguments all =
        parse({"render", "-o",        "a.png",  "a.toile",       "--view",  "pattern",
               "--size", "16x8192",   "--look", "-90,45.5",      "--morph", "0.25",
               "--bar",  "off",       "--xray", "--seams-shown", "off",     "--wireframe",
               "--dark", "--overlay", "bias",   "--method",      "natural"});
    ASSERT_EQ(all.command, Command::Render);
    EXPECT_EQ(all.inputs.size(), 1U);
    EXPECT_EQ(all.picture.views, ViewsShown::Pattern);
    EXPECT_EQ(all.picture.width, 16);
    EXPECT_EQ(all.picture.height, 8192);
    ASSERT_TRUE(all.picture.direction);
    EXPECT_DOUBLE_EQ(all.picture.direction->yaw, kLeftView.yaw);
    EXPECT_NEAR(all.picture.direction->pitch, 0.794, 1e-3);
    EXPECT_EQ(all.picture.morph, 0.25);
    EXPECT_EQ(all.picture.bar, false);
    EXPECT_TRUE(all.picture.xray && all.picture.wireframe && all.picture.dark);
    EXPECT_FALSE(all.picture.seams);
    EXPECT_EQ(all.overlay, Overlay::Bias);
    EXPECT_EQ(all.options.method, Method::Natural);
    EXPECT_EQ(parse({"render", "a.obj", "-o", "a.PNG", "--look", "top"}).picture.direction,
              kTopView);
}

TEST(Arguments, EveryCommandThatDrawsAPatternTakesItsOptions) {
    for (const char* command : {"flatten", "check", "walk", "render"}) {
        std::vector<const char*> typed{command, "a.obj", "--pattern", "--allowance", "7"};
        if (std::string_view(command) == "render") {
            typed.insert(typed.end(), {"-o", "a.png"});
        }
        const Arguments a = parse(typed);
        LineSettings expected = withPattern({});
        expected.allowance->seam = 7;
        EXPECT_EQ(a.lines, expected) << command << ": ";
    }
}

TEST(Arguments, EdgeAllowanceSetsTheWidthOfOneKind) {
    const auto widths = [](std::vector<const char*> typed) {
        typed.insert(typed.begin(), {"flatten", "a.obj"});
        return parse(typed).lines.allowance.value_or(AllowanceWidths{});
    };
    const AllowanceWidths set = widths({"--allowance", "12", "--hem", "20", "--edge-allowance",
                                        "cuff=15", "--edge-allowance", "neckline=6.5"});
    EXPECT_EQ(set.widthOf(EdgeKind::Cuff), 15);
    EXPECT_EQ(set.widthOf(EdgeKind::Neckline), 6.5);
    EXPECT_EQ(set.widthOf(EdgeKind::Hem), 20);
    EXPECT_EQ(set.widthOf(EdgeKind::Waist), 12);
    EXPECT_EQ(widths({"--edge-allowance", "hem=18"}).hem, 18);
    // --hem sets hems and edges of unknown kind only.
    const AllowanceWidths hem = widths({"--hem", "40"}), usual;
    for (std::size_t k = 0; k < kEdgeKindCount; ++k) {
        const auto kind = static_cast<EdgeKind>(k);
        const bool isHem = kind == EdgeKind::Hem || kind == EdgeKind::Unknown;
        EXPECT_EQ(hem.widthOf(kind), isHem ? 40 : usual.widthOf(kind)) << k;
    }
    for (const char* wrong : {"sleeve=10", "cuff", "cuff=", "cuff=wide", "cuff=-1", "cuff=501",
                              "cuff=nan", "cuff=1=2", "=10", ""}) {
        const Shown shown = refused({"flatten", "a.obj", "--edge-allowance", wrong});
        EXPECT_EQ(shown.status, kExitUsage) << wrong;
        EXPECT_NE(shown.message.find("--edge-allowance"), std::string::npos) << shown.message;
    }
    EXPECT_NE(refused({"flatten", "a.obj", "--edge-allowance", "sleeve=10"})
                  .message.find("\"collar-edge\""),
              std::string::npos);
}

TEST(Arguments, HelpAndVersionAreMessages) {
    const Arguments help = parse({"--help"});
    EXPECT_EQ(help.command, Command::Message);
    EXPECT_NE(help.message.find("flatten"), std::string::npos);
    EXPECT_NE(parse({"flatten", "--help"}).message.find("--boundary-solver"), std::string::npos);
    EXPECT_NE(parse({"--version"}).message.find(TOILE_VERSION), std::string::npos);
}

TEST(Arguments, WrongUsageIsStatusTwoWithASentence) {
    const std::vector<std::vector<const char*>> wrong = {
        {"flatten"},
        {"flatten", "a.obj", "-o", "a.tiff"},
        {"flatten", "a.obj", "--unit", "ell"},
        {"flatten", "a.obj", "--method", "magic"},
        {"flatten", "a.obj", "--report", "r.txt"},
        {"flatten", "a.obj", "--split", "seams"},
        {"flatten", "a.obj", "--up", "x"},
        {"flatten", "a.obj", "--nonsense"},
        {"flatten", "a.obj", "--auto-cut=no"},
        {"info", "a.obj", "--json=7"},
        {"flatten", "a.obj", "-o"},
        {"flatten", "a.obj", "--quality", "superb"},
        {"flatten", "a.obj", "--free-boundary", "loose"},
        {"flatten", "a.obj", "--authalic", "1.5"},
        {"flatten", "a.obj", "--authalic", "nan"},
        {"compare"},
        {"compare", "a.obj", "--methods", "natural,magic"},
        {"compare", "a.obj", "--methods", ""},
        {"compare", "a.obj", "--json", "--markdown"},
        {"info"},
        {"render", "a.obj"},
        {"render", "-o", "a.png"},
        {"render", "a.obj", "-o", "a.svg"},
        {"render", "a.obj", "-o", "a.png", "-o", "b.png"},
        {"render", "a.obj", "-o", "a.png", "--size", "800"},
        {"render", "a.obj", "-o", "a.png", "--size", "800x"},
        {"render", "a.obj", "-o", "a.png", "--size", "800x600x3"},
        {"render", "a.obj", "-o", "a.png", "--size", "800.5x600"},
        {"render", "a.obj", "-o", "a.png", "--size", "15x600"},
        {"render", "a.obj", "-o", "a.png", "--size", "800x8193"},
        {"render", "a.obj", "-o", "a.png", "--size", "nanxinf"},
        {"render", "a.obj", "-o", "a.png", "--look", "sideways"},
        {"render", "a.obj", "-o", "a.png", "--look", "10,91"},
        {"render", "a.obj", "-o", "a.png", "--morph", "1.1"},
        {"render", "a.obj", "-o", "a.png", "--morph", "nan"},
        {"render", "a.obj", "-o", "a.png", "--view", "inside"},
        {"a.obj", "flatten", "b.obj"},
        {"--enough", "3", "flatten", "b.obj"},
        {"--overlay", "magic"},
        {"--panel", "wardrobe"},
        {"--nonsense"},
        {"batch", "list.txt", "-o", ""},
        {"flatten", "", "-o", "a.svg"},
        {"flatten", "a.obj", "-o", "a.svg", "-o", ""},
        {"compare", "a.obj", "--pattern", ""},
    };
    for (const auto& typed : wrong) {
        const Shown a = refused(typed);
        EXPECT_EQ(a.status, kExitUsage) << typed.back();
        EXPECT_TRUE(a.message.starts_with("toile: ")) << a.message;
        EXPECT_EQ(std::count(a.message.begin(), a.message.end(), '\n'), 1);
    }
}

TEST(Arguments, NameTheWordBeforeACommand) {
    for (const std::vector<const char*>& typed :
         {std::vector<const char*>{"--ledger", "flatten", "a.obj"},
          {"--unit", "cm", "flatten", "a.obj"},
          {"a.obj", "flatten"}}) {
        const std::string message = refused(typed).message;
        EXPECT_NE(message.find(std::string("\"") + typed.front() +
                               "\" stands before the command \"flatten\""),
                  std::string::npos)
            << message;
    }
}

/// The commands by the help, and the window, "".
std::vector<std::string> everyCommand() {
    std::vector<std::string> commands{""};
    const std::string help = parse({"--help"}).message;
    const std::size_t begin = help.find("Subcommands:");
    const std::string listed = help.substr(begin, help.find("Exit status:") - begin);
    const std::regex row("\n  (\\w+) ");
    for (std::sregex_iterator at(listed.begin(), listed.end(), row), end; at != end; ++at) {
        commands.push_back((*at)[1]);
    }
    return commands;
}

TEST(Arguments, OnlyATypedToleranceOfFairLinesIsFixed) {
    EXPECT_FALSE(parse({"flatten", "--fair", "a.obj"}).lines.fairing->isFixed);
    for (const char* typed : {"--fair=1", "--fair=0.5,30"}) {
        EXPECT_TRUE(parse({"flatten", "a.obj", typed}).lines.fairing->isFixed) << typed;
    }
    EXPECT_TRUE(parse({"flatten", "--fair", "1", "a.obj"}).lines.fairing->isFixed);
}

TEST(Arguments, NoNumberIsNanOrInfinite) {
    int tried = 0;
    for (const CommandRow& command : commandRows()) {
        Arguments ignored;
        OptionArchive at;
        command.describe(at, ignored);
        for (const Option& option : at.rows()) {
            for (const char* value : {"nan", "-nan", "inf", "-inf"}) {
                if (option.range) {
                    const std::string wrong = option.read({value});
                    EXPECT_NE(wrong.find("number from"), std::string::npos)
                        << command.word << ' ' << option.names << ' ' << value << ": " << wrong;
                    ++tried;
                }
            }
        }
    }
    EXPECT_GT(tried, 4 * 60);
    EXPECT_EQ(refused({"flatten", "a.obj", "--allowance", "nan"}).message,
              "toile: --allowance: needs a number from 0 to " + std::to_string(int(kMaxAllowance)) +
                  ", not \"nan\"; see toile flatten --help.\n");
    EXPECT_EQ(refused({"flatten", "a.obj", "--fair", "nan"}).status, kExitUsage);
    EXPECT_EQ(refused({"flatten", "a.obj", "--unit", "nanmm"}).status, kExitUsage);
}

TEST(Arguments, WhoAsksForHelpAsElsewhereGetsIt) {
    EXPECT_EQ(parse({"help"}).message, parse({"--help"}).message);
    EXPECT_EQ(parse({"help", "flatten"}).message, parse({"flatten", "--help"}).message);
    EXPECT_EQ(refused({"help", "flaten"}).status, kExitUsage);
}

TEST(Arguments, AWordThatIsNoCommandAndNoFileIsNoGarment) {
    EXPECT_EQ(refused({"flaten", "tee.obj", "--pattern"}).message,
              "toile: there is no command or file \"flaten\" (did you mean flatten?); see toile "
              "--help.\n");
    EXPECT_NE(refused({"halp"}).message.find("did you mean help?"), std::string::npos);
    const Shown far = refused({"wardrobe"});
    EXPECT_EQ(far.status, kExitUsage);
    EXPECT_EQ(far.message.find("did you mean"), std::string::npos) << far.message;
    // What could be a garment is for the window to open, there or not.
    EXPECT_EQ(parse({"flaten.obj"}).command, Command::Window);
    EXPECT_EQ(parse({TOILE_SOURCE_DIR "/README.md"}).command, Command::Window);
}

TEST(Arguments, WrongUsageEndsWithTheHelpOfItsCommand) {
    for (const std::string& command : everyCommand()) {
        std::vector<const char*> words{"--unt", "cm"};
        if (!command.empty()) {
            words.insert(words.begin(), command.c_str());
        }
        const std::string said = refused(words).message;
        const std::string hint = "; see toile " + command + (command.empty() ? "" : " ") + "--help";
        EXPECT_TRUE(said.ends_with(hint + ".\n")) << said;
        EXPECT_EQ(answerTo(words).refusal().message.find("--help"), std::string::npos) << said;
    }
    const std::string later = refused({"check", "a.obj", "--fabric", "tin"}).message;
    EXPECT_TRUE(later.ends_with("; see toile check --help.\n")) << later;
}

TEST(Arguments, AnOptionThatIsSaidTwiceIsCalledThat) {
    EXPECT_EQ(refused({"flatten", "a.obj", "--split", "uv", "--split", "objects"}).message,
              "toile: --split is given more than once; give it once; see toile flatten --help.\n");
}

TEST(Arguments, AnOlderNameWorksAndIsNotInTheHelp) {
    EXPECT_EQ(parse({"info", "a.obj", "--max-strain", "2.5"}).load.enoughStrain, 0.025);
    EXPECT_EQ(parse({"info", "--help"}).message.find("--enough"), std::string::npos);
    EXPECT_EQ(
        refused({"info", "a.obj", "--enough", "3", "--max-strain", "4"}).message,
        "toile: --max-strain is given more than once; give it once; see toile info --help.\n");
}

TEST(Arguments, EveryHelpIsGroupedBySubjectAndEndsWithAnExample) {
    for (const std::string& command : everyCommand()) {
        const std::string help = command.empty() ? parse({"--help"}).message
                                                 : parse({command.c_str(), "--help"}).message;
        EXPECT_NE(help.find(command.empty() ? ": toile dress" : "\nExample:\n  "),
                  std::string::npos)
            << help;
        EXPECT_NE(help.find("\nHelp:\n"), std::string::npos) << command;
        EXPECT_EQ(help.find("\nOptions:\n"), std::string::npos) << command;
    }
}

TEST(Arguments, ExamplesOfTheHelpAreValid) {
    for (const CommandRow& row : commandRows()) {
        std::istringstream words(row.example);
        std::vector<std::string> typed;
        for (std::string word; words >> word;) {
            typed.push_back(word);
        }
        typed.erase(typed.begin(), std::ranges::find(typed, "toile") + 1);
        std::vector<const char*> pointers;
        for (const std::string& word : typed) {
            pointers.push_back(word.c_str());
        }
        EXPECT_EQ(parse(pointers).command, row.command) << row.word;
    }
}

/// What a project says holds unless an option says otherwise; one rule for all settings.
TEST(Arguments, TypedOptionsHoldOverAProject) {
    Project project;
    project.options.method = Method::Lscm;
    project.options.quality = Quality::Fine;
    project.lines.allowance = AllowanceWidths{7, 8};
    project.proof.settings.edge = 5;
    project.proof.settings.hasGravity = true;
    project.proof.settings.stiffness.shear = 3;
    const Arguments flat =
        withSettingsOf(project, parse({"flatten", "a.obj", "--quality", "draft", "--hem", "20"}));
    EXPECT_EQ(flat.options.method, Method::Lscm);
    EXPECT_EQ(flat.options.quality, Quality::Draft);
    EXPECT_EQ(flat.lines.allowance, (AllowanceWidths{7, 20}));
    const auto proof = [&project](std::vector<const char*> typed) {
        typed.insert(typed.begin(), {"prove", "a.obj"});
        return withSettingsOf(project, parse(typed)).prove.plan.settings;
    };
    EXPECT_EQ(proof({}), project.proof.settings);
    EXPECT_FALSE(proof({"--no-gravity"}).hasGravity);
    EXPECT_EQ(proof({"--no-gravity"}).edge, 5);
    EXPECT_FALSE(proof({"--fabric", "denim"}).stiffness.shear);
}

TEST(Arguments, ExitStatusesAreToldInOnePlace) {
    const std::string help = parse({"--help"}).message;
    std::string table = "| Status | Meaning |\n|---|---|\n";
    for (const auto& [status, meaning] : exitMeanings()) {
        EXPECT_NE(help.find(meaning), std::string::npos) << meaning;
        table += std::string("| ") + status + " | " + meaning + " |\n";
    }
    test::expectTableInDocs("report.md", "exit statuses", table);
}

}  // namespace
}  // namespace toile::app
