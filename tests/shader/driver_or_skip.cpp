#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "../catch.hpp"
#include "driver.hpp"

namespace {

struct Opened {
  explicit Opened(Driver::Language language) : driver(Driver::open(reason, language)) {}
  std::string reason;
  std::unique_ptr<Driver> driver;
};

const Opened& opened(Driver::Language language) {
  if (language == Driver::Language::glsl_es) {
    static const Opened es(language);
    return es;
  }
  static const Opened desktop(language);
  return desktop;
}

}  // namespace

Driver* driver_or_skip(Driver::Language language) {
  const Opened& the = opened(language);
  if (the.driver != nullptr) {
    the.driver->use();
    return the.driver.get();
  }
  const char* ci = std::getenv("CI");
  if (ci != nullptr && std::string_view(ci) == "true") FAIL("no driver: " << the.reason);
  std::printf("skipped: no driver: %s\n", the.reason.c_str());
  return nullptr;
}
