function distance(a, b)
  local dx, dy, dz = a.x - b.x, a.y - b.y, a.z - b.z
  return math.sqrt(dx * dx + dy * dy + dz * dz)
end
pPick = {}
for i = 0, 9 do
  pPick[i] = { x = i * 3, y = i * 4, z = 0 }
end
pHome = { x = 0, y = 0, z = 0 }
nSum = 0
for r = 1, 50000 do
  nRound = r
  for i = 0, 9 do
    nI = i
    nSum = nSum + distance(pPick[nI], pHome)
  end
end
print(nSum)
