// The one table of integrators.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "integrators/composition.h"
#include "integrators/integrator.h"
#include "integrators/runge_kutta.h"
#include "integrators/verlet.h"

namespace weft {

namespace {

// How a method is run: exactly one of the members is set.
struct Method {
    const ButcherTable* runge_kutta = nullptr;
    const CompositionTable* composition = nullptr;
    enum class Verlet { none, fixed, time_corrected, velocity } verlet = Verlet::none;
};

constexpr std::array<IntegratorInfo, 10> infos{{
    {"forward-euler", 1, 1, 1, false, 0.0, "x+ = x + dt v; v+ = v + dt a(x, v)",
     "Euler (1768); both papers (section 1.3.1; eq. 2)"},
    {"symplectic-euler", 1, 1, 1, true, 2.0, "v+ = v + dt a(x, v); x+ = x + dt v+",
     "Hairer, Lubich, Wanner, Geometric Numerical Integration, I.1.2"},
    {"verlet", 2, 2, 1, true, 2.0, "x+ = x + (x - x_prev) + a dt^2",
     "Verlet (1967) Phys. Rev. 159, 98; comparison eq. 5"},
    {"time-corrected-verlet", 2, 2, 1, true, 2.0,
     "x+ = x + (x - x_prev) dt/dt_prev + a dt (dt + dt_prev)/2",
     "Verlet for a changing step; named in Flag in the Wind, section 1.3.2"},
    {"velocity-verlet", 2, 2, 1, true, 2.0, "x+ = x + dt v + dt^2 a/2; v+ = v + dt (a + a+)/2",
     "Swope, Andersen, Berens, Wilson (1982) J. Chem. Phys. 76, 637"},
    {"rk2", 2, 2, 2, false, 0.0, "midpoint: K2 = f(y + h/2 K1); y+ = y + h K2",
     "Runge (1895); Hairer, Norsett, Wanner, Solving ODEs I, II.1"},
    {"rk3", 3, 3, 3, false, 1.7320508075688772,
     "K2 = f(y + h/2 K1); K3 = f(y - h K1 + 2h K2); y+ = y + h/6 (K1 + 4 K2 + K3)",
     "Kutta (1901); comparison eq. 12, its K2 mended"},
    {"rk4", 4, 4, 4, false, 2.8284271247461903, "y+ = y + h/6 (K1 + 2 K2 + 2 K3 + K4)",
     "Kutta (1901); Hairer, Norsett, Wanner, Solving ODEs I, II.1"},
    {"yoshida4", 4, 1, 3, true, 1.5734, "drift w1/2, kick w1, drift (w0+w1)/2, kick w0, and back",
     "Yoshida (1990) Phys. Lett. A 150, 262"},
    {"forest-ruth", 4, 1, 3, true, 1.5734, "drift t/2, kick t, drift (1-t)/2, kick 1-2t, and back",
     "Forest, Ruth (1990) Physica D 43, 105; the same coefficients as yoshida4"},
}};

const std::array<Method, infos.size()> methods{{
    {.runge_kutta = &forward_euler_table},
    {.composition = &symplectic_euler_table},
    {.verlet = Method::Verlet::fixed},
    {.verlet = Method::Verlet::time_corrected},
    {.verlet = Method::Verlet::velocity},
    {.runge_kutta = &midpoint_table},
    {.runge_kutta = &kutta3_table},
    {.runge_kutta = &classical4_table},
    {.composition = &fourth_order_table},
    {.composition = &fourth_order_table},
}};

const Method& find_method(std::string_view name) {
    const IntegratorInfo* info = find_integrator(name);
    assert(info != nullptr);
    return methods[static_cast<std::size_t>(info - infos.data())];
}

double runge_kutta_amplification(const ButcherTable& table, double omega_dt, double zeta) {
    const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1.0));
    return std::max(std::abs(stability_function(table, omega_dt * (-zeta + root))),
                    std::abs(stability_function(table, omega_dt * (-zeta - root))));
}

double amplification(const Method& method, double omega_dt, double zeta) {
    if (method.runge_kutta != nullptr) {
        return runge_kutta_amplification(*method.runge_kutta, omega_dt, zeta);
    }
    if (method.composition != nullptr) {
        return composition_amplification(*method.composition, omega_dt, zeta);
    }
    return method.verlet == Method::Verlet::velocity
               ? velocity_verlet_amplification(omega_dt, zeta)
               : position_verlet_amplification(omega_dt, zeta);
}

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
    return amplification(find_method(method), omega_dt, zeta);
}

double stability_limit(std::string_view name, double zeta) {
    const Method& method = find_method(name);
    const IntegratorInfo& info = *find_integrator(name);
    if (zeta == 0.0 && info.imaginary_limit == 0.0) return 0.0;
    const auto stable = [&](double omega_dt) {
        // Growth below this is rounding: over 1e9 steps it stays under a thousandth.
        return amplification(method, omega_dt, zeta) <= 1.0 + 1e-12;
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
std::unique_ptr<Integrator<Real>> make_integrator(std::string_view name, InstructionSet set) {
    const Method& method = find_method(name);
    if (method.runge_kutta != nullptr) {
        return std::make_unique<RungeKutta<Real>>(*method.runge_kutta, set);
    }
    if (method.composition != nullptr) {
        return std::make_unique<Composition<Real>>(*method.composition);
    }
    if (method.verlet == Method::Verlet::velocity) return std::make_unique<VelocityVerlet<Real>>();
    return std::make_unique<PositionVerlet<Real>>(method.verlet == Method::Verlet::time_corrected);
}

template std::unique_ptr<Integrator<float>> make_integrator(std::string_view, InstructionSet);
template std::unique_ptr<Integrator<double>> make_integrator(std::string_view, InstructionSet);

}  // namespace weft
