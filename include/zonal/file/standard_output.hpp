// For programs: what they print arrives, or they fail.
#pragma once

#include <cerrno>
#include <cstdio>
#include <system_error>

#if __has_include(<unistd.h>)
#include <fcntl.h>
#include <unistd.h>
#endif

#include "file_error.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// A closed one would be the next file to be opened, and that file receive what is printed.
inline void require_standard_output() {
#if __has_include(<unistd.h>)
  if (fcntl(STDOUT_FILENO, F_GETFD) == -1) throw FileError("standard output", "is closed");
#endif
}

inline void flush_standard_output() {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  const std::error_code reason(errno != 0 ? errno : EIO, std::generic_category());
  throw FileError("standard output", "cannot be written (" + reason.message() + ")");
}
}  // namespace detail

/// What body() returns, an exit status. Throws FileError, before it, where standard output is closed, and after it
/// where not all that was printed has arrived, as on a full disk.
template <class Body>
int with_standard_output(const Body& body) {
  detail::require_standard_output();
  const int status = body();
  detail::flush_standard_output();
  return status;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
