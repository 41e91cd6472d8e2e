#include <gtest/gtest.h>
#include <sys/stat.h>

#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/plugin/elf.hpp>
#include <random>

#include "plugin_files.hpp"

namespace wend::core {
namespace {

class Elf : public PluginFiles {
 protected:
  std::string problem(const std::string& path) const {
    try {
      manifest_section(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::plugin);
      return error.what();
    }
    return "";
  }
  std::string problem_of(const std::string& bytes) const { return problem(put("x.so", bytes)); }
  std::string problem_of(const PluginImage& image) const { return problem_of(image.bytes()); }
};

TEST_F(Elf, ReadsTheManifest) {
  EXPECT_EQ(manifest_section(put("x.so", PluginImage("{\"wend\": 1}"))), "{\"wend\": 1}");
  EXPECT_EQ(manifest_section(put("c.so", PluginImage(std::string("{}\0\0", 4)))), "{}");  // from a C array of char
  PluginImage full(std::string(1 << 20, ' '));
  EXPECT_EQ(manifest_section(put("full.so", full)).size(), std::size_t{1} << 20);
}

TEST_F(Elf, ReadsWhatTheCompilerMakes) {
  put("p.c",
      "__attribute__((section(\".wend.manifest\"), used)) static const char manifest[] = \"{\\\"wend\\\": 1}\";\n"
      "const int wend_plugin_1 = 1;\n");
  ASSERT_EQ(std::system(("cc -shared -fPIC -o " + path("p.so") + " " + path("p.c")).c_str()), 0);
  EXPECT_EQ(manifest_section(path("p.so")), "{\"wend\": 1}");
  ASSERT_EQ(std::system(("strip -o " + path("s.so") + " " + path("p.so")).c_str()), 0);
  EXPECT_EQ(manifest_section(path("s.so")), "{\"wend\": 1}");
  const std::string whole = read_file(path("p.so"));
  for (std::size_t keep = 0; keep < whole.size(); keep += 397) EXPECT_NE(problem_of(whole.substr(0, keep)), "") << keep;
  ASSERT_EQ(std::system(("cc -c -fPIC -o " + path("p.o") + " " + path("p.c")).c_str()), 0);
  EXPECT_EQ(problem(path("p.o")), "an object file, expected a shared object: link it with -shared");
}

TEST_F(Elf, WhatIsNoSharedObject) {
  EXPECT_EQ(problem(path("none.so")), "cannot be opened: No such file or directory");
  EXPECT_EQ(problem(directory_), "a directory, expected a shared object");
  ASSERT_EQ(::mkfifo(path("fifo.so").c_str(), 0600), 0);
  EXPECT_EQ(problem(path("fifo.so")), "not a regular file");
  EXPECT_EQ(problem_of(""), "an empty file, expected a shared object");
  EXPECT_EQ(problem_of("#!/bin/sh\necho no plugin\n"), "not an ELF file, expected a shared object");
  EXPECT_EQ(problem_of("\x7f"), "not an ELF file, expected a shared object");
  PluginImage image("{}");
  image.header.e_type = ET_EXEC;
  EXPECT_EQ(problem_of(image), "a program, expected a shared object");
  image.header.e_type = ET_CORE;
  EXPECT_EQ(problem_of(image), "ELF type 4, expected a shared object (3)");
}

TEST_F(Elf, ForeignMachines) {
  PluginImage image("{}");
  image.header.e_ident[EI_CLASS] = ELFCLASS32;
  EXPECT_EQ(problem_of(image), "a 32-bit ELF file, expected a 64-bit one");
  image = PluginImage("{}");
  image.header.e_ident[EI_DATA] = ELFDATA2MSB;
  EXPECT_EQ(problem_of(image), "a big-endian ELF file, expected a little-endian one");
  image = PluginImage("{}");
  image.header.e_machine = EM_AARCH64;
  EXPECT_EQ(problem_of(image), "built for another machine (ELF machine 183), expected x86-64 (62)");
}

TEST_F(Elf, TruncatedFiles) {
  const std::string whole = PluginImage("{}").bytes();
  const std::string size = std::to_string(whole.size());
  EXPECT_EQ(problem_of(whole), "");
  EXPECT_EQ(problem_of(whole.substr(0, 30)),
            "damaged or truncated: the ELF header lies beyond the end of the file (30 bytes)");
  EXPECT_EQ(problem_of(whole.substr(0, 100)),
            "damaged or truncated: the program header table lies beyond the end of the file (100 bytes)");
  EXPECT_EQ(problem_of(whole.substr(0, 200)),
            "truncated: a segment of " + size + " bytes starts at byte 0, but the file has only 200");
  PluginImage image("{}");
  image.segment.p_filesz = 1 << 20;
  EXPECT_EQ(problem_of(image), "truncated: a segment of 1048576 bytes starts at byte 0, but the file has only " + size);
  image.segment.p_filesz = 16;
  image.segment.p_offset = ~std::uint64_t{0} - 4;  // offset + size overflows
  EXPECT_EQ(problem_of(image),
            "truncated: a segment of 16 bytes starts at byte 18446744073709551611, but the file has only " + size);
}

TEST_F(Elf, DamagedTables) {
  const std::string size = std::to_string(PluginImage("{}").bytes().size());
  PluginImage image("{}");
  image.header.e_phnum = 0;
  EXPECT_EQ(problem_of(image), "damaged: no usable program header table");
  image = PluginImage("{}");
  image.header.e_shnum = 0;
  EXPECT_EQ(problem_of(image), "no section table, so no manifest (was it stripped of it?)");
  image = PluginImage("{}");
  image.header.e_shstrndx = 5;
  EXPECT_EQ(problem_of(image), "damaged: no usable section table");
  image = PluginImage("{}");
  image.header.e_shentsize = 40;
  EXPECT_EQ(problem_of(image), "damaged: no usable section table");
  image = PluginImage("{}");
  image.header.e_shoff = ~std::uint64_t{0} - 8;
  EXPECT_EQ(problem_of(image),
            "damaged or truncated: the section table lies beyond the end of the file (" + size + " bytes)");
  std::string bytes = PluginImage("{}").bytes();
  Elf64_Shdr section;
  const std::size_t at = bytes.size() - 4 * sizeof section;  // the manifest's
  std::memcpy(&section, bytes.data() + at, sizeof section);
  section.sh_offset = 1 << 20;
  std::memcpy(bytes.data() + at, &section, sizeof section);
  EXPECT_EQ(problem_of(bytes),
            "damaged or truncated: the section .wend.manifest lies beyond the end of the file (" + size + " bytes)");
  section.sh_flags = SHF_COMPRESSED;
  std::memcpy(bytes.data() + at, &section, sizeof section);
  EXPECT_EQ(problem_of(bytes), "its section .wend.manifest is compressed");
}

TEST_F(Elf, ManifestsThatAreNone) {
  PluginImage image("{}");
  image.section = ".rodata";
  EXPECT_EQ(problem_of(image), "no section .wend.manifest: not a wend plugin, or built without wend_add_plugin()");
  EXPECT_EQ(problem_of(PluginImage("")), "its section .wend.manifest is empty");
  image = PluginImage("{}");
  image.manifest_type = SHT_NOBITS;
  EXPECT_EQ(problem_of(image), "its section .wend.manifest is empty");
  EXPECT_EQ(problem_of(PluginImage(std::string((1 << 20) + 1, ' '))),
            "its section .wend.manifest has 1048577 bytes, expected at most 1048576");
}

TEST_F(Elf, TheSymbolHasToBeExported) {
  const std::string missing =
      "it does not export the symbol wend_plugin_1: WEND_PLUGIN(...) in C++, a WEND_EXPORT const wend_plugin in C";
  PluginImage image("{}");
  image.symbol = "wend_plugin_2";
  EXPECT_EQ(problem_of(image), missing);
  image = PluginImage("{}");
  image.symbol_section = SHN_UNDEF;
  EXPECT_EQ(problem_of(image), missing);
  image = PluginImage("{}");
  image.binding = STB_LOCAL;
  EXPECT_EQ(problem_of(image), missing);
  image = PluginImage("{}");
  image.visibility = STV_HIDDEN;
  EXPECT_EQ(problem_of(image), missing);
}

TEST_F(Elf, RandomDamageIsNeverFatal) {
  const std::string whole = PluginImage(manifest_of("a")).bytes();
  std::mt19937 random(11);
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    std::string bytes = whole;
    for (unsigned n = 1 + random() % 8; n > 0; --n) {
      // The header and the section table are where damage matters.
      const std::size_t at =
          random() % 2 == 0 ? random() % 120 : bytes.size() - 1 - random() % (5 * sizeof(Elf64_Shdr));
      bytes[at] = static_cast<char>(random());
    }
    if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    refused += !problem_of(bytes).empty();
  }
  EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace wend::core
