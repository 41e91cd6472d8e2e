#include "fixture.hpp"

namespace wend::core {
namespace {

class WorkTest : public RunTest {
 protected:
  Request request(Request::Kind kind, const Json& unit) {
    Request request;
    request.kind = kind;
    request.unit = unit;
    request.plugins = test_plugins();
    request.scratch = folder_;
    return request;
  }
  std::string outcome(const Request& request) {
    const Answer answer = perform(request, libraries_);
    return answer.ok ? "ok" : answer.failure.cause + ": " + answer.failure.message;
  }
};

TEST_F(WorkTest, RequestsAndAnswersTravelAsJson) {
  Request request = this->request(Request::Kind::training, training_of(counter(), table(), {"episodes", 2}));
  request.state = "a/b", request.state_name = "b", request.batch = 3;
  EXPECT_EQ(Json(Json(request).get<Request>()), Json(request));
  Answer answer;
  answer.failure = {"rule", "text"};
  answer.warnings = {"one"};
  EXPECT_EQ(Json(Json(answer).get<Answer>()), Json(answer));
}

TEST_F(WorkTest, DoesEachKind) {
  EXPECT_EQ(outcome(request(Request::Kind::cell, cell_of(counter(), script()))), "ok");
  EXPECT_EQ(outcome(request(Request::Kind::check, cell_of(counter(), script({{"fail_at", 0}})))), "ok");
  EXPECT_EQ(outcome(request(Request::Kind::training, training_of(counter(), table(), {"episodes", 2}))), "ok");
  EXPECT_EQ(
      outcome(request(Request::Kind::scene, {{"type", "test.counter"}, {"params", counter().params}, {"key", 1}})),
      "rule: world (test.counter): expected the extension wend.scene/1, found none: its scenes cannot be written");
  EXPECT_EQ(outcome(request(Request::Kind::cell, Json::object())).substr(0, 6), "host: ");
}

TEST_F(WorkTest, NamesAStateThatCannotBeUsed) {
  Request cell = request(Request::Kind::cell, cell_of(counter(), table()));
  cell.state = folder_ + "/empty.state", cell.state_name = "states/empty.state";
  write_file(cell.state, "");
  EXPECT_EQ(outcome(cell), "state: states/empty.state: expected a state, found an empty file");
  cell.state = folder_ + "/absent.state";
  EXPECT_EQ(outcome(cell), "host: cannot read " + cell.state + ": No such file or directory");
}

TEST_F(WorkTest, TurnsExceptionsOfPluginsIntoFailures) {
  const auto doing = [&](const char* deed) {
    return outcome(request(Request::Kind::cell, cell_of(counter(), bad(deed))));
  };
  EXPECT_EQ(doing("nothing"), "ok");
  EXPECT_EQ(doing("throw"), "rule: a plugin let an exception out, expected a status: thrown across");
  EXPECT_EQ(doing("throw_int"), "rule: a plugin let an exception out, expected a status: it is no std::exception");
  EXPECT_EQ(doing("bad_alloc"), "memory: out of memory");
  EXPECT_EQ(doing("rounding"), "rule: a plugin changed the process's floating-point rounding and did not put it back");
  EXPECT_EQ(doing("flush"), "rule: a plugin changed the process's floating-point rounding and did not put it back");
  EXPECT_EQ(doing("locale"), "rule: a plugin changed the process's locale and did not put it back");
  EXPECT_EQ(doing("chdir"), "rule: a plugin changed the process's working directory and did not put it back");
  EXPECT_EQ(doing("nothing"), "ok");
}

}  // namespace
}  // namespace wend::core
