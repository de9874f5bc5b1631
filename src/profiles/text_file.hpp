/// Text files of numbers, read and written alike in every locale. Offline: it allocates.
#pragma once

#include <string>
#include <vector>

namespace wrc::profiles {

/// A line that is more than a comment, with its number, counted from 1.
struct TextLine {
  int number = 0;
  std::string text;  ///< without spaces at its ends
};

/// Lines of a file up to a sign of `comments` each; false where it cannot be read.
bool read_text(const std::string& path, const char* comments, std::vector<TextLine>& lines);

/// Writes the whole file; false where it cannot.
bool write_text(const std::string& path, const std::string& text);

/// A number as Fortran and C write it, NaN among them; false where the cell is something else.
bool read_number(const std::string& cell, double& value);

/// The cells of a line: between spaces, tabs and commas; where it has semicolons, between these, with decimal
/// commas.
std::vector<std::string> cells_of(const std::string& line);

/// The numbers of a line; false where a cell is none.
bool read_numbers(const std::string& line, std::vector<double>& numbers);

/// A number with so many decimals.
std::string fixed(double value, int decimals);

/// Text without spaces and tabs at its ends; in small letters.
std::string trimmed(const std::string& text);
std::string lower_case(std::string text);

/// Does it end so, in small or capital letters?
bool ends_with(const std::string& text, const char* ending);

}  // namespace wrc::profiles
