-- Neovim with the files of editors/neovim, as a user's configuration would have them.
local root, output = vim.env.VAL3_ROOT, vim.env.VAL3_OUTPUT
local passed = 0

local function wait(what, condition)
  assert(vim.wait(10000, condition, 20), 'no ' .. what)
  return true
end

local function step(name, run)
  run()
  passed = passed + 1
  io.stdout:write('ok ' .. name .. '\n')
end

local function copy_of_the_cell()
  local folder = vim.fn.tempname()
  vim.fn.system({ 'cp', '-r', root .. '/examples/palletiser', folder })
  vim.fn.system({ vim.env.VAL3_SERVER, 'test', '--init', folder .. '/usr/usrapp/partBox' })
  return folder .. '/usr/usrapp/palletiser/'
end

local function content(path)
  return table.concat(vim.fn.readfile(path, 'b'), '\n')
end

local function place(line, text)
  local column = assert(vim.api.nvim_buf_get_lines(0, line - 1, line, true)[1]:find(text, 1, true), text)
  vim.api.nvim_win_set_cursor(0, { line, column - 1 })
end

local function line_of(text)
  for number, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, true)) do
    if line:find(text, 1, true) then return number end
  end
  error('no line has ' .. text)
end

local function floating_text()
  for _, window in ipairs(vim.api.nvim_list_wins()) do
    if vim.api.nvim_win_get_config(window).relative ~= '' then
      return table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false), '\n')
    end
  end
end

local function run()
  vim.env.VAL3_TRACE = output .. '/traces/neovim.jsonl'
  vim.opt.runtimepath:prepend(root .. '/editors/neovim')
  vim.cmd('filetype plugin on')
  -- As a start with a configuration does.
  vim.cmd('runtime plugin/val3.lua')
  vim.lsp.config('val3', { cmd = { root .. '/tests/editors/record', 'lsp' } })
  vim.lsp.enable('val3')
  local application = copy_of_the_cell()

  step('a program is recognised and the server starts', function()
    vim.cmd('edit ' .. application .. 'pick.pgx')
    assert(vim.bo.filetype == 'val3', vim.bo.filetype)
    wait('client', function() return #vim.lsp.get_clients({ bufnr = 0 }) == 1 end)
  end)

  step('a mistake is shown and disappears', function()
    local line = line_of('waitEndMove()')
    vim.api.nvim_buf_set_lines(0, line - 1, line, true, { '    waitEndMove(1)' })
    wait('diagnostic', function() return #vim.diagnostic.get(0) == 1 end)
    local found = vim.diagnostic.get(0)[1]
    assert(found.lnum == line - 1 and found.message:find('waitEndMove', 1, true), vim.inspect(found))
    vim.api.nvim_buf_set_lines(0, line - 1, line, true, { '    waitEndMove()' })
    wait('repair', function() return #vim.diagnostic.get(0) == 0 end)
  end)

  step('hover opens a window', function()
    place(line_of('movel(pPick'), 'pPick')
    vim.lsp.buf.hover()
    wait('window', function() return floating_text() ~= nil end)
    assert(floating_text():find('pPick', 1, true), floating_text())
  end)

  step('definition leads to the data', function()
    place(line_of('movel(pPick'), 'tSuction')
    vim.lsp.buf.definition()
    wait('jump', function() return vim.api.nvim_buf_get_name(0):match('palletiser%.dtx$') end)
    assert(vim.api.nvim_get_current_line():find('name="tSuction"', 1, true))
    vim.cmd('edit ' .. application .. 'pick.pgx')
  end)

  step('a name is changed in every file', function()
    place(line_of('bHolding=x_bOk'), 'bHolding')
    vim.lsp.buf.rename('bCarries')
    wait('change', function() return vim.api.nvim_get_current_line():find('bCarries=x_bOk', 1, true) end)
    vim.cmd('silent wall')
    for _, file in ipairs({ 'pick.pgx', 'place.pgx', 'sensors.pgx', 'init.pgx', 'palletiser.dtx' }) do
      local before = content(root .. '/examples/palletiser/usr/usrapp/palletiser/' .. file)
      assert(content(application .. file) == before:gsub('bHolding', 'bCarries'), file)
    end
  end)

  step('the code is shown without XML and follows the file', function()
    vim.cmd('edit ' .. application .. 'pick.pgx')
    local line = line_of('movel(pPick')
    vim.api.nvim_win_set_cursor(0, { line, 0 })
    local text = vim.api.nvim_get_current_line()
    wait('command', function() return vim.fn.exists(':Val3Code') == 2 end)
    vim.cmd('Val3Code')
    local lines = vim.api.nvim_buf_get_lines(0, 0, -1, true)
    assert(lines[1] == 'begin' and lines[#lines] == 'end', vim.inspect(lines))
    assert(vim.api.nvim_get_current_line() == text and not vim.bo.modifiable and vim.bo.filetype == 'val3-code')
    vim.cmd('Val3File')
    assert(vim.api.nvim_get_current_line() == text and vim.api.nvim_win_get_cursor(0)[1] == line)
    vim.api.nvim_buf_set_lines(0, line - 1, line - 1, true, { '  // the first line' })
    vim.cmd('Val3Code')
    wait('new text', function() return vim.fn.search('the first line', 'cnw') > 0 end)
    vim.cmd('Val3File')
    vim.cmd('edit!')
  end)

  step('the code without XML has hover, definition, findings and renaming', function()
    local requests = require('val3_code_requests')
    vim.cmd('edit! ' .. application .. 'pick.pgx')
    local line = line_of('movel(pPick')
    vim.api.nvim_buf_set_lines(0, line - 1, line - 1, true, { '  nWrong=1' })
    vim.cmd('Val3Code')
    wait('text', function() return vim.fn.search('nWrong', 'cnw') > 0 end)
    local code = vim.api.nvim_get_current_buf()
    wait('finding', function()
      requests.show_findings(code)
      return vim.wait(500, function()
        return vim.iter(vim.diagnostic.get(code)):any(function(found) return found.message:find('nWrong', 1, true) end)
      end, 20)
    end)
    local found = vim.iter(vim.diagnostic.get(code)):find(function(it) return it.message:find('nWrong', 1, true) end)
    assert(vim.api.nvim_buf_get_lines(code, found.lnum, found.lnum + 1, true)[1]:sub(found.col + 1, found.end_col) == 'nWrong')
    place(line_of('movel(pPick'), 'tSuction')
    requests.hover()
    wait('hover', function() return #vim.api.nvim_list_wins() == 2 end)
    vim.cmd('only!')
    place(line_of('movel(pPick'), 'tSuction')
    requests.definition()
    wait('jump', function() return vim.api.nvim_buf_get_name(0):match('palletiser%.dtx$') end)
    vim.cmd('edit! ' .. application .. 'pick.pgx')
    vim.cmd('Val3Code')
    place(line_of('bCarries=x_bOk'), 'bCarries')
    requests.rename('bHolds')
    wait('new name', function() return vim.fn.search('bHolds=x_bOk', 'cnw') > 0 end)
    place(line_of('bHolds=x_bOk'), 'bHolds')
    requests.rename('bCarries')
    wait('old name', function() return vim.fn.search('bCarries=x_bOk', 'cnw') > 0 end)
    vim.cmd('Val3File')
    vim.cmd('edit!')
    vim.cmd('silent wall')
  end)

  step('the test of a file is executed in a terminal', function()
    vim.cmd('edit ' .. application .. '../partBoxTest/testFirst.pgx')
    wait('command', function() return vim.fn.exists(':Val3Test') == 2 end)
    vim.cmd('Val3Test')
    wait('terminal', function() return vim.bo.buftype == 'terminal' end)
    local shown = function() return table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, true), '\n') end
    wait('result', function() return shown():find('1 passed, 0 failed', 1, true) end)
    assert(shown():find('testFirst', 1, true), shown())
  end)
end

local ok, fault = xpcall(run, debug.traceback)
if not ok then io.stdout:write('FAILED ' .. tostring(fault) .. '\n') end
io.stdout:write(('test result: %s. %d passed; %d failed; neovim\n'):format(ok and 'ok' or 'FAILED', passed, ok and 0 or 1))
for _, client in ipairs(vim.lsp.get_clients()) do client:stop() end
vim.wait(3000, function() return #vim.lsp.get_clients() == 0 end, 20)
vim.cmd(ok and 'qa!' or 'cq')
