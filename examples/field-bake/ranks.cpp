#include "ranks.hpp"

#include <algorithm>
#include <cstdlib>

#ifdef ZONAL_HAS_MPI
#include <mpi.h>
#endif

namespace example::field_bake {

#ifdef ZONAL_HAS_MPI

namespace {

/// Did mpirun start this? A program that was not needs no MPI, and must not fail where it cannot start.
bool is_started_by_mpi() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK", "PMI_RANK"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

/// In pieces that an int can count.
template <class Visit>
void for_pieces(std::size_t count, const Visit& visit) {
  constexpr std::size_t most = std::size_t{1} << 26;
  for (std::size_t first = 0; first < count; first += most)
    visit(first, static_cast<int>(std::min(most, count - first)));
}

template <class Number>
void reduce(bool is_first, Number* numbers, std::size_t count, MPI_Datatype type) {
  for_pieces(count, [&](std::size_t first, int piece) {
    Number* at = numbers + first;
    MPI_Reduce(is_first ? MPI_IN_PLACE : at, is_first ? at : nullptr, piece, type, MPI_SUM, 0, MPI_COMM_WORLD);
  });
}

}  // namespace

Ranks::Ranks() {
  if (!is_started_by_mpi()) return;
  MPI_Init(nullptr, nullptr);
  started_ = true;
  int index = 0, count = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &index);
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  index_ = static_cast<std::size_t>(index);
  count_ = static_cast<std::size_t>(count);
}

Ranks::~Ranks() {
  if (started_) MPI_Finalize();
}

void Ranks::wait() const {
  if (count_ > 1) MPI_Barrier(MPI_COMM_WORLD);
}

void Ranks::add_up(float* numbers, std::size_t count) const {
  if (count_ > 1) reduce(is_first(), numbers, count, MPI_FLOAT);
}
void Ranks::add_up(double* numbers, std::size_t count) const {
  if (count_ > 1) reduce(is_first(), numbers, count, MPI_DOUBLE);
}

void Ranks::end_all(int exit_status) const {
  if (started_) MPI_Abort(MPI_COMM_WORLD, exit_status);
  std::exit(exit_status);
}

#else

Ranks::Ranks() = default;
Ranks::~Ranks() = default;
void Ranks::wait() const {}
void Ranks::add_up(float*, std::size_t) const {}
void Ranks::add_up(double*, std::size_t) const {}
void Ranks::end_all(int exit_status) const { std::exit(exit_status); }

#endif

}  // namespace example::field_bake
