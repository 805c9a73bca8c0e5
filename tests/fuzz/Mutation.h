#pragma once

#include <random>
#include <string>
#include <vector>

namespace haptiv::testing {

/// Makes wrong scenes out of right ones. The same seed makes the same scenes.
class Mutation {
 public:
  /// @param corpus  scenes to start from
  /// @param words   to put in: names of nodes and fields
  Mutation(std::vector<std::string> corpus, std::vector<std::string> words, unsigned seed);

  std::string next();

 private:
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  void mutate(std::string& text);
  void replaceWord(std::string& text);
  void replaceNumber(std::string& text);
  void changeByte(std::string& text);
  void deletePart(std::string& text);
  void repeatPart(std::string& text);
  void insertFromOther(std::string& text);
  void insertNode(std::string& text);

  std::vector<std::string> corpus_;
  std::vector<std::string> words_;
  std::mt19937 random_;
};

}  // namespace haptiv::testing
