// Reads, compiles, writes and reads again wrong scenes, until its time is over or something breaks.
//
//     scene_fuzz [--seconds N] [--seed S] [--save FOLDER] SCENE...
//     scene_fuzz --replay SCENE
//
// What broke is saved, and its path printed.
#include <Inventor/SbName.h>
#include <Inventor/lists/SoFieldList.h>
#include <Inventor/nodes/SoNode.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <stdexcept>

#include "scenegraph/compiling/SceneCompiler.h"
#include "scenegraph/reading/SceneFile.h"
#include "scenegraph/solid/MakeSolid.h"
#include "scenegraph/solid/SolidModel.h"
#include "scenegraph/writing/SceneWriter.h"
#include "tests/fuzz/Mutation.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr unsigned kHang = 100;  // seconds for one scene; its rehearsal ends itself after 30 to 60

struct Options {
  int seconds = 60;
  unsigned seed = std::random_device{}();
  fs::path folder = ".";
  fs::path replay;
  std::vector<fs::path> scenes;
};

Options optionsOf(int argc, char** argv) {
  Options options;
  if (const char* seconds = std::getenv("HAPTIV_FUZZ_SECONDS")) options.seconds = std::stoi(seconds);
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] {
      if (i + 1 == argc) throw std::runtime_error(word + " needs a value");
      return std::string(argv[++i]);
    };
    if (word == "--seconds") {
      options.seconds = std::stoi(value());
    } else if (word == "--seed") {
      options.seed = static_cast<unsigned>(std::stoul(value()));
    } else if (word == "--save") {
      options.folder = value();
    } else if (word == "--replay") {
      options.replay = value();
    } else {
      options.scenes.push_back(word);
    }
  }
  return options;
}

std::string contentsOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The name of every node that Coin knows, each followed by its fields'.
std::vector<std::string> wordsOfCoin() {
  std::vector<std::string> words;
  SoTypeList types;
  SoType::getAllDerivedFrom(SoNode::getClassTypeId(), types);
  for (int i = 0; i < types.getLength(); ++i) {
    if (!types[i].canCreateInstance()) continue;
    auto* node = static_cast<SoNode*>(types[i].createInstance());
    node->ref();
    words.emplace_back(types[i].getName().getString());
    SoFieldList fields;
    const int count = node->getFields(fields);
    for (int k = 0; k < count; ++k) {
      SbName name;
      if (node->getFieldName(fields[k], name)) words.emplace_back(name.getString());
    }
    node->unref();
  }
  return words;
}

/// How the scenes fared, by the message of their first error.
using Tally = std::map<std::string, int>;

/// All of it is felt, as with --solid.
void tryAsSolid(const SceneFile& scene) {
  static const DeviceDescription device = loadDeviceDescription("vishard10");
  for (const NegativeSize& size : negativeSizes(scene.root.get())) size.field->setValue(-size.field->getValue());
  for (const NodeRef<>& node : solidNodes(scene.root.get(), device)) scene.root->insertChild(node.get(), 0);
  SceneCompiler().compile(scene);
}

/// The laws: reading, compiling, making solid and writing end, and what has been written can be read.
void tryOne(const std::string& text, Tally& tally) {
  const SceneFile scene = readSceneText(text, "fuzz.iv");
  if (!scene.root) {
    for (const Diagnostic& diagnostic : scene.diagnostics) {
      if (diagnostic.message.starts_with("Coin crashes") || diagnostic.message.starts_with("Coin takes"))
        ++tally[diagnostic.message.substr(0, 90)];
    }
    ++tally["refused"];
    return;
  }
  ++tally["read"];
  SceneCompiler().compile(scene);
  std::string written;
  try {
    written = writeSceneText(scene.root.get());
  } catch (const std::runtime_error&) {
    return;  // a value that no file can hold
  }
  tryAsSolid(scene);
  const SceneFile again = readSceneText(written, "fuzz.iv");
  if (again.root) {
    SceneCompiler().compile(again);
    return;
  }
  ++tally["cannot be read again: " + toText(again.diagnostics.front())];
}

int fuzz(const Options& options, const fs::path& input, unsigned seed) {
  std::vector<std::string> corpus;
  for (const fs::path& path : options.scenes) corpus.push_back(contentsOf(path));
  if (corpus.empty()) throw std::runtime_error("name scenes to start from");
  testing::Mutation mutation(std::move(corpus), wordsOfCoin(), seed);
  Tally tally;
  const auto end = Clock::now() + std::chrono::seconds(options.seconds);
  do {
    const std::string text = mutation.next();
    std::ofstream(input, std::ios::binary) << text;
    ::alarm(kHang);
    tryOne(text, tally);
  } while (Clock::now() < end);
  for (const auto& [what, count] : tally) std::cout << count << " x " << what << "\n";
  return 0;
}

/// Runs work in a child, for its crash to be told here.
bool survives(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    const int result = work();
    std::cout.flush();
    ::_exit(result);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int run(const Options& options) {
  initSceneGraph();
  if (!options.replay.empty()) {
    Tally tally;
    tryOne(contentsOf(options.replay), tally);
    for (const auto& [what, count] : tally) std::cout << count << " x " << what << "\n";
    return 0;
  }
  const fs::path input = options.folder / ("fuzz-" + std::to_string(options.seed) + ".iv");
  std::cout << "seed " << options.seed << ", " << options.seconds << " s" << std::endl;
  if (!survives([&] { return fuzz(options, input, options.seed); })) {
    std::cout << "broken by " << fs::absolute(input).string() << "; again with --replay" << std::endl;
    return 1;
  }
  fs::remove(input);
  return 0;
}

}  // namespace
}  // namespace haptiv

int main(int argc, char** argv) {
  try {
    return haptiv::run(haptiv::optionsOf(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
