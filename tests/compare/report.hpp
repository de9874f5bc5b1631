/// Errors of every variant over the rows of a file, and how they are printed.
#pragma once

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace compare {

/// Signed errors of one measure (fractions), one per row that counts, with the row's number in the file.
struct Errors {
  std::vector<double> values;
  std::vector<std::size_t> rows;
  void add(std::size_t row, double error) {
    values.push_back(error);
    rows.push_back(row);
  }
};

struct Statistics {
  double median = 0.0, p95 = 0.0, max = 0.0;  ///< of |error|
  double bias = 0.0;                          ///< median of the signed error
  std::size_t worst_row = 0;
};
Statistics statistics(const Errors& errors);

struct Failure {
  std::size_t row;
  std::string variant, reason;
};

struct Report {
  std::string kind;
  std::size_t rows = 0;
  bool numbered = false;                                        ///< `row` is the case's number in the file
  std::map<std::string, std::string> units;                     ///< of measures that are no fractions
  std::vector<std::string> measures;                            ///< in the order they are printed
  std::vector<std::string> variants;                            ///< in the order they are printed
  std::map<std::string, std::map<std::string, Errors>> errors;  ///< variant -> measure -> errors
  std::vector<Failure> failed;
  std::string default_variant;

  /// A row that failed counts as error 1 in every measure, or in those that would have had an error of it.
  void fail(std::size_t row, const std::string& variant, const std::string& reason);
  void fail(std::size_t row, const std::string& variant, const std::string& reason,
            const std::vector<std::string>& of_measures);

  /// Empty where there is no such error.
  Errors sample_of(const std::string& variant, const std::string& measure) const;

  void print_table() const;
  void print_json() const;  ///< one line: {"kind", "rows", "variants": {...}, "default", "failed"}; a measure
                            ///< without a single row is left out
};

/// The variants to run: those of `all` named in `only`, in their own order; all of them when none is named.
/// Throws std::runtime_error with the known names when one is unknown.
template <class Variant>
std::vector<Variant> chosen(const std::vector<Variant>& all, const std::vector<std::string>& only) {
  if (only.empty()) return all;
  std::vector<Variant> found;
  for (const Variant& variant : all)
    if (std::find(only.begin(), only.end(), variant.name) != only.end()) found.push_back(variant);
  for (const std::string& name : only) {
    if (std::any_of(all.begin(), all.end(), [&](const Variant& variant) { return variant.name == name; }))
      continue;
    std::string message = "no variant '" + name + "'; known are";
    for (const Variant& variant : all) message += std::string("\n  ") + variant.name;
    throw std::runtime_error(message);
  }
  return found;
}

}  // namespace compare
