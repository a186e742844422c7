// Which vector instructions there are, and choosing among them.
#include <gtest/gtest.h>

#include "math/instruction_sets.h"
#include "weft/error.h"

namespace weft::test {
namespace {

class InstructionSets : public ::testing::Test {
    void TearDown() override { use_instruction_set(instruction_sets().back()); }
};

TEST_F(InstructionSets, BeginWithScalarAndEndWithTheBest) {
    const auto sets = instruction_sets();
    ASSERT_GE(sets.size(), 1u);
    EXPECT_EQ(sets.front(), "scalar");
    for (std::size_t n = 0; n < sets.size(); ++n) {
        EXPECT_EQ(name_of(static_cast<InstructionSet>(n)), sets[n]);
    }
}

TEST_F(InstructionSets, EachCanBeChosen) {
    for (const std::string_view name : instruction_sets()) {
        use_instruction_set(name);
        EXPECT_EQ(instruction_set(), name);
        EXPECT_EQ(name_of(chosen_instruction_set()), name);
    }
}

TEST_F(InstructionSets, AnotherNameIsRefusedAndChangesNothing) {
    use_instruction_set("scalar");
    try {
        use_instruction_set("mmx");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("\"mmx\""), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("it has scalar"), std::string::npos);
    }
    EXPECT_EQ(instruction_set(), "scalar");
}

}  // namespace
}  // namespace weft::test
