// The tables of results.sqlite.  "row" in trainings and cells numbers the attempts; episodes, metrics and curves refer
// to it.
#pragma once

namespace wend::core {

constexpr int schema_application = 0x77656e64;  // "wend"
constexpr int schema_version = 2;

constexpr const char* schema = R"(
CREATE TABLE provenance(
  session INTEGER PRIMARY KEY, build_id TEXT NOT NULL, build TEXT NOT NULL, details TEXT NOT NULL);
CREATE TABLE trainings(
  row INTEGER PRIMARY KEY, id TEXT NOT NULL, attempt INTEGER NOT NULL,
  status TEXT NOT NULL CHECK(status IN ('ok', 'failed')), cause TEXT, message TEXT,
  session INTEGER NOT NULL REFERENCES provenance, arm TEXT, point TEXT, seed INTEGER,
  hash TEXT, final_state TEXT, snapshots TEXT, traces TEXT, samples INTEGER, steps INTEGER, episodes INTEGER, train_s REAL,
  description TEXT NOT NULL, UNIQUE(id, attempt));
CREATE TABLE cells(
  row INTEGER PRIMARY KEY, id TEXT NOT NULL, attempt INTEGER NOT NULL,
  status TEXT NOT NULL CHECK(status IN ('ok', 'failed')), cause TEXT, message TEXT,
  session INTEGER NOT NULL REFERENCES provenance, arm TEXT, point TEXT, seed INTEGER,
  world TEXT, variant INTEGER, at TEXT, training TEXT, metrics TEXT, traces TEXT, decision_us REAL,
  description TEXT NOT NULL, UNIQUE(id, attempt));
CREATE TABLE episodes(
  cell INTEGER NOT NULL REFERENCES cells, episode INTEGER NOT NULL, robot INTEGER NOT NULL,
  flags INTEGER NOT NULL, steps INTEGER NOT NULL, reward REAL, hash TEXT NOT NULL,
  PRIMARY KEY(cell, episode, robot)) WITHOUT ROWID;
CREATE TABLE metrics(
  cell INTEGER NOT NULL REFERENCES cells, episode INTEGER NOT NULL, robot INTEGER NOT NULL,
  name TEXT NOT NULL, value REAL NOT NULL, PRIMARY KEY(cell, episode, robot, name)) WITHOUT ROWID;
CREATE TABLE curves(
  training INTEGER NOT NULL REFERENCES trainings, curve INTEGER NOT NULL, point INTEGER NOT NULL,
  metric TEXT NOT NULL, robot INTEGER, x_name TEXT NOT NULL, x REAL, y REAL,
  PRIMARY KEY(training, curve, point)) WITHOUT ROWID;
CREATE TABLE cell_curves(
  cell INTEGER NOT NULL REFERENCES cells, curve INTEGER NOT NULL, point INTEGER NOT NULL,
  metric TEXT NOT NULL, robot INTEGER, x_name TEXT NOT NULL, x REAL, y REAL,
  PRIMARY KEY(cell, curve, point)) WITHOUT ROWID;
)";

}  // namespace wend::core
