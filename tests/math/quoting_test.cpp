// Text made fit for messages.
#include "math/quoting.h"

#include <gtest/gtest.h>

namespace weft {
namespace {

TEST(Quoting, ControlCharactersBecomeSpaces) {
    EXPECT_EQ(one_line("a\nb\tc\x1b[0m\x7f"), "a b c [0m ");
    EXPECT_EQ(one_line("caf\xc3\xa9"), "caf\xc3\xa9");
}

TEST(Quoting, QuotesAreThoseOfToml) {
    EXPECT_EQ(in_quotes("rk4"), "\"rk4\"");
    EXPECT_EQ(in_quotes("a\"b\\c"), "\"a\\\"b\\\\c\"");
    EXPECT_EQ(in_quotes("a\nb"), "\"a\\u000ab\"");
}

}  // namespace
}  // namespace weft
