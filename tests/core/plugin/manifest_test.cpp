#include <gtest/gtest.h>

#include <core/base/error.hpp>
#include <core/plugin/manifest.hpp>
#include <random>

namespace wend::core {
namespace {

const std::string good = R"({"wend": 1, "name": "wend-lspi", "version": "0.1.0", "license": "BSD-3-Clause",
 "components": [{"id": "wend.lspi", "summary": "Least squares.",
   "interfaces": ["wend.policy/1", "wend.learner/1", "wend.state/1", "acme.rules/2"],
   "slots": {"teacher": {"interface": "wend.values/1", "required": true, "summary": "Who teaches."},
     "avoid": {"interface": "wend.policy/1"}},
   "uses": {"world": {"interfaces": ["wend.body/1"]}}, "action": "discrete", "forwards": "avoid",
   "parameters": {"type": "object", "additionalProperties": false, "properties": {
     "gamma": {"type": "number", "minimum": 0, "exclusiveMaximum": 1, "default": 0.9}}}},
  {"id": "wend.arena", "summary": "A world.", "interfaces": ["wend.world/1"],
   "robot": {"type": "object", "properties": {}}}]})";

std::string problem(const std::string& text) {
  try {
    parse_manifest("p.so", text);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::plugin);
    return error.what();
  }
  return "";
}

TEST(Manifest, ReadsAllThatItSays) {
  const Manifest manifest = parse_manifest("p.so", good);
  EXPECT_EQ(manifest.name, "wend-lspi");
  EXPECT_EQ(manifest.version, "0.1.0");
  EXPECT_EQ(manifest.license, "BSD-3-Clause");
  EXPECT_EQ(manifest.file, "p.so");
  ASSERT_EQ(manifest.components.size(), 2u);
  const ComponentEntry& lspi = manifest.components[0];
  EXPECT_EQ(lspi.id, "wend.lspi");
  EXPECT_EQ(lspi.summary, "Least squares.");
  EXPECT_EQ(lspi.action, "discrete");
  EXPECT_TRUE(lspi.answers("wend.learner/1"));
  EXPECT_TRUE(lspi.answers("acme.rules/2"));
  EXPECT_FALSE(lspi.answers("wend.world/1"));
  EXPECT_FALSE(lspi.answers("wend.learner"));
  ASSERT_EQ(lspi.slots.size(), 2u);
  EXPECT_EQ(lspi.slots.at("teacher").interface, "wend.values/1");
  EXPECT_EQ(lspi.slots.at("teacher").summary, "Who teaches.");
  EXPECT_TRUE(lspi.slots.at("teacher").required);
  EXPECT_FALSE(lspi.slots.at("avoid").required);
  EXPECT_EQ(lspi.uses.at("world"), std::vector<std::string>{"wend.body/1"});
  EXPECT_EQ(lspi.forwards, "avoid");
  EXPECT_FALSE(lspi.privileged);
  EXPECT_EQ(lspi.parameters["properties"]["gamma"]["default"], 0.9);
  EXPECT_TRUE(lspi.robot.is_null());
  const ComponentEntry& arena = manifest.components[1];
  EXPECT_EQ(arena.action, "any");
  EXPECT_EQ(arena.parameters, Json::parse(R"({"type": "object", "properties": {}})"));
  EXPECT_EQ(arena.robot["type"], "object");
}

TEST(Manifest, RolesByTheFirstInterfaceThatCounts) {
  const auto role_of = [](std::vector<std::string> interfaces) {
    ComponentEntry entry;
    entry.id = "a";
    entry.interfaces = std::move(interfaces);
    return title(entry);
  };
  EXPECT_EQ(role_of({"wend.sensor/1", "wend.world/1"}), "world \"a\"");
  EXPECT_EQ(role_of({"wend.sensor/1"}), "sensor \"a\"");
  EXPECT_EQ(role_of({"wend.policy/1", "wend.learner/1"}), "learner \"a\"");
  EXPECT_EQ(role_of({"wend.policy/1"}), "policy \"a\"");
  EXPECT_EQ(role_of({"wend.reward/1"}), "reward \"a\"");
  EXPECT_EQ(role_of({"wend.values/1"}), "component \"a\"");
  ComponentEntry forwarding;
  forwarding.interfaces = {"wend.policy/1", "wend.learner/1"};
  forwarding.forwards = "avoid";
  EXPECT_EQ(role(forwarding), "policy");  // it learns only if what stands in its slot does
}

TEST(Manifest, APolicyThatReadsTheMapIsPrivilegedWhetherItSaysSoOrNot) {
  const auto privileged = [](const std::string& rest) {
    return parse_manifest(
               "p.so",
               R"({"wend": 1, "name": "p", "version": "1", "components": [{"id": "a", "summary": "s", )" + rest + "}]}")
        .components[0]
        .privileged;
  };
  EXPECT_TRUE(
      privileged(R"("interfaces": ["wend.policy/1"], "uses": {"world": {"interfaces": ["wend.geometry2d/1"]}})"));
  EXPECT_TRUE(privileged(R"("interfaces": ["wend.policy/1"], "privileged": true)"));
  EXPECT_FALSE(privileged(R"("interfaces": ["wend.policy/1"], "uses": {"world": {"interfaces": ["wend.body/1"]}})"));
  EXPECT_FALSE(
      privileged(R"("interfaces": ["wend.sensor/1"], "uses": {"world": {"interfaces": ["wend.geometry2d/1"]}})"));
}

TEST(Manifest, BadJsonHasAPlace) {
  EXPECT_EQ(
      problem("{\"wend\": 1,\n \"name\": NaN}"),
      "error: expected a value, found \"NaN\"\n  --> p.so (.wend.manifest):2:10  (/name)\n   2 |  \"name\": NaN}\n"
      "     |          ^^^ JSON has no NaN and no infinity");
  EXPECT_EQ(problem("[]"),
            "error: expected an object, found an empty array\n  --> p.so (.wend.manifest):1:1\n   1 |  []\n     |  ^");
}

TEST(Manifest, AnotherVersionIsRefused) {
  EXPECT_EQ(
      problem(R"({"wend": 2, "name": "p", "version": "1", "components": [{"id": "a", "summary": "s", )"
              R"("interfaces": ["wend.policy/1"]}]})"),
      "error: expected manifest version 1, found 2\n  --> p.so (.wend.manifest):1:10  (/wend)\n   1 |  {\"wend\": 2, "
      "\"name\": \"p\", \"version\": \"1\", \"components\": [{\"id\": \"a\", \"summary\": \"s\", \"interfaces\": "
      "[\"...\n"
      "     |           ^ this host is older or newer than the plugin's SDK");
}

TEST(Manifest, EveryMistakeIsTold) {
  EXPECT_EQ(
      problem("{\n\"naem\": \"p\",\n\"version\": 1,\n\"components\": []}"),
      "error: missing key \"wend\"\n  --> p.so (.wend.manifest):1:1\n   1 |  {\n     |  ^\n"
      "error: missing key \"name\"\n  --> p.so (.wend.manifest):1:1\n   1 |  {\n     |  ^\n"
      "error: unknown key \"naem\" in a manifest\n  --> p.so (.wend.manifest):2:1  (/naem)\n   2 |  \"naem\": \"p\",\n"
      "     |  ^^^^^^ did you mean \"name\"?\n"
      "error: expected a string, found 1\n  --> p.so (.wend.manifest):3:12  (/version)\n   3 |  \"version\": 1,\n"
      "     |             ^\n"
      "error: expected at least one component\n  --> p.so (.wend.manifest):4:15  (/components)\n   4 |  "
      "\"components\": []}\n"
      "     |                ^");
}

TEST(Manifest, MistakesInComponents) {
  const auto expect = [](const std::string& component, const std::string& message, const std::string& marked,
                         const std::string& pointer, const std::string& hint = "") {
    const std::size_t at = component.rfind(marked), newline = component.rfind('\n', at);
    ASSERT_NE(at, std::string::npos);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    const std::string line = component.substr(begin, component.find('\n', begin) - begin),
                      number = begin == 0 ? "2" : "3";
    const bool container = marked[0] == '{' || marked[0] == '[';
    EXPECT_EQ(problem(R"({"wend": 1, "name": "p", "version": "1", "components": [)"
                      "\n" +
                      component + "\n]}"),
              "error: " + message + "\n  --> p.so (.wend.manifest):" + number + ":" + std::to_string(at - begin + 1) +
                  "  (/components/0" + pointer + ")\n   " + number + " |  " + line + "\n     |  " +
                  std::string(at - begin, ' ') + std::string(container ? 1 : marked.size(), '^') +
                  (hint.empty() ? "" : " " + hint));
  };
  const auto with = [](const std::string& rest) {
    return R"({"id":"a","summary":"","interfaces":["wend.policy/1"],)"
           "\n" +
           rest + "}";
  };
  const auto answering = [](const std::string& list) { return R"({"id":"a","summary":"","interfaces":)" + list + "}"; };
  expect(R"({"id":"A b","summary":"","interfaces":["wend.policy/1"]})",
         "expected a name of a-z, 0-9, _ . and -, found \"A b\"", "\"A b\"", "/id");
  expect(R"({"summary":"","interfaces":["wend.policy/1"]})", "missing key \"id\"", "{", "");
  expect(with(R"("paramters":{})"), "unknown key \"paramters\" in a component", "\"paramters\"", "/paramters",
         "did you mean \"parameters\"?");
  expect(answering(R"(["wend.polcy/1"])"), "this host knows no interface \"wend.polcy/1\"", "\"wend.polcy/1\"",
         "/interfaces/0", "did you mean \"wend.policy/1\"?");
  expect(answering(R"(["wend.policy/2"])"), "this host knows no interface \"wend.policy/2\"", "\"wend.policy/2\"",
         "/interfaces/0", "did you mean \"wend.policy/1\"?");
  expect(answering(R"(["policy"])"), "expected an interface like \"wend.policy/1\", found \"policy\"", "\"policy\"",
         "/interfaces/0");
  expect(answering("[]"), "expected at least one interface", "[]", "/interfaces");
  expect(answering("[\"acme.a/1\",\n\"acme.a/1\"]"), "\"acme.a/1\" stands here twice", "\"acme.a/1\"", "/interfaces/1");
  expect(answering(R"(["wend.policy/1","wend.learner/1"])"), "a learner also answers for \"wend.state/1\"", "[",
         "/interfaces");
  expect(with(R"("slots":{"avoid":{"interfce":"wend.policy/1","interface":"wend.policy/1"}})"),
         "unknown key \"interfce\" in a slot", "\"interfce\"", "/slots/avoid/interfce", "did you mean \"interface\"?");
  expect(with(R"("slots":{"avoid":{}})"), "missing key \"interface\"", "{}", "/slots/avoid");
  expect(with(R"("slots":{"avoid":{"interface":"wend.policy/1","required":7}})"), "expected a boolean, found 7", "7",
         "/slots/avoid/required");
  expect(with(R"("uses":{"wrld":{"interfaces":["wend.body/1"]}})"), "unknown use \"wrld\"", "\"wrld\"", "/uses/wrld",
         "the host lends \"world\"");
  expect(with(R"("action":"discreet")"), "expected \"discrete\", \"continuous\" or \"any\", found \"discreet\"",
         "\"discreet\"", "/action");
  expect(with(R"("forwards":"avoid")"), "expected the name of a slot, found \"avoid\"", "\"avoid\"", "/forwards");
  expect(with(R"("robot":{"type":"object"})"), "only a world has \"robot\"", "\"robot\"", "/robot");
  expect(with(R"("parameters":{"type":"object","properties":{"a":{"type":"number","minimun":0}}})"),
         "schema: unknown keyword \"minimun\"", "\"minimun\"", "/parameters/properties/a/minimun",
         "did you mean \"minimum\"?");
  expect(with(R"("parameters":{"type":"number"})"), "expected a schema with \"type\": \"object\"", "{\"type\"",
         "/parameters");
}

TEST(Manifest, RandomDamageIsNeverFatal) {
  std::mt19937 random(13);
  const std::string alphabet = "{}[]\",:0123456789.-enaz/ ";
  int refused = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::string text = good;
    const std::size_t at = random() % text.size(), to = random() % text.size();
    if (random() % 3 == 0)
      text.erase(at, random() % 20);
    else if (random() % 2 == 0)
      text.insert(to, text.substr(at, random() % 40));
    else
      text[at] = alphabet[random() % alphabet.size()];
    refused += !problem(text).empty();
  }
  EXPECT_GT(refused, 10'000);
}

TEST(Manifest, TwoComponentsOfOneName) {
  const std::string twice = R"({"id":"a","summary":"","interfaces":["wend.policy/1"]})";
  EXPECT_EQ(
      problem("{\"wend\": 1, \"name\": \"p\", \"version\": \"1\", \"components\": [\n" + twice + ",\n" + twice + "]}"),
      "error: two components are called \"a\"\n  --> p.so (.wend.manifest):3:7  (/components/1/id)\n   3 |  " + twice +
          "]}\n     |        ^^^");
}

}  // namespace
}  // namespace wend::core
