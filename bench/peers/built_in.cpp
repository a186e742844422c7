#include "bench/peers/built_in.h"

#ifdef WEFT_BENCH_BOOST
#include "bench/peers/odeint.h"
#endif
#ifdef WEFT_BENCH_BULLET
#include "bench/peers/bullet.h"
#include "bench/peers/bullet_deformable.h"
#endif

namespace weft::bench {

#ifdef WEFT_BENCH_BOOST
constinit const MakePeer odeint_rk4 = [](const PlainSheet& sheet) {
    return make_odeint(sheet, OdeintStepper::rk4);
};
constinit const MakePeer odeint_velocity_verlet = [](const PlainSheet& sheet) {
    return make_odeint(sheet, OdeintStepper::velocity_verlet);
};
std::string boost_version_built_in() {
    return odeint_version();
}
#else
constinit const MakePeer odeint_rk4 = nullptr;
constinit const MakePeer odeint_velocity_verlet = nullptr;
std::string boost_version_built_in() {
    return {};
}
#endif

#ifdef WEFT_BENCH_BULLET
constinit const MakePeer bullet_soft_body = make_bullet;
constinit const MakePeer bullet_deformable = make_bullet_deformable;
std::string bullet_version_built_in() {
    return bullet_version();
}
#else
constinit const MakePeer bullet_soft_body = nullptr;
constinit const MakePeer bullet_deformable = nullptr;
std::string bullet_version_built_in() {
    return {};
}
#endif

}  // namespace weft::bench
