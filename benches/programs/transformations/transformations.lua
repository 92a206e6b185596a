-- A transformation is six numbers: a place, and angles in degrees about x, then y, then z of the turned frame.
local rad, deg, sin, cos, atan, sqrt = math.rad, math.deg, math.sin, math.cos, math.atan, math.sqrt

local function rotation(t)
  local a, b, c = rad(t.rx), rad(t.ry), rad(t.rz)
  local sa, ca, sb, cb, sc, cc = sin(a), cos(a), sin(b), cos(b), sin(c), cos(c)
  return cb * cc, -cb * sc, sb,
    ca * sc + sa * sb * cc, ca * cc - sa * sb * sc, -sa * cb,
    sa * sc - ca * sb * cc, sa * cc + ca * sb * sc, ca * cb
end

local function product(l, r)
  local a, b, c, d, e, f, g, h, i = rotation(l)
  local j, k, m, n, o, p, q, s, t = rotation(r)
  local r00, r01, r02 = a * j + b * n + c * q, a * k + b * o + c * s, a * m + b * p + c * t
  local r12 = d * m + e * p + f * t
  local r22 = g * m + h * p + i * t
  return {
    x = l.x + a * r.x + b * r.y + c * r.z,
    y = l.y + d * r.x + e * r.y + f * r.z,
    z = l.z + g * r.x + h * r.y + i * r.z,
    rx = deg(atan(-r12, r22)),
    ry = deg(atan(r02, sqrt(r00 * r00 + r01 * r01))),
    rz = deg(atan(-r01, r00)),
  }
end

local place = { x = 0, y = 0, z = 0, rx = 0, ry = 0, rz = 0 }
local step = { x = 1, y = 2, z = 3, rx = 10, ry = 20, rz = 30 }
for _ = 1, 500000 do
  place = product(place, step)
end
print(string.format("%.3f %.3f", place.x, place.rz))
