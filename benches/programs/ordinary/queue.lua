nQueue = { 0 }
nSum = 0
for i = 1, 300000 do
  nI = i
  nQueue[#nQueue + 1] = nI
  if #nQueue > 10 then
    nSum = nSum + nQueue[1]
    table.remove(nQueue, 1)
  end
end
print(nSum)
