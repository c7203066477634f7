#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "../catch.hpp"
#include "driver.hpp"

Driver* driver_or_skip() {
  static std::string reason;
  static const std::unique_ptr<Driver> driver = Driver::open(reason);
  if (driver != nullptr) return driver.get();
  const char* ci = std::getenv("CI");
  if (ci != nullptr && std::string_view(ci) == "true") FAIL("no driver: " << reason);
  std::printf("skipped: no driver: %s\n", reason.c_str());
  return nullptr;
}
