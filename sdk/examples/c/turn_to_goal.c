/* A policy in C: action 1 turns left, 2 right, 0 goes straight on. */
#include <stdlib.h>
#include <string.h>
#include <wend/abi.h>

struct wend_object {
  uint32_t width, bearing; /* of an observation row; its column "goal.bearing" */
  double tolerance;        /* rad */
};

static wend_status create(const wend_host *host, const wend_config *config, wend_object **out) {
  wend_object policy = {config->observation->width, 0, 0.1};
  while (policy.bearing < policy.width && strcmp(config->observation->columns[policy.bearing].name, "goal.bearing") != 0)
    ++policy.bearing;
  if (policy.bearing == policy.width)
    return host->fail(host, WEND_E_UNSUPPORTED, NULL, "expected a column goal.bearing, found none");
  if (config->action->columns[0].count < 3)
    return host->fail(host, WEND_E_UNSUPPORTED, NULL, "expected at least 3 discrete actions");
  for (uint32_t i = 0; i < config->value_count; ++i)
    if (strcmp(config->values[i].path, "tolerance") == 0) policy.tolerance = config->values[i].number;
  wend_object *self = malloc(sizeof *self);
  if (self == NULL) return host->fail(host, WEND_E_INTERNAL, NULL, "out of memory");
  *self = policy;
  *out = self;
  return WEND_OK;
}

static void destroy(wend_object *self) { free(self); }

static wend_status act(wend_object *self, const uint32_t *rows, uint32_t n, const double *observations, double *actions) {
  (void)rows;
  for (uint32_t i = 0; i < n; ++i) {
    const double bearing = observations[(size_t)i * self->width + self->bearing];
    actions[i] = bearing > self->tolerance ? 1 : bearing < -self->tolerance ? 2 : 0;
  }
  return WEND_OK;
}

static const void *query(wend_object *self, const char *id) {
  static const wend_policy policy = {sizeof policy, NULL, act};
  (void)self;
  return strcmp(id, WEND_POLICY) == 0 ? &policy : NULL;
}

static const wend_component component = {sizeof component, "example.turn_to_goal_c", create, destroy, query};
static const wend_component *const components[] = {&component};
const wend_plugin wend_plugin_1 = {sizeof wend_plugin_1, WEND_ABI_MAJOR, WEND_ABI_MINOR, 1, components};
