// The one table of integrators.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <variant>

#include "integrators/composition.h"
#include "integrators/embedded_runge_kutta.h"
#include "integrators/implicit.h"
#include "integrators/projective_dynamics.h"
#include "integrators/runge_kutta.h"
#include "integrators/vbd.h"
#include "integrators/verlet.h"
#include "integrators/xpbd.h"

namespace weft {

namespace {

constexpr double any = std::numeric_limits<double>::infinity();
constexpr IntegratorKind explicit_steps = IntegratorKind::explicit_steps,
                         adaptive = IntegratorKind::adaptive, implicit = IntegratorKind::implicit,
                         by_springs = IntegratorKind::by_springs;

constexpr std::array<IntegratorInfo, 22> infos{{
    {"forward-euler", 1, 1, 1, false, 0.0, explicit_steps, 0.0,
     "x+ = x + dt v; v+ = v + dt a(x, v)", "Euler (1768); both papers (section 1.3.1; eq. 2)"},
    {"symplectic-euler", 1, 1, 1, true, 2.0, explicit_steps, 0.0,
     "v+ = v + dt a(x, v); x+ = x + dt v+",
     "Hairer, Lubich, Wanner, Geometric Numerical Integration, I.1.2"},
    {"verlet", 2, 2, 1, true, 2.0, explicit_steps, 0.0, "x+ = x + (x - x_prev) + a dt^2",
     "Verlet (1967) Phys. Rev. 159, 98; comparison eq. 5"},
    {"time-corrected-verlet", 2, 2, 1, true, 2.0, explicit_steps, 0.0,
     "x+ = x + (x - x_prev) dt/dt_prev + a dt (dt + dt_prev)/2",
     "Verlet for a changing step; named in Flag in the Wind, section 1.3.2"},
    {"velocity-verlet", 2, 2, 1, true, 2.0, explicit_steps, 0.0,
     "x+ = x + dt v + dt^2 a/2; v+ = v + dt (a + a+)/2",
     "Swope, Andersen, Berens, Wilson (1982) J. Chem. Phys. 76, 637"},
    {"rk2", 2, 2, 2, false, 0.0, explicit_steps, 0.0, "midpoint: K2 = f(y + h/2 K1); y+ = y + h K2",
     "Runge (1895); Hairer, Norsett, Wanner, Solving ODEs I, II.1"},
    {"rk3", 3, 3, 3, false, 1.7320508075688772, explicit_steps, 0.0,
     "K2 = f(y + h/2 K1); K3 = f(y - h K1 + 2h K2); y+ = y + h/6 (K1 + 4 K2 + K3)",
     "Kutta (1901); comparison eq. 12, its K2 mended"},
    {"rk4", 4, 4, 4, false, 2.8284271247461903, explicit_steps, 0.0,
     "y+ = y + h/6 (K1 + 2 K2 + 2 K3 + K4)",
     "Kutta (1901); Hairer, Norsett, Wanner, Solving ODEs I, II.1"},
    {"yoshida4", 4, 1, 3, true, 1.5734, explicit_steps, 0.0,
     "drift w1/2, kick w1, drift (w0+w1)/2, kick w0, and back",
     "Yoshida (1990) Phys. Lett. A 150, 262"},
    {"forest-ruth", 4, 1, 3, true, 1.5734, explicit_steps, 0.0,
     "drift t/2, kick t, drift (1-t)/2, kick 1-2t, and back",
     "Forest, Ruth (1990) Physica D 43, 105; the same coefficients as yoshida4"},
    {"bosh3", 3, 3, 0, false, 1.7320508075688772, adaptive, 0.0,
     "Runge-Kutta 3(2), steps by error; y(t) between them by a cubic",
     "Bogacki, Shampine (1989) Appl. Math. Letters 2, 321"},
    {"dopri5", 5, 5, 0, false, 0.99718901069190602, adaptive, 0.0,
     "Runge-Kutta 5(4), steps by error; y(t) between them of order 4",
     "Dormand, Prince (1980) J. Comput. Appl. Math. 6, 19"},
    {"implicit-euler", 1, 1, 0, false, any, implicit, 1.0 / 60, "v+ = v + dt a+; x+ = x + dt v+",
     "Hairer, Wanner, Solving ODEs II, IV.3; damps all motion"},
    {"implicit-midpoint", 2, 2, 0, true, any, implicit, 1.0 / 240, "y+ = y + h f((y + y+)/2)",
     "Hairer, Lubich, Wanner, Geometric Numerical Integration, II.1"},
    {"trapezoidal", 2, 2, 0, false, any, implicit, 1.0 / 240, "y+ = y + h/2 (f(y) + f(y+))",
     "Hairer, Wanner, Solving ODEs II, IV.3; keeps stiff modes ringing"},
    {"bdf2", 2, 2, 0, false, any, implicit, 1.0 / 120, "y+ = 4/3 y - 1/3 y_prev + 2/3 h f(y+)",
     "Curtiss, Hirschfelder (1952) PNAS 38, 235"},
    {"tr-bdf2", 2, 2, 0, false, any, implicit, 1.0 / 120,
     "trapezoidal to t + (2 - sqrt 2) h, then BDF2 to t + h",
     "Bank et al. (1985) IEEE Trans. CAD 4, 436; Hosea, Shampine (1996)"},
    {"sdirk2", 2, 2, 0, false, any, implicit, 1.0 / 120,
     "two implicit stages of 1 - 1/sqrt 2 of the step",
     "Alexander (1977) SIAM J. Numer. Anal. 14, 1006"},
    {"baraff-witkin", 1, 1, 0, false, any, implicit, 1.0 / 60,
     "one Newton iteration of implicit-euler, from x + dt v: one linear solve",
     "Baraff, Witkin (1998) Large steps in cloth simulation, SIGGRAPH"},
    {"projective-dynamics", 1, 1, 0, false, any, by_springs, 1.0 / 60,
     "implicit-euler by constant matrix: local projections, global solve",
     "Bouaziz et al. (2014) ACM TOG 33, 154; Liu, Bouaziz, Kavan (2017)"},
    {"xpbd", 1, 1, 0, false, any, by_springs, 1.0 / 1200,
     "each spring in turn moves its ends by its multiplier's change",
     "Macklin, Mueller, Chentanez (2016); small steps: Macklin et al. (2019)"},
    {"vbd", 1, 1, 0, false, any, by_springs, 1.0 / 600,
     "each particle in turn takes a Newton step of its own",
     "Chen, Liu, Yang, Yuksel (2024) Vertex block descent, ACM TOG 43, 116"},
}};

// How a method is run.
enum class VerletForm { fixed, time_corrected, velocity };
enum class BySprings { projective_dynamics, xpbd, vbd };
struct TwoStepBackward {};
struct SingleSolve {};
using Method =
    std::variant<const ButcherTable*, const CompositionTable*, VerletForm, const EmbeddedTable*,
                 const DirkTable*, TwoStepBackward, SingleSolve, BySprings>;

const std::array<Method, infos.size()> methods{{
    &forward_euler_table,  &symplectic_euler_table,
    VerletForm::fixed,     VerletForm::time_corrected,
    VerletForm::velocity,  &midpoint_table,
    &kutta3_table,         &classical4_table,
    &fourth_order_table,   &fourth_order_table,
    &bosh3_table,          &dopri5_table,
    &implicit_euler_table, &implicit_midpoint_table,
    &trapezoidal_table,    TwoStepBackward{},
    &tr_bdf2_table,        &sdirk2_table,
    SingleSolve{},         BySprings::projective_dynamics,
    BySprings::xpbd,       BySprings::vbd,
}};

const Method& find_method(std::string_view name) {
    const IntegratorInfo* info = find_integrator(name);
    assert(info != nullptr);
    return methods[static_cast<std::size_t>(info - infos.data())];
}

// A method's growth on a mode; what solves implicit Euler's equations has its.
struct Amplification {
    double omega_dt, zeta;

    double operator()(const ButcherTable* table) const {
        return amplification(*table, omega_dt, zeta);
    }
    double operator()(const CompositionTable* table) const {
        return composition_amplification(*table, omega_dt, zeta);
    }
    double operator()(VerletForm form) const {
        return form == VerletForm::velocity ? velocity_verlet_amplification(omega_dt, zeta)
                                            : position_verlet_amplification(omega_dt, zeta);
    }
    double operator()(const EmbeddedTable* table) const {
        return embedded_amplification(*table, omega_dt, zeta);
    }
    double operator()(const DirkTable* table) const {
        return dirk_amplification(*table, omega_dt, zeta);
    }
    double operator()(TwoStepBackward) const { return bdf2_amplification(omega_dt, zeta); }
    double operator()(SingleSolve) const { return (*this)(&implicit_euler_table); }
    double operator()(BySprings) const { return (*this)(&implicit_euler_table); }
};

template <typename Real>
struct Maker {
    using Result = std::unique_ptr<Integrator<Real>>;
    const IntegratorSettings& settings;

    Result operator()(const ButcherTable* table) const {
        return std::make_unique<RungeKutta<Real>>(*table, settings.instruction_set);
    }
    Result operator()(const CompositionTable* table) const {
        return std::make_unique<Composition<Real>>(*table);
    }
    Result operator()(VerletForm form) const {
        if (form == VerletForm::velocity) return std::make_unique<VelocityVerlet<Real>>();
        return std::make_unique<PositionVerlet<Real>>(form == VerletForm::time_corrected);
    }
    Result operator()(const EmbeddedTable* table) const {
        ErrorControl control;
        if (settings.tolerance) control.tolerance = *settings.tolerance;
        if (settings.largest_step) control.largest_step = *settings.largest_step;
        return std::make_unique<EmbeddedRungeKutta<Real>>(*table, control,
                                                          settings.instruction_set);
    }
    Result operator()(const DirkTable* table) const {
        return std::make_unique<DiagonallyImplicit<Real>>(*table, newton());
    }
    Result operator()(TwoStepBackward) const { return std::make_unique<Bdf2<Real>>(newton()); }
    Result operator()(SingleSolve) const {
        return std::make_unique<DiagonallyImplicit<Real>>(implicit_euler_table, newton(), true);
    }
    Result operator()(BySprings method) const {
        switch (method) {
            case BySprings::projective_dynamics: {
                typename ProjectiveDynamics<Real>::Settings chosen;
                if (settings.iterations) chosen.iterations = *settings.iterations;
                if (settings.tolerance) chosen.tolerance = *settings.tolerance;
                return std::make_unique<ProjectiveDynamics<Real>>(chosen);
            }
            case BySprings::xpbd:
                return std::make_unique<Xpbd<Real>>(settings.iterations.value_or(1));
            case BySprings::vbd:
                break;
        }
        return std::make_unique<VertexBlockDescent<Real>>(settings.iterations.value_or(20));
    }

private:
    [[nodiscard]] NewtonLimits newton() const {
        NewtonLimits limits;
        if (settings.tolerance) limits.tolerance = *settings.tolerance;
        if (settings.iterations) limits.max_iterations = *settings.iterations;
        return limits;
    }
};

}  // namespace

std::span<const IntegratorInfo> integrator_catalogue() {
    return infos;
}

const IntegratorInfo* find_integrator(std::string_view name) {
    const auto found = std::find_if(infos.begin(), infos.end(),
                                    [&](const IntegratorInfo& info) { return info.name == name; });
    return found == infos.end() ? nullptr : &*found;
}

double amplification(std::string_view method, double omega_dt, double zeta) {
    return std::visit(Amplification{omega_dt, zeta}, find_method(method));
}

double stability_limit(std::string_view name, double zeta) {
    const IntegratorInfo& info = *find_integrator(name);
    if (std::isinf(info.imaginary_limit)) return info.imaginary_limit;  // and in the whole plane
    if (zeta == 0.0 && info.imaginary_limit == 0.0) return 0.0;
    const auto stable = [&](double omega_dt) {
        // Growth below this is rounding: over 1e9 steps it stays under a thousandth.
        return amplification(name, omega_dt, zeta) <= 1.0 + 1e-12;
    };
    // Along a mode's ray every method here is stable from 0 up to its limit: march, then bisect.
    constexpr double first = 1e-6, last = 10.0, ratio = 1.02;
    double low = 0.0, high = first;
    while (high < last && stable(high)) {
        low = high;
        high *= ratio;
    }
    for (int n = 0; n < 50; ++n) {
        const double middle = (low + high) / 2;
        (stable(middle) ? low : high) = middle;
    }
    return low;
}

template <typename Real>
std::unique_ptr<Integrator<Real>> make_integrator(std::string_view name,
                                                  const IntegratorSettings& settings) {
    return std::visit(Maker<Real>{settings}, find_method(name));
}

template std::unique_ptr<Integrator<float>> make_integrator(std::string_view,
                                                            const IntegratorSettings&);
template std::unique_ptr<Integrator<double>> make_integrator(std::string_view,
                                                             const IntegratorSettings&);

}  // namespace weft
