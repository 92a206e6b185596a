nState = 0
nDone = 0
for i = 1, 1500000 do
  nI = i
  if nState == 0 then
    nState = 1
  elseif nState == 1 or nState == 2 then
    nState = 3
  elseif nState == 3 then
    nState = 4
    nDone = nDone + 1
  elseif nState == 4 then
    nState = 5
  else
    nState = 0
  end
end
print(nDone)
