/// Sentences with numbers in them: six digits, whatever the host's locale, into bounded memory.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace wrc {

/// A number >= 0 to six digits, digit[0].digit[1]... 10^exponent, as printf's %g. No standard library before
/// that of gcc 11 writes numbers without the host's locale.
struct Decimal {
  static constexpr int most = 6;
  char digit[most] = {};
  int count = 1;  ///< without zeros at the end
  int exponent = 0;

  explicit Decimal(double number) {
    digit[0] = '0';
    if (number == 0.0) return;
    // number = scaled 10^exponent, 1 <= scaled < 10
    double scaled = number;
    for (; scaled >= 1e16; exponent += 16) scaled *= 1e-16;
    for (; scaled < 1e-16; exponent -= 16) scaled *= 1e16;
    double power = 1.0;
    if (scaled >= 1.0)
      for (; scaled / power >= 10.0; ++exponent) power *= 10.0;
    else
      for (; scaled * power < 1.0; --exponent) power *= 10.0;
    auto rounded =
        static_cast<std::int32_t>(std::floor((scaled >= 1.0 ? scaled / power : scaled * power) * 1e5 + 0.5));
    if (rounded == 1000000) {
      rounded = 100000;
      ++exponent;
    }
    for (int i = most - 1; i >= 0; --i, rounded /= 10) digit[i] = static_cast<char>('0' + rounded % 10);
    for (count = most; count > 1 && digit[count - 1] == '0';) --count;
  }
};

/// Appends to a bounded, always terminated string.
class Sentence {
 public:
  Sentence(char* text, std::size_t size) : at_(text), end_(text + size - 1) { *at_ = '\0'; }

  void add(const char* piece) {
    while (*piece != '\0' && at_ < end_) *at_++ = *piece++;
    *at_ = '\0';
  }

  void add(double number) {
    if (std::isnan(number)) return add("NaN");
    if (number < 0.0) add("-");
    if (std::isinf(number)) return add("inf");
    add(Decimal(std::abs(number)));
  }

  /// Nothing for a pure number, whose unit is "" or "1".
  void add_unit(const char* unit) {
    if (unit == nullptr || unit[0] == '\0' || std::strcmp(unit, "1") == 0) return;
    add(" ");
    add(unit);
  }

  void add(std::int32_t number) {
    char digits[16] = {};
    const auto result = std::to_chars(digits, digits + sizeof digits - 1, number);
    *result.ptr = '\0';
    add(digits);
  }

 private:
  char* at_;
  char* end_;

  void add(char character) {
    const char piece[2] = {character, '\0'};
    add(piece);
  }

  void add(const Decimal& number) {
    const bool scientific = number.exponent < -4 || number.exponent >= Decimal::most;
    // places before the decimal point, then those behind it
    const int before = scientific ? 1 : number.exponent + 1;
    if (before <= 0) add("0.");
    for (int i = before; i < 0; ++i) add('0');
    for (int i = 0; i < number.count || i < before; ++i) {
      if (i == before && i > 0) add('.');
      add(i < number.count ? number.digit[i] : '0');
    }
    if (!scientific) return;
    const int size = number.exponent < 0 ? -number.exponent : number.exponent;
    add(number.exponent < 0 ? "e-" : "e+");
    if (size < 10) add('0');
    add(static_cast<std::int32_t>(size));
  }
};

}  // namespace wrc
