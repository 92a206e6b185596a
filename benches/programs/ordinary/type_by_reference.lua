tAxis = {}
for i = 0, 3 do
  tAxis[i] = { nPosition = 0, nLimit = 360, nTurns = 0 }
end
function move(axis, by)
  axis.nPosition = axis.nPosition + by
  if axis.nPosition > axis.nLimit then
    axis.nPosition = 0
    axis.nTurns = axis.nTurns + 1
  end
end
for r = 1, 150000 do
  nRound = r
  for i = 0, 3 do
    nI = i
    move(tAxis[nI], nI + 1)
  end
end
print(tAxis[3].nTurns)
