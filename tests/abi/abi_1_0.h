/* wend/abi.h as it was at ABI 1.0.  Never edit this file: plugins that were compiled from it must load for ever. */
/* wend/abi.h -- the stable C ABI between the wend host and its plugins.  C11, C++20; no other header.
 *
 * The rules, once, for every function below:
 *   Errors   Return WEND_OK, or the value of host->fail(...).  The message says what was expected, what was found
 *            and where.  No exception, longjmp, signal or exit crosses this line.
 *   Memory   Whoever allocates, frees.  Inputs are valid during the call.  Outputs belong to the caller.
 *            What a plugin returns by pointer (tables, spaces, strings, shapes) lives until destroy(), or until the
 *            next reset() where it says so.
 *   Threads  [any]     from any thread, concurrently.
 *            [object]  never concurrently for one object.  Different objects run in parallel, so a plugin keeps no
 *                      mutable globals.  An object may move between threads between calls.
 *   Growth   Every table starts with its size in bytes; members are only appended, never moved, removed or retyped;
 *            ask WEND_HAS before touching a member newer than /1.0.  A break is a new id ("/2").
 *            Structs marked FROZEN are array elements and never grow.
 *   Values   All values are double, all text is UTF-8 ending in NUL, angles are radians counter-clockwise.
 *   Rows     row = copy * robots + robot.  A batch names its rows in ascending order; its i-th row starts at i * width.
 *   Order    begin -> sense -> (act -> step -> sense -> score -> learn)* -> the copy's rows end.  A row that ended is
 *            stepped, sensed and learned from that once more, then never named again until its copy's next reset.
 *            learn comes before the next act.  act changes what the object knows only in the TRAIN modes.
 *            A world never resets itself.
 */
#ifndef WEND_ABI_H
#define WEND_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define WEND_ABI_MAJOR 1u
#define WEND_ABI_MINOR 0u
#define WEND_HAS(table, member)                                                                      \
  ((table) != NULL && (table)->size >= offsetof(__typeof__(*(table)), member) + sizeof (table)->member \
   && (table)->member != NULL)
#define WEND_EXPORT __attribute__((visibility("default")))

/* ------------------------------------------------------------------------------------------ status -- */

typedef int32_t wend_status;
enum {
  WEND_OK = 0,
  WEND_E_ARGUMENT = 1,    /* the caller broke a rule of this header */
  WEND_E_PARAMETER = 2,   /* a value in params cannot be used */
  WEND_E_UNSUPPORTED = 3, /* a space, slot or extension this component cannot work with */
  WEND_E_STATE = 4,       /* saved bytes are damaged, or of another component or version */
  WEND_E_INTERNAL = 5     /* a defect in the plugin */
};

typedef struct wend_sink { /* where a plugin writes bytes to */
  uint32_t size;
  void *context;
  wend_status (*write)(void *context, const void *bytes, uint64_t n);
} wend_sink;

/* -------------------------------------------------------------------------------------------- host -- */

typedef struct wend_host { /* one per object, valid until its destroy() returns */
  uint32_t size;

  /* Keeps the message for this thread and returns `code`; `param` is the path of the parameter at fault, or NULL:
   * return host->fail(host, WEND_E_PARAMETER, "rays", "expected 1..720, found 0");  [any] */
  wend_status (*fail)(const struct wend_host *host, wend_status code, const char *param, const char *message);

  /* level: 0 debug, 1 info, 2 warning.  Errors are not logged; they are returned.  [any] */
  void (*log)(const struct wend_host *host, uint32_t level, const char *message);

  /* n numbers in [0, 1) of the counter-based stream `key`, from `counter` on: a pure function.  [any] */
  void (*random)(const struct wend_host *host, uint64_t key, uint64_t counter, double *out, uint64_t n);

  /* The key of an independent stream: a pure function of its arguments.  [any] */
  uint64_t (*stream)(const struct wend_host *host, uint64_t parent, const char *name);

  /* One point of a curve that arises inside a call, such as best fitness against generation.  [any] */
  void (*series)(const struct wend_host *host, const char *x_name, double x, const char *y_name, double y);

  /* A host extension by id, or NULL.  [any] */
  const void *(*extension)(const struct wend_host *host, const char *id);
} wend_host;

/* ------------------------------------------------------------------------------------------ spaces -- */

/* FROZEN.  One column of a row: Box if count == 0 (low..high, may be infinite), else Discrete: the whole numbers
 * 0..count-1.  A Gymnasium Box(n), Discrete(k), MultiDiscrete or Tuple is a list of columns. */
typedef struct wend_column {
  double low, high;
  uint64_t count;
  double at;        /* where it was taken: the bearing of a beam in rad; 0 where that means nothing */
  const char *name; /* "goal.bearing", "range": what a policy looks its columns up by */
  const char *unit; /* "m", "rad", "m/s", "1" */
} wend_column;

typedef struct wend_space {
  uint32_t size;
  uint32_t width;
  const wend_column *columns;
} wend_space;

/* ------------------------------------------------------------------------------------- components -- */

typedef struct wend_object wend_object; /* defined by each plugin, opaque to everyone else */
struct wend_component;

typedef struct wend_ref { /* FROZEN.  A component instance as others see it. */
  wend_object *self;
  const struct wend_component *type;
} wend_ref;

/* FROZEN.  An instance by name.  In `slots` it is owned: created before its owner, destroyed after, called by the
 * owner alone.  In `uses` it is borrowed ("world"): only the functions its manifest entry asked for, between steps. */
typedef struct wend_named {
  const char *name;
  wend_ref ref;
} wend_named;

typedef struct wend_value { /* FROZEN.  One resolved parameter: no plugin needs a JSON parser. */
  const char *path; /* "axes/2" */
  const char *text; /* NULL unless it is a string */
  double number;    /* booleans are 0 and 1 */
} wend_value;

typedef struct wend_config {
  uint32_t size;
  uint32_t copies, robots;       /* independent copies of the world, robots in each that this instance serves */
  uint32_t value_count, robot_value_count, slot_count, use_count;
  const wend_value *values;      /* checked against the manifest's schema, defaults filled in, sorted by path */
  const char *params;            /* the same as JSON text */
  const wend_value *robot_values; /* worlds: the robot definition (body, kinematics, actions, ...), checked against the
                                     manifest entry's "robot" schema; else none */
  const char *robot;             /* the same as JSON text, or NULL */
  const wend_named *slots, *uses;
  uint64_t seed;                 /* parent of this instance's own streams (initial weights) */
  const wend_space *observation; /* policies, learners, rewards; else NULL */
  const wend_space *action;      /* policies, learners, rewards; else NULL */
} wend_config;

typedef struct wend_component {
  uint32_t size;
  const char *id; /* "wend.xcs", as in the manifest */

  /* On failure *out stays untouched and nothing is leaked.  [any] */
  wend_status (*create)(const wend_host *host, const wend_config *config, wend_object **out);
  void (*destroy)(wend_object *self); /* [object] */

  /* The table of interface or extension `id`, or NULL.  Same answer for the object's whole life.  A policy whose slot
   * is a learner may answer for wend.learner/1 and forward to it; its manifest says so.  [any] */
  const void *(*query)(wend_object *self, const char *id);
} wend_component;

/* ---------------------------------------------------------------------------------------- episodes -- */

enum { WEND_TEST = 0u, WEND_TRAIN_GREEDY = 1u, WEND_TRAIN_EXPLORE = 2u };

/* FROZEN.  All chance of an episode comes from its seeds, so results do not depend on batching.  A world is handed one
 * per copy; sensors, policies and rewards one per row, whose `seed` is the row's own. */
typedef struct wend_episode {
  uint64_t index; /* 0, 1, ... within the training or the test */
  uint64_t seed;  /* starts, goals, patrol phases, noise, exploration */
  uint64_t scene; /* draws the map: equal scenes are equal maps, so a world may keep what it built for one */
  uint32_t variant; /* which of the world's files ("files" parameters), from 0 */
  uint32_t mode;
} wend_episode;

enum {
  WEND_TERMINATED = 1u, /* the task ended here: no value beyond */
  WEND_TRUNCATED = 2u,  /* the time limit: the state has a value */
  WEND_COLLIDED = 4u,
  WEND_ARRIVED = 8u,
  WEND_HANDED_OVER = 16u /* s' is valid, but the next decision is another component's */
};

typedef struct wend_outcome { /* FROZEN.  What a step brought one row. */
  double reward;
  uint32_t flags, reserved;
} wend_outcome;

typedef struct wend_batch { /* n transitions; per row in the order they happened */
  uint32_t size, n;
  const uint32_t *rows;
  const double *observations, *actions, *next_observations;
  const wend_outcome *outcomes;
} wend_batch;

/* ------------------------------------------------------------------------------------------- world -- */

#define WEND_WORLD "wend.world/1"
typedef struct wend_world { /* a world without range sensors also answers WEND_SENSOR and observes itself */
  uint32_t size;
  double (*period)(wend_object *self);                                  /* s between two decisions  [object] */
  const wend_space *(*action)(wend_object *self, uint32_t robot);       /* [object] */

  /* A new episode in each named copy; `episodes` has one entry per copy.  [object] */
  wend_status (*reset)(wend_object *self, const uint32_t *copies, uint32_t n, const wend_episode *episodes);

  /* One control period in each named copy.  `actions` holds one action row and `outcomes` one outcome for every row of
   * the named copies; rows that ended are ignored and their outcomes left as they are.  [object] */
  wend_status (*step)(wend_object *self, const uint32_t *copies, uint32_t n, const double *actions, wend_outcome *outcomes);
} wend_world;

/* Extension of a world in the plane.  Between two steps its functions may be called from several threads. */
#define WEND_GEOMETRY2D "wend.geometry2d/1"
enum { WEND_NOTHING = 0u, WEND_WALL = 1u, WEND_OBSTACLE = 2u, WEND_MOVER = 4u, WEND_ROBOT = 8u, WEND_GOAL = 16u };
typedef struct wend_pose { double x, y, heading; } wend_pose;  /* FROZEN  m, m, rad */
typedef struct wend_disc { double x, y, radius; } wend_disc;   /* FROZEN  m */
enum { WEND_SHAPE_DISC = 0u, WEND_SHAPE_SEGMENTS = 1u, WEND_SHAPE_POLYGON = 2u, WEND_SHAPE_GRID = 3u };
typedef struct wend_shape { /* FROZEN.  For drawing and planning. */
  uint32_t form, kind;
  uint64_t count;       /* points, or columns << 32 | rows of a grid */
  const double *xy;     /* points; a grid's lower-left corner and cell size */
  const uint8_t *cells; /* grid: 1 is occupied, row-major from the bottom */
  double radius, vx, vy; /* radius of a disc; m/s of a mover */
} wend_shape;
typedef struct wend_geometry2d {
  uint32_t size;
  wend_status (*poses)(wend_object *world, const uint32_t *rows, uint32_t n, wend_pose *out);
  wend_status (*bodies)(wend_object *world, const uint32_t *rows, uint32_t n, wend_disc *body, wend_disc *goal);

  /* rays[i] is seen by the robot of rows[i], which does not see itself.  Distance to the first surface whose kind is in
   * `kinds`, at most `reach`, and its kind (WEND_NOTHING beyond).  A ray that starts inside a surface reads 0. */
  wend_status (*cast)(wend_object *world, const uint32_t *rows, const wend_pose *rays, uint32_t n, double reach,
                      uint32_t kinds, double *distance, uint8_t *kind);

  /* From the point xy[2i], xy[2i+1] to the nearest surface of `kinds`, negative inside. */
  wend_status (*clearance)(wend_object *world, const uint32_t *rows, const double *xy, uint32_t n, uint32_t kinds, double *out);

  wend_status (*shapes)(wend_object *world, uint32_t copy, const wend_shape **out, uint32_t *n); /* valid until reset() */
} wend_geometry2d;

/* Extension of a world: what a robot knows of its own body.  No map and no pose are in it, so a policy that uses it is
 * not privileged.  Planners ask it where an action leads.  Functions of `robot` alone are pure.  [any] */
#define WEND_BODY "wend.body/1"
typedef struct wend_motion { double x, y, heading, speed, turn_rate; } wend_motion; /* FROZEN  m, m, rad, m/s, rad/s */
typedef struct wend_limits { /* FROZEN.  Infinite where there is no limit. */
  double radius;                            /* m, of the body's disc */
  double stop_distance;                     /* m of clearance at which the world ends the episode as a collision */
  double speed_low, speed_high, turn_rate;  /* m/s, m/s, rad/s: |turn rate| <= turn_rate */
  double acceleration, turn_acceleration;   /* m/s^2, rad/s^2 */
  double turn_radius;                       /* m: of the tightest curve driven forward; 0 where it turns in place */
} wend_limits;
typedef struct wend_body {
  uint32_t size;
  wend_status (*limits)(wend_object *world, uint32_t robot, wend_limits *out);

  /* to[i] is where actions + i * action width leads from from[i] in `seconds`, in free space and without noise. */
  wend_status (*predict)(wend_object *world, uint32_t robot, const wend_motion *from, const double *actions, uint32_t n,
                         double seconds, wend_motion *to);
} wend_body;

/* Extension of a world: writes a copy's present scene in the world's own file format, so that it can be loaded again. */
#define WEND_SCENE "wend.scene/1"
typedef struct wend_scene {
  uint32_t size;
  wend_status (*write)(wend_object *world, uint32_t copy, const wend_sink *sink);
} wend_scene;

/* ------------------------------------------------------------------------- sensor, policy, learner -- */

#define WEND_SENSOR "wend.sensor/1" /* reads the world in uses "world" */
typedef struct wend_sensor {
  uint32_t size;
  const wend_space *(*space)(wend_object *self);                                                         /* [object] */
  wend_status (*begin)(wend_object *self, const uint32_t *rows, uint32_t n, const wend_episode *episodes); /* may be NULL */

  /* Writes the reading of rows[i] to out + i * stride.  [object] */
  wend_status (*sense)(wend_object *self, const uint32_t *rows, uint32_t n, double *out, uint64_t stride);
} wend_sensor;

#define WEND_POLICY "wend.policy/1"
typedef struct wend_policy {
  uint32_t size;
  wend_status (*begin)(wend_object *self, const uint32_t *rows, uint32_t n, const wend_episode *episodes); /* may be NULL */

  /* One action row for each observation row.  [object] */
  wend_status (*act)(wend_object *self, const uint32_t *rows, uint32_t n, const double *observations, double *actions);
} wend_policy;

#define WEND_LEARNER "wend.learner/1" /* an object with this table also has WEND_POLICY and WEND_STATE */
typedef struct wend_learner {
  uint32_t size;

  /* *samples_used: how many of them it learned from, the unit of a budget in samples.  [object] */
  wend_status (*learn)(wend_object *self, const wend_batch *batch, uint64_t *samples_used);

  /* The budget is spent, or a snapshot of it is to be tested; may be NULL.  LSPI solves here.  [object] */
  wend_status (*finish)(wend_object *self);
} wend_learner;

#define WEND_REWARD "wend.reward/1" /* belongs to the arm; called right after step and sense */
typedef struct wend_reward {
  uint32_t size;
  wend_status (*begin)(wend_object *self, const uint32_t *rows, uint32_t n, const wend_episode *episodes); /* may be NULL */

  /* Sets reward, and in training may add WEND_TERMINATED; the flags that metrics use stay the world's.  [object] */
  wend_status (*score)(wend_object *self, const wend_batch *batch, wend_outcome *outcomes);
} wend_reward;

/* -------------------------------------------------------------------- extensions of a policy or learner -- */

#define WEND_STATE "wend.state/1" /* what was learned: weights, rules, schedules; no random numbers (Order, episode.seed) */
typedef struct wend_state {
  uint32_t size;
  wend_status (*save)(wend_object *self, const wend_sink *sink);                 /* slots are saved by the host  [object] */
  wend_status (*load)(wend_object *self, const void *bytes, uint64_t n);         /* on failure the object is unchanged */
} wend_state;

#define WEND_VALUES "wend.values/1" /* what XCS reads from its teacher */
typedef struct wend_values {
  uint32_t size;
  wend_status (*values)(wend_object *self, const double *observations, uint32_t n, double *q, double *spread); /* n x actions */
} wend_values;

#define WEND_TELEMETRY "wend.telemetry/1" /* metrics, curves, explanations */
enum { WEND_PER_STEP = 0u, WEND_PER_EPISODE = 1u, WEND_PER_UPDATE = 2u };
typedef struct wend_telemetry { /* of a world too: its episodes' metrics, one value a row */
  uint32_t size;
  const wend_space *(*space)(wend_object *self, uint32_t when); /* NULL: nothing to tell then */

  /* n x width.  NaN: does not apply to this row, such as the length of a path that did not arrive; means leave it out.
   * PER_UPDATE tells of the whole object: n is 1 and rows is NULL. */
  wend_status (*read)(wend_object *self, uint32_t when, const uint32_t *rows, uint32_t n, double *out);
  wend_status (*text)(wend_object *self, uint32_t row, const wend_sink *sink); /* why, for a person; may be NULL */
} wend_telemetry;

/* ----------------------------------------------------------------------------------------- plugin -- */

typedef struct wend_plugin {
  uint32_t size;
  uint32_t abi_major, abi_minor;
  uint32_t component_count;
  const wend_component *const *components;
} wend_plugin;

/* The one exported symbol.  Its manifest is the JSON text of the ELF section ".wend.manifest", which the host reads
 * without loading the file: no code of a plugin runs before it is chosen. */
WEND_EXPORT extern const wend_plugin wend_plugin_1;

#ifdef __cplusplus
}
#endif
#endif
