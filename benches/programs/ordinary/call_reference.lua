t = { nTotal = 0 }
function count(x, by)
  x.nTotal = x.nTotal + by
  if x.nTotal > 1000 then
    x.nTotal = x.nTotal - 1000
  end
end
for i = 1, 1000000 do
  nI = i
  count(t, nI % 7)
end
print(t.nTotal)
