#include "output_file.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "input_error.hpp"

namespace example {
namespace {

namespace fs = std::filesystem;

/// write(), whose failures are the user's input.
template <class Write>
void report_as_input(const Write& write) {
  try {
    write();
  } catch (const zonal::FileError& error) {
    throw InputError(one_line(error.what()));
  }
}

/// Two names of one file. One that is not there yet has the place where it would be made.
bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const auto place = [&](const fs::path& path) {
    return fs::weakly_canonical(fs::absolute(zonal::behind_links(path)), error);
  };
  return place(a) == place(b);
}

}  // namespace

void check_outputs(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  report_as_input([&] {
    for (const fs::path& path : outputs) zonal::OutputFile(path).close();  // and given up
    for (const fs::path& path : outputs) {
      const auto same = [&](const fs::path& other) { return same_file(other, path); };
      if (std::count_if(outputs.begin(), outputs.end(), same) > 1) {
        throw InputError(path.string() + ": two outputs cannot be one file");
      }
      if (std::any_of(inputs.begin(), inputs.end(), [&](const fs::path& p) { return !p.empty() && same(p); })) {
        throw InputError(path.string() + ": is read, and cannot be written as well");
      }
    }
  });
}

void OutputBatch::add(const fs::path& path, const std::string& bytes) {
  report_as_input([&] {
    zonal::OutputFile& file = files_.emplace_back(path);
    file.write(bytes.data(), bytes.size());
    file.close();
  });
}

void OutputBatch::move_into_place() {
  report_as_input([&] {
    for (zonal::OutputFile& file : files_) file.move_into_place();
  });
  files_.clear();
}

OutputDirectory::OutputDirectory(fs::path path) : path_(std::move(path)) {
  std::error_code reason;
  made_ = fs::create_directory(path_, reason);
  if (reason) throw InputError(path_.string() + ": cannot be made a directory (" + reason.message() + ")");
}

OutputDirectory::~OutputDirectory() {
  std::error_code ignored;
  // Removes an empty directory only.
  if (made_) fs::remove(path_, ignored);
}

}  // namespace example
