#pragma once

#include <filesystem>
#include <string>

namespace haptiv {

/// A new, empty folder.
std::filesystem::path makeFolder();

/// All bytes of a file; empty where there is none.
std::string readFile(const std::filesystem::path& path);

/// A folder for one test's files, gone afterwards.
class TestFolder {
 public:
  TestFolder() : path_(makeFolder()) {}
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  /// Path of a file in it.
  std::string operator/(const std::string& name) const { return path_ / name; }
  /// A device on which nothing can be written: "no space left". Root gets one of its own in this folder, because root
  /// could replace the machine's; for others that of the machine is safe.
  std::string fullDevice() const;
  /// Writes a file and gives its path.
  std::string write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// A scene with the ball at (0.3, 0, 0) and a wall of 2000 N/m that stops the ball's centre at y = 0.14.
/// `more` is added to the scene, `surface` to the wall's properties.
std::string wallScene(const std::string& surface = "", const std::string& more = "");

/// A hand that goes from the ball's home to 60 mm beyond that place within a second: at rest it presses with 20 N,
/// 10 mm into the wall (400 N/m of the hand against 2000 N/m of the wall).
std::string pushingHand();

/// A file under tests/data.
std::string data(const std::string& name);

}  // namespace haptiv
