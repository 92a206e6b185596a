tPart = {}
for i = 0, 9 do
  tPart[i] = { nWeight = 0, sName = "part" .. tostring(i) }
end
sWanted = "part7"
nFound = 0
for r = 1, 100000 do
  nRound = r
  for i = 0, 9 do
    nI = i
    if tPart[nI].sName == sWanted then
      nFound = nFound + 1
    end
  end
end
print(nFound)
