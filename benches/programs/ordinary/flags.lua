bAir = true
bStop = false
nStarts = 0
nI = 0
while nI < 1500000 do
  bDoor = nI % 4 == 0
  bReady = bAir and not bDoor
  if bReady and not bStop or nI % 100 == 0 then
    nStarts = nStarts + 1
  end
  bStop = not bStop
  nI = nI + 1
end
print(nStarts)
