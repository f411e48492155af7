#include "geometry/read/image.hpp"

#include <algorithm>
#include <array>

#include "geometry/read/pgm.hpp"
#include "geometry/read/png.hpp"

namespace underway {
namespace {

using Decoder = Expected<void> (*)(std::string_view, const std::string&, const RowSink&);

/// How a kind of image begins.
struct ImageKind {
  std::string_view magic;
  const char* name;
  Decoder decode;  ///< nullptr: known, but not read here
};

constexpr std::array kKinds{
    ImageKind{"P5", "a PGM image", decodePgm},
    ImageKind{"P2", "a PGM image", decodePgm},
    ImageKind{"\x89PNG\r\n\x1a\n", "a PNG image", decodePng},
    ImageKind{"P1", "a PBM image", nullptr},
    ImageKind{"P3", "a PPM image", nullptr},
    ImageKind{"P4", "a PBM image", nullptr},
    ImageKind{"P6", "a PPM image", nullptr},
    ImageKind{"P7", "a PAM image", nullptr},
    ImageKind{"GIF8", "a GIF image", nullptr},
    ImageKind{"BM", "a BMP image", nullptr},
    ImageKind{"\xff\xd8\xff", "a JPEG image", nullptr},
    ImageKind{"II*", "a TIFF image", nullptr},
    ImageKind{std::string_view("MM\0*", 4), "a TIFF image", nullptr},
};

bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Two letters alone could also begin a text: "P5" and its kin must be followed by white space, "BM" by the
/// zeros that a BMP has at 6 to 9.
bool beginsLike(const ImageKind& kind, std::string_view bytes) {
  if (!bytes.starts_with(kind.magic)) return false;
  if (kind.magic == "BM") return bytes.size() > 10 && bytes.substr(6, 4) == std::string_view("\0\0\0\0", 4);
  if (kind.magic[0] == 'P') return bytes.size() > 2 && (isSpace(bytes[2]) || bytes[2] == '#');
  return true;
}

const ImageKind* findKind(std::string_view bytes) {
  const auto found = std::find_if(kKinds.begin(), kKinds.end(),
                                  [&](const ImageKind& kind) { return beginsLike(kind, bytes); });
  return found == kKinds.end() ? nullptr : &*found;
}

}  // namespace

bool isImage(std::string_view bytes) { return findKind(bytes) != nullptr; }

Expected<void> checkIsReadable(std::string_view bytes, const std::string& file) {
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorCode::kInvalidMap, file + ": " + what);
  };
  const ImageKind* kind = findKind(bytes);
  if (kind == nullptr) return refuse("is no image that is known here; give a PGM (P5, P2) or a PNG");
  if (kind->decode == nullptr)
    return refuse(
        std::string("is ") + kind->name +
        "; PGM and PNG are read: convert it, for example with ImageMagick's 'convert IMAGE map.png'");
  return {};
}

Expected<void> decodeImage(std::string_view bytes, const std::string& file, const RowSink& sink) {
  if (const auto readable = checkIsReadable(bytes, file); !readable) return readable;
  return findKind(bytes)->decode(bytes, file, sink);
}

Expected<void> checkImageSize(std::uint64_t width, std::uint64_t height, const std::string& file) {
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorCode::kInvalidMap, file + ": says it has " + std::to_string(width) + " x " +
                                            std::to_string(height) + " pixels; " + what);
  };
  if (width == 0 || height == 0) return refuse("a map needs at least one");
  if (std::max(width, height) > kLongestSide)
    return refuse("at most " + std::to_string(kLongestSide) +
                  " along a side are read: crop it or use larger cells");
  if (width * height > kMostPixels)
    return refuse("at most " + std::to_string(kMostPixels) + " are read: crop it or use larger cells");
  return {};
}

}  // namespace underway
