// scratch.h — names of files and folders that a test makes.
#pragma once

#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace kadr::testing {

/// A path for this process alone: the tests of another tree may run beside these.
inline std::string scratch(const std::string& name) {
    return ::testing::TempDir() + "kadr-" + std::to_string(::getpid()) + '-' + name;
}

}  // namespace kadr::testing
