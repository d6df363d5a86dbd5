#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace planish {

/// How many times as many cases as usual: the environment variable PLANISH_PROPERTY_FACTOR.
inline int property_factor() {
  const char* const factor = std::getenv("PLANISH_PROPERTY_FACTOR");
  return factor == nullptr ? 1 : std::max(1, std::atoi(factor));
}

/// Checks a property on so many arbitrary cases: the same in every run, or those of the seed that
/// rapidcheck's environment variable names, as in RC_PARAMS="seed=7".
template <class Body>
void check_cases(int cases, Body body) {
  const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
  rc::detail::TestMetadata metadata;
  metadata.id = std::string(test->test_suite_name()) + "/" + test->name();
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  constexpr std::uint64_t k_seed = 2010;
  if (std::getenv("RC_PARAMS") == nullptr) params.seed = k_seed;
  params.maxSuccess = cases * property_factor();
  const auto result = rc::detail::checkTestable(body, metadata, params);
  if (result.template is<rc::detail::SuccessResult>()) {
    const auto passed = result.template get<rc::detail::SuccessResult>().numSuccess;
    std::cout << "passed " << passed << " cases" << std::endl;
    testing::Test::RecordProperty("cases", passed);
    return;
  }
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  FAIL() << message.str();
}

}  // namespace planish

/// Defines a test whose body is run on so many cases.
#define PLANISH_PROPERTY(suite, name, cases)                  \
  void suite##_##name##_property();                           \
  TEST(suite, name) {                                         \
    ::planish::check_cases(cases, suite##_##name##_property); \
  }                                                           \
  void suite##_##name##_property()
