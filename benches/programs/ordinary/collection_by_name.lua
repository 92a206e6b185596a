nStock = {}
sName = {}
for i = 0, 7 do
  sName[i] = "article " .. tostring(i)
  nStock[sName[i]] = 0
end
for r = 1, 80000 do
  nRound = r
  for i = 0, 7 do
    nI = i
    if nStock[sName[nI]] ~= nil then
      nStock[sName[nI]] = nStock[sName[nI]] + 1
    end
  end
end
print(nStock["article 3"])
