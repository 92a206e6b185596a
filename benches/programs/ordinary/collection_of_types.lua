tPart = {}
for _, name in ipairs({ "gear", "shaft", "housing" }) do
  tPart[name] = { nCount = 0, bBlocked = false }
end
sWanted = "shaft"
for i = 1, 600000 do
  nI = i
  tPart[sWanted].nCount = tPart[sWanted].nCount + 1
  if tPart["gear"].bBlocked then
    tPart["housing"].nCount = 0
  end
end
print(tPart["shaft"].nCount)
