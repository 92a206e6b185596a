nSum = 0
function book(amount)
  order = { nAmount = 0, nPrice = 0, bDone = false }
  order.nAmount = amount
  order.nPrice = amount * 3
  nSum = nSum + order.nPrice
end
for i = 1, 300000 do
  nI = i
  book(nI % 10)
end
print(nSum)
