// y' = f(t, y) by SUNDIALS' CVODE (Hindmarsh et al. (2005) ACM TOMS 31, 363): somebody else's
// solver, of variable order.
#pragma once

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "support/extrapolation.h"

namespace weft::test {

/// y(t_end) from y(t), by Adams methods of orders 1 to 12 with fixed-point iteration.
/// @param tolerance of the local error, relative and absolute.
/// @throws std::runtime_error where CVODE fails.
class Cvode {
public:
    Cvode(Slope slope, double tolerance) : slope_(std::move(slope)), tolerance_(tolerance) {
        check(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
    }
    ~Cvode() { SUNContext_Free(&context_); }
    Cvode(const Cvode&) = delete;
    Cvode& operator=(const Cvode&) = delete;

    Values operator()(double t, double t_end, const Values& start) {
        in_ = start;
        out_ = start;
        const auto size = static_cast<sunindextype>(start.size());
        const std::unique_ptr<_generic_N_Vector, void (*)(N_Vector)> y(
            N_VNew_Serial(size, context_), N_VDestroy);
        std::copy(start.begin(), start.end(), N_VGetArrayPointer(y.get()));
        const std::unique_ptr<void, void (*)(void*)> memory(CVodeCreate(CV_ADAMS, context_),
                                                            [](void* m) { CVodeFree(&m); });
        check(CVodeInit(memory.get(), right_side, t, y.get()), "CVodeInit");
        const std::unique_ptr<_generic_SUNNonlinearSolver, int (*)(SUNNonlinearSolver)> solver(
            SUNNonlinSol_FixedPoint(y.get(), 0, context_), SUNNonlinSolFree);
        check(CVodeSetUserData(memory.get(), this), "CVodeSetUserData");
        check(CVodeSStolerances(memory.get(), tolerance_, tolerance_), "CVodeSStolerances");
        check(CVodeSetNonlinearSolver(memory.get(), solver.get()), "CVodeSetNonlinearSolver");
        check(CVodeSetMaxNumSteps(memory.get(), 10'000'000), "CVodeSetMaxNumSteps");
        check(CVodeSetStopTime(memory.get(), t_end), "CVodeSetStopTime");
        double reached = t;
        check(CVode(memory.get(), t_end, y.get(), &reached, CV_NORMAL), "CVode");
        const double* end = N_VGetArrayPointer(y.get());
        return {end, end + start.size()};
    }

private:
    static int right_side(double t, N_Vector y, N_Vector slope, void* user) {
        auto& self = *static_cast<Cvode*>(user);
        std::copy_n(N_VGetArrayPointer(y), self.in_.size(), self.in_.begin());
        self.slope_(t, self.in_, self.out_);
        std::copy(self.out_.begin(), self.out_.end(), N_VGetArrayPointer(slope));
        return 0;
    }
    static void check(int flag, const char* call) {
        if (flag < 0) throw std::runtime_error(call + (" returned " + std::to_string(flag)));
    }

    Slope slope_;
    double tolerance_;
    SUNContext context_ = nullptr;
    Values in_, out_;
};

}  // namespace weft::test
