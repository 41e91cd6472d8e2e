/* Compiled from the header of ABI 1.0, not from today's: a world that observes itself, and a learner with a state and
 * telemetry.  It uses whatever a plugin of that day could have used, and today's host has to run it. */
#include <stdlib.h>
#include <string.h>

#include "abi_1_0.h"

#define MOST 64
struct wend_object {
  const wend_host* host;
  uint64_t cells, *at, *steps; /* of each row: its cell, or the stream of its episode */
  uint32_t rows, actions, explore;
  double rate, q[MOST];
};

static double value(const wend_config* config, const char* path, double otherwise) {
  for (uint32_t i = 0; i < config->value_count; ++i)
    if (strcmp(config->values[i].path, path) == 0) return config->values[i].number;
  return otherwise;
}

static wend_object* blank(const wend_host* host, const wend_config* config) {
  wend_object* self = calloc(1, sizeof *self);
  self->host = host;
  self->rows = config->copies * config->robots;
  self->at = calloc(self->rows, sizeof *self->at);
  self->steps = calloc(self->rows, sizeof *self->steps);
  return self;
}

static void destroy(wend_object* self) {
  free(self->at);
  free(self->steps);
  free(self);
}

/* ------------------------------------------------------------------------------------------ the world */

static wend_status create_line(const wend_host* host, const wend_config* config, wend_object** out) {
  if (!WEND_HAS(host, extension) || config->size < sizeof(wend_config))
    return host->fail(host, WEND_E_INTERNAL, NULL, "expected a host of 1.0 or later");
  *out = blank(host, config);
  (*out)->cells = (uint64_t)value(config, "cells", 12);
  return WEND_OK;
}

static double period(wend_object* self) {
  return self ? 1.0 : 0.0;
}

static const wend_space* action(wend_object* self, uint32_t robot) {
  static const wend_column column = {0, 2, 3, 0, "move", "1"};
  static const wend_space space = {sizeof space, 1, &column};
  (void)self, (void)robot;
  return &space;
}

static wend_status reset(wend_object* self, const uint32_t* copies, uint32_t n, const wend_episode* episodes) {
  for (uint32_t i = 0; i < n; ++i) {
    double start;
    self->host->random(self->host, self->host->stream(self->host, episodes[i].seed, "start"), 0, &start, 1);
    self->at[copies[i]] = (uint64_t)(start * (double)(self->cells / 2));
    self->steps[copies[i]] = 0;
  }
  return WEND_OK;
}

static wend_status step(wend_object* self, const uint32_t* copies, uint32_t n, const double* actions,
                        wend_outcome* outcomes) {
  for (uint32_t i = 0; i < n; ++i) {
    uint64_t* at = &self->at[copies[i]];
    if (actions[i] == 2) ++*at;
    if (actions[i] == 1 && *at > 0) --*at;
    const int arrived = *at + 1 >= self->cells, late = ++self->steps[copies[i]] >= 200;
    outcomes[i] = (wend_outcome){arrived ? 1.0 : actions[i] == 2 ? 0.1 : 0.0, 0, 0};
    if (arrived)
      outcomes[i].flags = WEND_TERMINATED | WEND_ARRIVED;
    else if (late)
      outcomes[i].flags = WEND_TRUNCATED;
  }
  return WEND_OK;
}

static const wend_space* seen(wend_object* self) {
  static const wend_column column = {0, 1000, 0, 0, "cell", "1"};
  static const wend_space space = {sizeof space, 1, &column};
  (void)self;
  return &space;
}

static wend_status sense(wend_object* self, const uint32_t* rows, uint32_t n, double* out, uint64_t stride) {
  for (uint32_t i = 0; i < n; ++i) out[i * stride] = (double)self->at[rows[i]];
  return WEND_OK;
}

static const void* query_line(wend_object* self, const char* id) {
  static const wend_world world = {sizeof world, period, action, reset, step};
  static const wend_sensor sensor = {sizeof sensor, seen, NULL, sense};
  (void)self;
  return strcmp(id, WEND_WORLD) == 0 ? (const void*)&world : strcmp(id, WEND_SENSOR) == 0 ? (const void*)&sensor : NULL;
}

/* ---------------------------------------------------------------------------------------- the learner */

static wend_status create_bandit(const wend_host* host, const wend_config* config, wend_object** out) {
  if (config->action == NULL || config->action->columns[0].count == 0 || config->action->columns[0].count > MOST)
    return host->fail(host, WEND_E_UNSUPPORTED, NULL, "expected 1..64 discrete actions");
  *out = blank(host, config);
  (*out)->rate = value(config, "rate", 0.1);
  (*out)->actions = (uint32_t)config->action->columns[0].count;
  return WEND_OK;
}

static wend_status begin(wend_object* self, const uint32_t* rows, uint32_t n, const wend_episode* episodes) {
  for (uint32_t i = 0; i < n; ++i) self->at[rows[i]] = episodes[i].seed, self->steps[rows[i]] = 0;
  self->explore = n > 0 && episodes[0].mode == WEND_TRAIN_EXPLORE;
  return WEND_OK;
}

static wend_status act(wend_object* self, const uint32_t* rows, uint32_t n, const double* observations,
                       double* actions) {
  (void)observations;
  for (uint32_t i = 0; i < n; ++i) {
    uint32_t best = 0;
    for (uint32_t a = 1; a < self->actions; ++a)
      if (self->q[a] > self->q[best]) best = a;
    double u[2];
    self->host->random(self->host, self->at[rows[i]], 2 * self->steps[rows[i]]++, u, 2);
    actions[i] = self->explore && u[0] < 0.3 ? (double)(uint32_t)(u[1] * self->actions) : best;
  }
  return WEND_OK;
}

static wend_status learn(wend_object* self, const wend_batch* batch, uint64_t* used) {
  for (uint32_t i = 0; i < batch->n; ++i) {
    double* q = &self->q[(uint32_t)batch->actions[i]];
    *q += self->rate * (batch->outcomes[i].reward - *q);
  }
  *used = batch->n;
  return WEND_OK;
}

static wend_status save(wend_object* self, const wend_sink* sink) {
  return sink->write(sink->context, self->q, sizeof self->q);
}

static wend_status load(wend_object* self, const void* bytes, uint64_t n) {
  if (n != sizeof self->q) return self->host->fail(self->host, WEND_E_STATE, NULL, "expected 64 values");
  memcpy(self->q, bytes, sizeof self->q);
  return WEND_OK;
}

static const wend_space* told(wend_object* self, uint32_t when) {
  static const wend_column column = {0, 0, 0, 0, "best_q", "1"};
  static const wend_space space = {sizeof space, 1, &column};
  (void)self;
  return when == WEND_PER_EPISODE ? &space : NULL;
}

static wend_status read(wend_object* self, uint32_t when, const uint32_t* rows, uint32_t n, double* out) {
  (void)when, (void)rows;
  for (uint32_t i = 0; i < n; ++i) {
    out[i] = self->q[0];
    for (uint32_t a = 1; a < self->actions; ++a)
      if (self->q[a] > out[i]) out[i] = self->q[a];
  }
  return WEND_OK;
}

static const void* query_bandit(wend_object* self, const char* id) {
  static const wend_policy policy = {sizeof policy, begin, act};
  static const wend_learner learner = {sizeof learner, learn, NULL};
  static const wend_state state = {sizeof state, save, load};
  static const wend_telemetry telemetry = {sizeof telemetry, told, read, NULL};
  (void)self;
  if (strcmp(id, WEND_POLICY) == 0) return &policy;
  if (strcmp(id, WEND_LEARNER) == 0) return &learner;
  if (strcmp(id, WEND_STATE) == 0) return &state;
  return strcmp(id, WEND_TELEMETRY) == 0 ? &telemetry : NULL;
}

static const wend_component bandit = {sizeof bandit, "test.bandit", create_bandit, destroy, query_bandit};
static const wend_component line = {sizeof line, "test.line", create_line, destroy, query_line};
static const wend_component* const components[] = {&bandit, &line};
const wend_plugin wend_plugin_1 = {sizeof wend_plugin_1, WEND_ABI_MAJOR, WEND_ABI_MINOR, 2, components};
