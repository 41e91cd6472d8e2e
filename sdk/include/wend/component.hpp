// wend/component.hpp -- the C tables of a C++ class, generated from the members that the class has.
//
//   class Greedy {
//    public:
//     explicit Greedy(const wend::Config&);
//     void act(wend::Rows, wend::Matrix<const double> observations, wend::Matrix<double> actions);
//   };
//   WEND_PLUGIN(wend::component<Greedy>("my.greedy"))
//
// Members, by interface (those in brackets may be left out):
//   world      double period()  const Columns& action(robot)  void reset(Rows copies, Episodes)
//              void step(Rows copies, Matrix<const double> actions, std::span<wend_outcome>)
//   sensor     const Columns& columns()  void sense(Rows, Matrix<double> out)  [void begin(Rows, Episodes)]
//   policy     void act(Rows, Matrix<const double> observations, Matrix<double> actions)  [begin]
//   learner    std::uint64_t learn(const Batch&)  [void finish()]
//   reward     void score(const Batch&, std::span<wend_outcome>)  [begin]
//   state      void save(Writer&)  void load(Reader&)
//   values     void values(Matrix<const double> observations, Matrix<double> q, Matrix<double> spread)
//   telemetry  const Columns* telemetry(when)  void read(when, Rows, Matrix<double> out)  [void explain(row, Writer&)]
//   geometry2d poses, bodies, cast, clearance, shapes      body  limits, predict      scene  write_scene
// A class that answers for less than its members say has `bool answers(std::string_view interface) const`.
#pragma once
#include <wend/bytes.hpp>
#include <wend/config.hpp>

#include <cstring>

namespace wend {
namespace detail {

// What stands behind a wend_object: the C++ object and what its calls need to know of the host.
template <class T>
struct Object {
  Object(const wend_host* h, const wend_config* c)
      : host(h), observation_width(c->observation ? c->observation->width : 0),
        action_width(c->action ? c->action->width : 0), robots(c->robots), value(Config(h, c)) {}
  const wend_host* host;
  std::size_t observation_width, action_width;
  std::uint32_t robots;
  T value;
};

template <class T>
Object<T>& of(wend_object* self) noexcept {
  return *reinterpret_cast<Object<T>*>(self);
}
template <class T, class Body>
wend_status call(wend_object* self, Body&& body) noexcept {
  return guarded(of<T>(self).host, [&] { body(of<T>(self).value); });
}

// ---- begin: shared by sensors, policies and rewards
template <class T>
concept Begins = requires(T t, Rows rows, Episodes episodes) { t.begin(rows, episodes); };
template <class T>
wend_status begin(wend_object* self, const std::uint32_t* rows, std::uint32_t n, const wend_episode* episodes) {
  return call<T>(self, [&](T& t) { t.begin({rows, n}, {episodes, n}); });
}
template <class T>
constexpr auto begin_or_null() noexcept -> wend_status (*)(wend_object*, const std::uint32_t*, std::uint32_t, const wend_episode*) {
  if constexpr (Begins<T>) return &begin<T>;
  else return nullptr;
}

// ---- the interfaces, each: has the class its members, and its table
template <class T>
concept World = requires(T t, Rows copies, Episodes e, Matrix<const double> a, std::span<wend_outcome> o) {
  t.period(), t.action(0u).table(), t.reset(copies, e), t.step(copies, a, o);
};
template <class T>
inline constexpr wend_world world_table{
    sizeof(wend_world), [](wend_object* self) { return static_cast<double>(of<T>(self).value.period()); },
    [](wend_object* self, std::uint32_t robot) -> const wend_space* { return of<T>(self).value.action(robot).table(); },
    [](wend_object* self, const std::uint32_t* copies, std::uint32_t n, const wend_episode* episodes) {
      return call<T>(self, [&](T& t) { t.reset(Rows{copies, n}, Episodes{episodes, n}); });
    },
    [](wend_object* self, const std::uint32_t* copies, std::uint32_t n, const double* actions, wend_outcome* outcomes) {
      return call<T>(self, [&](T& t) {
        const std::size_t rows = std::size_t{n} * of<T>(self).robots;
        t.step(Rows{copies, n}, Matrix<const double>(actions, rows, t.action(0u).width()), std::span(outcomes, rows));
      });
    }};

template <class T>
concept Sensor = requires(T t, Rows rows, Matrix<double> out) { t.columns().table(), t.sense(rows, out); };
template <class T>
inline constexpr wend_sensor sensor_table{
    sizeof(wend_sensor), [](wend_object* self) -> const wend_space* { return of<T>(self).value.columns().table(); },
    begin_or_null<T>(), [](wend_object* self, const std::uint32_t* rows, std::uint32_t n, double* out, std::uint64_t stride) {
      return call<T>(self, [&](T& t) { t.sense(Rows{rows, n}, Matrix<double>(out, n, t.columns().width(), stride)); });
    }};

template <class T>
concept Policy = requires(T t, Rows rows, Matrix<const double> o, Matrix<double> a) { t.act(rows, o, a); };
template <class T>
inline constexpr wend_policy policy_table{
    sizeof(wend_policy), begin_or_null<T>(),
    [](wend_object* self, const std::uint32_t* rows, std::uint32_t n, const double* observations, double* actions) {
      const auto& object = of<T>(self);
      return call<T>(self, [&](T& t) {
        t.act(Rows{rows, n}, Matrix<const double>(observations, n, object.observation_width),
              Matrix<double>(actions, n, object.action_width));
      });
    }};

template <class T>
concept Learner = requires(T t, const Batch& batch) { static_cast<std::uint64_t>(t.learn(batch)); };
template <class T>
concept Finishes = requires(T t) { t.finish(); };
template <class T>
constexpr auto finish_or_null() noexcept -> wend_status (*)(wend_object*) {
  if constexpr (Finishes<T>) return [](wend_object* self) { return call<T>(self, [](T& t) { t.finish(); }); };
  else return nullptr;
}
template <class T>
inline constexpr wend_learner learner_table{
    sizeof(wend_learner),
    [](wend_object* self, const wend_batch* batch, std::uint64_t* samples_used) {
      const auto& object = of<T>(self);
      return call<T>(self, [&](T& t) { *samples_used = t.learn(Batch(*batch, object.observation_width, object.action_width)); });
    },
    finish_or_null<T>()};

template <class T>
concept Reward = requires(T t, const Batch& batch, std::span<wend_outcome> outcomes) { t.score(batch, outcomes); };
template <class T>
inline constexpr wend_reward reward_table{
    sizeof(wend_reward), begin_or_null<T>(), [](wend_object* self, const wend_batch* batch, wend_outcome* outcomes) {
      const auto& object = of<T>(self);
      return call<T>(self, [&](T& t) {
        t.score(Batch(*batch, object.observation_width, object.action_width), std::span(outcomes, batch->n));
      });
    }};

template <class T>
concept State = requires(T t, Writer& writer, Reader& reader) { t.save(writer), t.load(reader); };
template <class T>
inline constexpr wend_state state_table{
    sizeof(wend_state),
    [](wend_object* self, const wend_sink* sink) {
      return call<T>(self, [&](T& t) {
        Writer writer(sink);
        t.save(writer);
      });
    },
    [](wend_object* self, const void* bytes, std::uint64_t n) {
      return call<T>(self, [&](T& t) {
        Reader reader(bytes, n);
        t.load(reader);
      });
    }};

template <class T>
concept Values = requires(T t, Matrix<const double> o, Matrix<double> q) { t.values(o, q, q); };
template <class T>
inline constexpr wend_values values_table{
    sizeof(wend_values), [](wend_object* self, const double* observations, std::uint32_t n, double* q, double* spread) {
      const auto& object = of<T>(self);
      return call<T>(self, [&](T& t) {
        const std::size_t actions = t.value_actions();
        t.values(Matrix<const double>(observations, n, object.observation_width), Matrix<double>(q, n, actions),
                 Matrix<double>(spread, n, actions));
      });
    }};

template <class T>
concept Telemetry = requires(T t, Rows rows, Matrix<double> out) {
  static_cast<const Columns*>(t.telemetry(0u)), t.read(0u, rows, out);
};
template <class T>
concept Explains = requires(T t, Writer& writer) { t.explain(0u, writer); };
template <class T>
constexpr auto explain_or_null() noexcept -> wend_status (*)(wend_object*, std::uint32_t, const wend_sink*) {
  if constexpr (Explains<T>)
    return [](wend_object* self, std::uint32_t row, const wend_sink* sink) {
      return call<T>(self, [&](T& t) {
        Writer writer(sink);
        t.explain(row, writer);
      });
    };
  else return nullptr;
}
template <class T>
inline constexpr wend_telemetry telemetry_table{
    sizeof(wend_telemetry),
    [](wend_object* self, std::uint32_t when) -> const wend_space* {
      const Columns* columns = of<T>(self).value.telemetry(when);
      return columns ? columns->table() : nullptr;
    },
    [](wend_object* self, std::uint32_t when, const std::uint32_t* rows, std::uint32_t n, double* out) {
      return call<T>(self, [&](T& t) {
        const Columns* columns = t.telemetry(when);
        if (columns) t.read(when, Rows{rows, rows ? n : 0}, Matrix<double>(out, n, columns->width()));
      });
    },
    explain_or_null<T>()};

template <class T>
concept Geometry = requires(T t, Rows rows, std::span<wend_pose> poses) { t.poses(rows, poses), t.shapes(0u); };
template <class T>
inline constexpr wend_geometry2d geometry_table{
    sizeof(wend_geometry2d),
    [](wend_object* world, const std::uint32_t* rows, std::uint32_t n, wend_pose* out) {
      return call<T>(world, [&](T& t) { t.poses(Rows{rows, n}, std::span(out, n)); });
    },
    [](wend_object* world, const std::uint32_t* rows, std::uint32_t n, wend_disc* body, wend_disc* goal) {
      return call<T>(world, [&](T& t) { t.bodies(Rows{rows, n}, std::span(body, n), std::span(goal, n)); });
    },
    [](wend_object* world, const std::uint32_t* rows, const wend_pose* rays, std::uint32_t n, double reach, std::uint32_t kinds,
       double* distance, std::uint8_t* kind) {
      return call<T>(world, [&](T& t) { t.cast(Rows{rows, n}, std::span(rays, n), reach, kinds, distance, kind); });
    },
    [](wend_object* world, const std::uint32_t* rows, const double* xy, std::uint32_t n, std::uint32_t kinds, double* out) {
      return call<T>(world, [&](T& t) { t.clearance(Rows{rows, n}, std::span(xy, 2 * std::size_t{n}), kinds, std::span(out, n)); });
    },
    [](wend_object* world, std::uint32_t copy, const wend_shape** out, std::uint32_t* n) {
      return call<T>(world, [&](T& t) {
        const std::span<const wend_shape> shapes = t.shapes(copy);
        *out = shapes.data();
        *n = static_cast<std::uint32_t>(shapes.size());
      });
    }};

template <class T>
concept Body = requires(T t) { static_cast<wend_limits>(t.limits(0u)); };
template <class T>
inline constexpr wend_body body_table{
    sizeof(wend_body),
    [](wend_object* world, std::uint32_t robot, wend_limits* out) { return call<T>(world, [&](T& t) { *out = t.limits(robot); }); },
    [](wend_object* world, std::uint32_t robot, const wend_motion* from, const double* actions, std::uint32_t n, double seconds,
       wend_motion* to) {
      return call<T>(world, [&](T& t) {
        t.predict(robot, std::span(from, n), Matrix<const double>(actions, n, t.action(robot).width()), seconds, std::span(to, n));
      });
    }};

template <class T>
concept Scene = requires(T t, Writer& writer) { t.write_scene(0u, writer); };
template <class T>
inline constexpr wend_scene scene_table{sizeof(wend_scene), [](wend_object* world, std::uint32_t copy, const wend_sink* sink) {
                                          return call<T>(world, [&](T& t) {
                                            Writer writer(sink);
                                            t.write_scene(copy, writer);
                                          });
                                        }};

template <class T>
const void* query(wend_object* self, const char* id) {
  if constexpr (requires(const T& t, std::string_view name) { static_cast<bool>(t.answers(name)); })
    if (!of<T>(self).value.answers(id)) return nullptr;
  const auto is = [id](const char* name) { return std::strcmp(id, name) == 0; };
  if constexpr (World<T>) if (is(WEND_WORLD)) return &world_table<T>;
  if constexpr (Sensor<T>) if (is(WEND_SENSOR)) return &sensor_table<T>;
  if constexpr (Policy<T>) if (is(WEND_POLICY)) return &policy_table<T>;
  if constexpr (Learner<T>) if (is(WEND_LEARNER)) return &learner_table<T>;
  if constexpr (Reward<T>) if (is(WEND_REWARD)) return &reward_table<T>;
  if constexpr (State<T>) if (is(WEND_STATE)) return &state_table<T>;
  if constexpr (Values<T>) if (is(WEND_VALUES)) return &values_table<T>;
  if constexpr (Telemetry<T>) if (is(WEND_TELEMETRY)) return &telemetry_table<T>;
  if constexpr (Geometry<T>) if (is(WEND_GEOMETRY2D)) return &geometry_table<T>;
  if constexpr (Body<T>) if (is(WEND_BODY)) return &body_table<T>;
  if constexpr (Scene<T>) if (is(WEND_SCENE)) return &scene_table<T>;
  (void)is;
  return nullptr;
}

}  // namespace detail

// The component of class T under the id of its manifest entry.
template <class T>
constexpr wend_component component(const char* id) noexcept {
  return {sizeof(wend_component), id,
          [](const wend_host* host, const wend_config* config, wend_object** out) {
            return guarded(host, [&] { *out = reinterpret_cast<wend_object*>(new detail::Object<T>(host, config)); });
          },
          [](wend_object* self) { delete reinterpret_cast<detail::Object<T>*>(self); }, &detail::query<T>};
}

namespace detail {

// The one table that a plugin exports, around its components.
template <std::size_t N>
struct Exported {
  wend_component components[N];
  const wend_component* pointers[N];
  template <class... C>
  constexpr explicit Exported(C... all) : components{all...}, pointers{} {
    for (std::size_t i = 0; i < N; ++i) pointers[i] = &components[i];
  }
};
template <class... C>
Exported(C...) -> Exported<sizeof...(C)>;

}  // namespace detail
}  // namespace wend

// Exports the components, once in a plugin: WEND_PLUGIN(wend::component<A>("my.a"), wend::component<B>("my.b"))
#define WEND_PLUGIN(...)                                                                                           \
  static constinit const wend::detail::Exported wend_exported{__VA_ARGS__};                                       \
  extern "C" WEND_EXPORT constinit const wend_plugin wend_plugin_1{                                               \
      sizeof(wend_plugin), WEND_ABI_MAJOR, WEND_ABI_MINOR, sizeof wend_exported.pointers / sizeof(wend_component*), \
      wend_exported.pointers};
