nSum = 0
for i = 1, 400000 do
  nI = i
  sMessage = "part " .. tostring(nI) .. " of " .. tostring(nI + 1)
  nSum = nSum + string.len(sMessage)
end
print(nSum)
