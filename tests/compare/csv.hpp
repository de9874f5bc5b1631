/// A CSV file of numbers with a heading line, by column name.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace compare {

class Csv {
 public:
  /// Reads the file; throws std::runtime_error with a sentence (missing file, ragged line, not a number).
  explicit Csv(const std::string& path);

  std::size_t rows() const { return rows_; }
  bool has(const std::string& column) const { return columns_.count(column) != 0; }

  /// Value in a row; throws when the column does not exist.
  double operator()(std::size_t row, const std::string& column) const;

 private:
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

}  // namespace compare
