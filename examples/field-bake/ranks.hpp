#pragma once

#include <cstddef>

namespace example::field_bake {

/// The processes that bake together: those that mpirun started, or this one alone, also where there is no MPI.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  std::size_t index() const { return index_; }
  std::size_t count() const { return count_; }
  bool is_first() const { return index_ == 0; }

  /// Until all are here.
  void wait() const;
  /// The sum of all ranks' numbers, to the first.
  void add_up(float* numbers, std::size_t count) const;
  void add_up(double* numbers, std::size_t count) const;

  /// Ends all of them, where one cannot go on.
  [[noreturn]] void end_all(int exit_status) const;

 private:
  std::size_t index_ = 0, count_ = 1;
  bool started_ = false;  // MPI, by us
};

}  // namespace example::field_bake
