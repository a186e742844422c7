// Runs to rest or blow-up, collected first and made together.
#pragma once

#include <string>
#include <vector>

#include "lab/settle/rest_run.h"

namespace weft::lab {

class RestBatch {
public:
    /// @param setting says all that determines the scene; one that is the study's own is "scene".
    /// @return where operator[] finds the run; a run asked for twice is made once.
    std::size_t add(const std::string& setting, const SceneDescription& scene,
                    const RestPlan& plan);

    /// Makes all of them: one call of Laboratory::run().
    void run(Laboratory& laboratory);

    [[nodiscard]] const RestRun& operator[](std::size_t run) const { return runs_[run]; }
    [[nodiscard]] std::size_t size() const { return trials_.size(); }

private:
    std::vector<Trial> trials_;
    std::vector<RestRun> runs_;
};

}  // namespace weft::lab
