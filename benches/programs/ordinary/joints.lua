jNow = { j1 = 0, j2 = 0, j3 = 0, j4 = 0, j5 = 0, j6 = 0 }
jLimit = { j1 = 100, j2 = 90, j3 = 80, j4 = 70, j5 = 60, j6 = 50 }
nOut = 0
for i = 1, 500000 do
  nI = i
  jNow.j1 = nI % 180
  jNow.j3 = nI % 90
  jNow.j5 = nI % 120
  if jNow.j1 > jLimit.j1 or jNow.j3 > jLimit.j3 or jNow.j5 > jLimit.j5 then
    nOut = nOut + 1
  end
end
print(nOut)
