-- Hover, definition, references, renaming and findings in a buffer that shows the code of a program without XML. The
-- server knows the file alone, so that requests are about the file and their results are moved to the code.

local M = {}

local namespace = vim.api.nvim_create_namespace('val3-code')

-- The file of a buffer: its address, a loaded buffer, and the number of lines before its code.
local function file_of(buffer)
  local code = require('val3_code')
  local path = code.file_of(vim.api.nvim_buf_get_name(buffer))
  local file = vim.fn.bufadd(path)
  vim.fn.bufload(file)
  return { uri = vim.uri_from_fname(path), buffer = file, before = code.lines_before_code(vim.api.nvim_buf_get_lines(file, 0, -1, true)) }
end

local function line_of(buffer, line) return vim.api.nvim_buf_get_lines(buffer, line, line + 1, false)[1] or '' end

-- For each byte of a line of code, and for its end, the byte of the line in the file: a tag can come before it, and
-- characters can be written as entities.
local function columns(code, file)
  local start = file:match('.*<[Cc]ode[^>]*><!%[CDATA%[()') or file:match('.*<[Cc]ode[^>]*>()') or 1
  local found, at = {}, start
  local is_plain = file:sub(start, start + #code - 1) == code
  for byte = 1, #code + 1 do
    found[byte] = at - 1
    local entity = not is_plain and file:match('^&[#%w]+;', at)
    at = at + (entity and #entity or 1)
  end
  return found
end

-- The position in the file of a byte of the code.
local function to_file(buffer, file, client, line, column)
  local text = line_of(file.buffer, line + file.before)
  local byte = columns(line_of(buffer, line), text)[column + 1] or 0
  return { line = line + file.before, character = vim.str_utfindex(text, client.offset_encoding, byte, false) }
end

-- The line and byte in the code of a position in the file; nothing outside of the code.
local function to_code(buffer, file, client, position)
  local line = position.line - file.before
  if line < 0 or line >= vim.api.nvim_buf_line_count(buffer) then return nil end
  local text = line_of(file.buffer, position.line)
  local byte = vim.str_byteindex(text, client.offset_encoding, position.character, false)
  local column = 0
  for code, at in ipairs(columns(line_of(buffer, line), text)) do
    if at <= byte then column = code - 1 end
  end
  return line, column
end

-- Sends a request about the word at the cursor.
local function request(method, more, answer)
  local buffer = vim.api.nvim_get_current_buf()
  local client = vim.lsp.get_clients({ name = 'val3' })[1]
  if client == nil then return end
  local file = file_of(buffer)
  local line, column = unpack(vim.api.nvim_win_get_cursor(0))
  local params = { textDocument = { uri = file.uri }, position = to_file(buffer, file, client, line - 1, column) }
  client:request(method, vim.tbl_extend('force', params, more), function(fault, result)
    if fault then
      vim.notify(fault.message, vim.log.levels.WARN)
    elseif result ~= nil and result ~= vim.NIL then
      answer(result, client)
    end
  end, file.buffer)
end

function M.hover()
  request('textDocument/hover', {}, function(result)
    local lines = vim.lsp.util.convert_input_to_markdown_lines(result.contents)
    vim.lsp.util.open_floating_preview(lines, 'markdown', { focus_id = 'val3-code' })
  end)
end

-- Locations in one form; a link becomes its target.
local function locations(result)
  local list = vim.islist(result) and result or { result }
  return vim.tbl_map(function(found)
    return found.targetUri and { uri = found.targetUri, range = found.targetSelectionRange } or found
  end, list)
end

-- Shows the declaration: in the code if the code has it, else in its file.
function M.definition()
  request('textDocument/definition', {}, function(result, client)
    local found = locations(result)
    if #found == 0 then return end
    vim.lsp.util.show_document(found[1], client.offset_encoding, { focus = true })
    local before = require('val3_code').lines_before_code(vim.api.nvim_buf_get_lines(0, 0, -1, true))
    if vim.bo.filetype == 'val3' and found[1].range.start.line >= before then require('val3_code').open() end
  end)
end

function M.references()
  request('textDocument/references', { context = { includeDeclaration = true } }, function(result, client)
    vim.fn.setqflist({}, ' ', { title = 'References', items = vim.lsp.util.locations_to_items(result, client.offset_encoding) })
    vim.cmd('botright copen')
  end)
end

function M.rename(new_name)
  local name = new_name or vim.fn.input('New name: ', vim.fn.expand('<cword>'))
  if name == '' then return end
  request('textDocument/rename', { newName = name }, function(result, client)
    vim.lsp.util.apply_workspace_edit(result, client.offset_encoding)
  end)
end

-- Shows the findings of the file that are in its code.
function M.show_findings(buffer)
  local client = vim.lsp.get_clients({ name = 'val3' })[1]
  if client == nil then return end
  local file = file_of(buffer)
  client:request('textDocument/diagnostic', { textDocument = { uri = file.uri } }, function(fault, result)
    if fault or not vim.api.nvim_buf_is_loaded(buffer) or result.kind ~= 'full' then return end
    local shown = {}
    for _, finding in ipairs(result.items) do
      local line, column = to_code(buffer, file, client, finding.range.start)
      local last, last_column = to_code(buffer, file, client, finding.range['end'])
      if line and last then
        table.insert(shown, {
          lnum = line, col = column, end_lnum = last, end_col = last_column,
          severity = finding.severity, message = finding.message, code = finding.code, source = 'val3',
        })
      end
    end
    vim.diagnostic.set(namespace, buffer, shown)
  end, file.buffer)
end

-- The keys that Neovim gives to a buffer with a server.
function M.map(buffer)
  local map = function(keys, run, about) vim.keymap.set('n', keys, run, { buffer = buffer, desc = about }) end
  map('K', M.hover, 'Show the information on a word')
  map('<C-]>', M.definition, 'Go to the declaration')
  map('gd', M.definition, 'Go to the declaration')
  map('grr', M.references, 'List the uses')
  map('grn', M.rename, 'Rename in all files')
end

return M
