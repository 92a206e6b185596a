-- Coroutines that take turns of ten lines, as tasks of priority 10 do.
local done = 0

local function count(rounds)
  local sum = 0
  for i = 1, rounds do
    sum = sum + i
    if i % 5 == 0 then
      coroutine.yield()
    end
  end
  done = done + 1
end

local tasks = {}
for i = 1, 1000 do
  tasks[i] = coroutine.create(count)
end
while done < 1000 do
  for i = 1, 1000 do
    if coroutine.status(tasks[i]) ~= "dead" then
      coroutine.resume(tasks[i], 2000)
    end
  end
end
print(done)
