-- The code of a program without XML, in a buffer for reading. The server makes its text of the file (LSP 3.18,
-- `workspace/textDocumentContent`), and says when it has changed.

local M = {}

local CONTENT = 'workspace/textDocumentContent'

-- The number of lines of the file before its code; the lines of the code are those of the file, one by one.
function M.lines_before_code(lines)
  for number, line in ipairs(lines) do
    if line:match('<[Cc]ode[>%s]') then return number - 1 end
  end
  return 0
end

function M.file_of(address) return vim.uri_to_fname((address:gsub('^val%-text:', 'file:'))) end

local function show(buffer, text)
  vim.bo[buffer].modifiable = true
  vim.api.nvim_buf_set_lines(buffer, 0, -1, true, vim.split(text:gsub('\r\n', '\n'), '\n'))
  vim.bo[buffer].modifiable = false
  vim.bo[buffer].modified = false
end

-- Asks the server for the text of a buffer whose name is its address.
function M.read(buffer)
  local address = vim.api.nvim_buf_get_name(buffer)
  local client = vim.lsp.get_clients({ name = 'val3' })[1]
  if client == nil then
    vim.notify('The server of VAL 3 is not running: open a program first', vim.log.levels.WARN)
    return
  end
  local answer = client:request_sync(CONTENT, { uri = address }, 5000, buffer)
  if answer == nil or answer.err then
    vim.notify(answer and answer.err.message or 'The server does not answer', vim.log.levels.WARN)
    return
  end
  vim.bo[buffer].buftype = 'nofile'
  vim.bo[buffer].swapfile = false
  vim.bo[buffer].filetype = 'val3-code'
  show(buffer, answer.result.text)
  require('val3_code_requests').show_findings(buffer)
end

-- Shows the code of the program in the window, at the line of the cursor.
function M.open()
  local line = vim.api.nvim_win_get_cursor(0)[1]
  local before = M.lines_before_code(vim.api.nvim_buf_get_lines(0, 0, -1, true))
  vim.cmd.edit(vim.fn.fnameescape((vim.uri_from_bufnr(0):gsub('^file:', 'val-text:'))))
  local last = vim.api.nvim_buf_line_count(0)
  vim.api.nvim_win_set_cursor(0, { math.min(math.max(line - before, 1), last), 0 })
end

-- Shows the file of the code in the window, at the line of the cursor.
function M.open_file()
  local line = vim.api.nvim_win_get_cursor(0)[1]
  vim.cmd.edit(vim.fn.fnameescape(M.file_of(vim.api.nvim_buf_get_name(0))))
  local before = M.lines_before_code(vim.api.nvim_buf_get_lines(0, 0, -1, true))
  vim.api.nvim_win_set_cursor(0, { math.min(line + before, vim.api.nvim_buf_line_count(0)), 0 })
end

-- The server says that a text has changed.
function M.refreshed(_, params)
  local buffer = vim.fn.bufnr(params.uri)
  if buffer ~= -1 and vim.api.nvim_buf_is_loaded(buffer) then
    vim.schedule(function() M.read(buffer) end)
  end
  return vim.NIL
end

return M
