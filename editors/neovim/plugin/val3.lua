vim.api.nvim_create_autocmd('BufReadCmd', {
  pattern = 'val-text://*',
  callback = function(event) require('val3_code').read(event.buf) end,
})
