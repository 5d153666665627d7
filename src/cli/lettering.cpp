#include "cli/lettering.h"

#include <algorithm>
#include <iterator>

namespace cli {
namespace {

constexpr int kColumns = 5, kRows = 7, kAdvance = 6;

struct Letter {
  char name;
  const char* dots;  // row after row
};

constexpr Letter kLetters[] = {{'0',
                                ".###."
                                "#...#"
                                "#...#"
                                "#...#"
                                "#...#"
                                "#...#"
                                ".###."},
                               {'1',
                                "..#.."
                                ".##.."
                                "..#.."
                                "..#.."
                                "..#.."
                                "..#.."
                                ".###."},
                               {'.',
                                "....."
                                "....."
                                "....."
                                "....."
                                "....."
                                ".##.."
                                ".##.."},
                               {'A',
                                ".###."
                                "#...#"
                                "#...#"
                                "#####"
                                "#...#"
                                "#...#"
                                "#...#"},
                               {'B',
                                "####."
                                "#...#"
                                "#...#"
                                "####."
                                "#...#"
                                "#...#"
                                "####."},
                               {'C',
                                ".###."
                                "#...#"
                                "#...."
                                "#...."
                                "#...."
                                "#...#"
                                ".###."},
                               {'F',
                                "#####"
                                "#...."
                                "#...."
                                "####."
                                "#...."
                                "#...."
                                "#...."},
                               {'K',
                                "#...#"
                                "#..#."
                                "#.#.."
                                "##..."
                                "#.#.."
                                "#..#."
                                "#...#"},
                               {'N',
                                "#...#"
                                "##..#"
                                "##..#"
                                "#.#.#"
                                "#..##"
                                "#..##"
                                "#...#"},
                               {'O',
                                ".###."
                                "#...#"
                                "#...#"
                                "#...#"
                                "#...#"
                                "#...#"
                                ".###."},
                               {'R',
                                "####."
                                "#...#"
                                "#...#"
                                "####."
                                "#.#.."
                                "#..#."
                                "#...#"},
                               {'T',
                                "#####"
                                "..#.."
                                "..#.."
                                "..#.."
                                "..#.."
                                "..#.."
                                "..#.."}};

}  // namespace

double width_of(const std::string& text, double dot) {
  return dot * (kAdvance * static_cast<double>(text.size()) - (kAdvance - kColumns));
}

void write(ColorPicture& picture, const std::string& text, Spot left_middle, double dot, Rgb color) {
  double left = left_middle.x;
  const double top = left_middle.y - kRows * dot / 2;
  for (const char name : text) {
    const auto* letter =
        std::find_if(std::begin(kLetters), std::end(kLetters), [name](const Letter& one) { return one.name == name; });
    for (int i = 0; letter != std::end(kLetters) && i < kColumns * kRows; ++i) {
      const int column = i % kColumns, row = i / kColumns;
      const Spot middle{left + (column + 0.5) * dot, top + (row + 0.5) * dot};
      if (letter->dots[i] == '#') stroke(picture, middle, middle, dot / 2, {color, 1});
    }
    left += kAdvance * dot;
  }
}

}  // namespace cli
