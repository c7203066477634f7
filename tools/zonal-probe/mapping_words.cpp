#include "mapping_words.hpp"

#include <algorithm>

namespace zonal_probe {

std::string mapping_word(zonal::Mapping mapping) {
  std::string word = zonal::mapping_name(mapping);
  std::replace(word.begin(), word.end(), ' ', '-');
  return word;
}

std::vector<std::string> mapping_words() {
  std::vector<std::string> words{"auto"};
  for (int i = 0; i < zonal::kMappingCount; ++i) words.push_back(mapping_word(static_cast<zonal::Mapping>(i)));
  return words;
}

}  // namespace zonal_probe
