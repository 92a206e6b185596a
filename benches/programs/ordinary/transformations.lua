function matrix(t)
  local a, b, c = math.rad(t.rx), math.rad(t.ry), math.rad(t.rz)
  local sa, ca, sb, cb, sc, cc = math.sin(a), math.cos(a), math.sin(b), math.cos(b), math.sin(c), math.cos(c)
  return cb * cc, -cb * sc, sb,
    ca * sc + sa * sb * cc, ca * cc - sa * sb * sc, -sa * cb,
    sa * sc - ca * sb * cc, sa * cc + ca * sb * sc, ca * cb
end
function angles(r00, r01, r02, r12, r22)
  return math.deg(math.atan(-r12, r22)), math.deg(math.atan(r02, math.sqrt(r00 * r00 + r01 * r01))), math.deg(math.atan(-r01, r00))
end
function product(l, r)
  local a, b, c, d, e, f, g, h, i = matrix(l)
  local j, k, m, n, o, p, q, s, t = matrix(r)
  local rx, ry, rz = angles(a * j + b * n + c * q, a * k + b * o + c * s, a * m + b * p + c * t, d * m + e * p + f * t, g * m + h * p + i * t)
  return {
    x = l.x + a * r.x + b * r.y + c * r.z,
    y = l.y + d * r.x + e * r.y + f * r.z,
    z = l.z + g * r.x + h * r.y + i * r.z,
    rx = rx, ry = ry, rz = rz,
  }
end
function inverse(t)
  local a, b, c, d, e, f, g, h, i = matrix(t)
  local rx, ry, rz = angles(a, d, g, h, i)
  return {
    x = -(a * t.x + d * t.y + g * t.z),
    y = -(b * t.x + e * t.y + h * t.z),
    z = -(c * t.x + f * t.y + i * t.z),
    rx = rx, ry = ry, rz = rz,
  }
end
trTool = { x = 0, y = 0, z = 100, rx = 0, ry = 0, rz = 30 }
for n = 1, 100000 do
  nI = n
  trPlace = { x = nI % 10, y = nI % 20, z = 5, rx = 0, ry = 0, rz = nI % 90 }
  trPlace = product(trPlace, trTool)
  trPlace = inverse(trPlace)
end
print(math.floor(trPlace.z + 0.5))
