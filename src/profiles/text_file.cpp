#include "profiles/text_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

namespace wrc::profiles {

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// 10^exponent, exact up to 22.
double power_of_ten(int exponent) {
  double power = 1.0;
  for (int i = 0; i < exponent; ++i) power *= 10.0;
  return power;
}

}  // namespace

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? std::string{}
                                    : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool ends_with(const std::string& text, const char* ending) {
  const std::size_t size = std::strlen(ending);
  return text.size() >= size && lower_case(text.substr(text.size() - size)) == ending;
}

bool read_text(const std::string& path, const char* comments, std::vector<TextLine>& lines) {
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) return false;
  std::string whole;
  char part[4096];
  for (std::size_t count; (count = std::fread(part, 1, sizeof part, file.get())) > 0;)
    whole.append(part, count);
  lines.clear();
  int number = 0;
  for (std::size_t at = 0; at < whole.size();) {
    const std::size_t end = std::min(whole.find('\n', at), whole.size());
    std::string text = whole.substr(at, end - at);
    text = trimmed(text.substr(0, text.find_first_of(comments)));
    ++number;
    if (!text.empty()) lines.push_back({number, text});
    at = end + 1;
  }
  return true;
}

bool write_text(const std::string& path, const std::string& text) {
  File file(std::fopen(path.c_str(), "wb"));
  if (!file) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  return std::fclose(file.release()) == 0 && written;
}

bool read_number(const std::string& cell, double& value) {
  if (lower_case(cell) == "nan") {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  // digits into a whole number: nineteen fit, further ones are below its last bit
  std::size_t at = !cell.empty() && (cell[0] == '-' || cell[0] == '+') ? 1 : 0;
  std::uint64_t digits = 0;
  int exponent = 0, seen = 0, kept = 0;
  bool behind_point = false;
  for (; at < cell.size() && (is_digit(cell[at]) || (cell[at] == '.' && !behind_point)); ++at) {
    if (cell[at] == '.') {
      behind_point = true;
      continue;
    }
    ++seen;
    if (kept < 19) {
      digits = 10 * digits + static_cast<std::uint64_t>(cell[at] - '0');
      kept += digits > 0 ? 1 : 0;
      exponent -= behind_point ? 1 : 0;
    } else if (!behind_point) {
      ++exponent;
    }
  }
  if (seen == 0) return false;
  // the exponent: e, or d of Fortran
  if (at < cell.size() && std::strchr("eEdD", cell[at]) != nullptr) {
    ++at;
    const bool down = at < cell.size() && cell[at] == '-';
    if (at < cell.size() && (cell[at] == '-' || cell[at] == '+')) ++at;
    if (at == cell.size()) return false;
    int given = 0;
    for (; at < cell.size() && is_digit(cell[at]); ++at)
      given = std::min(10 * given + (cell[at] - '0'), 9999);
    exponent += down ? -given : given;
  }
  if (at != cell.size()) return false;
  // One rounding where fifteen digits and 10^22 do; powers in parts, so that small numbers stay numbers.
  value = static_cast<double>(digits);
  for (; exponent < -22 && value != 0.0; exponent += 22) value /= 1e22;
  for (; exponent > 22 && std::isfinite(value) && value != 0.0; exponent -= 22) value *= 1e22;
  if (value != 0.0 && std::isfinite(value))
    value = exponent < 0 ? value / power_of_ten(-exponent) : value * power_of_ten(exponent);
  if (cell[0] == '-') value = -value;
  return true;
}

std::vector<std::string> cells_of(const std::string& line) {
  const bool semicolons = line.find(';') != std::string::npos;
  std::vector<std::string> cells;
  std::string cell;
  for (const char c : line + (semicolons ? ";" : " ")) {
    const bool between = semicolons ? c == ';' : std::strchr(" \t,\r", c) != nullptr;
    if (!between) {
      cell += semicolons && c == ',' ? '.' : c;
      continue;
    }
    cell = trimmed(cell);
    if (!cell.empty()) cells.push_back(cell);
    cell.clear();
  }
  return cells;
}

bool read_numbers(const std::string& line, std::vector<double>& numbers) {
  numbers.clear();
  for (const std::string& cell : cells_of(line)) {
    numbers.push_back(0.0);
    if (!read_number(cell, numbers.back())) return false;
  }
  return !numbers.empty();
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "nan";
  const double scaled = std::floor(std::abs(value) * power_of_ten(decimals) + 0.5);
  std::string digits;
  if (scaled < 9e18) digits = std::to_string(static_cast<std::uint64_t>(scaled));
  if (digits.empty()) return "nan";
  const auto behind = static_cast<std::size_t>(decimals);
  if (digits.size() <= behind) digits.insert(0, behind + 1 - digits.size(), '0');
  digits.insert(digits.size() - behind, ".");
  return (value < 0.0 && scaled > 0.0 ? "-" : "") + digits;
}

}  // namespace wrc::profiles
