// Where on a path a point is.
#include "track.hpp"

#include <gtest/gtest.h>

#include <cmath>

using ga::Track;

TEST(Track, FeetOnAnL) {
  const Track track({{0, 0}, {4, 0}, {4, 3}});
  EXPECT_EQ(track.length(), 7);
  EXPECT_EQ(track.foot({1, 2}, 0, 7).way, 1);
  EXPECT_EQ(track.foot({1, 2}, 0, 7).distance, 2);
  EXPECT_EQ(track.foot({5, 1}, 0, 7).way, 5);
  EXPECT_EQ(track.foot({5, -1}, 0, 7).way, 4);
  EXPECT_NEAR(track.foot({5, -1}, 0, 7).distance, std::sqrt(2), 1e-12);
  EXPECT_EQ(track.foot({-1, 0}, 0, 7).way, 0);
  EXPECT_EQ(track.foot({9, 9}, 0, 7).way, 7);
}

TEST(Track, TheWindowTellsCrossingLegsApart) {
  const Track track({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, -2}});  // the last leg crosses the first at way 2 and 10
  EXPECT_EQ(track.foot({2, 0.25}, 0, 3).way, 2);
  EXPECT_EQ(track.foot({2, 0.25}, 8, 12).way, 9.75);
  EXPECT_EQ(track.foot({0, 0}, 3, 5).way, 3) << "not behind the window";
  EXPECT_EQ(track.foot({2, 0}, 3, 5).distance, 1);
}

TEST(Track, PointsAlongIt) {
  const Track track({{0, 0}, {4, 0}, {4, 0}, {4, 3}});  // with a leg of no length
  EXPECT_EQ(track.at(0).x, 0);
  EXPECT_EQ(track.at(1.5).x, 1.5);
  EXPECT_EQ(track.at(4).x, 4);
  EXPECT_EQ(track.at(6).y, 2);
  EXPECT_EQ(track.at(100).y, 3);
  EXPECT_EQ(track.foot({4, 2}, 0, 7).way, 6);
  const Track point({{1, 1}, {1, 1}});
  EXPECT_EQ(point.length(), 0);
  EXPECT_EQ(point.foot({1, 3}, 0, 0).distance, 2);
  EXPECT_EQ(point.at(1).x, 1);
}
