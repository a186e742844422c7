// Names of tests that have a parameter.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace weft::test {

/// Of a parameter that is a word, such as a method: names of tests have no hyphens.
inline std::string test_name(const testing::TestParamInfo<std::string>& word) {
    std::string name = word.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}  // namespace weft::test
