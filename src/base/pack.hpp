/// Numbers as wide as the instruction set this unit is compiled for: one strip per lane.
///
/// Included by src/*/simd only, which is compiled once for each instruction set. Everything is in an unnamed
/// namespace, and nothing of the standard library's templates is used: the code of these units is theirs
/// alone. Otherwise the linker might pick a function compiled for the newest processors for code that runs
/// on all (tests/realtime/kernel_symbols.sh).
///
/// The bits of a lane are those of the same operations on a double: no operation here looks across lanes,
/// none is approximate, and nothing is contracted (-ffp-contract=off).
#pragma once

#include <cstdint>

#include "base/in_loop.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace wrc::simd {
namespace {

#if defined(__AVX512F__)

using Native = __m512d;
using NativeMask = __mmask8;
inline Native broadcast(double a) { return _mm512_set1_pd(a); }
inline Native load_lanes(const double* from) { return _mm512_loadu_pd(from); }
inline void store_lanes(double* to, Native a) { _mm512_storeu_pd(to, a); }
inline NativeMask first_lanes(std::int32_t count) {
  return static_cast<NativeMask>(count < 8 ? (1 << count) - 1 : 0xff);
}
inline Native load_first(std::int32_t count, const double* from, Native rest) {
  return _mm512_mask_loadu_pd(rest, first_lanes(count), from);
}
inline void store_first(std::int32_t count, double* to, Native a) {
  _mm512_mask_storeu_pd(to, first_lanes(count), a);
}
inline void pick_lanes(const double* from, const std::int64_t* i, Native& at, Native& behind) {
  const auto four = [&](std::int32_t k) {  // elements k, k + 2, k + 4, k + 6, each with the one behind it
    const Native first = _mm512_castpd128_pd512(_mm_loadu_pd(from + static_cast<std::uint32_t>(i[k])));
    const Native second =
        _mm512_insertf64x2(first, _mm_loadu_pd(from + static_cast<std::uint32_t>(i[k + 2])), 1);
    const Native third =
        _mm512_insertf64x2(second, _mm_loadu_pd(from + static_cast<std::uint32_t>(i[k + 4])), 2);
    return _mm512_insertf64x2(third, _mm_loadu_pd(from + static_cast<std::uint32_t>(i[k + 6])), 3);
  };
  const Native even = four(0), odd = four(1);
  at = _mm512_maskz_unpacklo_pd(0xff, even, odd);
  behind = _mm512_maskz_unpackhi_pd(0xff, even, odd);
}
// The masked forms with all lanes: the same instructions, of which gcc 12 does not warn (its bug 105593).
inline Native root_of(Native a) { return _mm512_maskz_sqrt_pd(0xff, a); }
inline Native floor_of(Native a) {
  return _mm512_maskz_roundscale_pd(0xff, a, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
inline Native larger_of(Native a, Native b) { return _mm512_maskz_max_pd(0xff, a, b); }
inline Native smaller_of(Native a, Native b) { return _mm512_maskz_min_pd(0xff, a, b); }
inline NativeMask less(Native a, Native b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
inline NativeMask less_equal(Native a, Native b) { return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ); }
inline Native choose(NativeMask m, Native a, Native b) { return _mm512_mask_blend_pd(m, b, a); }
inline NativeMask both(NativeMask a, NativeMask b) { return static_cast<NativeMask>(a & b); }
inline NativeMask either(NativeMask a, NativeMask b) { return static_cast<NativeMask>(a | b); }
inline NativeMask negated(NativeMask a) { return static_cast<NativeMask>(~a); }
inline bool any_lane(NativeMask m) { return m != 0; }

#elif defined(__AVX2__)

using Native = __m256d;
using NativeMask = __m256d;
inline Native broadcast(double a) { return _mm256_set1_pd(a); }
inline Native load_lanes(const double* from) { return _mm256_loadu_pd(from); }
inline void store_lanes(double* to, Native a) { _mm256_storeu_pd(to, a); }
inline __m256i first_lanes(std::int32_t count) {
  return _mm256_cmpgt_epi64(_mm256_set1_epi64x(count), _mm256_set_epi64x(3, 2, 1, 0));
}
inline Native load_first(std::int32_t count, const double* from, Native rest) {
  const __m256i wanted = first_lanes(count);
  return _mm256_blendv_pd(rest, _mm256_maskload_pd(from, wanted), _mm256_castsi256_pd(wanted));
}
inline void store_first(std::int32_t count, double* to, Native a) {
  _mm256_maskstore_pd(to, first_lanes(count), a);
}
inline void pick_lanes(const double* from, const std::int64_t* i, Native& at, Native& behind) {
  const auto two = [&](std::int32_t k) {  // elements k and k + 2, each with the one behind it
    const Native first = _mm256_castpd128_pd256(_mm_loadu_pd(from + static_cast<std::uint32_t>(i[k])));
    return _mm256_insertf128_pd(first, _mm_loadu_pd(from + static_cast<std::uint32_t>(i[k + 2])), 1);
  };
  const Native even = two(0), odd = two(1);
  at = _mm256_unpacklo_pd(even, odd);
  behind = _mm256_unpackhi_pd(even, odd);
}
inline Native root_of(Native a) { return _mm256_sqrt_pd(a); }
inline Native floor_of(Native a) { return _mm256_floor_pd(a); }
inline Native larger_of(Native a, Native b) { return _mm256_max_pd(a, b); }
inline Native smaller_of(Native a, Native b) { return _mm256_min_pd(a, b); }
inline NativeMask less(Native a, Native b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
inline NativeMask less_equal(Native a, Native b) { return _mm256_cmp_pd(a, b, _CMP_LE_OQ); }
inline Native choose(NativeMask m, Native a, Native b) { return _mm256_blendv_pd(b, a, m); }
inline NativeMask both(NativeMask a, NativeMask b) { return _mm256_and_pd(a, b); }
inline NativeMask either(NativeMask a, NativeMask b) { return _mm256_or_pd(a, b); }
inline NativeMask negated(NativeMask a) { return _mm256_xor_pd(a, _mm256_cmp_pd(a, a, _CMP_TRUE_UQ)); }
inline bool any_lane(NativeMask m) { return _mm256_movemask_pd(m) != 0; }

#elif defined(__SSE2__)

using Native = __m128d;
using NativeMask = __m128d;
inline Native broadcast(double a) { return _mm_set1_pd(a); }
inline Native load_lanes(const double* from) { return _mm_loadu_pd(from); }
inline void store_lanes(double* to, Native a) { _mm_storeu_pd(to, a); }
inline Native load_first(std::int32_t count, const double* from, Native rest) {
  return count >= 2 ? _mm_loadu_pd(from) : count == 1 ? _mm_loadl_pd(rest, from) : rest;
}
inline void store_first(std::int32_t count, double* to, Native a) {
  if (count >= 2) return _mm_storeu_pd(to, a);
  if (count == 1) _mm_storel_pd(to, a);
}
inline void pick_lanes(const double* from, const std::int64_t* i, Native& at, Native& behind) {
  const Native even = load_lanes(from + static_cast<std::uint32_t>(i[0])),
               odd = load_lanes(from + static_cast<std::uint32_t>(i[1]));
  at = _mm_unpacklo_pd(even, odd);
  behind = _mm_unpackhi_pd(even, odd);
}
inline Native root_of(Native a) { return _mm_sqrt_pd(a); }
inline Native larger_of(Native a, Native b) { return _mm_max_pd(a, b); }
inline Native smaller_of(Native a, Native b) { return _mm_min_pd(a, b); }
inline NativeMask less(Native a, Native b) { return _mm_cmplt_pd(a, b); }
inline NativeMask less_equal(Native a, Native b) { return _mm_cmple_pd(a, b); }
inline Native choose(NativeMask m, Native a, Native b) {
  return _mm_or_pd(_mm_and_pd(m, a), _mm_andnot_pd(m, b));
}
inline NativeMask both(NativeMask a, NativeMask b) { return _mm_and_pd(a, b); }
inline NativeMask either(NativeMask a, NativeMask b) { return _mm_or_pd(a, b); }
inline NativeMask negated(NativeMask a) { return _mm_andnot_pd(a, _mm_castsi128_pd(_mm_set1_epi32(-1))); }
inline bool any_lane(NativeMask m) { return _mm_movemask_pd(m) != 0; }

#elif defined(__aarch64__)

using Native = float64x2_t;
using NativeMask = uint64x2_t;
inline Native broadcast(double a) { return vdupq_n_f64(a); }
inline Native load_lanes(const double* from) { return vld1q_f64(from); }
inline void store_lanes(double* to, Native a) { vst1q_f64(to, a); }
inline Native load_first(std::int32_t count, const double* from, Native rest) {
  return count >= 2 ? vld1q_f64(from) : count == 1 ? vld1q_lane_f64(from, rest, 0) : rest;
}
inline void store_first(std::int32_t count, double* to, Native a) {
  if (count >= 2) return vst1q_f64(to, a);
  if (count == 1) vst1q_lane_f64(to, a, 0);
}
inline void pick_lanes(const double* from, const std::int64_t* i, Native& at, Native& behind) {
  const Native even = load_lanes(from + static_cast<std::uint32_t>(i[0])),
               odd = load_lanes(from + static_cast<std::uint32_t>(i[1]));
  at = vtrn1q_f64(even, odd);
  behind = vtrn2q_f64(even, odd);
}
inline Native root_of(Native a) { return vsqrtq_f64(a); }
inline NativeMask less(Native a, Native b) { return vcltq_f64(a, b); }
inline NativeMask less_equal(Native a, Native b) { return vcleq_f64(a, b); }
inline Native choose(NativeMask m, Native a, Native b) { return vbslq_f64(m, a, b); }
inline Native larger_of(Native a, Native b) { return choose(less(b, a), a, b); }  // as x86: b of two zeros
inline Native smaller_of(Native a, Native b) { return choose(less(a, b), a, b); }
inline NativeMask both(NativeMask a, NativeMask b) { return vandq_u64(a, b); }
inline NativeMask either(NativeMask a, NativeMask b) { return vorrq_u64(a, b); }
inline NativeMask negated(NativeMask a) { return veorq_u64(a, vdupq_n_u64(~0ull)); }
inline bool any_lane(NativeMask m) { return (vgetq_lane_u64(m, 0) | vgetq_lane_u64(m, 1)) != 0; }

#else  // any other processor: one strip at a time

using Native = double __attribute__((vector_size(8)));
using NativeMask = bool;
inline Native broadcast(double a) { return Native{a}; }
inline Native load_lanes(const double* from) { return Native{*from}; }
inline void store_lanes(double* to, Native a) { *to = a[0]; }
inline Native load_first(std::int32_t count, const double* from, Native rest) {
  return count >= 1 ? Native{*from} : rest;
}
inline void store_first(std::int32_t count, double* to, Native a) {
  if (count >= 1) *to = a[0];
}
inline void pick_lanes(const double* from, const std::int64_t* i, Native& at, Native& behind) {
  at = Native{from[static_cast<std::uint32_t>(i[0])]};
  behind = Native{from[static_cast<std::uint32_t>(i[0]) + 1]};
}
inline Native root_of(Native a) { return Native{__builtin_sqrt(a[0])}; }
inline NativeMask less(Native a, Native b) { return a[0] < b[0]; }
inline NativeMask less_equal(Native a, Native b) { return a[0] <= b[0]; }
inline Native choose(NativeMask m, Native a, Native b) { return m ? a : b; }
inline Native larger_of(Native a, Native b) { return choose(less(b, a), a, b); }
inline Native smaller_of(Native a, Native b) { return choose(less(a, b), a, b); }
inline NativeMask both(NativeMask a, NativeMask b) { return a && b; }
inline NativeMask either(NativeMask a, NativeMask b) { return a || b; }
inline NativeMask negated(NativeMask a) { return !a; }
inline bool any_lane(NativeMask m) { return m; }

#endif

/// Columns of a matrix, or derivatives of a number, in one vector: four at most. Wider vectors would have
/// many elements without use.
#if defined(__AVX512F__)
using Columns = __m256d;
inline Columns in_all_columns(double a) { return _mm256_set1_pd(a); }
inline Columns load_columns(const double* from) { return _mm256_loadu_pd(from); }
inline void store_columns(double* to, Columns a) { _mm256_storeu_pd(to, a); }
#else
using Columns = Native;
inline Columns in_all_columns(double a) { return broadcast(a); }
inline Columns load_columns(const double* from) { return load_lanes(from); }
inline void store_columns(double* to, Columns a) { store_lanes(to, a); }
#endif
constexpr std::int32_t abreast = sizeof(Columns) / sizeof(double);

constexpr std::int32_t native_lanes = sizeof(Native) / sizeof(double);
constexpr std::int32_t lanes = 2 * native_lanes;

/// One number for each lane: two vectors of the processor, so that one computes while the other waits for its
/// root or divide.
struct Pack {
  Native a, b;

  Pack() = default;
  // Vector by vector: gcc 12 copies structs in pieces of 16 bytes, which a load of 32 must wait for.
  Pack(const Pack& x) : a(x.a), b(x.b) {}
  Pack& operator=(const Pack& x) {
    a = x.a;
    b = x.b;
    return *this;
  }
  Pack(Native first, Native second) : a(first), b(second) {}
  Pack(double everywhere) : a(broadcast(everywhere)), b(a) {}  // NOLINT: constants mix freely with packs

  friend Pack operator+(Pack x, Pack y) { return {x.a + y.a, x.b + y.b}; }
  friend Pack operator-(Pack x, Pack y) { return {x.a - y.a, x.b - y.b}; }
  friend Pack operator*(Pack x, Pack y) { return {x.a * y.a, x.b * y.b}; }
  friend Pack operator/(Pack x, Pack y) { return {x.a / y.a, x.b / y.b}; }
  friend Pack operator-(Pack x) { return {-x.a, -x.b}; }
  Pack& operator+=(Pack y) { return *this = *this + y; }
};

/// Yes or no for each lane.
struct Mask {
  NativeMask a, b;

  Mask() = default;
  Mask(const Mask& x) : a(x.a), b(x.b) {}
  Mask& operator=(const Mask& x) {
    a = x.a;
    b = x.b;
    return *this;
  }
  Mask(NativeMask first, NativeMask second) : a(first), b(second) {}

  friend Mask operator&(Mask x, Mask y) { return {both(x.a, y.a), both(x.b, y.b)}; }
  friend Mask operator|(Mask x, Mask y) { return {either(x.a, y.a), either(x.b, y.b)}; }
  friend Mask operator!(Mask x) { return {negated(x.a), negated(x.b)}; }
};
inline Mask operator<(Pack x, Pack y) { return {less(x.a, y.a), less(x.b, y.b)}; }
inline Mask operator<=(Pack x, Pack y) { return {less_equal(x.a, y.a), less_equal(x.b, y.b)}; }
inline Mask operator>(Pack x, Pack y) { return y < x; }
inline Mask operator>=(Pack x, Pack y) { return y <= x; }
inline bool any(Mask x) { return any_lane(either(x.a, x.b)); }

/// The number that decides between branches: the value of one with derivatives, here every lane.
inline Pack value_of(Pack x) { return x; }
inline Pack select(Mask m, Pack yes, Pack no) { return {choose(m.a, yes.a, no.a), choose(m.b, yes.b, no.b)}; }
inline Pack root(Pack x) { return {root_of(x.a), root_of(x.b)}; }
inline Pack larger(Pack x, Pack y) { return {larger_of(x.a, y.a), larger_of(x.b, y.b)}; }
inline Pack smaller(Pack x, Pack y) { return {smaller_of(x.a, y.a), smaller_of(x.b, y.b)}; }
inline Pack load_pack(const double* from) { return {load_lanes(from), load_lanes(from + native_lanes)}; }
inline void store_pack(double* to, Pack x) {
  store_lanes(to, x.a);
  store_lanes(to + native_lanes, x.b);
}

/// The nearest integer of 0 <= a < 2^51, ties to even.
inline Native nearest_integer(Native a) {
  const Native unit_spacing = broadcast(4503599627370496.0);  // 2^52: the next double is one more
  return (a + unit_spacing) - unit_spacing;
}
inline Pack nearest_integer(Pack a) { return {nearest_integer(a.a), nearest_integer(a.b)}; }

/// The largest integer that is no larger than 0 <= a < 2^51.
inline Native whole_part(Native a) {
#if defined(__AVX2__)
  return floor_of(a);
#else
  const Native nearest = nearest_integer(a);
  return choose(less(a, nearest), nearest - broadcast(1.0), nearest);
#endif
}
inline Pack whole_part(Pack a) { return {whole_part(a.a), whole_part(a.b)}; }

/// The bits of a pack, for masks and exponents read off them.
using NativeBits = std::uint64_t __attribute__((vector_size(sizeof(Native))));
struct Bits {
  NativeBits a, b;

  friend Bits operator>>(Bits x, int by) { return {x.a >> by, x.b >> by}; }
  friend Bits operator<<(Bits x, int by) { return {x.a << by, x.b << by}; }
  friend Bits operator&(Bits x, std::uint64_t y) { return {x.a & y, x.b & y}; }
  friend Bits operator|(Bits x, std::uint64_t y) { return {x.a | y, x.b | y}; }
  friend Bits operator|(Bits x, Bits y) { return {x.a | y.a, x.b | y.b}; }
  friend Bits operator+(Bits x, std::uint64_t y) { return {x.a + y, x.b + y}; }
  friend Bits operator+(Bits x, Bits y) { return {x.a + y.a, x.b + y.b}; }
};
inline Bits bits_of(Pack x) { return {reinterpret_cast<NativeBits>(x.a), reinterpret_cast<NativeBits>(x.b)}; }
inline Pack pack_of(Bits x) { return {reinterpret_cast<Native>(x.a), reinterpret_cast<Native>(x.b)}; }

/// Without its sign.
inline Pack magnitude(Pack x) { return pack_of(bits_of(x) & ~(std::uint64_t{1} << 63)); }

/// A number >= 0 with the sign of another.
inline Pack with_sign(Pack size, Pack of) {
  return pack_of(bits_of(size) | (bits_of(of) & (std::uint64_t{1} << 63)));
}

/// Whole numbers 0 <= x < 2^32, one for each lane, as indices.
struct Indices {
  std::int64_t at[lanes];  ///< in the lower halves
};
/// x + index_origin counts ones in its mantissa.
constexpr double index_origin = 4503599627370496.0;  // 2^52
inline void keep_indices(Bits whole, Indices& i) {
  __builtin_memcpy(i.at, &whole.a, sizeof whole.a);
  __builtin_memcpy(i.at + native_lanes, &whole.b, sizeof whole.b);
}
/// Makes the next reads come from memory: gcc pulls each lane out of the vector, at three times the cost.
inline void by_way_of_memory(Indices& i) { __asm__("" : "+m"(i)); }
inline Indices indices(Bits whole) {
  Indices i;
  keep_indices(whole, i);
  by_way_of_memory(i);
  return i;
}
inline Indices indices(Pack whole) { return indices(bits_of(whole + index_origin)); }

/// The same of one vector.
struct NativeIndices {
  std::int64_t at[native_lanes];
};
inline NativeIndices indices(Native whole) {
  NativeIndices i;
  const Native bits = whole + broadcast(index_origin);
  __builtin_memcpy(i.at, &bits, sizeof bits);
  __asm__("" : "+m"(i));
  return i;
}

/// Elements i.at[0], i.at[1], .. of an array, and those behind them.
struct Neighbours {
  Pack at, behind;
};
inline Neighbours pick(const double* from, const Indices& i) {
  Neighbours n;
  pick_lanes(from, i.at, n.at.a, n.behind.a);
  pick_lanes(from, i.at + native_lanes, n.at.b, n.behind.b);
  return n;
}

/// Lanes of a group of `count` that lie in the second vector of a pack.
inline std::int32_t in_second(std::int32_t count) { return count > native_lanes ? count - native_lanes : 0; }

/// Elements first .. first + count - 1 of an array, 0 <= count <= lanes; lanes behind them hold `rest`.
/// Nothing is read behind the array.
inline Pack load(const double* from, std::int32_t first, std::int32_t count, double rest) {
  if (count == lanes) return load_pack(from + first);
  const Native behind = broadcast(rest);
  return {load_first(count, from + first, behind),
          load_first(in_second(count), from + first + native_lanes, behind)};
}

/// The first `count` lanes to an array.
inline void store(Pack a, double* to, std::int32_t count) {
  if (count == lanes) return store_pack(to, a);
  store_first(count, to, a.a);
  store_first(in_second(count), to + native_lanes, a.b);
}

}  // namespace
}  // namespace wrc::simd
