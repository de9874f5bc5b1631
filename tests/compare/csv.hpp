/// A CSV file with a heading line, by column name.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace compare {

class Csv {
 public:
  /// Reads the file; throws std::runtime_error with a sentence (missing file, ragged line).
  explicit Csv(const std::string& path);

  const std::string& path() const { return path_; }
  std::size_t rows() const { return rows_; }
  bool has(const std::string& column) const { return columns_.count(column) != 0; }

  /// Number in a row; throws when the column does not exist or holds something else there.
  double operator()(std::size_t row, const std::string& column) const;

  /// The same as it is written.
  const std::string& text(std::size_t row, const std::string& column) const;

 private:
  std::string path_;
  std::map<std::string, std::vector<std::string>> columns_;
  std::size_t rows_ = 0;
};

/// The file of parameters beside a file of cases: params in the place of cases in its name. Throws
/// std::runtime_error where the name has no cases.
std::string parameters_of(const std::string& path);

}  // namespace compare
