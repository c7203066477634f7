// What is fuzzed: every reader of files, and every program's command line.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace fuzz {

struct Target {
  std::string name;
  std::function<void(const std::string& bytes)> feed;
  std::vector<std::string> seeds;  // what is read without complaint
};

std::vector<Target> readers();
std::vector<Target> command_lines();

/// A file of this process with that extension, and what is in it. Throws what the reader throws.
std::filesystem::path scratch(const std::string& extension = {});
void write_scratch(const std::filesystem::path& path, const std::string& bytes);

/// Ends the program where it is not so.
void require(bool is_so, const char* what);

}  // namespace fuzz
