// A study: experiments on one scene, or the same experiments on two, and the report of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/experiment.h"
#include "lab/laboratory.h"
#include "lab/report/report.h"

namespace weft::lab {

struct StudyPlan {
    std::vector<SceneDescription> scenes;        ///< one; or two, to compare
    std::vector<const Experiment*> experiments;  ///< none: all
    std::filesystem::path directory;
    std::string arguments;  ///< that follow the experiments on the command line: "sheet --quick"
    LabOptions options;
};

/// Measures, and writes the report into plan.directory; a report of before stays until then.
/// Finished trials stand in directory/trials (of two scenes: directory/SCENE/trials), where a study
/// of the same scenes finds them again.
/// @return the files written.
/// @throws Interrupted; Error.
std::vector<std::filesystem::path> run_study(const StudyPlan& plan);

}  // namespace weft::lab
