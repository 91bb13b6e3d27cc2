// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "graph/window_system.hpp"

/// The bodies of the WindowKernels, for window_kernels.cpp to compile once per instruction set.
namespace lanefuse::window_loops {

using Id = WindowGraph::Id;

/// The components of what the four poses of a block have.
LANEFUSE_INLINE void collect(std::span<const Quad> by_pose, const std::array<Id, 4>& pose, Quad& a, Quad& b,
                             Quad& c, Quad& d) {
  a = by_pose[pose[0]];
  b = by_pose[pose[1]];
  c = by_pose[pose[2]];
  d = by_pose[pose[3]];
  transpose(a, b, c, d);
}

/// Adds four components to what the four poses of a block have.
LANEFUSE_INLINE void distribute(const Quad& x, const Quad& y, const Quad& z, const Quad& w,
                                const std::array<Id, 4>& pose, std::span<Quad> by_pose) {
  Quad a = x, b = y, c = z, d = w;
  transpose(a, b, c, d);
  // One after the other: two of the four may be one pose.
  by_pose[pose[0]] += a;
  by_pose[pose[1]] += b;
  by_pose[pose[2]] += c;
  by_pose[pose[3]] += d;
}

/// What an observation says about where its landmark is, minus where it is, and Omega in the window's frame.
struct Observed {
  Quad xx, xy, yy, ux, uy, ex, ey, eh;
};

LANEFUSE_INLINE void observe(const WindowGraph::Block& block, const WindowSystem& system,
                             const Quad& landmark, Observed& out) {
  Quad px, py, heading, none;
  collect(system.places, block.pose, px, py, heading, none);
  Quad c, s, c2, s2;
  collect(system.turns, block.pose, c, s, c2, s2);
  const Quad half = block.half * c2 - block.cross * s2;
  out.xx = block.mean + half;
  out.yy = block.mean - half;
  out.xy = block.half * s2 + block.cross * c2;
  out.ux = landmark[0] - px;
  out.uy = landmark[1] - py;
  out.ex = out.ux - (c * block.x - s * block.y);
  out.ey = out.uy - (s * block.x + c * block.y);
  out.eh = landmark[2] - heading - block.heading;
  wrap_angles(out.eh);
}

LANEFUSE_INLINE double linearize(const WindowGraph& graph, WindowSystem& system) {
  Quad cost{};
  for (std::size_t r = 0; r < system.runs.size(); ++r) {
    const LandmarkRun& run = system.runs[r];
    const Quad landmark = system.landmarks[r];
    Quad bx{}, by{}, bh{}, dxx{}, dxy{}, dyy{}, dhh{};
    Id id = graph.first_block(run.landmark);
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      const WindowGraph::Block& block = graph.block(id);
      Observed o;
      observe(block, system, landmark, o);
      const Quad wx = o.xx * o.ex + o.xy * o.ey;
      const Quad wy = o.xy * o.ex + o.yy * o.ey;
      const Quad wh = block.heading_information * o.eh;
      cost += o.ex * wx + o.ey * wy + o.eh * wh;
      bx -= wx;
      by -= wy;
      bh -= wh;
      dxx += o.xx;
      dxy += o.xy;
      dyy += o.yy;
      dhh += block.heading_information;
      LinearBlock& linear = system.linear[i];
      linear.xx = o.xx;
      linear.xy = o.xy;
      linear.yy = o.yy;
      linear.heading = block.heading_information;
      linear.ux = o.ux;
      linear.uy = o.uy;
      linear.pose = block.pose;
      distribute(wx, wy, wh + (o.ux * wy - o.uy * wx), Quad{}, block.pose, system.pose_rhs);
      id = block.next;
    }
    system.landmark_rhs[r] = Quad{sum(bx), sum(by), sum(bh), 0};
    system.information[r] = Quad{sum(dxx), sum(dxy), sum(dyy), sum(dhh)};
  }
  return sum(cost);
}

LANEFUSE_INLINE double cost(const WindowGraph& graph, const WindowSystem& system) {
  Quad cost{};
  for (std::size_t r = 0; r < system.runs.size(); ++r) {
    const Quad landmark = system.landmarks[r];
    for (Id id = graph.first_block(system.runs[r].landmark); id != WindowGraph::kNone;) {
      const WindowGraph::Block& block = graph.block(id);
      Observed o;
      observe(block, system, landmark, o);
      cost += o.ex * (o.xx * o.ex + o.xy * o.ey) + o.ey * (o.xy * o.ex + o.yy * o.ey) +
              o.eh * (block.heading_information * o.eh);
      id = block.next;
    }
  }
  return sum(cost);
}

LANEFUSE_INLINE void reduce_diagonal(WindowSystem& system) {
  for (std::size_t r = 0; r < system.runs.size(); ++r) {
    const Quad inverse = system.inverses[r];
    for (std::uint32_t i = system.runs[r].begin; i < system.runs[r].end; ++i) {
      const LinearBlock& o = system.linear[i];
      // Omega D^-1 Omega, then T' (Omega - that) T.
      const Quad ax = o.xx * inverse[0] + o.xy * inverse[1];
      const Quad ay = o.xx * inverse[1] + o.xy * inverse[2];
      const Quad bx = o.xy * inverse[0] + o.yy * inverse[1];
      const Quad by = o.xy * inverse[1] + o.yy * inverse[2];
      const Quad xx = o.xx - (ax * o.xx + ay * o.xy);
      const Quad xy = o.xy - (ax * o.xy + ay * o.yy);
      const Quad yy = o.yy - (bx * o.xy + by * o.yy);
      const Quad hh = o.heading - o.heading * inverse[3] * o.heading;
      const Quad xh = xy * o.ux - xx * o.uy;
      const Quad yh = yy * o.ux - xy * o.uy;
      distribute(xx, xy, yy, xh, o.pose, system.reduced_first);
      distribute(yh, hh + (o.ux * yh - o.uy * xh), Quad{}, Quad{}, o.pose, system.reduced_rest);
    }
  }
}

LANEFUSE_INLINE void spread_one(const LinearBlock& o, const Quad& dx, const Quad& dy, const Quad& dh,
                                std::span<Quad> by_pose) {
  const Quad wx = o.xx * dx + o.xy * dy;
  const Quad wy = o.xy * dx + o.yy * dy;
  distribute(wx, wy, o.heading * dh + (o.ux * wy - o.uy * wx), Quad{}, o.pose, by_pose);
}

LANEFUSE_INLINE void spread(WindowSystem& system, std::size_t begin, std::size_t end,
                            std::span<const Quad> by_landmark, std::span<Quad> by_pose) {
  for (std::size_t r = begin; r < end; ++r) {
    const Quad l = by_landmark[r];
    const Quad x = l[0] - Quad{}, y = l[1] - Quad{}, h = l[2] - Quad{};
    for (std::uint32_t i = system.runs[r].begin; i < system.runs[r].end; ++i)
      spread_one(system.linear[i], x, y, h, by_pose);
  }
}

/// T p of a block's poses.
LANEFUSE_INLINE void swing(const LinearBlock& o, std::span<const Quad> by_pose, Quad& x, Quad& y, Quad& h) {
  Quad none;
  collect(by_pose, o.pose, x, y, h, none);
  x -= o.uy * h;
  y += o.ux * h;
}

/// Omega T p summed over a run; T p itself is left in `swung`, three Quads a block.
LANEFUSE_INLINE void gather_run(const WindowSystem& system, const LandmarkRun& run,
                                std::span<const Quad> by_pose, Quad* swung, Quad& total) {
  Quad vx{}, vy{}, vh{};
  for (std::uint32_t i = run.begin; i < run.end; ++i, swung += 3) {
    const LinearBlock& o = system.linear[i];
    swing(o, by_pose, swung[0], swung[1], swung[2]);
    vx += o.xx * swung[0] + o.xy * swung[1];
    vy += o.xy * swung[0] + o.yy * swung[1];
    vh += o.heading * swung[2];
  }
  total = Quad{sum(vx), sum(vy), sum(vh), 0};
}

LANEFUSE_INLINE void gather(WindowSystem& system, std::size_t begin, std::size_t end,
                            std::span<const Quad> by_pose, std::span<Quad> by_landmark) {
  for (std::size_t r = begin; r < end; ++r)
    gather_run(system, system.runs[r], by_pose, system.scratch.data(), by_landmark[r]);
}

LANEFUSE_INLINE void product(WindowSystem& system, std::span<const Quad> by_pose, std::span<Quad> eliminated,
                             std::span<Quad> product) {
  for (std::size_t r = 0; r < system.untied; ++r) {
    const LandmarkRun& run = system.runs[r];
    Quad v;
    gather_run(system, run, by_pose, system.scratch.data(), v);
    const Quad inverse = system.inverses[r];
    const Quad l{inverse[0] * v[0] + inverse[1] * v[1], inverse[1] * v[0] + inverse[2] * v[1],
                 inverse[3] * v[2], 0};
    eliminated[r] = l;
    const Quad* swung = system.scratch.data();
    for (std::uint32_t i = run.begin; i < run.end; ++i, swung += 3)
      spread_one(system.linear[i], swung[0] - l[0], swung[1] - l[1], swung[2] - l[2], product);
  }
}

LANEFUSE_INLINE void rest(WindowSystem& system, std::size_t begin, std::size_t end,
                          std::span<const Quad> by_pose, std::span<const Quad> by_landmark,
                          std::span<Quad> product) {
  for (std::size_t r = begin; r < end; ++r) {
    const Quad l = by_landmark[r];
    for (std::uint32_t i = system.runs[r].begin; i < system.runs[r].end; ++i) {
      Quad x, y, h;
      swing(system.linear[i], by_pose, x, y, h);
      spread_one(system.linear[i], x - l[0], y - l[1], h - l[2], product);
    }
  }
}

}  // namespace lanefuse::window_loops
