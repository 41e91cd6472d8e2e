// Plugin files made by the tests: byte by byte, so that each kind of damage can be put in, and no compiler is needed.
#pragma once
#include <elf.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace wend::core {

// The least shared object that the host takes for a plugin: a header, one segment, the symbol and the manifest.
struct PluginImage {
  std::string manifest;
  std::string symbol = "wend_plugin_1", section = ".wend.manifest";
  std::uint32_t manifest_type = SHT_PROGBITS;
  std::uint16_t symbol_section = SHN_ABS;  // SHN_UNDEF: only asked for, not offered
  unsigned char binding = STB_GLOBAL, visibility = STV_DEFAULT;
  Elf64_Ehdr header{};
  Elf64_Phdr segment{};

  explicit PluginImage(std::string text) : manifest(std::move(text)) {
    std::memcpy(header.e_ident, ELFMAG, SELFMAG);
    header.e_ident[EI_CLASS] = ELFCLASS64;
    header.e_ident[EI_DATA] = ELFDATA2LSB;
    header.e_type = ET_DYN;
    header.e_machine = EM_X86_64;
    header.e_phoff = sizeof header;
    header.e_phentsize = sizeof(Elf64_Phdr);
    header.e_phnum = 1;
    header.e_shentsize = sizeof(Elf64_Shdr);
    header.e_shnum = 5;
    header.e_shstrndx = 4;
    segment.p_type = PT_LOAD;
  }

  static constexpr std::size_t manifest_offset = sizeof(Elf64_Ehdr) + sizeof(Elf64_Phdr);

  std::string bytes() const {
    std::string out(manifest_offset, '\0');
    Elf64_Shdr sections[5] = {};
    std::string names("\0", 1);
    const auto add = [&](int i, const std::string& name, std::uint32_t type, const std::string& content) {
      sections[i].sh_name = static_cast<std::uint32_t>(names.size());
      sections[i].sh_type = type;
      sections[i].sh_offset = out.size();
      sections[i].sh_size = content.size();
      names += name + '\0';
      out += content;
    };
    Elf64_Sym symbols[2] = {};
    symbols[1].st_name = 1;
    symbols[1].st_info = ELF64_ST_INFO(binding, STT_OBJECT);
    symbols[1].st_other = visibility;
    symbols[1].st_shndx = symbol_section;
    add(1, section, manifest_type, manifest);
    add(2, ".dynstr", SHT_STRTAB, std::string("\0", 1) + symbol + '\0');
    add(3, ".dynsym", SHT_DYNSYM, {reinterpret_cast<const char*>(symbols), sizeof symbols});
    sections[3].sh_link = 2;
    names += std::string(".shstrtab") + '\0';
    sections[4].sh_name = static_cast<std::uint32_t>(names.size() - 10);
    sections[4].sh_type = SHT_STRTAB;
    sections[4].sh_offset = out.size();
    sections[4].sh_size = names.size();
    out += names;
    Elf64_Ehdr head = header;
    if (head.e_shnum > 0 && head.e_shoff == 0) head.e_shoff = out.size();
    out.append(reinterpret_cast<const char*>(sections), sizeof sections);
    Elf64_Phdr load = segment;
    if (load.p_filesz == 0) load.p_filesz = load.p_memsz = out.size();
    std::memcpy(out.data(), &head, sizeof head);
    std::memcpy(out.data() + sizeof head, &load, sizeof load);
    return out;
  }
};

// A manifest with one policy.
inline std::string manifest_of(const std::string& id) {
  return R"({"wend": 1, "name": "test", "version": "1", "license": "BSD-3-Clause", "components": [)"
         R"({"id": ")" +
         id + R"(", "summary": "A test.", "interfaces": ["wend.policy/1"]}]})";
}

class PluginFiles : public testing::Test {
 protected:
  PluginFiles() {
    std::string name = testing::TempDir() + "wend_plugins_XXXXXX";
    directory_ = std::filesystem::canonical(::mkdtemp(name.data())).string();
  }
  ~PluginFiles() override { std::filesystem::remove_all(directory_); }

  std::string path(const std::string& name) const { return directory_ + "/" + name; }

  std::string put(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  std::string put(const std::string& name, const PluginImage& image) const { return put(name, image.bytes()); }

  std::string directory_;
};

}  // namespace wend::core
