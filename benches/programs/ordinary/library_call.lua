counter = { nCount = 0 }
function counter.add(by)
  counter.nCount = counter.nCount + by
end
function counter.read(t)
  t.nSum = counter.nCount
end
t = { nSum = 0 }
for i = 1, 700000 do
  nI = i
  counter.add(nI % 3)
  counter.read(t)
end
print(t.nSum)
