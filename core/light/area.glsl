// SPDX-License-Identifier: Apache-2.0
// Area lights: a piece of four corners lights a surface point. Based on:
//   Heitz, Dupuy, Hill and Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines"
//   Baum, Rushmeier and Winget 1989: the form factor of a polygon as a sum over its edges
//   Abramowitz and Stegun 1964, 4.4.49: the arc tangent
// Corners and directions are in the frame of the point: normal +z, viewer in the xz plane with x >= 0. Corners go around
// so that those of a piece whose lit side is seen turn from +x to +y.
//
// The model's lobe times its cosine is known as a sum of two cosines (core/light/area_lobes.h), whose integral over a
// piece is exact. It is wrong by the ratio of the model to that sum, which is taken at one direction: the mean one
// from which the piece lights the sum. So a small piece is exact for every model and Fresnel term, and a piece that
// covers a part of the lobe is wrong by as much as the ratio changes over it.

const real area_pi = real(3.14159265358979323846);

// A transformed cosine: the matrix (a 0 b, 0 1 0, d 0 e).
struct AreaMatrix {
  real a;
  real b;
  real d;
  real e;
};

// An outline while its edges are added.
//   flow          vector form factor times 2 pi
//   sinks, rises  where the outline passes the horizon of the surface
//   leaves, enters   where it passes that of the cosine
struct AreaOutline {
  vec3 flow;
  vec3 sinks;
  vec3 rises;
  vec3 leaves;
  vec3 enters;
};

// How a piece lights a model.
//   towards      unit direction at which the model is taken
//   irradiance   per unit of the piece's radiance: times f_r in that direction it is the radiance that is reflected
struct AreaLit {
  vec3 towards;
  real irradiance;
};

vec3 area_cross(vec3 u, vec3 v) {
  return vec3(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
}

vec3 area_unit(vec3 v) {
  return v / sqrt(max(dot(v, v), tiny));
}

// The arc tangent over its argument, for arguments of 0 to 1 whose square is x: error 2e-8.
real area_arc_share(real x) {
  return 1 + x * (real(-0.3333314528) + x * (real(0.1999355085) + x * (real(-0.1420889944) + x * (real(0.1065626393) +
    x * (real(-0.0752896400) + x * (real(0.0429096138) + x * (real(-0.0161657367) + x * real(0.0028662257))))))));
}

// An edge's part of the flow: the angle between both corners along the normal of their plane.
vec3 area_edge(vec3 u, vec3 v) {
  vec3 across = area_cross(u, v);
  real sine = sqrt(dot(across, across));
  real cosine = dot(u, v);
  real t = sine / max(sqrt(sine * sine + cosine * cosine) + abs(cosine), tiny);
  real half_angle = t * area_arc_share(t * t);
  real angle = cosine >= 0 ? 2 * half_angle : area_pi - 2 * half_angle;
  return across * (angle / max(sine, tiny));
}

vec3 area_transformed(AreaMatrix m, vec3 v) {
  return vec3(m.a * v.x + m.b * v.z, v.y, m.d * v.x + m.e * v.z);
}

// Adds what of an edge lies above the horizon of the cosine.
AreaOutline area_above_cosine(AreaOutline before, AreaMatrix m, vec3 first, vec3 last) {
  AreaOutline sum = before;
  vec3 u = area_transformed(m, first);
  vec3 v = area_transformed(m, last);
  if (u.z < 0 && v.z < 0) return sum;
  if (u.z < 0 || v.z < 0) {
    vec3 at = u + (v - u) * (u.z / (u.z - v.z));
    at.z = real(0);
    if (v.z < 0) {
      sum.leaves = at;
      v = at;
    } else {
      sum.enters = at;
      u = at;
    }
  }
  sum.flow = sum.flow + area_edge(u, v);
  return sum;
}

// Adds what of an edge lies above the horizon of the surface.
AreaOutline area_side(AreaOutline before, AreaMatrix m, vec3 first, vec3 last) {
  AreaOutline sum = before;
  vec3 u = first;
  vec3 v = last;
  if (u.z < 0 && v.z < 0) return sum;
  if (u.z < 0 || v.z < 0) {
    vec3 at = u + (v - u) * (u.z / (u.z - v.z));
    at.z = real(0);
    if (v.z < 0) {
      sum.sinks = at;
      v = at;
    } else {
      sum.rises = at;
      u = at;
    }
  }
  return area_above_cosine(sum, m, u, v);
}

// The vector form factor of a piece in the space of the cosine, times 2 pi; its z is not below 0 where the piece
// shows its lit side.
vec3 area_flow(AreaMatrix m, vec3 p0, vec3 p1, vec3 p2, vec3 p3) {
  AreaOutline sum;
  sum.flow = vec3(0);
  sum.sinks = vec3(0);
  sum.rises = vec3(0);
  sum.leaves = vec3(0);
  sum.enters = vec3(0);
  sum = area_side(sum, m, p0, p1);
  sum = area_side(sum, m, p1, p2);
  sum = area_side(sum, m, p2, p3);
  sum = area_side(sum, m, p3, p0);
  sum = area_above_cosine(sum, m, sum.sinks, sum.rises);
  return sum.flow + area_edge(sum.leaves, sum.enters);
}

vec3 area_plain_flow(vec3 p0, vec3 p1, vec3 p2, vec3 p3) {
  AreaMatrix m;
  m.a = real(1);
  m.b = real(0);
  m.d = real(0);
  m.e = real(1);
  return area_flow(m, p0, p1, p2, p3);
}

// A diffuse model: the plain cosine is its lobe. Exact for Lambert.
AreaLit area_diffuse(vec3 p0, vec3 p1, vec3 p2, vec3 p3) {
  AreaLit lit_by;
  vec3 flow = area_plain_flow(p0, p1, p2, p3);
  lit_by.towards = area_unit(flow);
  lit_by.irradiance = max(flow.z, real(0)) / 2;
  return lit_by;
}

// A specular model with the lobe (1 - cosine) transformed cosine + cosine plain cosine.
AreaLit area_specular(AreaMatrix m, real cosine, vec3 p0, vec3 p1, vec3 p2, vec3 p3) {
  AreaLit lit_by;
  vec3 flow = area_flow(m, p0, p1, p2, p3);
  vec3 plain = area_plain_flow(p0, p1, p2, p3);
  real det = m.a * m.e - m.b * m.d;
  // The share of the transformed cosine that lies above the surface.
  real mass = (1 + m.a / sqrt(m.a * m.a + m.d * m.d)) / 2;
  real scale = (1 - cosine) / mass;
  real narrow = scale * max(flow.z, real(0));
  real wide = cosine * max(plain.z, real(0));
  vec3 back = vec3(m.e * flow.x - m.b * flow.z, det * flow.y, m.a * flow.z - m.d * flow.x);
  vec3 l = area_unit(area_unit(back) * narrow + area_unit(plain) * wide);
  vec3 q = area_transformed(m, l);
  real length2 = dot(q, q);
  // pi times the sum of the two cosines in that direction.
  real here = scale * max(q.z, real(0)) * det / (length2 * length2) + cosine * max(l.z, real(0));
  lit_by.towards = l;
  lit_by.irradiance = (narrow + wide) / 2 * max(l.z, real(0)) / max(here, tiny);
  return lit_by;
}
