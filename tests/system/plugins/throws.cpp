// A policy that can't do its work: what the host says of it is tested.
#include <wend/plugin.hpp>

class Throws {
 public:
  explicit Throws(const wend::Config& config) {
    if (config.params.flag("early")) throw wend::parameter_error("early", "expected false, found true");
  }
  void act(wend::Rows, wend::Matrix<const double>, wend::Matrix<double>) {
    throw wend::Error("expected to be spared, found work");
  }
};

WEND_PLUGIN(wend::component<Throws>("test.throws"))
