#include "isogloss/engine/library.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

using namespace isogloss;

namespace fs = std::filesystem;

TEST_CASE("a folder that every user can write is refused once, however often it is loaded") {
  std::string name = (fs::temp_directory_path() / "isogloss-plugins-XXXXXX").string();
  REQUIRE(::mkdtemp(name.data()) != nullptr);
  const fs::path folder = name;
  std::ofstream(folder / "first.so");
  std::ofstream(folder / "second.so");
  fs::permissions(folder, fs::perms::all);

  Library library({folder});
  library.load_all();
  library.load_all();
  REQUIRE(library.refused().size() == 1);
  CHECK(library.refused()[0].file == folder);
  CHECK(library.refused()[0].code == "IG-0311");
  CHECK_FALSE(library.load_file(folder / "first.so"));
  CHECK(library.refused().size() == 2);
  fs::remove_all(folder);
}
