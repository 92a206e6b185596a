function copy(p)
  return { x = p.x, y = p.y, z = p.z, rx = p.rx, ry = p.ry, rz = p.rz, shoulder = p.shoulder, elbow = p.elbow, wrist = p.wrist }
end
pPlace = {}
pCorner = { x = 0, y = 0, z = 0, rx = 0, ry = 0, rz = 0, shoulder = 0, elbow = 0, wrist = 0 }
for r = 1, 20000 do
  nRound = r
  for row = 0, 3 do
    nRow = row
    for column = 0, 5 do
      nColumn = column
      pPlace[nRow * 6 + nColumn] = copy(pCorner)
      pPlace[nRow * 6 + nColumn].x = pCorner.x + nColumn * 50
      pPlace[nRow * 6 + nColumn].y = pCorner.y + nRow * 40
    end
  end
end
print(pPlace[23].x + pPlace[23].y)
