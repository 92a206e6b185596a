sName = {}
for i = 0, 19 do
  sName[i] = "tool number " .. tostring(i)
end
sWanted = "tool number 15"
nFound = 0
for r = 1, 50000 do
  nRound = r
  nI = 0
  while nI < 20 and sName[nI] ~= sWanted do
    nI = nI + 1
  end
  nFound = nFound + nI
end
print(nFound)
