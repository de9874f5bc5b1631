#include "abi/message.hpp"

#include <charconv>
#include <cmath>
#include <cstring>

#include "abi/fp_environment.hpp"

namespace wrc::abi {
namespace {

/// Appends to a bounded, always terminated string.
class Sentence {
 public:
  Sentence(char* text, std::size_t size) : at_(text), end_(text + size - 1) { *at_ = '\0'; }

  void add(const char* piece) {
    while (*piece != '\0' && at_ < end_) *at_++ = *piece++;
    *at_ = '\0';
  }

  void add(double number) {
    if (std::isnan(number)) return add("NaN");  // to_chars writes "nan", and the sign of a NaN is noise
    char digits[32] = {};
    const auto result =
        std::to_chars(digits, digits + sizeof digits - 1, number, std::chars_format::general, 6);
    *result.ptr = '\0';
    add(digits);
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
};

}  // namespace

const char* status_name(std::int32_t status) {
  switch (status) {
#define WRC_NAME(name, value, text) \
  case value:                       \
    return #name;
    WRC_STATUS_LIST(WRC_NAME)
#undef WRC_NAME
    default:
      return "unknown status";
  }
}

const char* status_text(std::int32_t status) {
  switch (status) {
#define WRC_TEXT(name, value, text) \
  case value:                       \
    return text;
    WRC_STATUS_LIST(WRC_TEXT)
#undef WRC_TEXT
    default:
      return "unknown status";
  }
}

void write_sentence(const Fault& fault, char* text, std::size_t size, const char* file) {
  const FloatingPointScope scope;  // digits are inexact, and the value refused may be a signalling NaN
  Sentence out(text, size);
  if (fault.status == WRC_OK) return;
  if (fault.call != nullptr) {
    out.add(fault.call);
    out.add(": ");
  }
  if (fault.field == nullptr) {
    out.add(status_text(fault.status));
  } else {
    if (fault.of != nullptr) {
      out.add(fault.of);
      out.add(".");
    }
    out.add(fault.field);
    if (fault.index >= 0) {
      out.add("[");
      out.add(fault.index);
      out.add("]");
    }
    if (fault.unit != nullptr) {
      out.add(" = ");
      out.add(fault.value);
      out.add_unit(fault.unit);
    }
    if (fault.low == fault.high && fault.high > 0.0) {
      out.add(" is not ");
      out.add(fault.high);
      out.add_unit(fault.unit);
    } else if (fault.low < fault.high) {
      out.add(" is outside ");
      out.add(fault.low);
      out.add(" .. ");
      out.add(fault.high);
      out.add_unit(fault.unit);
    } else {
      out.add(": ");
      out.add(status_text(fault.status));
    }
  }
  if (fault.cause != nullptr) {
    out.add(": ");
    out.add(fault.cause);
  }
  if (file != nullptr) {
    out.add(" (");
    out.add(file);
    out.add(")");
  }
}

}  // namespace wrc::abi
