/** @file wrc.hpp
 * The C interface in C++17 and newer, header only: the C headers have the documentation of what everything is
 * and does.
 *
 * Structs and enumerations are those of C. What is added:
 *  - handles that own: wrc::model, wrc::contact, wrc::transient, move only. A contact_ref is the same
 *    contact, not owned: for memory of your own (contact_ref::init), and to pass one on. A model must outlive
 *    its contacts, as in C.
 *  - wrc::defaults<Struct>(): any struct with its size set and its defaults, results too.
 *  - statuses and sentences as values or as exceptions. Every function `name` of C (without wrc_contact_ and
 *    so on) comes as
 *
 *        status  contact.name(inputs..., output)    noexcept; the status as a value, nothing copied: for real time
 *
 *    and where it has one output, as
 *
 *        answer  contact.name(inputs...)            throws wrc::error with the library's sentence where it fails
 *        expected<answer, status>  contact.try_name(inputs...)    noexcept, std::expected where there is one
 *
 *    An answer is the C struct with the status it came with, the gravest flag: answer.flag. All flags are bits of
 *    the struct's `flags`: wrc::met(answer.flags, WRC_FLAG_CLIMBING). Without exceptions (-fno-exceptions) the
 *    functions that throw are not there, and wrc::model and wrc::contact are made by make().
 *  - spans for arrays (std::span where there is one), wrc::field for what wrc_contact_field() copies.
 *
 * @code
 *   wrc_config config = wrc::defaults<wrc_config>();
 *   config.wheel.kind = WRC_PROFILE_S1002;
 *   config.rail.kind = WRC_PROFILE_60E1;
 *   config.track.rail_inclination = 1.0 / 40.0;
 *   const wrc::model model(config);
 *   wrc::contact contact(model, WRC_SIDE_RIGHT);
 *   auto input = wrc::defaults<wrc_wheel_input>();
 *   input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
 *   input.vertical_load = 80e3;
 *   const auto wrench = contact.wrench(input);   // wrench.z: the height at which the wheelset stands
 *   for (int i = 0; i < wrench.region_count; ++i) {
 *     const auto region = contact.region(i);
 *     const wrc::field pressure = contact.field(i, WRC_FIELD_PRESSURE);
 *     use(region.area, pressure(0, 0));
 *   }
 * @endcode
 *
 * Nothing here allocates but wrc::field and the library itself, in model's and contact's constructors and
 * make(); an error carries its sentence in an array of its own. A handle that was moved from is empty: its
 * functions return WRC_ERROR_NULL. What wrc_damage.h, wrc_surface.h, wrc_offline.h and wrc_profiles.h declare
 * may change in a minor version, here too. wrc_calls.hpp, which has the functions, is made from the C headers
 * by tools/interface/describe.py.
 */
#ifndef WRC_HPP
#define WRC_HPP

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>
#if __has_include(<version>)
#include <version>
#endif
#ifdef __cpp_lib_span
#include <span>
#endif
#ifdef __cpp_lib_expected
#include <expected>
#endif

#include "wrc/wrc_offline.h"
#include "wrc/wrc_profiles.h"
#include "wrc/wrc_surface.h"

#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define WRC_EXCEPTIONS 1
#endif

namespace wrc {

/** A status of wrc_status.h: 0 done, > 0 done but flagged, < 0 failed. */
class [[nodiscard]] status {
 public:
  constexpr status() noexcept = default;
  constexpr status(std::int32_t value) noexcept : value_(value) {}

  constexpr std::int32_t value() const noexcept { return value_; }
  constexpr bool failed() const noexcept { return value_ < 0; }
  constexpr bool flagged() const noexcept { return value_ > 0; }
  /** for example "WRC_ERROR_RANGE" */
  const char* name() const noexcept { return wrc_status_name(value_); }
  /** its meaning in one line */
  const char* text() const noexcept { return wrc_status_text(value_); }

  friend constexpr bool operator==(status a, status b) noexcept { return a.value_ == b.value_; }
  friend constexpr bool operator!=(status a, status b) noexcept { return a.value_ != b.value_; }

 private:
  std::int32_t value_ = WRC_OK;
};

/** Was this flag met? `flags` of any result. */
constexpr bool met(std::uint32_t flags, std::int32_t flag) noexcept { return ((flags >> flag) & 1u) != 0; }

/** What a function gives, with the status it gave it with: WRC_OK or the gravest flag. */
template <class Struct>
struct answer : Struct {
  status flag;
};

namespace detail {
template <class Struct, class = void>
struct has_size : std::false_type {};
template <class Struct>
struct has_size<Struct, std::void_t<decltype(std::declval<Struct&>().struct_size)>> : std::true_type {};
}  // namespace detail

/** Any struct of the interface with its size set, where it has one, and its defaults: what the library has,
 * else zero. */
template <class Struct>
Struct defaults() noexcept {
  Struct made{};
  if constexpr (detail::has_size<Struct>::value) made.struct_size = static_cast<std::uint32_t>(sizeof made);
  return made;
}

#ifdef __cpp_lib_span
template <class T>
using span = std::span<T>;
#else
/** The part of std::span that is needed here. */
template <class T>
class span {
 public:
  constexpr span() noexcept = default;
  constexpr span(T* data, std::size_t size) noexcept : data_(data), size_(size) {}
  template <std::size_t count>
  constexpr span(T (&array)[count]) noexcept : data_(array), size_(count) {}
  /** of std::vector, std::array and the like */
  template <class Container,
            class = std::enable_if_t<std::is_convertible_v<
                std::remove_pointer_t<decltype(std::declval<Container&>().data())> (*)[], T (*)[]>>>
  constexpr span(Container& container) noexcept : data_(container.data()), size_(container.size()) {}

  constexpr T* data() const noexcept { return data_; }
  constexpr std::size_t size() const noexcept { return size_; }
  constexpr bool empty() const noexcept { return size_ == 0; }
  constexpr T& operator[](std::size_t i) const noexcept { return data_[i]; }
  constexpr T* begin() const noexcept { return data_; }
  constexpr T* end() const noexcept { return data_ + size_; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};
#endif

#ifdef __cpp_lib_expected
template <class T>
using expected = std::expected<T, status>;
using failure = std::unexpected<status>;
#else
/** The status of what failed, to be made an expected of any type. */
class failure {
 public:
  constexpr explicit failure(status why) noexcept : why_(why) {}
  constexpr status error() const noexcept { return why_; }

 private:
  status why_;
};

/** The part of std::expected<T, status> that is needed here; value() is not: check first. */
template <class T>
class [[nodiscard]] expected {
 public:
  expected(T value) noexcept : there_(true) { new (&value_) T(std::move(value)); }
  expected(failure why) noexcept : why_(why.error()), there_(false) {}
  expected(expected&& other) noexcept : why_(other.why_), there_(other.there_) {
    if (there_) new (&value_) T(std::move(other.value_));
  }
  expected(const expected&) = delete;
  expected& operator=(const expected&) = delete;
  ~expected() {
    if (there_) value_.~T();
  }

  constexpr bool has_value() const noexcept { return there_; }
  constexpr explicit operator bool() const noexcept { return there_; }
  /** where has_value() is false */
  constexpr status error() const noexcept { return why_; }
  T& operator*() & noexcept { return value_; }
  const T& operator*() const& noexcept { return value_; }
  T&& operator*() && noexcept { return std::move(value_); }
  T* operator->() noexcept { return &value_; }
  const T* operator->() const noexcept { return &value_; }

 private:
  static_assert(std::is_nothrow_move_constructible_v<T>);
  union {
    T value_;
  };
  status why_;
  bool there_;
};
#endif

#ifdef WRC_EXCEPTIONS
/** What failed: status and sentence, in the object itself. */
class error : public std::exception {
 public:
  /** The sentence is the status's meaning unless `sentence` has more to say. */
  explicit error(status why, const char* sentence = "") noexcept : why_(why) {
    const char* from = *sentence ? sentence : why.text();
    std::size_t i = 0;
    for (; i + 1 < sizeof sentence_ && from[i]; ++i) sentence_[i] = from[i];
    sentence_[i] = 0;
  }
  const char* what() const noexcept override { return sentence_; }
  status why() const noexcept { return why_; }

 private:
  status why_;
  char sentence_[512];
};
#endif

/** How many values a field has: cells of each strip, 1 of a field over strips or rows of a gap, and strips or
 * rows. */
struct field_shape {
  std::size_t cells = 0, strips = 0;
  constexpr std::size_t size() const noexcept { return cells * strips; }
};

/** A field of a region, copied. */
class field {
 public:
  field() = default;
  field(std::vector<double> values, field_shape shape) noexcept : values_(std::move(values)), shape_(shape) {}

  std::size_t cells() const noexcept { return shape_.cells; }
  std::size_t strips() const noexcept { return shape_.strips; }
  double operator()(std::size_t cell, std::size_t strip) const noexcept {
    return values_[strip * shape_.cells + cell];
  }
  /** The cells of one strip, leading edge first. */
  span<const double> strip(std::size_t i) const noexcept {
    return span<const double>(values_.data() + i * shape_.cells, shape_.cells);
  }
  /** All of them, strip by strip; of a field over strips one for each. */
  const std::vector<double>& values() const noexcept { return values_; }

 private:
  std::vector<double> values_;
  field_shape shape_;
};

/** A profile as the model uses it, in the model's memory: nodes y, z and how far the smoothed curve is from a
 * point that was given, m. */
struct curve {
  span<const double> y, z;
  double deviation = 0.0;
};

/** What the functions in wrc_calls.hpp are made of. */
namespace detail {

/** Bytes from one struct of a batch to the next; one for all has none. */
template <class T>
constexpr std::uint64_t stride(span<T> structs) noexcept {
  return structs.size() == 1 ? 0 : sizeof(T);
}
/** Are there as many structs as contacts, or one for all where they are read? */
template <class T>
constexpr bool fits(span<T> structs, std::size_t contacts, bool read) noexcept {
  return structs.size() == contacts || (read && structs.size() == 1);
}

template <class T, class Call>
expected<T> attempt(T start, const Call& call) noexcept {
  const status how = call(start);
  if (how.failed()) return failure(how);
  return start;
}

template <class T, class Call>
expected<answer<T>> attempt_struct(const Call& call) noexcept {
  answer<T> made{defaults<T>(), {}};
  made.flag = call(made);
  if (made.flag.failed()) return failure(made.flag);
  return made;
}

#ifdef WRC_EXCEPTIONS
[[noreturn]] inline void raise(const wrc_contact* contact, status why) {
  char sentence[512] = "";
  if (contact) wrc_contact_last_error(contact, sentence, sizeof sentence);
  throw error(why, sentence);
}
template <class T>
T value_or_throw(expected<T>&& found, const wrc_contact* contact = nullptr) {
  if (!found) raise(contact, found.error());
  return std::move(*found);
}
#endif

}  // namespace detail

}  // namespace wrc

#include "wrc/wrc_calls.hpp"

namespace wrc {

#ifdef WRC_EXCEPTIONS
/** Throws where a status is one of failure, else gives WRC_OK or the flag: wrc::check(wrc::config_use(config,
 * "FASTSIM", text)). */
inline std::int32_t check(status how) {
  if (how.failed()) detail::raise(nullptr, how);
  return how.value();
}
#endif

/** A model that is not owned: what wrc_model has to say. */
class model_ref : public detail::model_calls {
 public:
  model_ref() noexcept = default;
  explicit model_ref(const wrc_model* model) noexcept { handle_ = model; }
  const wrc_model* get() const noexcept { return handle_; }
  explicit operator bool() const noexcept { return handle_ != nullptr; }

  /** wrc_model_profile() */
  status profile(std::int32_t side, std::int32_t body, curve& shown) const noexcept {
    wrc_view y = defaults<wrc_view>(), z = y;
    const status how = wrc_model_profile(handle_, side, body, &y, &z, &shown.deviation);
    shown.y = span<const double>(y.data, static_cast<std::size_t>(y.count));
    shown.z = span<const double>(z.data, static_cast<std::size_t>(z.count));
    return how;
  }
  expected<curve> try_profile(std::int32_t side, std::int32_t body) const noexcept {
    return detail::attempt<curve>(curve(), [&](curve& shown) { return profile(side, body, shown); });
  }
#ifdef WRC_EXCEPTIONS
  curve profile(std::int32_t side, std::int32_t body) const {
    return detail::value_or_throw(try_profile(side, body));
  }
#endif

  /** wrc_model_init(): in the caller's memory. `text` gets the sentence where it fails. */
  static expected<model_ref> init(const wrc_config& config, span<std::byte> memory,
                                  span<char> text = {}) noexcept {
    wrc_model* made = nullptr;
    const status how = wrc_model_init(&config, memory.data(), memory.size(), &made, text.data(), text.size());
    if (how.failed()) return failure(how);
    return model_ref(made);
  }
};

/** A model that is owned. */
class model : public model_ref {
 public:
  model() noexcept = default;
  /** wrc_model_create(). `text` gets the sentence where it fails; `allocator` nullptr: malloc and free. */
  static expected<model> make(const wrc_config& config, span<char> text = {},
                              const wrc_allocator* allocator = nullptr) noexcept {
    model made;
    const status how = wrc_model_create(&config, allocator, &made.owned_, text.data(), text.size());
    made.handle_ = made.owned_;
    if (how.failed()) return failure(how);
    return made;
  }
#ifdef WRC_EXCEPTIONS
  /** The same; throws an error with the sentence. */
  explicit model(const wrc_config& config, const wrc_allocator* allocator = nullptr) {
    char sentence[512] = "";
    const status how = wrc_model_create(&config, allocator, &owned_, sentence, sizeof sentence);
    handle_ = owned_;
    if (how.failed()) throw error(how, sentence);
  }
#endif
  model(model&& other) noexcept { swap(other); }
  model& operator=(model&& other) noexcept {
    model(std::move(other)).swap(*this);
    return *this;
  }
  ~model() { wrc_model_destroy(owned_); }
  void swap(model& other) noexcept {
    std::swap(owned_, other.owned_);
    std::swap(handle_, other.handle_);
  }
  /** Hands the C handle over: wrc_model_destroy() is the caller's from here on. */
  wrc_model* release() noexcept {
    handle_ = nullptr;
    return std::exchange(owned_, nullptr);
  }

 private:
  wrc_model* owned_ = nullptr;
};

/** A contact that is not owned, and all that can be asked of one. */
class contact_ref : public detail::contact_calls {
 public:
  contact_ref() noexcept = default;
  explicit contact_ref(wrc_contact* contact) noexcept { handle_ = contact; }
  wrc_contact* get() const noexcept { return handle_; }
  explicit operator bool() const noexcept { return handle_ != nullptr; }

  /** wrc_contact_init(): in the caller's memory. `text` gets the sentence where it fails. */
  static expected<contact_ref> init(model_ref model, std::int32_t side, span<std::byte> memory,
                                    span<char> text = {}) noexcept {
    wrc_contact* made = nullptr;
    const status how =
        wrc_contact_init(model.get(), side, memory.data(), memory.size(), &made, text.data(), text.size());
    if (how.failed()) return failure(how);
    return contact_ref(made);
  }

  /** wrc_contact_field() into memory of the caller: for real time. Empty `values`: only the shape is wanted.
   */
  status field(std::int32_t region, std::int32_t which, span<double> values, field_shape& shape) noexcept {
    std::uint64_t counts[2] = {0, 0};
    const status how = wrc_contact_field(handle_, region, which, values.data(), values.size(), counts);
    shape = {static_cast<std::size_t>(counts[0]), static_cast<std::size_t>(counts[1])};
    return how;
  }
  /** The same, copied into a vector. */
  expected<wrc::field> try_field(std::int32_t region, std::int32_t which) {
    field_shape shape;
    status how = field(region, which, {}, shape);
    if (how.failed()) return failure(how);
    std::vector<double> values(shape.size());
    how = field(region, which, values, shape);
    if (how.failed()) return failure(how);
    return wrc::field(std::move(values), shape);
  }
#ifdef WRC_EXCEPTIONS
  wrc::field field(std::int32_t region, std::int32_t which) {
    return detail::value_or_throw(try_field(region, which), handle_);
  }
  /** Throws where a status of this contact is one of failure, with the sentence behind it; else gives WRC_OK
   * or the flag. */
  std::int32_t check(status how) const {
    if (how.failed()) detail::raise(handle_, how);
    return how.value();
  }
#endif
};

/** A contact that is owned. */
class contact : public contact_ref {
 public:
  contact() noexcept = default;
  /** wrc_contact_create(). `text` gets the sentence where it fails; `allocator` nullptr: malloc and free. */
  static expected<contact> make(model_ref model, std::int32_t side, span<char> text = {},
                                const wrc_allocator* allocator = nullptr) noexcept {
    contact made;
    const status how =
        wrc_contact_create(model.get(), side, allocator, &made.handle_, text.data(), text.size());
    if (how.failed()) return failure(how);
    return made;
  }
#ifdef WRC_EXCEPTIONS
  /** The same; throws an error with the sentence. */
  contact(model_ref model, std::int32_t side, const wrc_allocator* allocator = nullptr) {
    char sentence[512] = "";
    const status how = wrc_contact_create(model.get(), side, allocator, &handle_, sentence, sizeof sentence);
    if (how.failed()) throw error(how, sentence);
  }
#endif
  contact(contact&& other) noexcept { std::swap(handle_, other.handle_); }
  contact& operator=(contact&& other) noexcept {
    contact moved(std::move(other));
    std::swap(handle_, moved.handle_);
    return *this;
  }
  ~contact() { wrc_contact_destroy(handle_); }
  /** Hands the C handle over: wrc_contact_destroy() is the caller's from here on. */
  wrc_contact* release() noexcept { return std::exchange(handle_, nullptr); }
};

/** Two bodies that roll on cell by cell and remember their tractions (wrc_exact_transient_create()), owned.
 * May change in a minor version. */
class transient {
 public:
  transient() noexcept = default;
  /** Materials nullptr: the defaults. `text` gets the sentence where it fails. */
  static expected<transient> make(const wrc_grid& grid, const wrc_material* wheel = nullptr,
                                  const wrc_material* rail = nullptr, span<char> text = {}) noexcept {
    transient made;
    const status how =
        wrc_exact_transient_create(&grid, wheel, rail, &made.handle_, text.data(), text.size());
    if (how.failed()) return failure(how);
    return made;
  }
#ifdef WRC_EXCEPTIONS
  /** The same; throws an error with the sentence. */
  explicit transient(const wrc_grid& grid, const wrc_material* wheel = nullptr,
                     const wrc_material* rail = nullptr) {
    char sentence[512] = "";
    const status how = wrc_exact_transient_create(&grid, wheel, rail, &handle_, sentence, sizeof sentence);
    if (how.failed()) throw error(how, sentence);
  }
#endif
  transient(transient&& other) noexcept { std::swap(handle_, other.handle_); }
  transient& operator=(transient&& other) noexcept {
    transient moved(std::move(other));
    std::swap(handle_, moved.handle_);
    return *this;
  }
  ~transient() { wrc_exact_transient_destroy(handle_); }
  wrc_exact_transient* get() const noexcept { return handle_; }
  explicit operator bool() const noexcept { return handle_ != nullptr; }
  /** wrc_exact_transient_step() */
  status step(const wrc_exact_rolling_problem& problem, wrc_exact_rolling_solution& solution,
              span<char> text = {}) noexcept {
    return wrc_exact_transient_step(handle_, &problem, &solution, text.data(), text.size());
  }

 private:
  wrc_exact_transient* handle_ = nullptr;
};

}  // namespace wrc

#endif  // WRC_HPP
