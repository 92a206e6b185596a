-- The language server of VAL 3, for `vim.lsp.enable('val3')` (Neovim 0.11 and later).

-- Executes the test of a file in a terminal below.
local function test(client, buffer)
  vim.cmd('silent! wall')
  local params = { command = 'val3.tests', arguments = { vim.uri_from_bufnr(buffer) } }
  client:request('workspace/executeCommand', params, function(fault, tests)
    if fault or #tests == 0 then
      vim.notify(fault and fault.message or 'This file has no test', vim.log.levels.WARN)
      return
    end
    vim.cmd('botright new')
    vim.fn.jobstart(tests[1].command, { term = true })
  end, buffer)
end

return {
  cmd = { 'val3', 'lsp' },
  filetypes = { 'val3', 'val3-data', 'val3-project' },
  -- The controller's folder where there is one, else the nearest configuration or repository.
  root_markers = { 'usr', 'val3.toml', '.git' },
  handlers = { ['workspace/textDocumentContent/refresh'] = function(...) return require('val3_code').refreshed(...) end },
  on_attach = function(client, buffer)
    local run = function() test(client, buffer) end
    vim.api.nvim_buf_create_user_command(buffer, 'Val3Test', run, { desc = 'Execute the test of this file' })
    if vim.bo[buffer].filetype == 'val3' then
      local open = function() require('val3_code').open() end
      vim.api.nvim_buf_create_user_command(buffer, 'Val3Code', open, { desc = 'Show the code without XML' })
    end
  end,
}
