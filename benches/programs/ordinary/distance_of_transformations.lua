function distance(a, b)
  local dx, dy, dz = a.x - b.x, a.y - b.y, a.z - b.z
  return math.sqrt(dx * dx + dy * dy + dz * dz)
end
trA = { x = 0, y = 0, z = 0 }
trB = { x = 0, y = 0, z = 0 }
nSum = 0
for i = 1, 600000 do
  nI = i
  trB.x = nI % 7
  trB.y = nI % 5
  nSum = nSum + math.floor(distance(trA, trB))
end
print(nSum)
