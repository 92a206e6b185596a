function copy(part)
  return { nWeight = part.nWeight, bGood = part.bGood, sName = part.sName }
end
tBuffer = {}
tNow = { nWeight = 0, bGood = false, sName = "" }
for i = 1, 200000 do
  nI = i
  tNow.nWeight = nI
  tNow.sName = "gear"
  tBuffer[nI % 5] = copy(tNow)
end
print(tBuffer[2].nWeight)
