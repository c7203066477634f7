// libFuzzer on every reader of files and every command line: whatever is given, it is read or refused, by the errors
// stated, without a report of the sanitizers. The first byte chooses the target.
//
//   ZONAL_SEEDS=<folder> fuzz ...    writes small valid inputs there first, and <folder>.words for -dict
//   ZONAL_TARGET=<name> fuzz ...     that target alone, of whole inputs; with ZONAL_SEEDS too
//   ZONAL_TARGETS= fuzz              the names
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <unistd.h>

#include "targets.hpp"

namespace fuzz {

// In memory where there is such a folder: twenty times as many inputs as with files on a disk.
std::filesystem::path scratch(const std::string& extension) {
  static const std::filesystem::path folder =
      ::access("/dev/shm", W_OK) == 0 ? "/dev/shm" : std::filesystem::temp_directory_path();
  return folder / ("zonal_fuzz_" + std::to_string(::getpid()) + extension);
}

void write_scratch(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

void require(bool is_so, const char* what) {
  if (is_so) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}

namespace {

const std::vector<Target>& targets() {
  static const std::vector<Target> all = [] {
    std::vector<Target> list = readers();
    for (Target& target : command_lines()) list.push_back(std::move(target));
    return list;
  }();
  return all;
}

const Target* the_only_one() {
  static const Target* const only = []() -> const Target* {
    const char* const name = std::getenv("ZONAL_TARGET");
    if (name == nullptr) return nullptr;
    for (const Target& target : targets()) {
      if (target.name == name) return &target;
    }
    std::fprintf(stderr, "no target %s\n", name);
    std::exit(2);
  }();
  return only;
}

/// Of command lines, their words are a dictionary.
void write_seeds(const std::filesystem::path& folder) {
  std::set<std::string> words;
  for (std::size_t i = 0; i < targets().size(); ++i) {
    const Target& target = targets()[i];
    if (the_only_one() != nullptr && the_only_one() != &target) continue;
    for (std::size_t k = 0; k < target.seeds.size(); ++k) {
      const std::string& seed = target.seeds[k];
      write_scratch(folder / (target.name + "-" + std::to_string(k)),
                    (the_only_one() ? "" : std::string(1, char(i))) + seed);
      if (seed.rfind("--", 0) != 0) continue;
      for (std::size_t at = 0, end = 0; at < seed.size(); at = end + 1) {
        end = std::min(seed.find('\n', at), seed.size());
        words.insert(seed.substr(at, end - at));
      }
    }
  }
  std::ofstream dictionary(folder.string() + ".words");
  dictionary << "# of command lines\n";  // libFuzzer refuses an empty one
  for (const std::string& word : words) {
    if (!word.empty()) dictionary << '"' << word << "\"\n";
  }
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (std::getenv("ZONAL_TARGETS") != nullptr) {
    for (const auto& target : fuzz::targets()) std::printf("%s\n", target.name.c_str());
    std::exit(0);
  }
  if (const char* const folder = std::getenv("ZONAL_SEEDS")) fuzz::write_seeds(folder);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const char* const bytes = reinterpret_cast<const char*>(data);
  if (const fuzz::Target* const only = fuzz::the_only_one()) {
    only->feed({bytes, size});
  } else if (size > 0) {
    fuzz::targets()[data[0] % fuzz::targets().size()].feed({bytes + 1, size - 1});
  }
  return 0;
}
