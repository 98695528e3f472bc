// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "app/cli/command_line.h"

namespace toile {
namespace {

using Command = Arguments::Command;

Arguments parse(std::vector<const char*> typed) {
    typed.insert(typed.begin(), "toile");
    return parseArguments(static_cast<int>(typed.size()), typed.data());
}

TEST(Arguments, NothingOrAFileOpensTheWindow) {
    EXPECT_EQ(parse({}).command, Command::Window);
    const Arguments file = parse({"dress.obj", "belt.obj", "--unit", "cm"});
    EXPECT_EQ(file.command, Command::Window);
    EXPECT_EQ(file.inputs.size(), 2U);
    EXPECT_EQ(file.load.unit, LengthUnit::Centimetre);
    EXPECT_EQ(parse({"dress.obj", "--screenshot", "a.png"}).screenshot, "a.png");
    EXPECT_EQ(parse({"dress.obj", "--overlay", "strain"}).overlay, Overlay::Strain);
    EXPECT_EQ(parse({}).overlay, Overlay::Checker);
    EXPECT_EQ(parse({"dress.obj", "--panel", "seams"}).panel, Panel::Seams);
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

TEST(Arguments, AnOutputMayComeBeforeTheInput) {
    const Arguments a = parse({"flatten", "-o", "x.svg", "a.obj", "b.obj"});
    EXPECT_EQ(a.inputs.size(), 2U);
    EXPECT_EQ(a.outputs.size(), 1U);
}

TEST(Arguments, DefaultsAreTheLengthPreservedBoundaryByNewton) {
    const Arguments a = parse({"flatten", "a.obj"});
    EXPECT_EQ(a.options.method, Method::Wang2005);
    EXPECT_EQ(a.options.boundarySolver, BoundarySolver::Newton);
    EXPECT_TRUE(a.outputs.empty());
}

TEST(Arguments, TheWindowReadsFilesAsTheCommandsDo) {
    for (const bool window : {true, false}) {
        std::vector<const char*> typed{"a.obj",  "--split",    "seams",  "--seams",
                                       "a.json", "--auto-cut", "--weld", "--up",
                                       "z",      "--unit",     "in",     "--strict"};
        if (!window) {
            typed.insert(typed.begin(), "info");
        }
        const Arguments a = parse(typed);
        EXPECT_EQ(a.command, window ? Command::Window : Command::Info) << a.message;
        EXPECT_EQ(a.load.split, SplitMode::Seams);
        EXPECT_EQ(a.seams, "a.json");
        EXPECT_EQ(a.load.up, UpAxis::Z);
        EXPECT_EQ(a.load.unit, LengthUnit::Inch);
        EXPECT_TRUE(a.load.autoCut && a.load.weld && a.load.strict);
    }
}

TEST(Arguments, HelpAndVersionAreMessages) {
    const Arguments help = parse({"--help"});
    EXPECT_EQ(help.command, Command::Message);
    EXPECT_EQ(help.status, kExitDone);
    EXPECT_NE(help.message.find("flatten"), std::string::npos);
    EXPECT_NE(parse({"flatten", "--help"}).message.find("--boundary-solver"), std::string::npos);
    EXPECT_NE(parse({"--version"}).message.find(TOILE_VERSION), std::string::npos);
}

TEST(Arguments, WrongUsageIsStatusTwoWithASentence) {
    const std::vector<std::vector<const char*>> wrong = {
        {"flatten"},
        {"flatten", "a.obj", "-o", "a.pdf"},
        {"flatten", "a.obj", "--unit", "ell"},
        {"flatten", "a.obj", "--method", "magic"},
        {"flatten", "a.obj", "--report", "r.txt"},
        {"flatten", "a.obj", "--split", "seams"},
        {"flatten", "a.obj", "--up", "x"},
        {"flatten", "a.obj", "--nonsense"},
        {"flatten", "a.obj", "-o"},
        {"info"},
        {"a.obj", "flatten", "b.obj"},
        {"--overlay", "magic"},
        {"--panel", "wardrobe"},
        {"--nonsense"},
    };
    for (const auto& typed : wrong) {
        const Arguments a = parse(typed);
        EXPECT_EQ(a.command, Command::Message);
        EXPECT_EQ(a.status, kExitUsage);
        EXPECT_TRUE(a.message.starts_with("toile: ")) << a.message;
        EXPECT_EQ(std::count(a.message.begin(), a.message.end(), '\n'), 1) << a.message;
    }
}

}  // namespace
}  // namespace toile
