// Every kernel of the registry in every scalar, against itself in long double, which the rooms' tests set against
// definitions. That records are to the bit what C++ computes: ../shader/record_test.cpp, and here for those that are no
// shader functions. Compiled without fused multiplication and addition, for just that.
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "../../bench/rivals.hpp"
#include "subjects.hpp"

namespace {

template <class Check>
void for_every_kernel(Check check) {
  for (const KernelRuns& kernel : all_kernels()) {
    INFO(kernel.name);
    check(subject_of(kernel));
  }
}

}  // namespace

TEST_CASE("Every kernel of the registry in float and double") {
  for_every_kernel([](const Subject& subject) {
    check_builtin<float>(subject);
    check_builtin<double>(subject);
  });
}

TEST_CASE("Every kernel of the registry in packets") {
  for_every_kernel([](const Subject& subject) {
    check_packet<float, 8>(subject);
    check_packet<double, 4>(subject);
  });
}

TEST_CASE("Every kernel of the registry in dual numbers") { for_every_kernel(check_dual); }

TEST_CASE("Every kernel of the registry in shadow pairs") { for_every_kernel(check_shadow); }

TEST_CASE("Every kernel that is no shader function, recorded, to the bit") {
  for (const KernelRuns& kernel : all_kernels()) {
    if (kernel.record == nullptr) continue;
    INFO(kernel.name);
    check_record(subject_of(kernel));
  }
}

TEST_CASE("No kernel has two entries, neither in the registry nor among its rivals") {
  std::set<std::string> names;
  const auto add = [&](const char* name) {
    INFO(name);
    CHECK(names.insert(name).second);
  };
  for (const KernelRuns& kernel : all_kernels()) add(kernel.name);
  for (const auto& entry : zonal_glsl::shader_functions()) {
    if (entry.name.find("_colour") == std::string_view::npos) {
      CHECK(names.count(std::string(entry.name)) == 1);  // it runs above
    } else {
      add(entry.name.data());
    }
  }
  zonal::kernels::for_each_kernel(zonal_bench::Rivals{}, [&](auto rival) { add(rival.name); });
}

// What makes an entry, a list of them, or a kernel of another form with a name.
TEST_CASE("Outside the registry only the rivals, and a lobe of one's own, are kernels") {
  const std::string marks[] = {"KernelList<", "class Io>", "const char* name = \""};
  std::set<std::string> found;
  for (const char* folder : {"bench", "tests", "tools", "examples"}) {
    for (const auto& file : std::filesystem::recursive_directory_iterator(std::string(ZONAL_SOURCE) + "/" + folder)) {
      if (file.path().extension() != ".hpp" && file.path().extension() != ".cpp") continue;
      std::ostringstream text;
      text << std::ifstream(file.path()).rdbuf();
      for (const std::string& mark : marks) {
        if (text.str().find(mark) != std::string::npos) found.insert(file.path().filename().string());
      }
    }
  }
  // chosen_kernels.hpp is a list of the registry's own, for tests/fast_math.
  CHECK(found == std::set<std::string>{"chosen_kernels.hpp", "every_scalar_test.cpp", "own_kernel.cpp",
                                       "own_lobe_test.cpp", "rivals.hpp"});
}
