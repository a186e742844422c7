// Limited-memory BFGS against the dense update it stands for.
#include "math/limited_memory.h"
#include "math/dot_product.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "math/parallel.h"
#include "math/random.h"

namespace weft::test {
namespace {

constexpr Eigen::Index size = 9;  // three slots

Vec3Array<double> to_array(const Eigen::VectorXd& v) {
    Vec3Array<double> array(3);
    for (std::size_t s = 0; s < 3; ++s) {
        const auto at = 3 * static_cast<Eigen::Index>(s);
        array.set(s, {v(at), v(at + 1), v(at + 2)});
    }
    return array;
}

Eigen::VectorXd to_vector(const Vec3Array<double>& array) {
    Eigen::VectorXd v(size);
    for (std::size_t s = 0; s < 3; ++s) {
        v.segment<3>(3 * static_cast<Eigen::Index>(s)) << array[s].x, array[s].y, array[s].z;
    }
    return v;
}

Eigen::VectorXd random(std::uint64_t seed) {
    Eigen::VectorXd v(size);
    for (Eigen::Index n = 0; n < size; ++n) {
        v(n) = 2 * random_uniform(seed, 0, static_cast<std::uint64_t>(n)) - 1;
    }
    return v;
}

// H+ = (I - s y^T/s.y) H (I - y s^T/s.y) + s s^T/s.y, from the identity.
TEST(LimitedMemory, IsTheDenseUpdateOfItsLastPairs) {
    const Eigen::VectorXd scale = (random(1).array().abs() + 0.5).matrix();
    LimitedMemory memory(3, 4);
    std::vector<std::pair<Eigen::VectorXd, Eigen::VectorXd>> pairs;
    const Vec3Array<double> zero(3);
    for (std::uint64_t n = 0; n < 7; ++n) {
        const Eigen::VectorXd s = random(10 + n), y = scale.cwiseProduct(s);
        memory.add(to_array(s), zero, to_array(y), zero);
        pairs.emplace_back(s, y);
    }
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(size, size);
    for (std::size_t n = 3; n < 7; ++n) {
        const auto& [s, y] = pairs[n];
        const Eigen::MatrixXd half =
            Eigen::MatrixXd::Identity(size, size) - y * s.transpose() / s.dot(y);
        inverse = half.transpose() * inverse * half + s * s.transpose() / s.dot(y);
    }
    Vec3Array<double> r = to_array(random(50));
    memory.before(r);
    memory.after(r);
    EXPECT_LT((to_vector(r) - inverse * random(50)).norm(), 1e-12);
}

TEST(LimitedMemory, PassesOverPairsWithoutCurvature) {
    LimitedMemory memory(3, 2);
    const Vec3Array<double> zero(3);
    const Eigen::VectorXd s = random(3);
    memory.add(to_array(s), zero, to_array(-s), zero);
    memory.add(zero, zero, zero, zero);
    Vec3Array<double> r = to_array(random(4));
    memory.before(r);
    memory.after(r);
    EXPECT_EQ(to_vector(r), random(4));
}

TEST(LimitedMemory, OfNoPairsIsTheIdentity) {
    LimitedMemory memory(3, 0);
    memory.add(to_array(random(1)), to_array(random(2)), to_array(random(3)), to_array(random(4)));
    Vec3Array<double> r = to_array(random(5));
    memory.before(r);
    memory.after(r);
    EXPECT_EQ(to_vector(r), random(5));
}

TEST(LimitedMemory, ForgetsWhenCleared) {
    LimitedMemory memory(3, 2);
    const Vec3Array<double> zero(3);
    const Eigen::VectorXd s = random(3);
    memory.add(to_array(s), zero, to_array(2 * s), zero);
    memory.clear();
    Vec3Array<double> r = to_array(random(4));
    memory.before(r);
    memory.after(r);
    EXPECT_EQ(to_vector(r), random(4));
}

TEST(Dot, IsTheSumAndTheSameForAnyThreads) {
    for (const std::size_t slots : {1u, 9u, 4000u, 100000u}) {
        Vec3Array<double> a(slots), b(slots);
        double exact = 0.0;
        for (std::size_t s = 0; s < slots; ++s) {
            a.set(s, {random_uniform(1, 0, s), random_uniform(2, 0, s), 1.0});
            b.set(s, {random_uniform(3, 0, s), 1.0, random_uniform(4, 0, s)});
            exact += a[s].x * b[s].x + a[s].y + b[s].z;
        }
        const double alone = dot(a, b);
        EXPECT_NEAR(alone, exact, 1e-12 * exact);
        for (const int threads : {2, 7}) {
            ThreadTeam team(threads);
            team.run([&] { EXPECT_EQ(dot(a, b), alone); });
        }
    }
}

}  // namespace
}  // namespace weft::test
