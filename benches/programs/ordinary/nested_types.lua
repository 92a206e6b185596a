tLine = { tPart = { nWeight = 0, sName = "" }, nStored = { [0] = 0, 0, 0, 0, 0 } }
for i = 1, 1000000 do
  nI = i
  tLine.tPart.nWeight = tLine.tPart.nWeight + nI % 3
  tLine.nStored[nI % 5] = tLine.tPart.nWeight
end
print(tLine.tPart.nWeight)
