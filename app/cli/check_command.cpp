// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/proof_order.h"
#include "app/cli/write_patterns.h"
#include "core/base/characters.h"
#include "core/check/finding.h"
#include "core/check/ready_to_cut.h"
#include "core/project/project.h"
#include "core/project/rigid_motion.h"
#include "core/prove/proof.h"

namespace toile::app {
namespace {

/// What is said of the pieces, for the flat coordinates they have now.
std::vector<PieceSettings> settingsNow(const Arguments& arguments, const Garment& garment,
                                       const PieceResults& results) {
    std::vector<PieceSettings> settings = settingsOf(arguments, garment);
    for (std::size_t i = 0; i < settings.size(); ++i) {
        if (results[i]->flat) {
            settings[i] = anchoredSettings(std::move(settings[i]), results[i]->flat->Q);
        }
    }
    return settings;
}

/// The grain that was stated is set: where the project says none of a piece, by the rule.
void setGrains(const Arguments& arguments, CutPlan& plan) {
    std::vector<Fabric> fabrics;
    for (const PieceSettings& said : plan.settings) {
        fabrics.push_back(fabricOf(said.material, plan.materials, plan.fabric));
    }
    const auto grains =
        grainsByRule(arguments, *plan.garment, plan.results, fabrics, plan.pattern->symmetry.get());
    for (std::size_t p = 0; p < grains.size(); ++p) {
        std::optional<double>& grain = plan.settings[p].grain;
        grain = grain ? grain : grains[p];
    }
}

/// A line for each finding; those that say the same of several pieces or seams share one.
void printFindings(const Readiness& readiness, std::ostream& out) {
    const auto& findings = readiness.findings;
    for (std::size_t i = 0; i < findings.size();) {
        Finding told = findings[i];
        std::string& names = told.subject.name;
        names = shownText(names, kMaxOfPlace);
        for (++i; i < findings.size() && findings[i].severity == told.severity &&
                  findings[i].kind == told.kind && !names.empty() &&
                  description(findings[i]) == description(told) &&
                  adviceFor(findings[i]) == adviceFor(told);
             ++i) {
            names += ", " + shownText(findings[i].subject.name, kMaxOfPlace);
        }
        out << name(told.severity) << ": " << sentence(told) << '\n';
    }
}

/// The pattern sewn back together; null, and why, where it cannot be.
std::shared_ptr<const Proof> proved(const Arguments& arguments, const CutPlan& plan,
                                    Progress& progress, std::ostream& err) {
    const auto ordered = orderOfOwn(arguments, *plan.garment, progress);
    if (const auto* refusal = std::get_if<Refusal>(&ordered)) {
        refuse(*refusal, err);
        return nullptr;
    }
    const LaidOutPattern laid = laidOut(arguments, *plan.garment, plan.results);
    const ExportSource source(*plan.garment, plan.results, laid, arguments.exporting, {},
                              arguments.lines, plan.fabric);
    const auto proof = proofOf(source, std::get<ProofOrder>(ordered), progress);
    if (!proof) {
        refuse(refusalOfProof(proof.error(), plan.results), err);
        return nullptr;
    }
    return *proof;
}

}  // namespace

int runCheck(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    Progress progress;
    auto read = readInput(arguments, progress, err);
    if (!read) {
        return kExitUnreadable;
    }
    CutPlan plan;
    plan.garment = std::make_shared<const Garment>(std::move(*read));
    plan.options = arguments.options;
    plan.lines = arguments.lines;
    plan.results = flattened(arguments, *plan.garment, progress);
    plan.pattern = std::make_shared<const Pattern>(makePattern(
        *plan.garment, plan.results, plan.lines, symmetryOf(*plan.garment, plan.lines)));
    plan.fabric = arguments.fabric.value_or(plan.fabric);
    plan.settings = settingsNow(arguments, *plan.garment, plan.results);
    plan.materials = materialsOf(arguments, plan.settings);
    setGrains(arguments, plan);
    if (arguments.project) {
        plan.rules = clothRules(arguments.project->markers);
    }
    if (arguments.isProving) {
        plan.proof = proved(arguments, plan, progress, err);
    }
    const Readiness readiness = readyToCut(plan, progress);
    if (arguments.json) {
        out << writeReadiness(*plan.garment, readiness);
    } else {
        out << verdictText(readiness) << '\n';
        printFindings(readiness, out);
        for (const ClothNeed& need : readiness.cloth) {
            out << "cloth: " << sentence(need) << '\n';
        }
    }
    out.flush();
    const bool isProved = !arguments.isProving || plan.proof != nullptr;
    const bool isReady = isProved && readiness.count(Severity::Fault) == 0 &&
                         !(arguments.failOnDoubt && readiness.count(Severity::Doubt) > 0);
    return !out ? kExitUnreadable : isReady ? kExitDone : kExitSomeFailed;
}

}  // namespace toile::app
