// Records of a kernel's scalars: what it is handed a packet of, what lies in memory, and what a shader reads are one
// list.
//
// A record names its members once, in the order in which they are stored; they are T, or arrays of T of any dimension.
// A field is one T of them.
//
//   template <class T>
//   struct Spark {
//     T position[3], heat;
//     template <class Visit>
//     ZONAL_INLINE constexpr void members(const Visit& visit) { visit(position), visit(heat); }
//   };
#pragma once

#include <cstddef>
#include <type_traits>

#include "scalar.hpp"
#include "unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
template <class Member, class Visit>
ZONAL_INLINE constexpr void for_each_number(Member& member, const Visit& visit) {
  if constexpr (std::is_array_v<Member>) {
    unroll<0, int(std::extent_v<Member>)>([&](auto i) ZONAL_INLINE { for_each_number(member[i], visit); });
  } else {
    visit(member);
  }
}
}  // namespace detail

/// visit(T& field) for each field of the record, in order.
template <class Record, class Visit>
ZONAL_INLINE constexpr void for_each_field(Record& record, const Visit& visit) {
  record.members([&](auto& member) ZONAL_INLINE { detail::for_each_number(member, visit); });
}

/// How many fields a record of floats has, and so one of any T.
template <class Record>
inline constexpr int field_count = [] {
  Record record{};
  int count = 0;
  for_each_field(record, [&count](float&) { ++count; });
  return count;
}();

}  // namespace ZONAL_TARGET
}  // namespace zonal
