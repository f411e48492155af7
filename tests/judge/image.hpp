#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace judge {

/// A file the judge cannot read; the sentence says which and why.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A picture in shades of grey, row 0 at the top. Whole numbers, so that no shade is rounded across a
/// threshold.
struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  double white = 255.0;       ///< the shade of white; black is 0
  std::vector<double> shade;  ///< row by row: a pixel's channels summed
};

/// Reads PGM (P2, P5, 8 and 16 bit) and PNG (all its channels count, alpha too, as map_server does in trinary
/// mode). Throws InputError.
Image readImage(const std::filesystem::path& file);

}  // namespace judge
