#include "abi/message.hpp"

#include <cmath>

#include "abi/fp_environment.hpp"
#include "base/sentence.hpp"

namespace wrc::abi {

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
  // Sections count from 1 for people, as their instruments have them.
  if (!std::isnan(fault.distance)) {
    out.add(" (section ");
    out.add(fault.index + 1);
    out.add(" at ");
    out.add(fault.distance);
    out.add(" m)");
  }
  if (file != nullptr) {
    out.add(" (");
    out.add(file);
    out.add(")");
  }
}

}  // namespace wrc::abi
