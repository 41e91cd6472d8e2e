#include "header.hpp"

#include <regex>
#include <sstream>

#include "support/program.hpp"

namespace wend::test {
namespace {

std::string without_comments(const std::string& text, bool keep_frozen) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = std::min(text.find("/*", at), text.size());
    out += text.substr(at, open - at);
    if (open == text.size()) break;
    const std::size_t close = text.find("*/", open);
    if (keep_frozen && text.substr(open, close - open).find("FROZEN") != std::string::npos) out += "@FROZEN@";
    at = close + 2;
  }
  return out;
}

std::string single_spaced(const std::string& text) {
  std::istringstream words(text);
  std::string out;
  for (std::string word; words >> word;) out += (out.empty() ? "" : " ") + word;
  return out;
}

// The declarators of "double x, y" and the one name in "wend_status (*act)(...)", each with its whole declaration.
void add_members(const std::string& declaration, Struct& into) {
  const std::regex function("\\(\\* ?(\\w+) ?\\)"), last("(\\w+) ?$"), type("^((const |struct )*\\w+)");
  std::smatch found;
  if (std::regex_search(declaration, found, function)) return into.members.emplace_back(found[1], declaration), void();
  if (!std::regex_search(declaration, found, type)) return;
  const std::string of = found[1];
  std::istringstream parts(declaration.substr(of.size()));
  for (std::string part; std::getline(parts, part, ',');)
    if (std::regex_search(part, found, last)) into.members.emplace_back(found[1], single_spaced(of + " " + part));
}

}  // namespace

Header read_header(const std::string& path) {
  Header header;
  const std::string marked = without_comments(read_text(path), true), text = without_comments(read_text(path), false);
  const std::regex structure("typedef struct \\w+ \\{([^}]*)\\} (\\w+);[ \\t]*(@FROZEN@)?"),
      enumeration("enum \\{([^}]*)\\}"), constant("(WEND_\\w+) = (\\w+)"), define("#define (WEND_\\w+) \"([^\"]*)\"");
  const auto all = [](const std::string& in, const std::regex& what) {
    return std::pair{std::sregex_iterator(in.begin(), in.end(), what), std::sregex_iterator()};
  };
  for (auto [at, end] = all(marked, structure); at != end; ++at) {
    Struct one;
    one.name = (*at)[2];
    std::string body = (*at)[1];
    const std::string before = marked.substr(0, static_cast<std::size_t>(at->position()));
    const std::size_t last = before.find_last_not_of(" \n");
    one.frozen = body.find("@FROZEN@") != std::string::npos || (*at)[3].matched ||
                 (last != std::string::npos && before.substr(0, last + 1).size() >= 8 &&
                  before.substr(last - 7, 8) == "@FROZEN@");
    body = std::regex_replace(body, std::regex("@FROZEN@"), "");
    std::istringstream members(body);
    for (std::string member; std::getline(members, member, ';');) add_members(single_spaced(member), one);
    header.structs.push_back(std::move(one));
  }
  for (auto [at, end] = all(text, enumeration); at != end; ++at) {
    const std::string body = (*at)[1];
    for (auto [c, none] = all(body, constant); c != none; ++c) header.constants.emplace_back((*c)[1], (*c)[2]);
  }
  for (auto [at, end] = all(text, define); at != end; ++at) header.texts.emplace_back((*at)[1], (*at)[2]);
  return header;
}

std::string layout_program(const Header& header, const std::string& path) {
  std::ostringstream out;
  out << "#include \"" << path << "\"\n#include <stdio.h>\nint main(void) {\n";
  for (const Struct& one : header.structs) {
    if (one.frozen) out << "  printf(\"sizeof " << one.name << " %zu\\n\", sizeof(" << one.name << "));\n";
    for (const auto& [member, declaration] : one.members)
      out << "  printf(\"" << one.name << "." << member << " %zu %zu\\n\", offsetof(" << one.name << ", " << member
          << "), sizeof(((" << one.name << "*)0)->" << member << "));\n";
  }
  for (const auto& [name, value] : header.constants)
    out << "  printf(\"" << name << " %lld\\n\", (long long)" << name << ");\n";
  for (const auto& [name, value] : header.texts) out << "  puts(\"" << name << " \" " << name << ");\n";
  out << "  return 0;\n}\n";
  return out.str();
}

}  // namespace wend::test
